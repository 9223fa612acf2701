#pragma once
// What may be required of a plane: one row for each statistic. Readers, judging, reports and
// schemas ask the row; only what a statistic is made of stands elsewhere (rules/measure).

#include "calc/base/names.h"
#include "calc/base/xml_reader.h"
#include "calc/scene/receiver_kernel.h"

#include <string_view>
#include <vector>

namespace rules {

enum class Metric {
  average,             // mean illuminance, lx
  minimum,             // lx
  maximum,             // lx
  uniformity_min_avg,  // Uo = minimum / average
  uniformity_min_max,  // Ud = minimum / maximum
  percentile,          // illuminance that the given share of points does not exceed, lx
  value_at_point,      // lx
  share,               // of the points whose value lies in a range
  power_density,       // installed power of the plane's space / its floor area, W/m2
  power_per_100_lx,    // the same / the plane's average illuminance, W/m2 per 100 lx
  leni,                // lighting energy of the plane's space in a year / its floor area, kWh/m2
  gradient,            // largest ratio between neighbouring points of the grid, >= 1
};

}  // namespace rules

namespace calc {

// As written in projects and packs and shown in reports.
template <>
struct EnumNames<rules::Metric> {
  static constexpr EnumName<rules::Metric> list[] = {
      {rules::Metric::average, "average"},
      {rules::Metric::minimum, "minimum"},
      {rules::Metric::maximum, "maximum"},
      {rules::Metric::uniformity_min_avg, "Uo"},
      {rules::Metric::uniformity_min_max, "Ud"},
      {rules::Metric::percentile, "percentile"},
      {rules::Metric::value_at_point, "value"},
      {rules::Metric::share, "share"},
      {rules::Metric::power_density, "power-density"},
      {rules::Metric::power_per_100_lx, "power-per-100-lx"},
      {rules::Metric::leni, "LENI"},
      {rules::Metric::gradient, "gradient"}};
};

}  // namespace calc

namespace rules {

// What it is computed from.
enum class MetricSource {
  values,           // of the plane's points
  counted_values,   // how many of them lie in a range
  neighbours,       // pairs of points
  space,            // the space alone: known before any light
  space_and_light,  // both
};

// Which quantities of points it has a meaning for.
enum class MetricDomain {
  illuminances,  // an average of ratios or of glare ratings means nothing
  no_ratings,    // and ratios
  all
};

struct MetricRow {
  Metric metric;
  const char* unit;  // of illuminances; "" of ratios
  MetricSource source;
  MetricDomain domain;
  bool is_linear;                   // grows in proportion with the light
  calc::NumberRange ratio_limit{};  // of ratios: what may be required
};

const MetricRow& metric_row(Metric metric);
// Without those about power, which are no statistics of points: as packs have them.
std::vector<std::string_view> metric_names();
// All: as projects have them; those about power at the end.
std::vector<std::string_view> all_metric_names();

// "lx", "" for ratios, "W/m2", "W/m2/100lx", "kWh/m2/a"; of illuminances.
inline const char* metric_unit(Metric metric) { return metric_row(metric).unit; }
bool is_ratio(Metric metric);
bool is_about_power(Metric metric);  // or energy
// Of the plane's space, whatever its light: known beforehand.
bool is_of_space(Metric metric);
// Whether points that measure this have it.
bool is_metric_of(Metric metric, calc::DerivedQuantity derived);

}  // namespace rules
