#pragma once
// Files appear whole or not at all.

#include "report/stream/sink.h"

#include <functional>
#include <string>
#include <string_view>

namespace report {

// Writes beside the target under a temporary name, flushes to the disk and renames; missing parent
// folders are created. On failure the target is as it was, nothing temporary stays behind, and the
// reason is returned; "" is success. A symbolic link is followed; devices and pipes ("/dev/stdout")
// are written directly. Threads and processes may write the same target at once: one of the whole
// files wins.
std::string write_file_atomically(const std::string& path, std::string_view bytes);
// The same piece by piece. make may throw: what is thrown goes on, but a WriteFailure, which is the
// reason of a failure.
std::string write_file_atomically(const std::string& path, const std::function<void(Sink&)>& make);

}  // namespace report
