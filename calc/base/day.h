#pragma once
// Days as files have them: YYYY-MM-DD. They compare as texts.

#include <string_view>

namespace calc {

// Returns whether the whole text is a day of the calendar, in the years 1 to 9999.
bool is_day(std::string_view text);

// Returns the days between two days, negative if `to` is earlier; both texts must be days.
int days_between(std::string_view from, std::string_view to);

}  // namespace calc
