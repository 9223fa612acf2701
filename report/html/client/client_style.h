#pragma once

#include <string>

namespace report {

// Returns client_style.css, embedded when the build is configured; it follows html_style().
std::string client_style();

}  // namespace report
