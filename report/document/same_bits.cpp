#include "report/document/same_bits.h"

namespace report {
namespace {

// A run that was cut short depends on how fast the machine was.
bool is_cut_short(const Document& document) {
  for (const ProjectPart& project : document.projects) {
    for (const SpacePart& space : project.spaces) {
      for (const PlanePart& plane : space.planes) {
        if (plane.stop == calc::StopReason::time_limit ||
            plane.stop == calc::StopReason::interrupted) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

SameBits same_bits_of(const Document& document, bool uses_graphics_device) {
  if (is_cut_short(document)) return SameBits::nowhere;
  return uses_graphics_device ? SameBits::same_device : SameBits::any_processor;
}

}  // namespace report
