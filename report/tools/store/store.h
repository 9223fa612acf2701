#pragma once
// `luxgate store`: what is in a store of looks, whether it is whole, and making room.

#include "report/shell/command/command.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace cli {

Command store_command();

// "1500000", "500MB", "2GiB": a whole number and a unit, of B, kB, MB, GB, TB (powers of 1000) or
// KiB, MiB, GiB, TiB (of 1024).
std::optional<std::uint64_t> parse_bytes(std::string_view text);

}  // namespace cli
