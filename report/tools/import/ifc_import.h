#pragma once
// Imports an IFC file as a design by the rules of a map.

#include "report/tools/import/design.h"
#include "report/tools/import/import_map.h"

#include <optional>
#include <string>
#include <string_view>

namespace cli {

// Returns the design. A room is imported by the first [[room]] whose `layer` matches its number,
// name, use or storey; without a `layer` it matches all. Its height is that of the file. Furniture
// is imported by the `type` that matches its name; luminaires by that of their type, at the map's
// height. `ignore` names types of luminaires, too. unit: m, cm, mm, in or ft instead of the file's;
// "" = the map's, else the file's. Empty exactly if `problem` says why.
std::optional<Design> design_of_ifc(std::string_view bytes, const std::string& file,
                                    const ImportMap& map, const std::string& unit,
                                    std::string& problem);

// Returns all of the file, without rules; unit and problem as above.
std::optional<Design> ifc_without_map(std::string_view bytes, const std::string& file,
                                      const std::string& unit, std::string& problem);

// Returns a map to start from: storeys, names of rooms, types of luminaires and furniture with
// counts, as comments. It can be read as it is, but users must fill in its blanks.
std::optional<std::string> suggest_ifc_map(std::string_view bytes, const std::string& file,
                                           const std::string& unit, std::string& problem);

}  // namespace cli
