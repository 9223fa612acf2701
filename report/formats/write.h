#pragma once
// Files appear whole or not at all.

#include <string>
#include <string_view>

namespace report {

// Writes beside the target under a temporary name, flushes to the disk and renames; missing parent
// folders are created. On failure the target is as it was, nothing temporary stays behind, and the
// reason is returned; "" is success. A symbolic link is followed; devices and pipes ("/dev/stdout")
// are written directly. Threads and processes may write the same target at once: one of the whole
// files wins.
std::string write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace report
