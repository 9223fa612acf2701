#pragma once
// The only place where a quantity becomes text. The locale is never read: always '.' and ASCII
// digits. A number that is not finite is shown as "–"; "nan" or "inf" never appear.

#include "calc/base/field.h"
#include "rules/catalogue/requirement.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Returns the value rounded to `decimals` in [0, 17] places; never "-0.0".
std::string format_fixed(double value, int decimals);

// Returns the shortest text that reads back as the same number ("500", "0.1"); "" unless finite.
// For data files.
std::string format_shortest(double value);

// A limit that a value is compared with: the shown digits stay on the same side of it as the value.
struct Threshold {
  double limit = 0.0;
  rules::Comparison comparison = rules::Comparison::at_least;
};

// Several thresholds; made implicitly from one, an optional one or two.
struct Thresholds {
  std::vector<Threshold> list;

  Thresholds() = default;
  Thresholds(const Threshold& one) : list{one} {}
  Thresholds(const std::optional<Threshold>& one) { add(one); }
  Thresholds(const std::optional<Threshold>& one, const std::optional<Threshold>& other) {
    add(one);
    add(other);
  }
  void add(const std::optional<Threshold>& one) {
    if (one) list.push_back(*one);
  }
};

// A value and its half width as text, "512" and "4"; `spread` is empty for exact values. The half
// width has two significant digits and the value ends at the same place, with at most three
// significant digits, or whole. A ratio has two decimals at most, or two digits if it is small; a
// rating of 10 or more has one. With thresholds, digits are added until value and interval ends are
// on their true side of all of them. The half width is rounded up, so that the shown interval
// contains the whole interval.
struct EstimateText {
  std::string value, spread;
};
// Returns value and half width. unit: "lx", or "" for a ratio.
EstimateText format_estimate(const calc::Estimate& estimate, std::string_view unit,
                             const Thresholds& thresholds = {});

// Returns "512 ± 4 lx", "0.61 ± 0.01", "512 lx" when exact; "21.4 (20.9 to 21.4)" if the shown
// sides of the interval differ; "≥ 17.2 lx" if the other end is open, and "none" for is_nothing().
// to: the word between the ends.
std::string format_measured(const calc::Estimate& estimate, std::string_view unit,
                            const Thresholds& thresholds = {}, std::string_view to = "to");

// Returns "508 – 517 lx", rounded outwards; "exact" when nothing was sampled. Both ends are on
// their true side.
std::string format_interval(const calc::Estimate& estimate, std::string_view unit,
                            const Thresholds& thresholds = {});

// Returns whether all of it is below the UGR scale, which starts at 10, and no threshold is: lower
// values disturb nobody, and their differences mean nothing. They do mean something if the value
// must be above a limit.
bool is_below_ugr_scale(const calc::Estimate& estimate, const Thresholds& thresholds = {});
// Returns "< 10" for such a value, and otherwise format_measured() without a unit.
std::string format_ugr(const calc::Estimate& estimate, const Thresholds& thresholds = {},
                       std::string_view to = "to");

// Returns whether format_fixed() with these decimals is on the value's side of the limit.
bool reads_alike(double value, int decimals, const Threshold& threshold);

// Returns one illuminance without interval, short enough for a cell of a plan: "1240", "512",
// "51.2", "5.12".
std::string format_cell(double value, const Thresholds& thresholds = {});

// Returns the digits of a number shown as it is: "500", "0.3"; nine digits if they are more than
// ten characters, as for 3 * 0.1.
std::string format_level(double level);

// Returns "≥ 500 lx", "≤ 0.60", "≤ 19" with the digits of the limit; nine if they are more than ten
// characters; at least two decimals for a number without unit below 10, which is a ratio.
std::string format_required(const Threshold& threshold, std::string_view unit);
std::string format_limit(double limit, std::string_view unit);

// Returns a relative margin as "+2.5 %" or "-0.02 %", with enough digits to show that it is not
// zero.
std::string format_margin(double margin);
// Returns a glare rating's margin as a difference to its limit: "-5.3 UGR".
std::string format_rating_margin(double margin, double limit, std::string_view rating);

std::string format_percent(double share);  // a setting: 0.95 -> "95 %", 0.999 -> "99.9 %"
std::string format_share(double share);    // 0.784 -> "78 %"
std::string format_metres(
    double metres);  // centimetres, or millimetres where there are any: "0.80", "0.125"
std::string format_position(const glm::dvec3& m);  // "(4.20, 1.10, 0.80)"
std::string format_lumens(double lumens);          // whole lumens above 100
std::string format_watts(double watts);            // one decimal
std::string format_seconds(double seconds);        // "0.42", "12.3", "340"
std::string format_count(std::uint64_t count);  // groups of three with narrow blanks: "4 194 304"

}  // namespace report
