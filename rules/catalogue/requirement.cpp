#include "rules/catalogue/requirement.h"

#include <array>

namespace rules {
namespace {

struct MetricEntry {
  Metric metric;
  bool is_ratio;
};

constexpr std::array kMetrics{
    MetricEntry{Metric::average, false},
    MetricEntry{Metric::minimum, false},
    MetricEntry{Metric::maximum, false},
    MetricEntry{Metric::uniformity_min_avg, true},
    MetricEntry{Metric::uniformity_min_max, true},
    MetricEntry{Metric::percentile, false},
    MetricEntry{Metric::value_at_point, false},
    MetricEntry{Metric::share, true},
    MetricEntry{Metric::power_density, false},
    MetricEntry{Metric::power_per_100_lx, false},
    MetricEntry{Metric::leni, false},
    MetricEntry{Metric::gradient, true},
};

const MetricEntry& entry(Metric metric) { return kMetrics[static_cast<std::size_t>(metric)]; }

static_assert(
    [] {
      for (std::size_t i = 0; i < kMetrics.size(); ++i) {
        if (static_cast<std::size_t>(kMetrics[i].metric) != i) return false;
      }
      return true;
    }(),
    "kMetrics is in the order of the enum");

}  // namespace

std::vector<std::string_view> metric_names() {
  std::vector<std::string_view> names;
  names.reserve(kMetrics.size());
  for (const MetricEntry& candidate : kMetrics) {
    if (!is_about_power(candidate.metric)) names.push_back(calc::name_of(candidate.metric));
  }
  return names;
}

const char* comparison_name(Comparison comparison) {
  switch (comparison) {
    case Comparison::at_least:
      return "at-least";
    case Comparison::at_most:
      return "at-most";
    case Comparison::more_than:
      return "more-than";
    case Comparison::less_than:
      return "less-than";
  }
  return "";
}

bool is_ratio(Metric metric) { return entry(metric).is_ratio; }

bool is_about_power(Metric metric) {
  return is_of_space(metric) || metric == Metric::power_per_100_lx;
}

bool is_of_space(Metric metric) {
  return metric == Metric::power_density || metric == Metric::leni;
}

const char* metric_unit(Metric metric) {
  if (metric == Metric::power_density) return "W/m2";
  if (metric == Metric::power_per_100_lx) return "W/m2/100lx";
  if (metric == Metric::leni) return "kWh/m2/a";
  return is_ratio(metric) ? "" : "lx";
}

bool is_in_lux(const Requirement& requirement) {
  return !is_ratio(requirement.metric) && !is_about_power(requirement.metric) &&
         !calc::is_plain_number(requirement.derived);
}

const char* unit_of(const Requirement& requirement) {
  if (is_about_power(requirement.metric)) return metric_unit(requirement.metric);
  return is_in_lux(requirement) ? "lx" : "";
}

}  // namespace rules
