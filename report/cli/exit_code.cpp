#include "report/cli/exit_code.h"

namespace cli {
namespace {

bool has_uncomputed_plane(const report::Document& document) {
  for (const report::ProjectPart& project : document.projects) {
    for (const report::SpacePart& space : project.spaces) {
      for (const report::PlanePart& plane : space.planes) {
        if (!plane.is_computed) return true;
      }
    }
  }
  return false;
}

}  // namespace

ExitCode exit_code_for(const report::Document& document) {
  const report::VerdictCounts counts = report::count_verdicts(document);
  if (counts.not_judged > 0 || has_uncomputed_plane(document)) return kNotJudged;
  if (counts.fail > 0) return kNotMet;
  if (counts.undecided > 0) return kUndecided;
  return kAllMet;
}

}  // namespace cli
