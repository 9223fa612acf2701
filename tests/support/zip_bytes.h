#pragma once
// ZIP archives made in memory.

#include <zip.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_support {

using ZipFiles = std::vector<std::pair<std::string, std::string>>;  // name, bytes

// name_flags: ZIP_FL_ENC_UTF_8 or ZIP_FL_ENC_CP437, the encoding of the names given.
inline std::string zip_bytes(const ZipFiles& files, bool packed = true,
                             zip_flags_t name_flags = ZIP_FL_ENC_UTF_8) {
  if (files.empty()) return std::string("PK\x05\x06") + std::string(18, '\0');
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_t* archive = zip_open_from_source(target, ZIP_TRUNCATE, nullptr);
  if (archive == nullptr) throw std::runtime_error("zip_open_from_source");
  zip_source_keep(target);
  for (const auto& [name, bytes] : files) {
    zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
    const zip_int64_t index = zip_file_add(archive, name.c_str(), source, name_flags);
    if (index < 0) throw std::runtime_error("zip_file_add: " + name);
    zip_set_file_compression(archive, static_cast<zip_uint64_t>(index),
                             packed ? ZIP_CM_DEFLATE : ZIP_CM_STORE, 9);
  }
  if (zip_close(archive) != 0) throw std::runtime_error("zip_close");
  std::string result;
  zip_source_open(target);
  char piece[4096];
  for (zip_int64_t got = 0; (got = zip_source_read(target, piece, sizeof piece)) > 0;)
    result.append(piece, static_cast<std::size_t>(got));
  zip_source_close(target);
  zip_source_free(target);
  return result;
}

// Every occurrence; both texts of the same length, so that the archive's offsets stay right.
inline std::string with_bytes_replaced(std::string text, const std::string& from,
                                       const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + 1))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace test_support
