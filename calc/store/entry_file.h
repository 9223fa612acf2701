#pragma once
// The file of one entry as bytes: magic, format version, lengths, key, bytes, SHA-256 of all of
// these.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace calc {

inline constexpr std::uint32_t kEntryFormat = 1;

std::string render_entry(std::string_view key, std::string_view bytes);
// Returns the size of the file for these lengths.
std::size_t entry_file_bytes(std::size_t key_bytes, std::size_t bytes);

// Views into the file's bytes; or `problem` states why it is not a whole entry of this format.
struct ParsedEntry {
  std::string_view key, bytes;
  std::string problem;
};
ParsedEntry parse_entry(std::string_view file);

// Returns whether a file begins like an entry of any format.
bool begins_as_entry(std::string_view file);

// The place of an entry's file: "ab/cdef...", the SHA-256 of the key.
struct EntryPlace {
  std::string folder, file;
};
EntryPlace place_of_key(std::string_view key);

}  // namespace calc
