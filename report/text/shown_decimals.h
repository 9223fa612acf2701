#pragma once
// The number of decimals for output that shows numbers as numbers, such as spreadsheets. The rules
// are those of number_format.h.

#include "report/text/number_format.h"

namespace report {

// Returns the decimals, [0, 9], for value and ends alike: all three are shown on their true side of
// the thresholds, unless nine decimals are too few.
int interval_decimals(const calc::Estimate& estimate, std::string_view unit,
                      const Thresholds& thresholds = {});

// Returns the decimals of the percentage in format_margin(), [0, 9].
int margin_decimals(double margin);

}  // namespace report
