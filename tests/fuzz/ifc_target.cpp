// IFC files.
#include "report/tools/import/ifc_design.h"

#include "calc/base/utf8.h"
#include "calc/scene/polygon.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

#include <cmath>
#include <set>
#include <string>

namespace {

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_text(const std::string& text) {
  fuzz::require(text == calc::printable(text), "a text is one line of UTF-8");
}

void check_turn(double rotation_deg) {
  fuzz::require(rotation_deg >= 0.0 && rotation_deg < 360.0, "a rotation is in [0, 360)");
}

void check_ring(const std::vector<glm::dvec2>& ring, bool is_hole) {
  fuzz::require((calc::signed_area(ring) < 0.0) == is_hole, "outlines run as they should");
  for (const glm::dvec2& p : ring) {
    fuzz::require(is_finite(glm::dvec3(p, 0.0)), "outlines are finite");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cli::StepProblem problem;
  const auto design = cli::read_ifc(fuzz::as_text(data, size), "a.ifc", {}, problem);
  if (!design) {
    fuzz::require(!problem.what.empty(), "a file that is refused has a reason");
    check_text(problem.what);
    return 0;
  }
  fuzz::count_result();
  std::set<std::string> keys;
  const auto check_source = [&](const cli::DesignSource& source) {
    fuzz::require(!source.key.empty() && keys.insert(source.key).second, "keys are unique");
    check_text(source.key);
  };
  for (const cli::DesignRoom& room : design->room) {
    check_source(room.source);
    for (const std::string& text : {room.number, room.name, room.use, room.storey}) {
      check_text(text);
    }
    check_ring(room.outline_m, false);
    for (const auto& hole : room.hole_m) check_ring(hole, true);
    fuzz::require(std::isfinite(room.floor_z_m) && room.height_m && *room.height_m > 0.0 &&
                      std::isfinite(*room.height_m),
                  "a room has a floor and a height");
  }
  for (const cli::DesignLuminaire& one : design->luminaire) {
    check_source(one.source);
    check_text(one.type);
    fuzz::require(!one.type.empty(), "a luminaire has a type");
    fuzz::require(is_finite(one.position_m), "luminaires are somewhere");
    check_turn(one.rotation_deg);
    for (const auto& [name, value] : one.attribute) {
      check_text(name);
      check_text(value);
    }
  }
  for (const cli::DesignBox& box : design->box) {
    check_source(box.source);
    fuzz::require(is_finite(box.centre_m) && is_finite(box.size_m) && box.size_m.x > 0.0 &&
                      box.size_m.y > 0.0 && box.size_m.z > 0.0,
                  "a box has a size");
    check_turn(box.rotation_deg);
  }
  for (const cli::DesignNote& note : design->note) {
    check_text(note.what);
    check_text(note.why);
  }
  return 0;
}
