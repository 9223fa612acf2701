#pragma once
// The machines on which the same command with the same files gives the same bits again.

#include "report/document/document.h"

namespace report {

// totals: over all projects.
SameBits same_bits_of(const Totals& totals, bool uses_graphics_device);

}  // namespace report
