#include "calc/store/entry_file.h"

#include "calc/base/file_hash.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <utility>

namespace calc {
namespace {

constexpr std::string_view kEntryMagic = "LUXENTRY";
constexpr std::size_t kHashBytes = 32;

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

struct EntryHeader {
  char magic[8];
  std::uint32_t format;
  std::uint32_t key_bytes;
  std::uint64_t bytes;
};
static_assert(sizeof(EntryHeader) == 24);

ParsedEntry unusable_entry(std::string problem) { return {{}, {}, std::move(problem)}; }

}  // namespace

std::size_t entry_file_bytes(std::size_t key_bytes, std::size_t bytes) {
  return sizeof(EntryHeader) + key_bytes + bytes + kHashBytes;
}

std::string render_entry(std::string_view key, std::string_view bytes) {
  EntryHeader header{};
  std::memcpy(header.magic, kEntryMagic.data(), sizeof header.magic);
  header.format = kEntryFormat;
  header.key_bytes = static_cast<std::uint32_t>(key.size());
  header.bytes = bytes.size();
  std::string file;
  file.reserve(entry_file_bytes(key.size(), bytes.size()));
  file.append(reinterpret_cast<const char*>(&header), sizeof header);
  file.append(key).append(bytes);
  file += sha256(file);
  return file;
}

ParsedEntry parse_entry(std::string_view file) {
  EntryHeader header{};
  if (file.empty()) return unusable_entry("it is empty");
  if (file.size() < sizeof header + kHashBytes) return unusable_entry("it is too short");
  std::memcpy(&header, file.data(), sizeof header);
  if (!begins_as_entry(file)) return unusable_entry("it is not a store entry");
  if (header.format != kEntryFormat) {
    return unusable_entry(
        fmt::format("its format is {}; this program reads {}", header.format, kEntryFormat));
  }
  const std::size_t rest = file.size() - sizeof header - kHashBytes;
  if (header.key_bytes > rest || header.bytes != rest - header.key_bytes) {
    return unusable_entry("its length differs from the stated length");
  }
  const std::size_t hashed = file.size() - kHashBytes;
  if (sha256(file.substr(0, hashed)) != file.substr(hashed)) {
    return unusable_entry("its checksum is wrong");
  }
  return {file.substr(sizeof header, header.key_bytes),
          file.substr(sizeof header + header.key_bytes, header.bytes), ""};
}

bool begins_as_entry(std::string_view file) { return file.starts_with(kEntryMagic); }

EntryPlace place_of_key(std::string_view key) {
  const std::string name = sha256_hex(key);
  return {name.substr(0, 2), name.substr(2)};
}

}  // namespace calc
