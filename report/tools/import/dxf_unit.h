#pragma once
// Chooses the unit of a drawing, which its header often has wrong.

#include <optional>
#include <string>
#include <vector>

namespace cli {

struct ImportUnit {
  std::string name, reason;  // as Design::unit
  std::string problem;       // in words: then there is no unit
};
// Returns the unit. stated: by --unit, else by the map; "" = neither. area_units: of the rooms'
// outlines, in square units of the file. The header counts only if the median room then has 1.5 to
// 900 m2, which detects millimetres taken for inches and the reverse; and not for DIALux, which
// always writes inches.
ImportUnit choose_unit(const std::string& stated, const std::string& stated_by,
                       std::optional<int> header, bool is_dialux, std::vector<double> area_units);

}  // namespace cli
