#pragma once
// For who shows numbers as numbers, as a spreadsheet does: how many decimals. The rules are those
// of number_format.h.

#include "report/text/number_format.h"

namespace report {

// [0, 9], for value and ends alike: all three are shown on their true side of the thresholds, but
// where nine do not suffice.
int interval_decimals(const calc::Estimate& estimate, std::string_view unit,
                      const Thresholds& thresholds = {});

// Of the percentage in format_margin(), [0, 9].
int margin_decimals(double margin);

}  // namespace report
