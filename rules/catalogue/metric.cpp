#include "rules/catalogue/metric.h"

#include <array>
#include <cstddef>

namespace rules {
namespace {

using enum MetricSource;
using enum MetricDomain;

constexpr calc::NumberRange kShare{0.0, 1.0, false, "a ratio from 0 to 1"};
constexpr calc::NumberRange kGradient{1.0, 1.0e9, false, "a ratio from 1 to 1e9"};

// In the order of the enumeration.
constexpr std::array kMetrics{
    MetricRow{Metric::average, "lx", values, illuminances, true},
    MetricRow{Metric::minimum, "lx", values, no_ratings, true},
    MetricRow{Metric::maximum, "lx", values, all, true},
    MetricRow{Metric::uniformity_min_avg, "", values, illuminances, false, kShare},
    MetricRow{Metric::uniformity_min_max, "", values, illuminances, false, kShare},
    MetricRow{Metric::percentile, "lx", values, no_ratings, true},
    MetricRow{Metric::value_at_point, "lx", values, all, true},
    MetricRow{Metric::share, "", counted_values, all, false, kShare},
    MetricRow{Metric::power_density, "W/m2", space, all, false},
    MetricRow{Metric::power_per_100_lx, "W/m2/100lx", space_and_light, illuminances, false},
    MetricRow{Metric::leni, "kWh/m2/a", space, all, false},
    MetricRow{Metric::gradient, "", neighbours, illuminances, false, kGradient},
};

static_assert(
    [] {
      for (std::size_t i = 0; i < kMetrics.size(); ++i) {
        if (static_cast<std::size_t>(kMetrics[i].metric) != i) return false;
      }
      return true;
    }(),
    "kMetrics is in the order of the enum");

}  // namespace

const MetricRow& metric_row(Metric metric) { return kMetrics[static_cast<std::size_t>(metric)]; }

std::vector<std::string_view> metric_names() {
  std::vector<std::string_view> names;
  for (const MetricRow& row : kMetrics) {
    if (!is_about_power(row.metric)) names.push_back(calc::name_of(row.metric));
  }
  return names;
}

std::vector<std::string_view> all_metric_names() {
  std::vector<std::string_view> names = metric_names();
  for (const MetricRow& row : kMetrics) {
    if (is_about_power(row.metric)) names.push_back(calc::name_of(row.metric));
  }
  return names;
}

bool is_ratio(Metric metric) { return *metric_row(metric).unit == '\0'; }

bool is_about_power(Metric metric) {
  return is_of_space(metric) || metric_row(metric).source == space_and_light;
}

bool is_of_space(Metric metric) { return metric_row(metric).source == space; }

bool is_metric_of(Metric metric, calc::DerivedQuantity derived) {
  switch (metric_row(metric).domain) {
    case all:
      return true;
    case no_ratings:
      return derived != calc::DerivedQuantity::ugr;
    case illuminances:
      break;
  }
  return !calc::is_plain_number(derived);
}

}  // namespace rules
