// DXF drawings, up to rooms and luminaires.
#include "report/tools/import/dxf_design.h"

#include "calc/scene/polygon.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace {

cli::ImportMap a_map() {
  cli::ImportMap map;
  map.room.push_back({"R*", "N*", 2.8, 0.7, 0.5, 0.2, {}, false, 1});
  map.room.push_back({"DLX_*CONT", "DLX_*DESC", 2.8, 0.7, 0.5, 0.2, {}, true, 1});
  cli::MapLuminaire luminaire;
  luminaire.type = "L*";
  luminaire.height = {cli::FromAttribute{"H"}, cli::FromZ{}, 2.5};
  map.luminaire.push_back(luminaire);
  map.furniture.push_back({"D*", "", 0.75, 0.4, 1});
  map.plane.push_back({"P", 0.75, 1});
  map.route.push_back({"W", 2.0, 1});
  return map;
}

void require(bool is_so) {
  if (!is_so) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string problem;
  const auto drawing = cli::read_dxf(fuzz::as_text(data, size), problem);
  require(drawing.has_value() == problem.empty());
  if (!drawing) return 0;
  const auto design = cli::design_of_dxf(*drawing, "a.dxf", a_map(), "mm", problem);
  require(design.has_value() == problem.empty());
  if (!design) return 0;
  fuzz::count_result();
  for (const cli::DesignRoom& room : design->room) {
    require(room.outline_m.size() >= 3 && calc::signed_area(room.outline_m) > 0.0);
    require(calc::is_simple_polygon(room.outline_m));
  }
  for (const cli::DesignLuminaire& luminaire : design->luminaire) {
    require(std::isfinite(luminaire.position_m.x) && std::isfinite(luminaire.position_m.z));
    require(luminaire.rotation_deg >= 0.0 && luminaire.rotation_deg < 360.0);
  }
  for (const cli::DesignBox& box : design->box) require(box.size_m.x > 0.0 && box.size_m.y > 0.0);
  cli::suggest_map(*drawing, "a.dxf");
  return 0;
}
