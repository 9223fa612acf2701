#pragma once

#include <string>

namespace report {

// client_style.css, embedded when the build is configured; it goes behind html_style().
std::string client_style();

}  // namespace report
