#pragma once
// SHA-256: of input files, for provenance; of what is stored.

#include <string>
#include <string_view>

namespace calc {

// SHA-256 in lower-case hexadecimal, 64 characters. Throws std::runtime_error if OpenSSL cannot do
// it.
std::string sha256_hex(std::string_view bytes);
// The same as 32 bytes.
std::string sha256(std::string_view bytes);

}  // namespace calc
