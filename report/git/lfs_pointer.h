#pragma once
// Git LFS: for a large file git has a pointer to contents that are stored beside git's objects.

#include "calc/base/file_reader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace git {

struct LfsPointer {
  std::string sha256;  // 64 hexadecimal digits, small letters
  std::uint64_t size_bytes = 0;
};

// Returns whether the bytes claim to be a pointer.
bool is_lfs_pointer(std::string_view bytes);
// Returns the pointer; empty if it is none, or broken.
std::optional<LfsPointer> parse_lfs_pointer(std::string_view bytes);

// Returns the contents, from <storage>/objects/ab/cd/..., if their size and hash are the pointer's;
// else an error that says what to do. commit: contains the pointer.
calc::FileContent read_lfs_object(const LfsPointer& pointer, const std::string& storage,
                                  const std::string& commit);

}  // namespace git
