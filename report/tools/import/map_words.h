#pragma once
// Words in maps to start from.

#include "calc/base/utf8.h"

#include <string>

namespace cli {

// Returns the name as a string of TOML.
inline std::string quoted_for_map(const std::string& name) {
  std::string text = "\"";
  for (const char c : calc::printable(name)) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

}  // namespace cli
