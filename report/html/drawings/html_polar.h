#pragma once

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns a small polar diagram of a luminaire, C0-C180 solid and C90-C270 dashed; "" if its
// intensities are not known or all zero.
std::string html_polar(const Texts& t, const LuminaireRow& row);

}  // namespace report
