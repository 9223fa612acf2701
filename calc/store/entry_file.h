#pragma once
// One entry as the bytes of a file: magic, format version, lengths, key, bytes, SHA-256 of all
// that.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace calc {

inline constexpr std::uint32_t kEntryFormat = 1;

std::string render_entry(std::string_view key, std::string_view bytes);
// Of a file that holds so much.
std::size_t entry_file_bytes(std::size_t key_bytes, std::size_t bytes);

// Views into the file's bytes; or `problem` says in words why it is no whole entry of this format.
struct ParsedEntry {
  std::string_view key, bytes;
  std::string problem;
};
ParsedEntry parse_entry(std::string_view file);

// Whether a file begins as an entry of any format does.
bool begins_as_entry(std::string_view file);

// "ab/cdef...", the SHA-256 of the key: where its file lies.
struct EntryPlace {
  std::string folder, file;
};
EntryPlace place_of_key(std::string_view key);

}  // namespace calc
