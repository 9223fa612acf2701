#pragma once
// Days as people write them into files: YYYY-MM-DD. They compare as texts.

#include <string_view>

namespace calc {

// A day of the calendar, of the years 1 to 9999, and nothing around it.
bool is_day(std::string_view text);

// From one day to another, negative if it was before; both must be days.
int days_between(std::string_view from, std::string_view to);

}  // namespace calc
