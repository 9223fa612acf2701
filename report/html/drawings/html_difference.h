#pragma once
// Where the light of planes has changed against a baseline, as drawings.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// A heading and a <figure> for each plane of the revision that has cells, those first that changed
// most; a few of them only, which is said. "" if there are none. Needs a revision.
std::string html_differences(const Texts& t, const Document& document);

}  // namespace report
