#include "report/text/schedule_words.h"

#include "calc/photometry/stated_colour.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace report {
namespace {

// Words such as "Unknown" tell nobody a colour.
bool has_digit(const std::string& words) {
  return std::any_of(words.begin(), words.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// What a file says of another light than the type's must not read as if it were the type's.
std::string words_of_file(const Texts& t, const LuminaireRow& type, const std::string& words) {
  return words.empty() || !type.is_of_other_light() ? words : t.say<Text::colour_of_file>(words);
}

std::string own_words(const std::string& words) {
  return has_digit(words) ? printable(words) : std::string();
}

std::string rendering_words(const Texts& t, const calc::StatedRa& ra) {
  const std::string low = format_shortest(t, ra.low);
  constexpr double kBest = 100.0;
  if (ra.low == ra.high) return low;
  return ra.high == kBest ? "≥ " + low : low + "–" + format_shortest(t, ra.high);
}

// "2.80 m, 3.20 m", of many "2.60 m to 3.20 m".
std::string heights_words(const Texts& t, const std::vector<double>& heights_m) {
  constexpr std::size_t kMostListed = 3;
  const auto height = [&](double m) { return format_fixed(t, m, 2) + " m"; };
  if (heights_m.size() > kMostListed) {
    return fmt::format("{} {} {}", height(heights_m.front()), t[Text::interval_to],
                       height(heights_m.back()));
  }
  std::string words;
  for (const double m : heights_m) words += (words.empty() ? "" : ", ") + height(m);
  return words;
}

}  // namespace

std::string colour_temperature_words(const Texts& t, const LuminaireRow& type) {
  const std::optional<double> kelvin = calc::stated_colour_temperature_k(type.colour_temperature);
  return words_of_file(t, type,
                       kelvin ? format_fixed(*kelvin, 0) : own_words(type.colour_temperature));
}

std::string colour_rendering_words(const Texts& t, const LuminaireRow& type) {
  const std::optional<calc::StatedRa> ra = calc::stated_ra(type.colour_rendering);
  return words_of_file(t, type, ra ? rendering_words(t, *ra) : own_words(type.colour_rendering));
}

std::string mounting_words(const Texts& t, const ScheduleRow& row) {
  const std::string words = heights_words(t, row.heights_m);
  if (row.heights_above_zero_m.empty()) return words;
  return words + (words.empty() ? "" : ", ") +
         t.say<Text::height_above_zero>(heights_words(t, row.heights_above_zero_m));
}

std::string rooms_words(const Texts& t, const ScheduleRow& row) {
  constexpr std::size_t kMostNamed = 3;
  const std::size_t all = row.spaces.size();
  const std::size_t named = all <= kMostNamed ? all : kMostNamed - 1;
  std::string words;
  for (std::size_t i = 0; i < named; ++i) {
    words += (i == 0 ? "" : ", ") + printable(title_of(row.spaces[i]->name, row.spaces[i]->id));
  }
  return named == all ? words : t.say<Text::and_more>(words, all - named);
}

std::string opening_words(const Texts& t, const ScheduleRow& row) {
  if (!(row.opening_m.x > 0.0) || !(row.opening_m.y > 0.0)) return {};
  constexpr std::size_t kCornersOfRectangle = 4;
  const std::string along = format_metres(t, row.opening_m.x);
  const std::string across = format_metres(t, row.opening_m.y);
  if (row.outline_m.size() > kCornersOfRectangle && along == across) {
    return t.say<Text::opening_round>(along);
  }
  return t.say<Text::opening_sides>(along, across);
}

std::vector<std::string> schedule_remarks(const Texts& t, const LuminaireSchedule& schedule) {
  std::vector<std::string> remarks;
  std::string unused;
  for (const ScheduleRow& row : schedule.unused) {
    unused += fmt::format("{}{} ({})", unused.empty() ? "" : ", ", row.position,
                          printable(row.type->type_id));
  }
  if (!unused.empty()) remarks.push_back(t.say<Text::unused_types>(unused));
  for (const SpacePart* road : schedule.roads) {
    remarks.push_back(t.say<Text::road_is_drawn>(printable(title_of(road->name, road->id)),
                                                 road->luminaires.size(), road->power.luminaires));
  }
  return remarks;
}

}  // namespace report
