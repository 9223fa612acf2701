#pragma once
// An IFC file as a design whose things are taken by the rules of a map.

#include "report/tools/import/design.h"
#include "report/tools/import/import_map.h"

#include <optional>
#include <string>
#include <string_view>

namespace cli {

// A room is taken by the first [[room]] whose `layer` fits its number, name, use or storey; one
// without a `layer` fits all. Its height is that of the file. Furniture is taken by the `type` that
// fits its name; luminaires by that of their type, at the height that the map says. `ignore` names
// types of luminaires, too. unit: m, cm, mm, in or ft instead of the file's; "" = the map's, else
// the file's. Empty if and only if `problem` says why.
std::optional<Design> design_of_ifc(std::string_view bytes, const std::string& file,
                                    const ImportMap& map, const std::string& unit,
                                    std::string& problem);

// All of the file, taken by no rule; unit and problem as above.
std::optional<Design> ifc_without_map(std::string_view bytes, const std::string& file,
                                      const std::string& unit, std::string& problem);

// A map to start from: storeys, names of rooms, types of luminaires and furniture with counts, as
// comments. It is read as it is, but the blanks that it leaves are the user's to fill in.
std::optional<std::string> suggest_ifc_map(std::string_view bytes, const std::string& file,
                                           const std::string& unit, std::string& problem);

}  // namespace cli
