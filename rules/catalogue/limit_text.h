#pragma once
// Reads parts that requirements in projects and limits in rule packs have in common.

#include "calc/base/xml_reader.h"
#include "rules/catalogue/requirement.h"

#include <optional>

namespace rules {

// Reads the attribute "quantity", one of `allowed` (names as in metric_names()); empty after an
// error.
std::optional<Metric> read_metric(calc::ElementReader& reader, const calc::Names& allowed);

enum class LimitUnit { lux, footcandle, plain };

// Reads a limit for `metric` from the attribute `name`: from 0 to 1e9 of the unit, ratios from 0 to
// 1. The result is in lx or without unit; ratios ignore `unit`.
double read_limit(calc::ElementReader& reader, std::string_view name, Metric metric,
                  LimitUnit unit);

// Returns which of "at-least" and "at-most" the element has; both or neither are an error: empty.
std::optional<Comparison> read_comparison(calc::ElementReader& reader);

}  // namespace rules
