#include "report/tools/advise/ceiling_map.h"

#include "report/html/drawings/html_legend.h"
#include "report/images/heatmap.h"
#include "report/text/markup.h"
#include "report/text/number_format.h"
#include "report/text/plain_text.h"
#include "report/text/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace cli {
namespace {

using report::escape_html;
using report::svg_number;

constexpr double kWidest_px = 640.0, kHighest_px = 460.0, kMargin_px = 12.0;
constexpr double kLeastNumber_px = 7.5, kLargestNumber_px = 12.0, kDigitWidth = 0.6;

// What the map is in, metres of the world to pixels; y points down there.
struct Frame {
  glm::dvec2 low_m{0.0}, high_m{0.0};
  double px_by_m = 1.0;

  glm::dvec2 at(const glm::dvec2& m) const {
    return {kMargin_px + (m.x - low_m.x) * px_by_m, kMargin_px + (high_m.y - m.y) * px_by_m};
  }
  glm::dvec2 size_px() const { return (high_m - low_m) * px_by_m + 2.0 * kMargin_px; }
};

Frame frame_of(const RoomPlaces& room) {
  Frame frame;
  frame.low_m = frame.high_m = glm::dvec2(room.places.front().position_m);
  const auto add = [&](const glm::dvec2& m, const glm::dvec2& half) {
    frame.low_m = glm::min(frame.low_m, m - half);
    frame.high_m = glm::max(frame.high_m, m + half);
  };
  for (const AdvisedPlace& place : room.places) {
    add(glm::dvec2(place.position_m), 0.5 * room.step_m);
  }
  for (const glm::dvec2& corner : room.outline_m) add(corner, glm::dvec2(0.0));
  for (const glm::dvec2& one : room.luminaires_m) add(one, glm::dvec2(0.0));
  const glm::dvec2 size_m = frame.high_m - frame.low_m;
  frame.px_by_m = std::min(kWidest_px / size_m.x, kHighest_px / size_m.y);
  return frame;
}

// The best way of mounting at each place.
std::vector<const AdvisedPlace*> places_of(const RoomPlaces& room, std::size_t requirement,
                                           const std::string& type) {
  std::map<std::pair<double, double>, const AdvisedPlace*> best;
  for (const AdvisedPlace& place : room.places) {
    if (place.type != type || requirement >= place.gain_lx.size()) continue;
    const AdvisedPlace*& known = best[{place.position_m.y, place.position_m.x}];
    if (known == nullptr || place.gain_lx[requirement].value > known->gain_lx[requirement].value) {
      known = &place;
    }
  }
  std::vector<const AdvisedPlace*> places;
  for (const auto& [at, place] : best) places.push_back(place);
  return places;
}

std::string gain_number(double lx) { return report::format_fixed(lx, lx < 9.95 ? 1 : 0); }

// Of the numbers in all cells; 0: they have no room.
double number_size_px(const std::vector<const AdvisedPlace*>& places, std::size_t requirement,
                      const glm::dvec2& cell_px) {
  std::size_t longest = 1;
  for (const AdvisedPlace* place : places) {
    longest = std::max(longest, gain_number(place->gain_lx[requirement].value).size());
  }
  const double fitting =
      std::min(0.86 * cell_px.x / (kDigitWidth * static_cast<double>(longest)), 0.62 * cell_px.y);
  return fitting < kLeastNumber_px ? 0.0 : std::min(fitting, kLargestNumber_px);
}

std::string cells(const std::vector<const AdvisedPlace*>& places, std::size_t requirement,
                  const report::ColourScale& scale, const Frame& frame, const glm::dvec2& step_m) {
  const glm::dvec2 cell_px = step_m * frame.px_by_m;
  const double number_px = number_size_px(places, requirement, cell_px);
  std::string svg;
  for (const AdvisedPlace* place : places) {
    const calc::Estimate& gain = place->gain_lx[requirement];
    const report::Rgb colour = report::band_colour(scale, report::band_of(scale, gain.value));
    const glm::dvec2 middle = frame.at(glm::dvec2(place->position_m));
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"><title>{}: {}</title>"
        "</rect>\n",
        svg_number(middle.x - 0.5 * cell_px.x), svg_number(middle.y - 0.5 * cell_px.y),
        svg_number(cell_px.x), svg_number(cell_px.y), report::hex_colour(colour),
        report::format_position(place->position_m),
        escape_html(report::format_measured(gain, "lx")));
    if (number_px == 0.0) continue;
    svg += fmt::format(
        "<text class=\"gain\" x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\">{}</text>\n",
        svg_number(middle.x), svg_number(middle.y + 0.36 * number_px), svg_number(number_px),
        report::needs_dark_text(colour) ? "#000" : "#fff", gain_number(gain.value));
  }
  return svg;
}

