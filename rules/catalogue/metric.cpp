#include "rules/catalogue/metric.h"

namespace rules {

std::vector<std::string_view> metric_names() {
  std::vector<std::string_view> names;
  for (const MetricRow& row : kMetrics) {
    if (!is_about_space(row.metric)) names.push_back(row.name);
  }
  return names;
}

std::vector<std::string_view> all_metric_names() {
  std::vector<std::string_view> names = metric_names();
  for (const MetricRow& row : kMetrics) {
    if (is_about_space(row.metric)) names.push_back(row.name);
  }
  return names;
}

bool is_ratio(Metric metric) { return !metric_row(metric).ratio_limit.words.empty(); }

bool is_about_space(Metric metric) {
  switch (metric_row(metric).source) {
    case MetricSource::values:
    case MetricSource::counted_values:
    case MetricSource::neighbours:
      return false;
    case MetricSource::space:
    case MetricSource::space_in_scene:
    case MetricSource::road:
    case MetricSource::luminaires:
    case MetricSource::space_and_light:
      break;
  }
  return true;
}

bool has_unit_of_values(Metric metric) { return !is_ratio(metric) && !is_about_space(metric); }

bool is_of_space(Metric metric) {
  return is_about_space(metric) && metric_row(metric).source != MetricSource::space_and_light;
}

bool is_of_space_in_scene(Metric metric) {
  return is_of_space(metric) && metric_row(metric).source != MetricSource::space;
}

bool is_of_light(Metric metric) {
  return metric_row(metric).source != MetricSource::space && metric != Metric::luminaire_distance;
}

bool is_of_road(Metric metric) { return metric_row(metric).source == MetricSource::road; }

bool is_of_luminaires(Metric metric) {
  return metric_row(metric).source == MetricSource::luminaires;
}

bool is_of_points(Metric metric) {
  return metric == Metric::intensity || metric == Metric::luminaire_distance;
}

bool is_metric_of(Metric metric, calc::DerivedQuantity derived) {
  switch (metric_row(metric).domain) {
    case MetricDomain::all:
      return true;
    case MetricDomain::no_ratings:
      return derived != calc::DerivedQuantity::ugr;
    case MetricDomain::illuminances:
      break;
  }
  return !calc::is_plain_number(derived);
}

}  // namespace rules
