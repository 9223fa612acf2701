#include "report/number_format.h"

#include "report/words.h"
#include "rules/compare.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace report {
namespace {

constexpr const char* kNoNumber = "–";
constexpr int kMostDecimals = 9;

// Place of the first significant digit: 0 for 1..9.99, 2 for 512, -1 for 0.5. value > 0.
int magnitude(double value) { return static_cast<int>(std::floor(std::log10(value))); }

double rounded(double value, int decimals) {
  double result = value;
  const std::string text = format_fixed(value, decimals);
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

bool meets(double value, const Threshold& threshold) {
  return rules::meets(value, threshold.comparison, threshold.limit);
}

double spread_of(const calc::Estimate& estimate) {
  return std::max(estimate.high - estimate.value, estimate.value - estimate.low);
}

// Decimals that show `digits` significant digits of value.
int decimals_for(double value, int digits) {
  if (value == 0.0) return 1;
  return std::clamp(digits - 1 - magnitude(std::abs(value)), 0, kMostDecimals);
}

int plain_decimals(double value, double spread, std::string_view unit) {
  const bool is_ratio = unit.empty();
  const int most = is_ratio ? 3 : std::max(1, decimals_for(value, 4));
  if (!(spread > 0.0)) return is_ratio ? 3 : most;
  int decimals = decimals_for(spread, 2);
  if (rounded(spread, decimals) >= 10.0 * std::pow(10.0, 1 - decimals) && decimals > 0) --decimals;
  return std::min(decimals, most);
}

bool tells_the_truth(const calc::Estimate& estimate, double spread, int decimals,
                     const Threshold& threshold) {
  const double value = rounded(estimate.value, decimals);
  if (meets(value, threshold) != meets(estimate.value, threshold)) return false;
  if (!(spread > 0.0)) return true;
  const double width = rounded(spread, decimals);
  return meets(value - width, threshold) == meets(estimate.value - spread, threshold) &&
         meets(value + width, threshold) == meets(estimate.value + spread, threshold);
}

std::string with_unit(std::string text, std::string_view unit) {
  if (!unit.empty() && text != kNoNumber) text.append(" ").append(unit);
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
                             const std::optional<Threshold>& threshold) {
  if (!std::isfinite(estimate.value)) return {kNoNumber, ""};
  const double spread = spread_of(estimate);
  if (!std::isfinite(spread)) {  // an unknown interval must not look like an exact value
    return {
        format_estimate({estimate.value, estimate.value, estimate.value}, unit, threshold).value,
        kNoNumber};
  }
  int decimals = plain_decimals(estimate.value, spread, unit);
  if (threshold) {
    int tried = decimals;
    while (tried <= kMostDecimals && !tells_the_truth(estimate, spread, tried, *threshold)) ++tried;
    if (tried <= kMostDecimals) {
      decimals = tried;
    } else if (meets(rounded(estimate.value, decimals), *threshold) !=
               meets(estimate.value, *threshold)) {
      return {format_shortest(estimate.value), spread > 0.0 ? format_shortest(spread) : ""};
    }
  }
  EstimateText text{format_fixed(estimate.value, decimals), ""};
  if (!(spread > 0.0)) return text;
  // A half width too small for these digits is rounded up to the last one rather than shown as
  // zero.
  text.spread = rounded(spread, decimals) > 0.0 ? format_fixed(spread, decimals)
                                                : format_fixed(std::pow(10.0, -decimals), decimals);
  return text;
}

std::string format_measured(const calc::Estimate& estimate, std::string_view unit,
                            const std::optional<Threshold>& threshold) {
  const EstimateText text = format_estimate(estimate, unit, threshold);
  return with_unit(text.spread.empty() ? text.value : text.value + " ± " + text.spread, unit);
}

std::string format_interval(const calc::Estimate& estimate, std::string_view unit) {
  if (!std::isfinite(estimate.low) || !std::isfinite(estimate.high)) return kNoNumber;
  if (estimate.low == estimate.high) return "exact";
  const int decimals = plain_decimals(estimate.value, spread_of(estimate), unit);
  return with_unit(
      format_fixed(estimate.low, decimals) + " – " + format_fixed(estimate.high, decimals), unit);
}

std::string format_cell_lx(double value_lx, const std::optional<Threshold>& threshold) {
  if (!std::isfinite(value_lx)) return kNoNumber;
  int decimals = std::min(decimals_for(value_lx, 3), 3);
  if (threshold) {
    const bool is_met = meets(value_lx, *threshold);
    for (int tried = decimals; tried <= kMostDecimals; ++tried) {
      if (meets(rounded(value_lx, tried), *threshold) != is_met) continue;
      decimals = tried;
      break;
    }
  }
  return format_fixed(value_lx, decimals);
}

std::string format_limit(double limit, std::string_view unit) {
  if (!std::isfinite(limit)) return kNoNumber;
  // A limit in foot-candles has no end in lx.
  constexpr std::size_t kMostCharacters = 10;
  std::string text = format_shortest(limit);
  if (text.size() > kMostCharacters) text = fmt::format("{:.9g}", limit);
  const bool is_plain = text.find('e') == std::string::npos;
  if (unit.empty() && is_plain) {
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

std::string format_margin(double margin) {
  if (!std::isfinite(margin)) return kNoNumber;
  const double percent = std::abs(margin) * 100.0;
  int decimals = 1;
  while (percent > 0.0 && rounded(percent, decimals) == 0.0 && decimals < kMostDecimals) ++decimals;
  const char* sign = margin < 0.0 ? "-" : "+";
  return sign + format_fixed(percent, decimals) + " %";
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
