#pragma once

#include <string>

namespace report {

// Returns html_style.css, embedded when the build is configured.
std::string html_style();

}  // namespace report
