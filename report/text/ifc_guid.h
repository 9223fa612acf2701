#pragma once
// GlobalIds of an IFC model in ids of imported rooms and luminaires, and GUIDs that depend only on
// names.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// The prefix that an import gives to room ids, before the room's key in its file: for IFC the
// GlobalId.
inline constexpr std::string_view kRoomIdPrefix = "room-";
inline constexpr std::string_view kLuminaireIdPrefix = "L-";
// Replaces the '$' of a GlobalId in ids, which cannot have it.
inline constexpr char kDollarInId = ':';

// Returns the key behind the prefix, with its '$'; "" if the id has another prefix.
std::string key_of_id(std::string_view id, std::string_view prefix);

using Guid = std::array<std::uint8_t, 16>;
// Returns the same GUID for the same names in the same order, on every machine, and different GUIDs
// for other names.
Guid guid_of_names(const std::vector<std::string>& names);
std::string ifc_letters(const Guid& guid);  // 22 of them

}  // namespace report
