#pragma once
// Files inside a ZIP archive in memory. The only owner of libzip. Archives come from anywhere:
// nothing they say about sizes is believed, and names that lead out of the archive are refused.

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
  // bytes must outlive the archive; name: its path, for messages. Empty, with an error, if the
  // bytes are no intact ZIP archive, if a name in it is absolute, has a drive letter, a backslash,
  // a control character or a step up (..), or is there twice, or if it has too many entries.
  static std::optional<ZipArchive> open(std::string_view bytes, const std::string& name,
                                        Diagnostics& diagnostics, const ZipLimits& limits = {});
  ZipArchive(ZipArchive&&) noexcept;
  ZipArchive& operator=(ZipArchive&&) noexcept;
  ~ZipArchive();

  // In the order of the archive, UTF-8; folders end with '/'.
  const std::vector<std::string>& names() const;
  bool has(std::string_view name) const;
  // A file's bytes. Empty, with an error, if it is absent, damaged, encrypted, packed in a way that
  // libzip does not know, or larger than the limits.
  std::optional<std::string> read(const std::string& name);

 private:
  struct Contents;
  explicit ZipArchive(std::unique_ptr<Contents> contents);

  std::unique_ptr<Contents> contents_;
};

// Why a name may not be used inside an archive, in words ("leaves the archive"); "" if it may.
std::string_view unsafe_name_reason(std::string_view name);

}  // namespace calc
