#include "rules/catalogue/limit_text.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/units.h"

namespace rules {
namespace {

constexpr calc::NumberRange kLuxLimit{0.0, 1.0e9, false, "a limit in lx from 0 to 1e9"};
constexpr calc::NumberRange kFootcandleLimit{0.0, 1.0e9, false, "a limit in fc from 0 to 1e9"};
constexpr calc::NumberRange kPlainLimit{0.0, 1.0e9, false, "a number from 0 to 1e9"};

}  // namespace

std::optional<Metric> read_metric(calc::ElementReader& reader, const calc::Names& allowed) {
  const std::size_t errors_before = reader.diagnostics().error_count();
  const std::size_t index = reader.choice("quantity", allowed);
  if (reader.diagnostics().error_count() > errors_before) return std::nullopt;
  return calc::find_value<Metric>(allowed[index]);
}

double read_limit(calc::ElementReader& reader, std::string_view name, Metric metric,
                  LimitUnit unit) {
  if (is_ratio(metric)) return reader.number(name, metric_row(metric).ratio_limit);
  if (unit == LimitUnit::plain) return reader.number(name, kPlainLimit);
  if (unit == LimitUnit::lux) return reader.number(name, kLuxLimit);
  return reader.number(name, kFootcandleLimit) * calc::kLuxPerFootcandle;
}

std::optional<Comparison> read_comparison(calc::ElementReader& reader) {
  if (!reader.exclude("at-least", "at-most")) return std::nullopt;
  if (reader.has("at-least")) return Comparison::at_least;
  if (reader.has("at-most")) return Comparison::at_most;
  reader.report(calc::DiagnosticId::missing_form, reader.where(), reader.element().name,
                "'at-least' or 'at-most'");
  return std::nullopt;
}

}  // namespace rules
