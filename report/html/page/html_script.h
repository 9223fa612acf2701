#pragma once

#include "report/text/texts.h"

#include <string>

namespace report {

// The page's scripts (html_script.js and html_levels.js, embedded when the build is configured):
// sorting and filtering of the summary, with its words in the language of t, and levels of light
// that move. Without '<' and '&', so that it may stand in
// XML as it is.
std::string html_script(const Texts& t);

}  // namespace report
