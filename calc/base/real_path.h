#pragma once
// Resolves paths, also of files that do not exist.

#include <filesystem>

namespace calc {

// Returns the absolute path without symbolic links, "." and "..". The missing rest of a path stays
// as written, and so does the rest after as many links as a kernel follows.
std::filesystem::path real_path(const std::filesystem::path& path);

}  // namespace calc
