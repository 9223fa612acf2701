#pragma once
// Where a path leads, whether there is something or not.

#include <filesystem>

namespace calc {

// The absolute path without symbolic links, "." and "..", also of what does not exist: what is
// missing stays as it is named. After as many links as a kernel follows the rest stays, too.
std::filesystem::path real_path(const std::filesystem::path& path);

}  // namespace calc
