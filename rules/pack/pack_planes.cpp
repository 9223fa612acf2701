#include "calc/base/diagnostic_ids.h"
#include "rules/pack/pack_parts.h"

#include "rules/pack/pack_elements.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace rules {
namespace {

using calc::DiagnosticId;
using calc::ElementReader;

// Reads the area that a workplace makes of a <plane>, or the relation of a drawn plane to others.
void read_zone(ElementReader& reader, RulePlane& plane) {
  if (reader.has("holds")) {
    plane.holds = reader.id("holds");
    reader.exclude("area", "holds");
  }
  constexpr std::array kAreas{ZoneArea::task, ZoneArea::band, ZoneArea::task_and_band,
                              ZoneArea::walls, ZoneArea::ceiling};
  if (!reader.has("area")) {
    for (const char* name : {"height", "margin", "narrow-below", "narrow-share"}) {
      if (reader.has(name)) reader.require_together(name, "area");
    }
    reader.require_together("around", "width");
    if (reader.has("around")) {
      plane.around = reader.id("around");
      plane.width_m = reader.number("width", calc::kPositive);
    }
    return;
  }
  plane.area = kAreas[reader.choice("area", kZoneAreaType.words)];
  const bool is_band = plane.area == ZoneArea::band;
  const bool has_width = is_band || plane.area == ZoneArea::task_and_band;
  const bool is_surface = plane.area == ZoneArea::walls || plane.area == ZoneArea::ceiling;
  const auto refuse = [&](const char* name, bool is_fit) {
    if (is_fit || !reader.has(name)) return;
    reader.report(DiagnosticId::attribute_without_meaning, reader.where(name), "plane", name,
                  "area");
  };
  refuse("around", is_band);
  refuse("width", has_width);
  refuse("height", !is_surface);
  refuse("narrow-below", !is_surface);
  if (is_band) plane.around = reader.id("around");
  if (has_width) {
    plane.width_m = reader.number("width", is_band ? calc::kPositive : calc::kNonNegative);
  }
  plane.height_m = reader.optional_number("height", calc::kNonNegative);
  plane.margin_m = reader.number_or("margin", calc::kNonNegative, 0.0);
  reader.require_together("narrow-below", "narrow-share");
  plane.narrow_m = reader.number_or("narrow-below", calc::kPositive, 0.0);
  plane.narrow_share = reader.number_or("narrow-share", kStripShare, 0.0);
  if (plane.area == ZoneArea::task && !plane.height_m) reader.number("height", calc::kNonNegative);
}

constexpr std::size_t kFormula = 0, kFixedSpacing = 1, kFixedCount = 2;  // methods of <grid>
constexpr const char* kTwoNumbers = "2 whole numbers (along the longer and the shorter side)";
constexpr calc::NumberRange kGridBase{1.0, 100.0, true, "a number above 1, up to 100"};
constexpr calc::NumberRange kSideRatio{1.0, 1.0e9, false, "a number from 1 to 1e9"};

// Checks the attributes: every method has its own numbers and its own rounding.
void check_grid_attributes(ElementReader& reader, std::size_t method, std::size_t count) {
  if (!reader.ok()) return;
  const auto refuse = [&](const char* name) {
    reader.report(DiagnosticId::attribute_without_meaning, reader.where(name), "grid", name,
                  "method");
  };
  for (const char* name : {"factor", "base", "max-spacing", "ratio"}) {
    if (reader.has(name) && method != kFormula) refuse(name);
  }
  for (const char* name : {"spacing", "least"}) {
    if (reader.has(name) && method != kFixedSpacing) refuse(name);
  }
  if (reader.has("cells") && method != kFixedCount) refuse("cells");
  constexpr std::size_t kUp = 1, kGiven = 3;
  const bool fits = method == kFormula        ? count != kGiven
                    : method == kFixedSpacing ? count == kUp
                                              : count == kGiven;
  if (!fits) refuse("count");
}

}  // namespace

