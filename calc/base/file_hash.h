#pragma once
// SHA-256 of input files, for provenance, and of stored entries.

#include <string>
#include <string_view>

namespace calc {

// Returns SHA-256 in lower-case hexadecimal, 64 characters. Throws std::runtime_error if OpenSSL
// fails.
std::string sha256_hex(std::string_view bytes);
// Returns the same as 32 bytes.
std::string sha256(std::string_view bytes);

}  // namespace calc
