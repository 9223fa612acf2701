// Lists of luminaires.
#include "calc/project/reading/luminaire_list_csv.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

#include <cmath>
#include <set>

namespace {

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_entry(const calc::LuminaireEntry& entry) {
  fuzz::require(is_finite(entry.position_m), "the position is finite");
  fuzz::require(std::isfinite(entry.rotation_rad), "the rotation is finite");
  fuzz::require(!entry.axis || !entry.aim_m, "axis and aim exclude each other");
  if (entry.axis) {
    fuzz::require(is_finite(*entry.axis) && *entry.axis != glm::dvec3(0.0),
                  "the axis has a length");
  }
  if (entry.aim_m) fuzz::require(is_finite(*entry.aim_m), "the aim is finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  calc::Diagnostics diagnostics;
  const auto list = calc::parse_luminaire_list(fuzz::as_text(data, size), "a.csv", diagnostics);
  fuzz::check_messages(list.has_value(), diagnostics);
  if (!list) return 0;
  fuzz::require(!list->entry.empty(), "a list has an entry");
  std::set<std::string> names;
  for (const calc::LuminaireEntry& entry : list->entry) {
    fuzz::require(names.insert(entry.name).second, "no name twice");
    check_entry(entry);
  }
  return 0;
}
