#pragma once
// Reads files inside a ZIP archive in memory. Only this uses libzip. Archives are untrusted: the
// sizes they state are not used, and names that lead out of the archive are refused.

#include "calc/base/diagnostics.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

struct ZipLimits {
  std::size_t entries = 10'000;
  std::size_t file_bytes = 64u << 20;    // of one file, unpacked
  std::size_t total_bytes = 128u << 20;  // of all files read
  // A file may always unpack to free_bytes, and beyond that to `ratio` times the whole archive:
  // photometry packs 5 to 20 times, a bomb 1000 times.
  std::size_t free_bytes = 1u << 20;
  std::size_t ratio = 200;
};

bool looks_like_zip(std::string_view bytes);

class ZipArchive {
 public:
  // Returns the archive. Empty, with an error, if the bytes are not an intact ZIP archive, if a
  // name in it is absolute, has a drive letter, a backslash, a control character or a step up (..),
  // or appears twice, or if it has too many entries. bytes must outlive it; name: its path in
  // messages.
  static std::optional<ZipArchive> open(std::string_view bytes, const std::string& name,
                                        Diagnostics& diagnostics, const ZipLimits& limits = {});
  ZipArchive(ZipArchive&&) noexcept;
  ZipArchive& operator=(ZipArchive&&) noexcept;
  ~ZipArchive();

  // Returns the names in the order of the archive, UTF-8; folders end with '/'.
  const std::vector<std::string>& names() const;
  bool has(std::string_view name) const;
  // Returns a file's bytes. Empty, with an error, if it is absent, damaged, encrypted, compressed
  // in a way unknown to libzip, or larger than the limits.
  std::optional<std::string> read(const std::string& name);

 private:
  struct Contents;
  explicit ZipArchive(std::unique_ptr<Contents> contents);

  std::unique_ptr<Contents> contents_;
};

// Returns why a name may not be used inside an archive ("leaves the archive"); "" if it may.
std::string_view unsafe_name_reason(std::string_view name);

}  // namespace calc
