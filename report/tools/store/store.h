#pragma once
// `luxgate store`: lists and checks a result cache, and frees space.

#include "report/shell/command/command.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace cli {

Command store_command();

// Returns the bytes for "1500000", "500MB", "2GiB": a whole number and a unit, of B, kB, MB, GB, TB
// (powers of 1000) or KiB, MiB, GiB, TiB (of 1024).
std::optional<std::uint64_t> parse_bytes(std::string_view text);

}  // namespace cli
