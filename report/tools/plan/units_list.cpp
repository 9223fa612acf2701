#include "report/tools/plan/units_list.h"

#include "report/text/json_layout.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <exception>
#include <set>
#include <utility>

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "luxgate-units";
constexpr int kFormatVersion = 1;

// Throws where it is no unit.
check::Unit unit_of(const Json& json) {
  check::Unit unit;
  unit.project = json.at("project").get<std::string>();
  unit.space = json.at("space").get<std::string>();
  unit.planes = json.at("planes").get<std::vector<std::string>>();
  unit.is_whole_space = json.at("whole_space").get<bool>();
  unit.points = json.at("points").get<std::size_t>();
  unit.first_look_s = json.at("first_look_s").get<double>();
  if (unit.project.empty() || unit.planes.empty() || !(unit.first_look_s >= 0.0)) {
    throw std::invalid_argument("a job needs a project, planes and seconds from 0");
  }
  return unit;
}

}  // namespace

std::string render_units_text(const std::vector<check::Unit>& units) {
  double sum_s = 0.0, largest_s = 0.0;
  std::size_t points = 0;
  for (const check::Unit& unit : units) {
    sum_s += unit.first_look_s;
    largest_s = std::max(largest_s, unit.first_look_s);
    points += unit.points;
  }
  std::string text = fmt::format("{:>9}  {:>9}  unit\n", "seconds", "points");
  for (const check::Unit& unit : units) {
    text += fmt::format("{:>9.3g}  {:>9}  {}\n", unit.first_look_s,
                        report::format_count(unit.points), report::printable(unit_name(unit)));
  }
  return text +
         fmt::format(
             "\n{} jobs, {} points; the first sampling round takes {:.3g} s of one core in total "
             "and {:.3g} s for the largest job; the number of further rounds is not known yet\n",
             units.size(), report::format_count(points), sum_s, largest_s);
}

std::string render_units_json(const std::vector<check::Unit>& units) {
  Json list = Json::array();
  for (const check::Unit& unit : units) {
    list.push_back({{"project", unit.project},
                    {"space", unit.space},
                    {"planes", unit.planes},
                    {"whole_space", unit.is_whole_space},
                    {"points", unit.points},
                    {"first_look_s", unit.first_look_s}});
  }
  return report::json_layout(
      {{"format", kFormat}, {"format_version", kFormatVersion}, {"units", std::move(list)}});
}

std::optional<std::vector<check::Unit>> read_units(const std::string& file,
                                                   const calc::FileReader& files,
                                                   std::string& problem) {
  const calc::FileContent content = files.read(file);
  if (!content.ok()) {
    problem = content.error;
    return std::nullopt;
  }
  try {
    const Json json = Json::parse(content.bytes);
    if (json.at("format") != kFormat || json.at("format_version") != kFormatVersion) {
      throw std::invalid_argument(
          fmt::format("its format is not '{}' {}", kFormat, kFormatVersion));
    }
    std::vector<check::Unit> units;
    if (!json.at("units").is_array()) throw std::invalid_argument("its 'units' is not a list");
    for (const Json& unit : json.at("units")) units.push_back(unit_of(unit));
    return units;
  } catch (const std::exception& error) {
    problem = error.what();
    return std::nullopt;
  }
}

}  // namespace cli
