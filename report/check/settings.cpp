#include "report/check/settings.h"

#include "calc/base/day.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

namespace check {

std::string day_or_today(const std::string& day) {
  if (!day.empty()) return day;
  const std::time_t now = std::time(nullptr);
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(now));
}

std::string problem_with(const Settings& settings) {
  if (!(settings.tolerance > 0.0 && settings.tolerance < 1.0)) {
    return "the tolerance must be between 0 and 1";
  }
  if (!(settings.confidence > 0.5 && settings.confidence < 1.0)) {
    return "the confidence must be between 0.5 and 1";
  }
  if (!settings.today.empty() && !calc::is_day(settings.today)) {
    return "the day by which waivers end must be YYYY-MM-DD";
  }
  return calc::validate(settings.radiosity);
}

}  // namespace check
