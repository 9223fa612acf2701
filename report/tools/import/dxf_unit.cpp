#include "report/tools/import/dxf_unit.h"

#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "report/tools/import/import_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace cli {
namespace {

constexpr double kLowestBelievedArea_m2 = 1.5, kHighestBelievedArea_m2 = 900.0;

std::string unit_of_header(std::optional<int> header) {
  switch (header.value_or(0)) {
    case 1:
      return "in";
    case 2:
      return "ft";
    case 4:
      return "mm";
    case 5:
      return "cm";
    case 6:
      return "m";
    default:
      return "";
  }
}

std::string header_words(std::optional<int> header) {
  const std::string unit = unit_of_header(header);
  if (!unit.empty()) return "the header says " + unit;
  if (!header || *header == 0) return "the header says none";
  return fmt::format("the header says number {}, which is not one of {}", *header,
                     calc::join_choices(kImportUnits));
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// "44.6 m2 in mm, 4460 m2 in cm ..."
std::string areas_in_units(double area) {
  std::string text;
  for (const std::string_view unit : kImportUnits) {
    const double metres = *metres_per_import_unit(unit);
    text +=
        fmt::format("{}{:.3g} m2 in {}", text.empty() ? "" : ", ", area * metres * metres, unit);
  }
  return text;
}

}  // namespace

ImportUnit choose_unit(const std::string& stated, const std::string& stated_by,
                       std::optional<int> header, bool is_dialux, std::vector<double> area_units) {
  ImportUnit unit;
  const std::string by_header = unit_of_header(header);
  if (!stated.empty()) {
    unit.name = stated;
    unit.reason = fmt::format("stated by {}", stated_by);
    if (by_header != stated) unit.reason += "; " + header_words(header);
    return unit;
  }
  const std::string ask =
      "state it by --unit or 'unit' in the map: " + calc::join_choices(kImportUnits);
  const std::string sizes =
      area_units.empty() ? "there is no closed outline of a room to decide by (see 'close' of the "
                           "map for open ones)"
                         : fmt::format("the {} of {} outlines of rooms would have {}", "median",
                                       area_units.size(), areas_in_units(median_of(area_units)));
  if (is_dialux) {
    unit.problem = fmt::format(
        "the unit is not known: {}, and in files of DIALux this value is not reliable; {}; {}",
        header_words(header), sizes, ask);
  } else if (by_header.empty() || area_units.empty()) {
    unit.problem =
        fmt::format("the unit is not known: {}; {}; {}", header_words(header), sizes, ask);
  } else {
    const double metres = *metres_per_import_unit(by_header);
    const double area = median_of(area_units) * metres * metres;
    if (area < kLowestBelievedArea_m2 || area > kHighestBelievedArea_m2) {
      unit.problem = fmt::format("{}, which is unlikely: {}; {}", header_words(header), sizes, ask);
    } else {
      unit.name = by_header;
      unit.reason =
          fmt::format("as the header says; the {} has {:.3g} m2",
                      area_units.size() == 1 ? "only room"
                                             : fmt::format("median of {} rooms", area_units.size()),
                      area);
    }
  }
  return unit;
}

}  // namespace cli
