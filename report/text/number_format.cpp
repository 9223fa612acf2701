#include "report/text/number_format.h"

#include "calc/base/elementary.h"
#include "report/text/shown_decimals.h"
#include "report/text/words.h"
#include "rules/catalogue/compare.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace report {
namespace {

constexpr const char* kNoNumber = "–";
constexpr int kMostDecimals = 9;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// Place of the first significant digit: 0 for 1..9.99, 2 for 512, -1 for 0.5. value > 0.
int magnitude(double value) { return static_cast<int>(std::floor(calc::log10(value))); }

double rounded(double value, int decimals) {
  double result = value;
  const std::string text = format_fixed(value, decimals);
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

// An end of an interval: what is shown holds all of it. Differences of doubles are noise.
double rounded_outward(double end, int decimals, bool upwards) {
  const double step = calc::pow(10.0, -decimals), nearest = rounded(end, decimals);
  const double noise = std::max(1e-6 * step, 1e-13 * std::abs(end));
  if (upwards && nearest < end - noise) return rounded(nearest + step, decimals);
  if (!upwards && nearest > end + noise) return rounded(nearest - step, decimals);
  return nearest;
}

// Of the interval around the value that is shown in so many decimals.
double shown_width(const calc::Estimate& estimate, int decimals) {
  const double shown = rounded(estimate.value, decimals);
  return rounded_outward(std::max(estimate.high - shown, shown - estimate.low), decimals, true);
}

// On the same side of every threshold.
bool are_alike(double shown, double value, const Thresholds& thresholds) {
  return std::all_of(thresholds.list.begin(), thresholds.list.end(), [&](const Threshold& t) {
    return rules::meets(shown, t.comparison, t.limit) == rules::meets(value, t.comparison, t.limit);
  });
}

double spread_of(const calc::Estimate& estimate) {
  if (!std::isfinite(estimate.low) || !std::isfinite(estimate.high)) return kUnknown;
  return std::max(estimate.high - estimate.value, estimate.value - estimate.low);
}

// Decimals that show `digits` significant digits of value.
int decimals_for(double value, int digits) {
  if (value == 0.0) return 1;
  return std::clamp(digits - 1 - magnitude(std::abs(value)), 0, kMostDecimals);
}

int plain_decimals(double value, double spread, std::string_view unit) {
  // Three significant digits; ratios have two decimals, or two digits where they are small, and
  // ratings such as a UGR of 24 have one.
  constexpr double kLeastRating = 10.0;
  const bool is_rating = std::abs(value) >= kLeastRating;
  const int most = !unit.empty() ? decimals_for(value, 3)
                   : is_rating   ? 1
                                 : std::max(2, decimals_for(value, 2));
  if (!(spread > 0.0)) return most;
  int decimals = decimals_for(spread, 2);
  if (rounded(spread, decimals) >= 10.0 * calc::pow(10.0, 1 - decimals) && decimals > 0) --decimals;
  return std::min(decimals, most);
}

bool tells_the_truth(const calc::Estimate& estimate, double spread, int decimals,
                     const Thresholds& thresholds) {
  const double value = rounded(estimate.value, decimals);
  if (!are_alike(value, estimate.value, thresholds)) return false;
  if (!(spread > 0.0)) return true;
  const double width = shown_width(estimate, decimals);
  return are_alike(value - width, estimate.value - spread, thresholds) &&
         are_alike(value + width, estimate.value + spread, thresholds);
}

// Decimals with which the value and both ends are on their true side; kMostDecimals + 1: there are
// none.
int true_decimals(const calc::Estimate& estimate, int from, const Thresholds& thresholds) {
  const auto is_true = [&](int decimals) {
    return are_alike(rounded(estimate.value, decimals), estimate.value, thresholds) &&
           are_alike(rounded_outward(estimate.low, decimals, false), estimate.low, thresholds) &&
           are_alike(rounded_outward(estimate.high, decimals, true), estimate.high, thresholds);
  };
  int decimals = from;
  while (decimals <= kMostDecimals && !is_true(decimals)) ++decimals;
  return decimals;
}

// Both ends in so many decimals; in more than there may be as they are.
std::string end_text(double end, int decimals, bool upwards) {
  return decimals > kMostDecimals ? format_shortest(end)
                                  : format_fixed(rounded_outward(end, decimals, upwards), decimals);
}

int decimals_of(const std::string& number) {
  const std::size_t point = number.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(number.size() - point - 1);
}

// Both sides look alike in so many decimals.
bool is_symmetric(const calc::Estimate& estimate, int decimals) {
  const double below = estimate.value - estimate.low, above = estimate.high - estimate.value;
  constexpr double kNoise = 1e-9;  // of differences of printed numbers
  return std::abs(above - below) <= kNoise * std::abs(estimate.value) ||
         format_fixed(below, decimals) == format_fixed(above, decimals);
}

// "21.35 (20.90 to 21.40)"
std::string with_ends(const calc::Estimate& estimate, std::string_view unit,
                      const Thresholds& thresholds, std::string_view to) {
  const int decimals = true_decimals(
      estimate, plain_decimals(estimate.value, spread_of(estimate), unit), thresholds);
  const std::string value = decimals > kMostDecimals ? format_shortest(estimate.value)
                                                     : format_fixed(estimate.value, decimals);
  return fmt::format("{} ({} {} {})", value, end_text(estimate.low, decimals, false), to,
                     end_text(estimate.high, decimals, true));
}

std::string with_unit(std::string text, std::string_view unit) {
  if (unit.empty() || text == kNoNumber) return text;
  text.append(" ").append(unit);
  // "cd/m2", as data have it
  if (const std::size_t at = text.find("m2"); at != std::string::npos) text.replace(at, 2, "m²");
  return text;
}

}  // namespace

std::string format_fixed(double value, int decimals) {
  if (!std::isfinite(value)) return kNoNumber;
  std::array<char, 400> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  std::string text(buffer.data(), end);
  if (text.starts_with('-') && text.find_first_of("123456789") == std::string::npos)
    text.erase(0, 1);
  return text;
}

std::string format_shortest(double value) {
  if (!std::isfinite(value)) return {};
  std::array<char, 32> buffer{};
  const double plain = value == 0.0 ? 0.0 : value;  // no "-0"
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), plain).ptr;
  return {buffer.data(), end};
}