RuleGrid read_grid(const calc::XmlElement& element, calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kGridElement);
  const std::size_t method = reader.choice("method", kGridMethodType.words);
  const std::size_t count = reader.choice("count", kGridCountType.words);
  RuleGrid grid;
  grid.id = reader.id();
  grid.trust = read_trust(reader);
  grid.note = reader.text_or("note", "");
  check_grid_attributes(reader, method, count);
  if (method == kFormula) {
    calc::GridByRule rule;
    rule.factor_m = reader.number_or("factor", calc::kPositive, rule.factor_m);
    rule.base = reader.number_or("base", kGridBase, rule.base);
    rule.max_spacing_m = reader.number_or("max-spacing", calc::kPositive, rule.max_spacing_m);
    rule.shorter_from_ratio = reader.number_or("ratio", kSideRatio, rule.shorter_from_ratio);
    rule.rounding = static_cast<calc::GridRounding>(std::min<std::size_t>(count, 2));
    grid.rule = rule;
  } else if (method == kFixedSpacing) {
    const std::vector<double> spacing = reader.number_groups(
        "spacing", 1, 1, 2, "1 or 2 numbers (along the longer and the shorter side)",
        calc::kPositive);
    if (!spacing.empty()) grid.rule = calc::GridBySpacing{spacing.front(), spacing.back(), {}};
    if (reader.has("least")) {
      const std::vector<int> least = reader.integers("least", 2, kTwoNumbers, 1);
      grid.least = {least[0], least[1]};
    }
  } else if (method == kFixedCount) {
    const std::vector<int> cells = reader.integers("cells", 2, kTwoNumbers, 1);
    grid.rule = calc::GridByCount{cells[0], cells[1]};
  }
  return grid;
}

RulePlane read_plane(const calc::XmlElement& element, const RulePack& pack,
                     calc::Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kPlaneElement);
  RulePlane plane;
  plane.role = reader.id("role");
  plane.orientation = kOrientationType.words[reader.choice("orientation", kOrientationType.words)];
  if (const auto heights = read_heights(reader, "heights")) {
    plane.has_heights = true;
    plane.lowest_m = heights->first;
    plane.highest_m = heights->second;
  }
  plane.are_heights_usual = reader.choice_or("heights-are", kHeightsAreType.words, 0) == 1;
  if (reader.has("heights-are")) reader.require_together("heights-are", "heights");
  read_zone(reader, plane);
  const auto read_one_of = [&](std::string_view attribute, const auto& items) {
    if (!reader.has(attribute)) return std::string();
    const std::string id = reader.id(attribute);
    calc::Names names;
    for (const auto& item : items) names.push_back(item.id);
    if (!id.empty() && std::find(names.begin(), names.end(), id) == names.end()) {
      report_unknown_name(diagnostics, reader.where(attribute), attribute, "plane", attribute, id,
                          names);
    }
    return id;
  };
  plane.grid = read_one_of("grid", pack.grids);
  plane.mask = read_one_of("mask", pack.masks);
  plane.missing_share = reader.number_or("missing", kSmallShare, plane.missing_share);
  plane.note = reader.text_or("note", "");
  return plane;
}

namespace {

// Checks a plane that no workplace makes: it may be drawn around any other plane.
void check_lies_to(const RulePack& pack, const RulePlane& plane, const calc::XmlElement& element,
                   calc::Diagnostics& diagnostics) {
  if (plane.area != ZoneArea::none) return;
  const auto check = [&](const char* attribute, const std::string& role) {
    if (role.empty()) return;
    calc::Names names;
    for (const RulePlane& other : pack.planes) {
      if (&other != &plane) names.emplace_back(other.role);
    }
    if (std::find(names.begin(), names.end(), role) != names.end()) return;
    report_unknown_name(diagnostics, element.where, attribute, "plane", "plane with role", role,
                        names);
  };
  check("around", plane.around);
  check("holds", plane.holds);
}

}  // namespace

void check_zones(const RulePack& pack, const calc::XmlElement& root,
                 calc::Diagnostics& diagnostics) {
  std::size_t index = 0;
  for (const calc::XmlElement& child : root.children) {
    if (child.name != "plane") continue;
    const RulePlane& plane = pack.planes[index++];
    check_lies_to(pack, plane, child, diagnostics);
    if (plane.area != ZoneArea::band) continue;
    calc::Names names;
    const RulePlane* inner = nullptr;
    for (const RulePlane& other : pack.planes) {
      const bool is_inner = &other != &plane && (other.area == ZoneArea::task ||
                                                 (other.area == ZoneArea::band && &other < &plane));
      if (!is_inner) continue;
      names.emplace_back(other.role);
      if (other.role == plane.around) inner = &other;
    }
    if (inner != nullptr || plane.around.empty()) continue;
    report_unknown_name(diagnostics, child.where, "around", "plane",
                        "plane of a task or, before this one, of a band with role", plane.around,
                        names);
  }
}

}  // namespace rules
