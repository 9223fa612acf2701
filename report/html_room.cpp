#include "report/html_room.h"

#include "report/heatmap.h"
#include "report/html_legend.h"
#include "report/html_markup.h"
#include "report/words.h"

#include <fmt/format.h>

namespace report {

std::string html_room(const SpacePart& space) {
  const RoomPictures& pictures = space.pictures;
  if (!pictures.problem.empty()) {
    return "<p class=\"quiet\">No pictures of this room: " + escape_html(pictures.problem) +
           ".</p>\n";
  }
  if (pictures.list.empty()) return {};
  const ColourScale scale{pictures.low_lx, pictures.step_lx, pictures.bands};
  std::string html = "<figure class=\"room\">\n";
  for (const RoomPicture& picture : pictures.list) {
    html += fmt::format(
        "<img src=\"data:image/png;base64,{}\" width=\"{}\" height=\"{}\" alt=\"{} {}, "
        "illuminance in false colours\"/>\n",
        base64(picture.png), picture.width, picture.height,
        escape_html(title_of(space.name, space.id)), escape_html(picture.title));
  }
  html += html_colour_bar(scale, {});
  std::string beyond;
  if (pictures.highest_lx > scale.high_lx()) {
    beyond = fmt::format(" The brightest places reach {} lx.", format_cell_lx(pictures.highest_lx));
  }
  return html +
         fmt::format(
             "<figcaption>Maintained illuminance in lx on surfaces, every luminaire at full "
             "output; dots are calculation points, white outlines calculation planes. Surfaces "
             "between the eye and the room are left out.{} For a look only, verdicts do not rest "
             "on it: sampling on surfaces has a relative standard error of {}, and shadows are as "
             "sharp as a mesh allows. Drawn by {}.</figcaption></figure>\n",
             beyond, format_percent(pictures.error_share), escape_html(pictures.device));
}

}  // namespace report
