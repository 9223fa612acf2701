#pragma once

#include "report/text/texts.h"

#include <string>

namespace report {

// The page's script (html_script.js, embedded when the build is configured): sorting and filtering
// of the summary, with its words in the language of t. Without '<' and '&', so that it may stand in
// XML as it is.
std::string html_script(const Texts& t);

}  // namespace report
