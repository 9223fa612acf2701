#pragma once
// What ids of imported rooms and luminaires say of the IFC model that they are from, and GUIDs that
// hang on nothing but names.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// An import calls a room so, and then the key that it has in its file: of IFC the GlobalId.
inline constexpr std::string_view kRoomIdPrefix = "room-";
inline constexpr std::string_view kLuminaireIdPrefix = "L-";
// Stands in an id for the '$' of a GlobalId, which ids cannot have.
inline constexpr char kDollarInId = ':';

// The key behind the prefix, with its '$'; "" if the id does not begin so.
std::string key_of_id(std::string_view id, std::string_view prefix);

using Guid = std::array<std::uint8_t, 16>;
// The same for the same names in the same order, on every machine; others for all others.
Guid guid_of_names(const std::vector<std::string>& names);
std::string ifc_letters(const Guid& guid);  // 22 of them

}  // namespace report
