#pragma once
// The quantities that may be required of a plane, one row each. Readers, judging, reports and
// schemas use these rows. Only the measuring (rules/measure) and the words (METRIC_TEXT in
// report/text/english.def) are elsewhere.

#include "calc/base/names.h"
#include "calc/base/xml_reader.h"
#include "calc/scene/receiver_kernel.h"
#include "rules/catalogue/metric_arguments.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

namespace rules {

enum class Metric {
  average,  // mean illuminance
  minimum,
  maximum,
  uniformity_min_avg,  // Uo = minimum / average
  uniformity_min_max,  // Ud = minimum / maximum
  percentile,          // value that the given share of points does not exceed
  value_at_point,
  share,                // of the points whose value lies in a range
  power_density,        // installed power of the plane's space / its floor area
  power_per_100_lx,     // the same / the plane's average illuminance
  leni,                 // lighting energy of the plane's space in a year / its floor area
  gradient,             // largest ratio between neighbouring points of the grid, >= 1
  ugr_table,            // glare rating of the plane's space by the tabular method
  road_luminance,       // average luminance of a carriageway, of the worst observer
  road_uniformity,      // overall uniformity Uo of that luminance
  road_lengthwise,      // longitudinal uniformity Ul, of the worst lane
  threshold_increment,  // TI, disability glare on a road, of the worst observer
  edge_ratio,           // edge illuminance ratio REI, of the darker edge
  glare_rating,         // GR of a field outdoors, of the worst observer above its points
  upward_share,         // ULR of the space's luminaires as mounted
  intensity,            // the greatest of one luminaire towards the plane's points
  glare_intensity,      // the greatest of one luminaire 60 to 90 degrees from the vertical
  peak_intensity,       // the greatest of one luminaire in any direction
  luminaire_distance,   // in plan, from a point of the plane to the nearest luminaire
  colour_rendering,     // least Ra of the space's luminaires, as their makers state it
};

// The input that a metric is computed from.
enum class MetricSource {
  values,           // of the plane's points
  counted_values,   // how many of them lie in a range
  neighbours,       // pairs of points
  space,            // the space alone: known before any light
  space_in_scene,   // the same, with the scene's levels: calculated without a sample
  road,             // likewise, of the carriageway of a road
  luminaires,       // likewise, of luminaires as such: what they send where, and where they are
  space_and_light,  // the space, and values of the plane's points
};

// The quantities of points for which a metric is defined.
enum class MetricDomain {
  illuminances,  // an average of ratios or of glare ratings means nothing
  no_ratings,    // and ratios
  all
};

struct MetricRow {
  Metric metric;
  std::string_view name;  // as written in projects and packs and shown in reports
  const char* unit;       // of illuminances; "" of ratios
  MetricSource source;
  MetricDomain domain;              // beyond illuminances: compute_derived() measures it, too
  bool is_linear;                   // grows in proportion with the light
  calc::NumberRange ratio_limit{};  // of ratios: what may be required
  MetricArguments arguments{};      // what it needs beside the light; only the kind counts
};

// In the order of the enumeration.
inline constexpr std::array kMetrics = [] {
  using enum Metric;
  using enum MetricSource;
  using enum MetricDomain;
  constexpr calc::NumberRange kNone{};
  constexpr calc::NumberRange kShare{0.0, 1.0, false, "a ratio from 0 to 1"};
  constexpr calc::NumberRange kEdgeRatio{0.0, 10.0, false, "a ratio from 0 to 10"};
  constexpr calc::NumberRange kGradient{1.0, 1.0e9, false, "a ratio from 1 to 1e9"};
  return std::array{
      MetricRow{average, "average", "lx", values, illuminances, true},
      MetricRow{minimum, "minimum", "lx", values, no_ratings, true},
      MetricRow{maximum, "maximum", "lx", values, all, true},
      MetricRow{uniformity_min_avg, "Uo", "", values, illuminances, false, kShare},
      MetricRow{uniformity_min_max, "Ud", "", values, illuminances, false, kShare},
      MetricRow{percentile, "percentile", "lx", values, no_ratings, true, kNone, Percentile{}},
      MetricRow{value_at_point, "value", "lx", values, all, true, kNone, PointOfValue{}},
      MetricRow{share, "share", "", counted_values, all, false, kShare, ValueRange{}},
      MetricRow{power_density, "power-density", "W/m2", space, all, false},
      MetricRow{power_per_100_lx, "power-per-100-lx", "W/m2/100lx", space_and_light, illuminances,
                false, kNone, SpacePower{}},
      MetricRow{leni, "LENI", "kWh/m2/a", space, all, false},
      MetricRow{gradient, "gradient", "", neighbours, illuminances, false, kGradient},
      MetricRow{ugr_table, "UGR-table", "", space_in_scene, all, false},
      MetricRow{road_luminance, "road-luminance", "cd/m2", road, all, true},
      MetricRow{road_uniformity, "road-Uo", "", road, all, false, kShare},
      MetricRow{road_lengthwise, "road-Ul", "", road, all, false, kShare},
      MetricRow{threshold_increment, "TI", "%", road, all, false},
      MetricRow{edge_ratio, "REI", "", road, all, false, kEdgeRatio},
      MetricRow{glare_rating, "GR", "", space_and_light, illuminances, false, kNone, LitField{}},
      MetricRow{upward_share, "ULR", "%", luminaires, all, false},
      MetricRow{intensity, "intensity", "cd", luminaires, all, true},
      MetricRow{glare_intensity, "glare-intensity", "cd", luminaires, all, true, kNone,
                HeightRange{}},
      MetricRow{peak_intensity, "peak-intensity", "cd", luminaires, all, true, kNone,
                HeightRange{}},
      MetricRow{luminaire_distance, "luminaire-distance", "m", luminaires, all, false},
      MetricRow{colour_rendering, "Ra", "", space, all, false},
  };
}();

static_assert(
    [] {
      for (std::size_t i = 0; i < kMetrics.size(); ++i) {
        if (static_cast<std::size_t>(kMetrics[i].metric) != i) return false;
      }
      return true;
    }(),
    "kMetrics is in the order of the enum");

constexpr const MetricRow& metric_row(Metric metric) {
  return kMetrics[static_cast<std::size_t>(metric)];
}
// Returns the names in packs, without metrics of the plane's space, which are no statistics of
// points.
std::vector<std::string_view> metric_names();
// Returns all names, as projects have them; those about the space are last.
std::vector<std::string_view> all_metric_names();

// Returns the unit for illuminances: "lx", "" for ratios, "W/m2", "W/m2/100lx", "kWh/m2/a", "cd",
// ...
inline const char* metric_unit(Metric metric) { return metric_row(metric).unit; }
bool is_ratio(Metric metric);  // of two values of one plane
// Returns whether it is power, energy, glare or colour rendering of the plane's space, about its
// luminaires as such, or a road's luminance.
bool is_about_space(Metric metric);
// Returns whether its unit is calc::unit_of() the points' quantity.
bool has_unit_of_values(Metric metric);
// Returns whether it is a value of the space known beforehand, without light at its points.
bool is_of_space(Metric metric);
// Returns whether it is one of these that depends on the levels of a scene.
bool is_of_space_in_scene(Metric metric);
// Returns whether it depends on emitted light, not only on power or places of luminaires.
bool is_of_light(Metric metric);
// Returns whether it is about the carriageway of a road.
bool is_of_road(Metric metric);
// Returns whether it is about luminaires as such.
bool is_of_luminaires(Metric metric);
// Returns whether it is one of these as seen from the plane's points.
bool is_of_points(Metric metric);
// Returns whether it is one of these for luminaires at certain mounting heights.
constexpr bool has_mounting_heights(Metric metric) {
  return std::holds_alternative<HeightRange>(metric_row(metric).arguments);
}
// Returns whether it is defined for points with this quantity.
bool is_metric_of(Metric metric, calc::DerivedQuantity derived);

}  // namespace rules

namespace calc {

template <>
struct EnumNames<rules::Metric> {
  static constexpr std::array list = [] {
    std::array<EnumName<rules::Metric>, rules::kMetrics.size()> names{};
    for (std::size_t i = 0; i < names.size(); ++i) {
      names[i] = {rules::kMetrics[i].metric, rules::kMetrics[i].name};
    }
    return names;
  }();
};

}  // namespace calc
