#pragma once

#include <string>

namespace report {

// html_style.css, embedded when the build is configured.
std::string html_style();

}  // namespace report
