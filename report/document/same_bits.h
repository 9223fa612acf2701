#pragma once
// Where the same command, with the same files, gives the same bits again.

#include "report/document/document.h"

namespace report {

// Of a document whose projects are all there.
SameBits same_bits_of(const Document& document, bool uses_graphics_device);

}  // namespace report
