#pragma once

#include "report/text/texts.h"

#include <string>

namespace report {

// Returns the page's scripts (html_script.js and html_levels.js, embedded when the build is
// configured): sorting and filtering of the summary, with its words in the language of t, and
// movable levels of light. Without '<' and '&', so that they may be in XML unchanged.
std::string html_script(const Texts& t);

}  // namespace report
