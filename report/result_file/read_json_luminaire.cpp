#include "report/result_file/read_json_parts.h"

#include <optional>
#include <string_view>

namespace report {
namespace {

// Either nothing or every step.
std::vector<double> polar_curve(const JsonCursor& polar, std::string_view key) {
  constexpr std::size_t kValues = 2 * kPolarHalfSteps + 1;
  const double step_deg = polar["step_deg"].finite();
  const std::vector<JsonCursor> items = polar[key].items();
  if (items.empty()) return {};
  if (step_deg != kPolarStep_deg || items.size() != kValues)
    polar[key].refuse("145 values, 2.5 degrees apart, are needed");
  std::vector<double> cd;
  for (const JsonCursor& item : items) cd.push_back(item.finite());
  return cd;
}

}  // namespace

LuminaireRow read_luminaire(const JsonCursor& at) {
  LuminaireRow row;
  row.type_id = at["type"].text();
  row.photometry_file = at["photometry_file"].text();
  row.sha256 = at["sha256"].text();
  row.name = at["name"].text();
  row.format = at["format"].text();
  row.count = read_whole(at["count"]);
  row.flux_lm = at["flux_lm"].number();
  row.power_w = at["power_w"].is_null() ? 0.0 : at["power_w"].finite();
  row.max_intensity_cd = at["max_intensity_cd"].number();
  row.maintenance_factor = at["maintenance_factor"].number();
  const JsonCursor parts = at["maintenance_parts"];
  row.maintenance.product = parts["product"].finite();
  row.maintenance.llmf = read_optional_number(parts["llmf"]);
  row.maintenance.lsf = read_optional_number(parts["lsf"]);
  row.maintenance.lmf = read_optional_number(parts["lmf"]);
  row.maintenance.rsmf = read_optional_number(parts["rsmf"]);
  if (const auto polar = at.find("polar")) {
    row.c0_cd = polar_curve(*polar, "c0_cd");
    row.c90_cd = polar_curve(*polar, "c90_cd");
  }
  return row;
}

}  // namespace report
