#include "report/html/room/html_room.h"

#include "report/html/drawings/html_legend.h"
#include "report/html/page/html_markup.h"
#include "report/images/heatmap.h"
#include "report/text/base64.h"
#include "report/text/markup.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace report {
namespace {

// Titles of our own are English in results.
std::string picture_title(const Texts& t, const RoomPicture& picture) {
  for (const Text id : {Text::from_a_corner, Text::from_above})
    if (picture.title == english_text(id)) return t[id];
  return picture.title;
}

// kind: attributes of the element.
std::string picture_html(const Texts& t, const SpacePart& space, const RoomPicture& picture,
                         const char* kind) {
  return fmt::format(
      "<img{} src=\"data:image/png;base64,{}\" width=\"{}\" height=\"{}\" alt=\"{}\"/>\n", kind,
      base64(picture.png), picture.width, picture.height,
      escape_html(picture_words(t, space, picture)));
}

// Rounded up, so that an error is not told smaller than it is.
double in_two_digits(double share) {
  const double steps = share > 0.1 ? 1e2 : share > 0.01 ? 1e3 : 1e4;
  return std::ceil(share * steps - 1e-9) / steps;
}

}  // namespace

std::string picture_words(const Texts& t, const SpacePart& space, const RoomPicture& picture) {
  const auto name = title_of(space.name, space.id);
  const std::string title = picture_title(t, picture);
  return picture.is_rendered ? t.say<Text::rendered_words>(name, title)
                             : t.say<Text::picture_words>(name, title);
}

std::string html_room(const Texts& t, const SpacePart& space, bool is_brief) {
  const RoomPictures& pictures = space.pictures;
  if (!pictures.problem.empty()) {
    if (is_brief) return {};
    return "<p class=\"quiet\">" +
           t.say<Text::no_pictures>(t.english_html(escape_html(pictures.problem))) + "</p>\n";
  }
  if (pictures.list.empty()) return {};
  const ColourScale scale{pictures.low_lx, pictures.step_lx, pictures.bands, {}, pictures.map};
  std::string html = "<figure class=\"room\">\n";
  for (const RoomPicture& picture : pictures.list) html += picture_html(t, space, picture, "");
  html += html_colour_bar(t, scale, {});
  if (is_brief) html += html_paper_colour_bar(t, scale, {}, "lx");
  std::string beyond;
  if (pictures.highest_lx > scale.high()) {
    beyond = " " + t.say<Text::brightest_places>(format_cell(t, pictures.highest_lx));
  }
  const bool has_rendered =
      std::any_of(pictures.list.begin(), pictures.list.end(),
                  [](const RoomPicture& picture) { return picture.is_rendered; });
  if (is_brief) {
    return html + "<figcaption>" +
           t.say<Text::picture_brief>(format_percent(t, in_two_digits(pictures.error_share)),
                                      beyond) +
           "</figcaption></figure>\n";
  }
  const std::string device =
      " " + t.say<Text::picture_device>(t.english_html(escape_html(pictures.device)));
  return html + "<figcaption>" +
         t.say<Text::picture_caption>(beyond, format_percent(t, pictures.error_share)) + device +
         (has_rendered ? fmt::format(" {}", t[Text::rendered_caption]) : "") +
         "</figcaption></figure>\n";
}

std::string html_cover_picture(const Texts& t, const ProjectPart& project) {
  for (const SpacePart& space : project.spaces) {
    const std::vector<RoomPicture>& list = space.pictures.list;
    if (list.empty()) continue;
    const auto rendered = std::find_if(list.begin(), list.end(),
                                       [](const auto& picture) { return picture.is_rendered; });
    return picture_html(t, space, rendered == list.end() ? list.front() : *rendered,
                        " class=\"on-cover\"");
  }
  return {};
}

}  // namespace report
