#pragma once

#include <string>

namespace report {

// The page's script (html_script.js, embedded when the build is configured): sorting and filtering
// of the summary. Without '<' and '&', so that it may stand in XML as it is.
std::string html_script();

}  // namespace report
