#pragma once
// Drawings of the change of the light on planes from a baseline.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns a heading and a <figure> for each plane of the revision that has cells, with the largest
// changes first; only a few, and the text says so. "" if there are none. Needs a revision.
std::string html_differences(const Texts& t, const Document& document);

}  // namespace report
