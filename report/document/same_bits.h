#pragma once
// Where the same command, with the same files, gives the same bits again.

#include "report/document/document.h"

namespace report {

// totals: of all projects.
SameBits same_bits_of(const Totals& totals, bool uses_graphics_device);

}  // namespace report
