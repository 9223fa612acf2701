#include "calc/base/day.h"

#include "calc/base/text.h"

#include <chrono>
#include <cstddef>

namespace calc {
namespace {

std::chrono::year_month_day day_of(std::string_view text) {
  const auto number_at = [&](std::size_t begin, std::size_t count) {
    int number = 0;
    for (const char c : text.substr(begin, count)) number = 10 * number + (c - '0');
    return number;
  };
  return {std::chrono::year(number_at(0, 4)),
          std::chrono::month(static_cast<unsigned>(number_at(5, 2))),
          std::chrono::day(static_cast<unsigned>(number_at(8, 2)))};
}

}  // namespace

bool is_day(std::string_view text) {
  if (text.size() != 10) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_dash = i == 4 || i == 7;
    if (is_dash ? text[i] != '-' : !is_digit(text[i])) return false;
  }
  const std::chrono::year_month_day day = day_of(text);
  return day.ok() && day.year() >= std::chrono::year(1);
}

int days_between(std::string_view from, std::string_view to) {
  const auto days = std::chrono::sys_days(day_of(to)) - std::chrono::sys_days(day_of(from));
  return static_cast<int>(days.count());
}

}  // namespace calc
