#include "report/html/drawings/heatmap_svg.h"

#include "report/html/drawings/html_plan.h"
#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/plane_names.h"
#include "report/text/svg.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace report {
namespace {

// As html_style.css on white, without variables: programs that draw SVG files know none.
constexpr const char* kHeatmapStyle = R"(
text { font-family: "Noto Sans", "DejaVu Sans", Arial, sans-serif; }
.cells path { stroke-width: .4; }
.floor { fill: #f1f3f5; }
.wall { fill: none; stroke: #2b3238; stroke-width: 3; }
.outline { fill: none; stroke: #191d21; stroke-width: 1; stroke-dasharray: 5 3; fill-rule: evenodd; }
.numbers { text-anchor: middle; paint-order: stroke; stroke-width: 3; stroke-linejoin: round; }
.luminaire { fill: none; stroke: #111; stroke-width: 1.2; }
.luminaire.halo { stroke: #fff; stroke-width: 2.6; stroke-opacity: .6; }
.luminaire .c0 { fill: #111; stroke-width: 1; }
.luminaire.halo .c0 { fill: #fff; stroke-width: 2.4; }
.sign-numbers { font-size: 10px; font-weight: 700; fill: #111; stroke: #fff; stroke-width: 2.6; stroke-opacity: .85; paint-order: stroke; stroke-linejoin: round; }
.furniture { fill: none; stroke: #000; stroke-width: 1; stroke-opacity: .5; }
.furniture.above { stroke-dasharray: 4 3; }
.isolux { fill: none; stroke: #fff; stroke-width: 1; stroke-linejoin: round; }
.isolux.halo { stroke: #000; stroke-width: 2; stroke-opacity: .4; }
.isolux.required { stroke-width: 2.4; }
.isolux.required.halo { stroke-width: 4.6; stroke-opacity: .85; }
.isolux-label { font-size: 10.5px; text-anchor: middle; fill: #fff; stroke: #16191c; stroke-width: 3.2; paint-order: stroke; stroke-linejoin: round; }
.isolux-label.required { font-weight: 700; }
.histogram rect { fill: #59636d; fill-opacity: .45; }
.min-halo { fill: none; stroke: #fff; stroke-width: 4.5; }
.min-mark { fill: none; stroke: #c2185b; stroke-width: 2.2; }
.scale { fill: none; stroke: #191d21; stroke-width: 1; }
.small, .colour-bar text { font-size: 11px; fill: #59636d; }
.title { font-size: 15px; font-weight: 600; fill: #191d21; }
.colour-bar .limit { fill: #191d21; font-weight: 600; }
.colour-bar .frame { fill: none; stroke: #59636d; stroke-width: .6; }
.colour-bar .mark { stroke: #191d21; stroke-width: 1.6; fill: none; }
.colour-bar .halo { stroke: #fff; stroke-width: 4.5; fill: none; }
)";

constexpr double kEdge = 12, kTitle = 30, kWords = 14, kScaleWidth = 480;

}  // namespace

std::string plane_picture_title(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  std::string title =
      std::string(title_of(space.name, space.id)) + " – " + plane_name(t, space, plane);
  if (plane.asked_light && plane.asked_light->is_shown) {
    title += ", " + asked_light_words(t, *plane.asked_light);
  }
  return title;
}

std::string render_heatmap_svg(const Texts& t, const SpacePart& space, const PlanePart& plane,
                               const PlaneScale& scale) {
  const PlanPictures pictures = plan_pictures(t, space, plane, scale);
  const double width = std::max(pictures.width_px, kScaleWidth) + 2 * kEdge;
  const double bar_top = kTitle + pictures.plan_height_px + kEdge;
  const double words_top = bar_top + pictures.bar_height_px + kWords;
  const double height = words_top + kEdge;
  const std::string title = escape_html(plane_picture_title(t, space, plane));
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\">\n<title>{2}</title>\n<style>{3}</style>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<text class=\"title\" x=\"{4}\" y=\"20\">{2}</text>\n"
      "<g transform=\"translate({4} {5})\">\n{6}</g>\n<g transform=\"translate({4} {7})\">\n{8}"
      "</g>\n<text class=\"small\" x=\"{4}\" y=\"{9}\">{10}</text>\n</svg>\n",
      svg_number(width), svg_number(height), title, kHeatmapStyle, kEdge, kTitle, pictures.plan,
      svg_number(bar_top), pictures.colour_bar, svg_number(words_top),
      sharing_words(t, scale.among));
}

}  // namespace report
