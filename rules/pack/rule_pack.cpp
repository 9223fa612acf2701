#include "rules/pack/rule_pack.h"

#include "calc/base/sentences.h"
#include "calc/scene/sensor_grid.h"
#include "rules/pack/builtin_packs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <variant>

namespace rules {
namespace {

using calc::ReceiverKernel;

constexpr std::array kQuantities{
    Quantity{"planar", Dimension::illuminance, ReceiverKernel::planar},
    Quantity{"cylindrical", Dimension::illuminance, ReceiverKernel::cylindrical},
    Quantity{"semicylindrical", Dimension::illuminance, ReceiverKernel::semicylindrical},
    Quantity{"hemispherical", Dimension::illuminance, ReceiverKernel::hemispherical},
    Quantity{"scalar", Dimension::illuminance, ReceiverKernel::scalar},
    Quantity{"modelling", Dimension::plain, ReceiverKernel::cylindrical,
             calc::DerivedQuantity::modelling},
    Quantity{"UGR", Dimension::plain, ReceiverKernel::planar, calc::DerivedQuantity::ugr},
    Quantity{"GR", Dimension::plain, std::nullopt, calc::DerivedQuantity::none,
             Metric::glare_rating},
    Quantity{"Ra", Dimension::plain, std::nullopt, calc::DerivedQuantity::none,
             Metric::colour_rendering},
    Quantity{"luminance", Dimension::luminance, std::nullopt},
    Quantity{"power-density", Dimension::power_density, std::nullopt, calc::DerivedQuantity::none,
             Metric::power_density},
    Quantity{"LENI", Dimension::energy_density, std::nullopt, calc::DerivedQuantity::none,
             Metric::leni},
    Quantity{"UGR-table", Dimension::plain, std::nullopt, calc::DerivedQuantity::none,
             Metric::ugr_table},
    Quantity{"road-luminance", Dimension::luminance, std::nullopt, calc::DerivedQuantity::none,
             Metric::road_luminance},
    Quantity{"road-Uo", Dimension::plain, std::nullopt, calc::DerivedQuantity::none,
             Metric::road_uniformity},
    Quantity{"road-Ul", Dimension::plain, std::nullopt, calc::DerivedQuantity::none,
             Metric::road_lengthwise},
    Quantity{"TI", Dimension::plain, std::nullopt, calc::DerivedQuantity::none,
             Metric::threshold_increment},
    Quantity{"REI", Dimension::plain, std::nullopt, calc::DerivedQuantity::none,
             Metric::edge_ratio},
    Quantity{"ULR", Dimension::plain, std::nullopt, calc::DerivedQuantity::none,
             Metric::upward_share},
    Quantity{"intensity", Dimension::intensity, std::nullopt, calc::DerivedQuantity::none,
             Metric::intensity},
    Quantity{"glare-intensity", Dimension::intensity, std::nullopt, calc::DerivedQuantity::none,
             Metric::glare_intensity},
    Quantity{"peak-intensity", Dimension::intensity, std::nullopt, calc::DerivedQuantity::none,
             Metric::peak_intensity},
    Quantity{"luminaire-distance", Dimension::length, std::nullopt, calc::DerivedQuantity::none,
             Metric::luminaire_distance},
};

template <class Item, class Key>
const Item* find_item(const std::vector<Item>& items, std::string_view wanted, Key key) {
  const auto found = std::find_if(items.begin(), items.end(),
                                  [&](const Item& item) { return item.*key == wanted; });
  return found == items.end() ? nullptr : &*found;
}

}  // namespace

calc::Message trust_remark(Trust trust) {
  switch (trust) {
    case Trust::confirmed:
      break;
    case Trust::single_source:
      return calc::say<calc::Sentence::one_source>();
    case Trust::unverified:
      return calc::say<calc::Sentence::unverified>();
  }
  return {};
}

calc::Message with_trust(const calc::Message& name, Trust trust) {
  switch (trust) {
    case Trust::confirmed:
      break;
    case Trust::single_source:
      return calc::say<calc::Sentence::one_source_of>(name);
    case Trust::unverified:
      return calc::say<calc::Sentence::unverified_of>(name);
  }
  return name;
}

const Quantity* quantity_from_name(std::string_view name) {
  for (const Quantity& quantity : kQuantities) {
    if (name == quantity.name) return &quantity;
  }
  return nullptr;
}

calc::Names quantity_names() {
  calc::Names names;
  for (const Quantity& quantity : kQuantities) names.emplace_back(quantity.name);
  return names;
}

const RuleValue* RuleRow::find_value(std::string_view parameter) const {
  return find_item(values, parameter, &RuleValue::parameter);
}

bool RuleRow::has_modified_level() const {
  return std::any_of(values.begin(), values.end(),
                     [](const RuleValue& value) { return value.modified.has_value(); });
}

calc::Names RulePack::levels_of(const RuleRow& row) const {
  const auto may_step = [&](int steps) {
    return std::any_of(row.values.begin(), row.values.end(), [&](const RuleValue& value) {
      const RuleScale* scale = find_scale_of(value.parameter);
      return value.required.has_value() && scale != nullptr && -scale->most_down <= steps &&
             steps <= scale->most_up;
    });
  };
  calc::Names names;
  for (const auto& name : level_names()) {
    const RowLevel level = level_named(name);
    const bool is_there = level == RowLevel::required ||
                          (level.is_modified ? row.has_modified_level() : may_step(level.steps));
    if (is_there) names.push_back(name);
  }
  return names;
}

const RuleRow* RulePack::find_row(std::string_view ref) const {
  return find_item(rows, ref, &RuleRow::ref);
}
const RuleSpecial* RuleCheck::find_special(calc::SpecialPlace place, const RuleRow* row) const {
  for (const RuleSpecial& special : specials) {
    const bool is_for_row = special.rows.empty() ||
                            (row != nullptr && std::find(special.rows.begin(), special.rows.end(),
                                                         row->ref) != special.rows.end());
    if (special.place == place && is_for_row) return &special;
  }
  return nullptr;
}

MetricArguments RuleCheck::arguments_of(Metric measured) const {
  MetricArguments arguments = metric_row(measured).arguments;
  if (auto* of = std::get_if<Percentile>(&arguments)) *of = {percent};
  if (auto* values = std::get_if<ValueRange>(&arguments)) *values = range;
  if (auto* heights = std::get_if<HeightRange>(&arguments)) *heights = {range.from, range.to};
  return arguments;
}

const RuleCheck* RulePack::find_check(std::string_view check_id) const {
  return find_item(checks, check_id, &RuleCheck::id);
}
const RuleTable* RulePack::find_table(std::string_view table_id) const {
  return find_item(tables, table_id, &RuleTable::id);
}
const RuleScale* RulePack::find_scale(std::string_view scale_id) const {
  return find_item(scales, scale_id, &RuleScale::id);
}
const RuleScale* RulePack::find_scale_of(std::string_view parameter_id) const {
  return find_item(scales, parameter_id, &RuleScale::parameter);
}
const RuleName* RulePack::find_parameter(std::string_view parameter_id) const {
  return find_item(parameters, parameter_id, &RuleName::id);
}
const RuleName* RulePack::find_fact(std::string_view fact_id) const {
  return find_item(facts, fact_id, &RuleName::id);
}

const RuleGrid* RulePack::find_grid(std::string_view grid_id) const {
  return find_item(grids, grid_id, &RuleGrid::id);
}
const RulePlane* RulePack::find_plane(std::string_view role_name) const {
  return find_item(planes, role_name, &RulePlane::role);
}

std::vector<std::string> RulePack::roles() const {
  std::vector<std::string> roles;
  for (const RuleCheck& check : checks) {
    if (std::find(roles.begin(), roles.end(), check.role) == roles.end()) {
      roles.push_back(check.role);
    }
  }
  return roles;
}

namespace {

bool is_of_task(const RulePlane& plane) {
  return plane.area == ZoneArea::task || (plane.area == ZoneArea::band && !plane.height_m);
}

}  // namespace

std::string orientation_of(const RulePlane& plane, const RuleRow* row) {
  const bool is_of_row = row != nullptr && !row->task_orientation.empty() && is_of_task(plane);
  return is_of_row ? row->task_orientation : plane.orientation;
}

std::optional<RuleRow::Heights> heights_of(const RulePlane& plane, const RuleRow* row) {
  const bool is_upright = plane.orientation == kUpright;
  const bool follows_task = is_of_task(plane) || (is_upright && !plane.has_heights);
  const bool has_own = plane.has_heights || is_upright;
  if (follows_task && has_own && row != nullptr && row->task_heights_m) return row->task_heights_m;
  if (orientation_of(plane, row) != plane.orientation) return std::nullopt;
  if (!plane.has_heights) return std::nullopt;
  return RuleRow::Heights{plane.lowest_m, plane.highest_m};
}

double margin_in_room_m(const RulePlane& plane, double width_m) {
  if (!(width_m < plane.narrow_m)) return plane.margin_m;
  return std::min(plane.margin_m, plane.narrow_share * width_m);
}

std::string grid_text(const RuleGrid& grid) {
  std::string text = "as the project says";
  if (grid.rule) {
    if (const auto* formula = std::get_if<calc::GridByRule>(&*grid.rule)) {
      text = fmt::format(
          "p = {:g} * {:g}^log10 d m, at most {:g} m; d the longer side, the shorter one from a "
          "ratio of {:g} on; counts rounded: {}",
          formula->factor_m, formula->base, formula->max_spacing_m, formula->shorter_from_ratio,
          calc::name_of(formula->rounding));
    } else if (const auto* spacing = std::get_if<calc::GridBySpacing>(&*grid.rule)) {
      text = fmt::format("at most {:g} m along the longer and {:g} m along the shorter side",
                         spacing->along_u_m, spacing->along_v_m);
      if (grid.least.columns > 1 || grid.least.rows > 1) {
        text += fmt::format(", at least {} x {} points", grid.least.columns, grid.least.rows);
      }
    } else {
      const auto& count = std::get<calc::GridByCount>(*grid.rule);
      text = fmt::format("{} cells along the longer and {} along the shorter side", count.columns,
                         count.rows);
    }
  }
  return with_trust(calc::Message::words(text), grid.trust).english();
}

std::vector<RulePack> builtin_rule_packs() {
  std::vector<RulePack> packs;
  for (const std::string_view text : builtin_pack_texts()) {
    calc::Diagnostics diagnostics;
    std::optional<RulePack> pack = parse_rule_pack(text, "built in", diagnostics);
    // Our own file: a test reads every one of them.
    if (!pack) throw std::logic_error(calc::format_diagnostic(diagnostics.all().front()));
    pack->is_built_in = true;
    packs.push_back(std::move(*pack));
  }
  return packs;
}

}  // namespace rules
