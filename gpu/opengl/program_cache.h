#pragma once
// Keeps compiled shaders in files, because compiling takes longer than a small calculation.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gpu {

// A result of glGetProgramBinary().
struct ProgramBinary {
  std::uint32_t format = 0;
  std::vector<std::byte> bytes;
};

// A file for each source and driver, whose names are hashes of both. An unreadable or incomplete
// file counts as missing, and failed writes are ignored, because this only saves time.
class ProgramCache {
 public:
  ProgramCache() = default;  // off: holds nothing, takes nothing
  // folder: made when first needed, "" = off. driver: a text that distinguishes drivers.
  ProgramCache(std::filesystem::path folder, std::string driver);

  bool is_on() const { return !folder_.empty(); }
  std::optional<ProgramBinary> find(std::string_view source) const;
  // Writes it whole or not at all, also if others write the same file or the program is killed.
  void keep(std::string_view source, const ProgramBinary& binary) const;

 private:
  std::string key(std::string_view source) const;

  std::filesystem::path folder_;
  std::string driver_;
};

}  // namespace gpu
