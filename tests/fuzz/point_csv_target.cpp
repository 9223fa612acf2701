// Lists of points.
#include "calc/project/reading/point_list_csv.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  calc::Diagnostics diagnostics;
  const auto list = calc::parse_point_list(fuzz::as_text(data, size), "a.csv", diagnostics);
  fuzz::check_messages(list.has_value(), diagnostics);
  if (!list) return 0;
  fuzz::require(!list->position_m.empty(), "a list has a point");
  fuzz::require(list->position_m.size() == list->normal.size() &&
                    list->position_m.size() == list->line.size(),
                "a normal and a line for each point");
  fuzz::check_triangles(list->position_m, {});
  for (const glm::dvec3& normal : list->normal) {
    fuzz::require(std::abs(glm::length(normal) - 1.0) < 1e-9, "normals are unit vectors");
  }
  return 0;
}