std::string room_lines(const RoomPlaces& room, const Frame& frame) {
  std::string svg;
  if (!room.outline_m.empty()) {
    std::string path;
    for (const glm::dvec2& corner : room.outline_m) {
      const glm::dvec2 at = frame.at(corner);
      path += fmt::format("{}{},{}", path.empty() ? "M" : "L", svg_number(at.x), svg_number(at.y));
    }
    svg += fmt::format("<path class=\"walls\" d=\"{}Z\"/>\n", path);
  }
  constexpr double kCross_px = 5.0;
  std::string crosses;
  for (const glm::dvec2& one : room.luminaires_m) {
    const glm::dvec2 at = frame.at(one);
    crosses += fmt::format("M{0},{2}H{1}M{3},{4}V{5}", svg_number(at.x - kCross_px),
                           svg_number(at.x + kCross_px), svg_number(at.y), svg_number(at.x),
                           svg_number(at.y - kCross_px), svg_number(at.y + kCross_px));
  }
  if (!crosses.empty()) {
    svg +=
        fmt::format("<path class=\"halo\" d=\"{0}\"/><path class=\"there\" d=\"{0}\"/>\n", crosses);
  }
  return svg;
}

// Those of the list of the best places that are of this type; beside the number of their square.
std::string best_marks(const RoomPlaces& room, const std::string& type, const Frame& frame) {
  constexpr double kRadius_px = 8.0;
  const glm::dvec2 corner_px = 0.5 * room.step_m * frame.px_by_m;
  std::string svg;
  for (std::size_t i = 0; i < room.best.size(); ++i) {
    const AdvisedPlace& place = room.best[i].places.front();
    if (place.type != type) continue;
    const glm::dvec2 at = frame.at(glm::dvec2(place.position_m)) +
                          glm::dvec2(1.0, -1.0) * (corner_px - 0.9 * kRadius_px);
    svg += fmt::format(
        "<circle class=\"best\" cx=\"{0}\" cy=\"{1}\" r=\"{2}\"/><text class=\"number\" x=\"{0}\" "
        "y=\"{3}\">{4}</text>\n",
        svg_number(at.x), svg_number(at.y), kRadius_px, svg_number(at.y + 4.0), i + 1);
  }
  return svg;
}

// Those that do it together.
std::string together_marks(const RoomPlaces& room, const std::string& type, const Frame& frame) {
  if (!room.together) return "";
  const glm::dvec2 half_px = 0.46 * room.step_m * frame.px_by_m;
  const double reach = std::min(half_px.x, half_px.y);
  std::string path;
  for (const AdvisedPlace& place : room.together->places) {
    if (place.type != type) continue;
    const glm::dvec2 at = frame.at(glm::dvec2(place.position_m));
    path += fmt::format("M{0},{1}l{2},{2} {2},-{2} -{2},-{2}Z", svg_number(at.x - reach),
                        svg_number(at.y), svg_number(reach));
  }
  return path.empty() ? ""
                      : fmt::format(
                            "<path class=\"around\" d=\"{0}\"/><path class=\"together\" "
                            "d=\"{0}\"/>\n",
                            path);
}

}  // namespace

std::vector<std::string> types_on_map(const RoomPlaces& room, std::size_t requirement) {
  std::vector<std::pair<double, std::string>> types;
  for (const AdvisedPlace& place : room.places) {
    if (requirement >= place.gain_lx.size()) continue;
    const double gain = place.gain_lx[requirement].value;
    const auto known = std::find_if(types.begin(), types.end(),
                                    [&](const auto& one) { return one.second == place.type; });
    if (known == types.end()) {
      types.emplace_back(gain, place.type);
    } else {
      known->first = std::max(known->first, gain);
    }
  }
  std::stable_sort(types.begin(), types.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> names;
  for (auto& [gain, name] : types) names.push_back(std::move(name));
  return names;
}

std::string ceiling_map(const RoomPlaces& room, std::size_t requirement, const std::string& type) {
  const std::vector<const AdvisedPlace*> places = places_of(room, requirement, type);
  if (places.empty()) return "";
  const auto [least, most] =
      std::minmax_element(places.begin(), places.end(), [&](const auto* a, const auto* b) {
        return a->gain_lx[requirement].value < b->gain_lx[requirement].value;
      });
  const double lowest = std::min(0.0, (*least)->gain_lx[requirement].value);
  const double highest = std::max(1.0e-3, (*most)->gain_lx[requirement].value);
  const report::ColourScale scale = report::make_colour_scale(lowest, highest);
  const Frame frame = frame_of(room);
  const glm::dvec2 size_px = frame.size_px();
  return fmt::format(
             "<figure class=\"ceiling\"><svg class=\"map\" role=\"img\" viewBox=\"0 0 {0} {1}\" "
             "width=\"{0}\" height=\"{1}\" aria-label=\"{2}\">\n",
             svg_number(size_px.x), svg_number(size_px.y),
             escape_html(fmt::format(
                 "Plan of the ceiling: what one more luminaire of type {} adds, at most {} at {}",
                 report::printable(type),
                 report::format_measured((*most)->gain_lx[requirement], "lx"),
                 report::format_position((*most)->position_m)))) +
         cells(places, requirement, scale, frame, room.step_m) + room_lines(room, frame) +
         together_marks(room, type, frame) + best_marks(room, type, frame) + "</svg>\n" +
         report::html_colour_bar(report::Texts(), scale, {}) + "</figure>\n";
}

}  // namespace cli
