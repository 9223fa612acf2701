#include "report/document/same_bits.h"

namespace report {

SameBits same_bits_of(const Totals& totals, bool uses_graphics_device) {
  if (totals.is_cut_short) return SameBits::nowhere;
  return uses_graphics_device ? SameBits::same_device : SameBits::any_processor;
}

}  // namespace report
