#pragma once
// Fingerprints of input files, for provenance.

#include <string>
#include <string_view>

namespace calc {

// SHA-256 in lower-case hexadecimal, 64 characters. Throws std::runtime_error if OpenSSL cannot do
// it.
std::string sha256_hex(std::string_view bytes);

}  // namespace calc
