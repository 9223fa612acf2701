#pragma once
// The functions of number_format.h with the reader's decimal sign and words: for prose and tables,
// not for coordinates, data or commands.

#include "report/text/number_format.h"
#include "report/text/texts.h"

#include <string>
#include <string_view>

namespace report {

inline std::string format_fixed(const Texts& t, double value, int decimals) {
  return t.number(format_fixed(value, decimals));
}
inline std::string format_shortest(const Texts& t, double value) {
  return t.number(format_shortest(value));
}
inline std::string format_measured(const Texts& t, const calc::Estimate& estimate,
                                   std::string_view unit, const Thresholds& thresholds = {}) {
  const std::string text = format_measured(estimate, unit, thresholds, t[Text::interval_to]);
  return text == english_text(Text::none) ? t[Text::none] : t.number(text);
}
inline std::string format_ugr(const Texts& t, const calc::Estimate& estimate,
                              const Thresholds& thresholds = {}) {
  const std::string text = format_ugr(estimate, thresholds, t[Text::interval_to]);
  return text == english_text(Text::none) ? t[Text::none] : t.number(text);
}
inline std::string format_interval(const Texts& t, const calc::Estimate& estimate,
                                   std::string_view unit, const Thresholds& thresholds = {}) {
  const std::string text = format_interval(estimate, unit, thresholds);
  return text == english_text(Text::exact) ? t[Text::exact] : t.number(text);
}
inline std::string format_cell(const Texts& t, double value, const Thresholds& thresholds = {}) {
  return t.number(format_cell(value, thresholds));
}
inline std::string format_level(const Texts& t, double level) {
  return t.number(format_level(level));
}
inline std::string format_limit(const Texts& t, double limit, std::string_view unit) {
  return t.number(format_limit(limit, unit));
}
inline std::string format_required(const Texts& t, const Threshold& threshold,
                                   std::string_view unit) {
  const std::string text = format_required(threshold, unit);
  return text == english_text(Text::unknown_limit) ? t[Text::unknown_limit] : t.number(text);
}
inline std::string format_margin(const Texts& t, double margin) {
  return t.number(format_margin(margin));
}
inline std::string format_percent(const Texts& t, double share) {
  return t.number(format_percent(share));
}
inline std::string format_share(const Texts& t, double share) {
  return t.number(format_share(share));
}
inline std::string format_metres(const Texts& t, double metres) {
  return t.number(format_metres(metres));
}
inline std::string format_position(const Texts& t, const glm::dvec3& m) {
  return t.number(format_position(m));
}
inline std::string format_lumens(const Texts& t, double lumens) {
  return t.number(format_lumens(lumens));
}
inline std::string format_watts(const Texts& t, double watts) {
  return t.number(format_watts(watts));
}
inline std::string format_seconds(const Texts& t, double seconds) {
  return t.number(format_seconds(seconds));
}

}  // namespace report
