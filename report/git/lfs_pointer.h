#pragma once
// Git LFS: what git holds of a large file is a pointer to contents that lie beside git's objects.

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

// Whether it says of itself that it is a pointer.
bool is_lfs_pointer(std::string_view bytes);
// Empty where it is none, or a broken one.
std::optional<LfsPointer> parse_lfs_pointer(std::string_view bytes);

// The contents, from <storage>/objects/ab/cd/...: only those whose size and hash are the pointer's;
// else an error that says what to do. commit: in which the pointer is.
calc::FileContent read_lfs_object(const LfsPointer& pointer, const std::string& storage,
                                  const std::string& commit);

}  // namespace git
