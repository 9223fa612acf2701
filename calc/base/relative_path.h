#pragma once
// Resolves names of files relative to another file.

#include <optional>
#include <string>
#include <string_view>

namespace calc {

// Returns "a/c" for "a/./b/../c"; empty for absolute names and for names that lead out of the
// folder they start from.
std::optional<std::string> normalize_relative_path(std::string_view path);

}  // namespace calc
