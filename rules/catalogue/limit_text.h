#pragma once
// What requirements in projects and limits in rule packs have in common.

#include "calc/base/xml_reader.h"
#include "rules/catalogue/requirement.h"

#include <optional>

namespace rules {

// The attribute "quantity", one of `allowed` (names as in metric_names()); empty after an error.
std::optional<Metric> read_metric(calc::ElementReader& reader, const calc::Names& allowed);

enum class LimitUnit { lux, footcandle, plain };

// A limit for `metric` from the attribute `name`: from 0 to 1e9 of the unit, ratios from 0 to 1.
// The result is in lx or without unit. `unit` does not matter for ratios.
double read_limit(calc::ElementReader& reader, std::string_view name, Metric metric,
                  LimitUnit unit);

// Which of "at-least" and "at-most" the element has; having both or neither is an error: empty.
std::optional<Comparison> read_comparison(calc::ElementReader& reader);

}  // namespace rules
