#include "report/html/drawings/html_difference.h"

#include "report/html/drawings/plan_cells.h"
#include "report/html/page/html_markup.h"
#include "report/images/heatmap.h"
#include "report/revision/revision_tables.h"
#include "report/text/markup.h"
#include "report/text/plain_text.h"
#include "report/text/svg.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace report {
namespace {

constexpr std::size_t kMostDrawings = 12;
constexpr int kSteps = 8;  // of colour on either side of no change

// Orange for less light, purple for more: told apart with all common forms of colour-vision
// deficiency. (The ends of ColorBrewer's PuOr.)
constexpr Rgb kLess{179, 88, 6}, kNone{247, 247, 247}, kMore{84, 39, 136};

Rgb step_colour(int step) {
  const double share = std::abs(step) / static_cast<double>(kSteps);
  const Rgb& end = step < 0 ? kLess : kMore;
  const auto mix = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {mix(kNone.r, end.r), mix(kNone.g, end.g), mix(kNone.b, end.b)};
}

struct Difference {
  const SpacePart* space = nullptr;
  const PlanePart* plane = nullptr;
  const RevisionPlace* place = nullptr;
  std::vector<double> lx;  // [point]
  double largest_lx = 0.0;
  double largest_share = 0.0;  // of the plane's average before
};

std::optional<Difference> difference_of_plane(const Document& document,
                                              const ChangedPlane& changed) {
  std::optional<Difference> found;
  for_each_plane(document, [&](const PlaneIndex&, const ProjectPart& project,
                               const SpacePart& space, const PlanePart& plane) {
    const RevisionPlace& place = changed.place;
    if (project.path != place.project || space.id != place.space || plane.id != place.plane) return;
    if (!has_cells(plane) || plane.points.size() != changed.before_lx.size()) return;
    Difference difference{&space, &plane, &place, {}};
    double sum_lx = 0.0;
    for (std::size_t k = 0; k < plane.points.size(); ++k) {
      difference.lx.push_back(plane.points[k].measured.value - changed.before_lx[k]);
      difference.largest_lx = std::max(difference.largest_lx, std::abs(difference.lx.back()));
      sum_lx += changed.before_lx[k];
    }
    const double average_lx = sum_lx / static_cast<double>(plane.points.size());
    difference.largest_share =
        average_lx > 0.0 ? difference.largest_lx / average_lx : difference.largest_lx;
    found = std::move(difference);
  });
  return found;
}

std::string signed_lx(const Texts& t, double lx) {
  const std::string digits = format_cell(t, std::abs(lx));
  const bool is_zero = digits.find_first_of("123456789") == std::string::npos;
  return is_zero ? "0" : (lx < 0.0 ? "−" : "+") + digits;
}

// Font size at which every number fits into its cell; 0: they do not fit.
double text_size_px(const PlanCells& cells, const std::vector<std::string>& words) {
  constexpr double kDigitWidth = 0.6, kSmallest = 7.5, kLargest = 12.5;
  std::size_t longest = 1;
  for (const std::string& word : words) longest = std::max(longest, display_width(word));
  const double fitting =
      std::min(0.86 * cells.cell_px().x / (kDigitWidth * static_cast<double>(longest)),
               0.62 * cells.cell_px().y);
  return fitting < kSmallest ? 0.0 : std::min(fitting, kLargest);
}

std::string svg_legend(const Texts& t, double largest_lx) {
  constexpr double kBox = 20, kHeight = 14;
  std::string svg = fmt::format(
      "<svg class=\"colour-bar\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "aria-hidden=\"true\">\n",
      svg_number(kBox * (2 * kSteps + 1) + 80), svg_number(kHeight + 20));
  for (int step = -kSteps; step <= kSteps; ++step) {
    svg += fmt::format("<rect x=\"{}\" y=\"0\" width=\"{}\" height=\"{}\" fill=\"{}\"/>",
                       svg_number(40 + kBox * (step + kSteps)), svg_number(kBox),
                       svg_number(kHeight), hex_colour(step_colour(step)));
  }
  const double middle = 40 + kBox * (kSteps + 0.5), y = kHeight + 15;
  svg += svg_text(40 + 0.5 * kBox, y, "middle", signed_lx(t, -largest_lx) + " lx") +
         svg_text(middle, y, "middle", "0") +
         svg_text(2 * middle - 40 - 0.5 * kBox, y, "middle", signed_lx(t, largest_lx) + " lx");
  return svg + "</svg>\n";
}

std::string figure(const Texts& t, const Document& document, const Difference& difference) {
  const PlanePart& plane = *difference.plane;
  const PlanCells cells = plan_cells(*difference.space, plane, {480, 345});
  std::map<int, std::string> paths, texts;
  std::vector<std::string> words;
  for (const double lx : difference.lx) words.push_back(signed_lx(t, lx));
  const double size = text_size_px(cells, words);
  for (std::size_t k = 0; k < plane.points.size(); ++k) {
    const PointRow& point = plane.points[k];
    const int step = static_cast<int>(
        std::lround(kSteps * difference.lx[k] / std::max(difference.largest_lx, 1e-300)));
    paths[step] += cells.cell_path(point.column, point.row);
    if (size == 0.0) continue;
    const glm::dvec2 middle = cells.cell_middle_px(point.column, point.row);
    texts[step] += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>", svg_number(middle.x),
                               svg_number(middle.y + 0.36 * size), words[k]);
  }
  const auto [low, high] = std::minmax_element(difference.lx.begin(), difference.lx.end());
  const std::string from = signed_lx(t, *low), to = signed_lx(t, *high);
  std::string svg = fmt::format(
      "<svg class=\"plan\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
      "aria-label=\"{2}\">\n",
      svg_number(cells.layout.width_px()), svg_number(cells.layout.height_px()),
      t.say<Text::difference_spoken>(escape_html(plane_title(t, plane)), plane.points.size(), from,
                                     to));
  for (const auto& [step, path] : paths) {
    const std::string colour = hex_colour(step_colour(step));
    svg += fmt::format("<path fill=\"{0}\" stroke=\"{0}\" stroke-width=\".4\" d=\"{1}\"/>\n",
                       colour, path);
  }
  for (const auto& [step, text] : texts) {
    const Rgb colour = step_colour(step);
    svg += fmt::format("<g class=\"numbers\" fill=\"{}\" stroke=\"{}\" font-size=\"{}\">{}</g>\n",
                       needs_dark_text(colour) ? "#000" : "#fff", hex_colour(colour),
                       svg_number(size), text);
  }
  return fmt::format("<figure>\n{}</svg>\n{}<figcaption><b>{}</b>. {}</figcaption></figure>\n", svg,
                     svg_legend(t, difference.largest_lx),
                     escape_html(place_words(document, *difference.place, t)),
                     t.say<Text::difference_caption>(from, to));
}

}  // namespace

std::string html_differences(const Texts& t, const Document& document) {
  std::vector<Difference> differences;
  for (const ChangedPlane& changed : document.revision->planes) {
    if (auto difference = difference_of_plane(document, changed)) {
      differences.push_back(std::move(*difference));
    }
  }
  if (differences.empty()) return {};
  std::stable_sort(
      differences.begin(), differences.end(),
      [](const Difference& a, const Difference& b) { return a.largest_share > b.largest_share; });
  const std::size_t shown = std::min(differences.size(), kMostDrawings);
  std::string html =
      fmt::format("<h3>{}</h3>\n<div class=\"differences\">\n", t[Text::difference_title]);
  for (std::size_t k = 0; k < shown; ++k) html += figure(t, document, differences[k]);
  html += "</div>\n";
  if (differences.size() > shown) {
    html += fmt::format("<p class=\"quiet\">{}</p>\n",
                        t.say<Text::difference_more>(differences.size() - shown));
  }
  return html;
}

}  // namespace report
