#pragma once
// In which unit a drawing is, which its header often has wrong.

#include <optional>
#include <string>
#include <vector>

namespace cli {

struct ImportUnit {
  std::string name, reason;  // as Design::unit
  std::string problem;       // in words: then there is no unit
};
// stated: by --unit, else by the map; "" = by nobody. area_units: of the rooms' outlines, in square
// units of the file. The header is believed only where the median room would have 1.5 to 900 m2:
// within that, millimetres taken for inches or the other way round are always seen; and not of
// DIALux, which writes inches whatever it means.
ImportUnit choose_unit(const std::string& stated, const std::string& stated_by,
                       std::optional<int> header, bool is_dialux, std::vector<double> area_units);

}  // namespace cli
