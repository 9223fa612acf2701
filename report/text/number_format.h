#pragma once
// The only place where a quantity becomes text. Never reads the locale: always '.' and ASCII
// digits. Whatever is not a finite number is shown as "–"; "nan" or "inf" never appear.

#include "calc/base/field.h"
#include "rules/catalogue/requirement.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Rounded to `decimals` in [0, 17] places; never "-0.0".
std::string format_fixed(double value, int decimals);

// The shortest text that reads back as the same number ("500", "0.1"); "" unless finite. For data
// files.
std::string format_shortest(double value);

// What a value is held against: the shown digits stay on the same side of it as the value itself.
struct Threshold {
  double limit = 0.0;
  rules::Comparison comparison = rules::Comparison::at_least;
};

// Several of them; from one, an optional one or two implicitly.
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

// "512" and "4"; `spread` is empty for exact values. The half width has two significant digits and
// the value ends at the same place, with at most three significant digits, or whole; a ratio has
// two decimals at most, or two digits where it is small, and a rating, which is one of 10 or more,
// one. With thresholds, digits are added until value and interval ends are on their true side of
// all of them. The half width is rounded up, so that what is shown holds all of the interval.
struct EstimateText {
  std::string value, spread;
};
// unit: "lx", or "" for a ratio.
EstimateText format_estimate(const calc::Estimate& estimate, std::string_view unit,
                             const Thresholds& thresholds = {});

// "512 ± 4 lx", "0.61 ± 0.01", "512 lx" when exact; "21.4 (20.9 to 21.4)" where one side
// of the interval is wider than the other in the digits shown; "≥ 17.2 lx" where the other end is
// open, and "none" of what is_nothing(). to: the word between the ends.
std::string format_measured(const calc::Estimate& estimate, std::string_view unit,
                            const Thresholds& thresholds = {}, std::string_view to = "to");

// "508 – 517 lx", rounded outwards; "exact" when nothing was sampled. Both ends are on their true
// side.
std::string format_interval(const calc::Estimate& estimate, std::string_view unit,
                            const Thresholds& thresholds = {});

// UGR is a scale from 10 up: what is below troubles nobody, and how far below says nothing. Whether
// all of it is below, where no threshold is. Of what must be above a limit it says something.
bool is_below_ugr_scale(const calc::Estimate& estimate, const Thresholds& thresholds = {});
// "< 10" of that, and else as format_measured() has it without a unit.
std::string format_ugr(const calc::Estimate& estimate, const Thresholds& thresholds = {},
                       std::string_view to = "to");

// Whether format_fixed() in so many decimals is on the value's side of the limit.
bool reads_alike(double value, int decimals, const Threshold& threshold);

// One illuminance without interval, short enough for a cell of a plan: "1240", "512", "51.2",
// "5.12".
std::string format_cell(double value, const Thresholds& thresholds = {});

// "500", "0.3", of a number that people are told as it is: its digits, but nine where that are more
// than ten characters, as of 3 * 0.1.
std::string format_level(double level);

// "≥ 500 lx", "≤ 0.60", "≤ 19": as many digits as the limit has, but nine where that are more than
// ten characters; at least two decimals for a number without unit below 10, which is a ratio.
std::string format_required(const Threshold& threshold, std::string_view unit);
std::string format_limit(double limit, std::string_view unit);

// A relative margin as "+2.5 %" or "-0.02 %": digits enough to show that it is not zero.
std::string format_margin(double margin);
// The same of a glare rating's margin, as a difference to its limit: "-5.3 UGR".
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
