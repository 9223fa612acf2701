#pragma once
// Names of files beside another file.

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// "a/./b/../c" -> "a/c"; empty for absolute names and for names that lead out of the folder they
// start from.
std::optional<std::string> normalize_relative_path(std::string_view path);

}  // namespace calc