EstimateText format_estimate(const calc::Estimate& estimate, std::string_view unit,
                             const Thresholds& thresholds) {
  if (!std::isfinite(estimate.value)) return {kNoNumber, ""};
  const double spread = spread_of(estimate);
  if (!std::isfinite(spread)) {  // an unknown interval must not look like an exact value
    return {
        format_estimate({estimate.value, estimate.value, estimate.value}, unit, thresholds).value,
        kNoNumber};
  }
  int decimals = plain_decimals(estimate.value, spread, unit);
  if (!thresholds.list.empty()) {
    int tried = decimals;
    while (tried <= kMostDecimals && !tells_the_truth(estimate, spread, tried, thresholds)) ++tried;
    if (tried <= kMostDecimals) {
      decimals = tried;
    } else if (!are_alike(rounded(estimate.value, decimals), estimate.value, thresholds)) {
      return {format_shortest(estimate.value), spread > 0.0 ? format_shortest(spread) : ""};
    }
  }
  EstimateText text{format_fixed(estimate.value, decimals), ""};
  if (!(spread > 0.0)) return text;
  text.spread = format_fixed(shown_width(estimate, decimals), decimals);
  return text;
}

std::string format_measured(const calc::Estimate& estimate, std::string_view unit,
                            const Thresholds& thresholds, std::string_view to) {
  const bool has_low = std::isfinite(estimate.low), has_high = std::isfinite(estimate.high);
  if (calc::is_nothing(estimate) && !has_high) return english_text(Text::none);
  if (has_low != has_high && !std::isnan(estimate.value)) {
    const double end = has_low ? estimate.low : estimate.high;
    return (has_low ? "≥ " : "≤ ") +
           with_unit(format_estimate({end, end, end}, unit, thresholds).value, unit);
  }
  const EstimateText text = format_estimate(estimate, unit, thresholds);
  const bool is_open = text.spread.empty() || text.spread == kNoNumber;
  if (!is_open && !is_symmetric(estimate, decimals_of(text.value))) {
    return with_unit(with_ends(estimate, unit, thresholds, to), unit);
  }
  return with_unit(text.spread.empty() ? text.value : text.value + " ± " + text.spread, unit);
}

bool is_below_ugr_scale(const calc::Estimate& estimate, const Thresholds& thresholds) {
  constexpr double kLowest = 10.0;
  return estimate.high < kLowest && estimate.value < kLowest && !calc::is_nothing(estimate) &&
         std::none_of(thresholds.list.begin(), thresholds.list.end(), [](const Threshold& one) {
           return one.limit < kLowest || rules::is_lower_limit(one.comparison);
         });
}

std::string format_ugr(const calc::Estimate& estimate, const Thresholds& thresholds,
                       std::string_view to) {
  return is_below_ugr_scale(estimate, thresholds) ? "< 10"
                                                  : format_measured(estimate, "", thresholds, to);
}

std::string format_interval(const calc::Estimate& estimate, std::string_view unit,
                            const Thresholds& thresholds) {
  if (!std::isfinite(estimate.low) || !std::isfinite(estimate.high)) return kNoNumber;
  if (estimate.low == estimate.high) return "exact";
  const int plain = plain_decimals(estimate.value, spread_of(estimate), unit);
  const int wanted = true_decimals(estimate, plain, thresholds);
  const int decimals = wanted > kMostDecimals ? plain : wanted;
  return with_unit(
      end_text(estimate.low, decimals, false) + " – " + end_text(estimate.high, decimals, true),
      unit);
}

