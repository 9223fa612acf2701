#include "report/git/lfs_pointer.h"

#include "calc/base/file_hash.h"
#include "calc/base/line_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>

namespace git {
namespace {

constexpr std::string_view kVersionLine = "version https://git-lfs.github.com/spec/v1";
constexpr std::size_t kMostPointerBytes = 1024;  // as git-lfs has it

bool is_sha256(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

bool is_lfs_pointer(std::string_view bytes) {
  return bytes.size() < kMostPointerBytes && bytes.starts_with(kVersionLine);
}

std::optional<LfsPointer> parse_lfs_pointer(std::string_view bytes) {
  if (!is_lfs_pointer(bytes)) return std::nullopt;
  constexpr std::string_view kOid = "oid sha256:", kSize = "size ";
  LfsPointer pointer;
  bool has_size = false;
  calc::LineCursor lines(bytes);
  while (const std::optional<std::string_view> line = lines.next()) {
    if (line->starts_with(kOid)) pointer.sha256 = line->substr(kOid.size());
    if (!line->starts_with(kSize)) continue;
    const std::string_view digits = line->substr(kSize.size());
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), pointer.size_bytes);
    has_size = error == std::errc() && end == digits.data() + digits.size();
  }
  if (!has_size || !is_sha256(pointer.sha256)) return std::nullopt;
  return pointer;
}

calc::FileContent read_lfs_object(const LfsPointer& pointer, const std::string& storage,
                                  const std::string& commit) {
  const std::string& hash = pointer.sha256;
  const std::string place =
      fmt::format("{}/objects/{}/{}/{}", storage, hash.substr(0, 2), hash.substr(2, 2), hash);
  const auto failure = [&](const std::string& why) {
    return calc::FileContent{
        {},
        fmt::format("git has only a Git LFS pointer, and {} ({}); 'git lfs fetch origin {}' "
                    "brings the contents",
                    why, place, commit)};
  };
  std::error_code error;
  if (!std::filesystem::exists(place, error)) {
    return failure("its contents are missing");
  }
  if (const std::uintmax_t size = std::filesystem::file_size(place, error);
      error || size != pointer.size_bytes) {
    return failure("the size of its contents differs from the pointer");
  }
  calc::FileContent content = calc::DiskFileReader().read(place);
  if (!content.ok()) return failure("its contents cannot be read: " + content.error);
  if (calc::sha256_hex(content.bytes) != hash) {
    return failure("the hash of its contents differs from the pointer");
  }
  return content;
}

}  // namespace git