int interval_decimals(const calc::Estimate& estimate, std::string_view unit,
                      const Thresholds& thresholds) {
  if (!std::isfinite(estimate.value)) return 0;
  const double spread = spread_of(estimate);
  int decimals = plain_decimals(estimate.value, std::isfinite(spread) ? spread : 0.0, unit);
  // A spreadsheet rounds what it has first rounded to 15 digits: a last bit may tip it over.
  constexpr double kLastDigit = 1e-14;
  const auto is_true = [&](double value) {
    return !std::isfinite(value) ||
           (are_alike(rounded(value * (1.0 - kLastDigit), decimals), value, thresholds) &&
            are_alike(rounded(value * (1.0 + kLastDigit), decimals), value, thresholds));
  };
  while (!is_true(estimate.value) || !is_true(estimate.low) || !is_true(estimate.high)) {
    if (++decimals > kMostDecimals) return kMostDecimals;
  }
  return decimals;
}

bool reads_alike(double value, int decimals, const Threshold& threshold) {
  return are_alike(rounded(value, decimals), value, threshold);
}

std::string format_cell(double value, const Thresholds& thresholds) {
  if (!std::isfinite(value)) return kNoNumber;
  int decimals = std::min(decimals_for(value, 3), 3);
  for (int tried = decimals; tried <= kMostDecimals; ++tried) {
    if (!are_alike(rounded(value, tried), value, thresholds)) continue;
    decimals = tried;
    break;
  }
  return format_fixed(value, decimals);
}

std::string format_level(double level) {
  // A limit in foot-candles has no end in lx.
  constexpr std::size_t kMostCharacters = 10;
  std::string text = format_shortest(level);
  return text.size() > kMostCharacters ? fmt::format("{:.9g}", level) : text;
}

std::string format_limit(double limit, std::string_view unit) {
  if (!std::isfinite(limit)) return kNoNumber;
  std::string text = format_level(limit);
  const bool is_plain = text.find('e') == std::string::npos;
  constexpr double kLeastRating = 10.0;  // ratios are smaller, and their zeros usual
  if (unit.empty() && is_plain && std::abs(limit) < kLeastRating) {
    const std::size_t point = text.find('.');
    const std::size_t decimals = point == std::string::npos ? 0 : text.size() - point - 1;
    if (decimals < 2) text = format_fixed(limit, 2);
  }
  return with_unit(text, unit);
}

std::string format_required(const Threshold& threshold, std::string_view unit) {
  if (std::isnan(threshold.limit)) return "unknown limit";
  return comparison_sign(threshold.comparison) + (" " + format_limit(threshold.limit, unit));
}

namespace {

// With one digit behind the point, or as many as show that it is not zero.
std::string signed_amount(double amount) {
  if (!std::isfinite(amount)) return kNoNumber;
  const double size = std::abs(amount);
  int decimals = 1;
  while (size > 0.0 && rounded(size, decimals) == 0.0 && decimals < kMostDecimals) ++decimals;
  return (amount < 0.0 ? "-" : "+") + format_fixed(size, decimals);
}

}  // namespace

int margin_decimals(double margin) {
  return std::isfinite(margin) ? decimals_of(signed_amount(margin * 100.0)) : 0;
}

std::string format_margin(double margin) {
  if (!std::isfinite(margin)) return kNoNumber;
  return signed_amount(margin * 100.0) + " %";
}

std::string format_rating_margin(double margin, double limit, std::string_view rating) {
  if (!std::isfinite(margin)) return kNoNumber;
  return fmt::format("{} {}", signed_amount(margin * std::abs(limit)), rating);
}

std::string format_percent(double share) {
  std::string text = format_fixed(share * 100.0, 3);
  if (text == kNoNumber) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text + " %";
}

std::string format_share(double share) {
  const std::string text = format_fixed(share * 100.0, 0);
  return text == kNoNumber ? text : text + " %";
}

std::string format_metres(double metres) {
  std::string text = format_fixed(metres, 3);
  if (text.ends_with('0') && text.find('.') != std::string::npos) text.pop_back();
  return text;
}

std::string format_position(const glm::dvec3& m) {
  return "(" + format_fixed(m.x, 2) + ", " + format_fixed(m.y, 2) + ", " + format_fixed(m.z, 2) +
         ")";
}

std::string format_lumens(double lumens) {
  return format_fixed(lumens, std::abs(lumens) >= 100.0 ? 0 : 1);
}

std::string format_watts(double watts) { return format_fixed(watts, 1); }

std::string format_seconds(double seconds) {
  return format_fixed(seconds, seconds >= 100.0 ? 0 : (seconds >= 10.0 ? 1 : 2));
}

std::string format_count(std::uint64_t count) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += "\u202F";
    text += digits[i];
  }
  return text;
}

}  // namespace report
