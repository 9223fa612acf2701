#include "report/html/client/client_positions.h"

#include "report/document/storeys.h"
#include "report/html/page/html_markup.h"
#include "report/text/luminaire_aim.h"
#include "report/text/markup.h"
#include "report/text/plain_text.h"
#include "report/text/room_titles.h"
#include "report/text/storey_title.h"
#include "report/text/text_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace report {
namespace {

// Mark, x, y, height and aim of a luminaire; not escaped.
using PositionLine = std::vector<std::string>;

// A room or a storey.
struct PositionGroup {
  std::string title;
  std::vector<const SpacePart*> spaces;

  std::size_t count() const {
    std::size_t all = 0;
    for (const SpacePart* space : spaces) all += space->luminaires.size();
    return all;
  }
};

std::vector<PositionGroup> groups_by_room(const ProjectPart& project) {
  const std::vector<std::string> titles = room_titles(project);
  std::vector<PositionGroup> groups;
  for (const std::size_t s : spaces_in_order(project)) {
    if (!project.spaces[s].luminaires.empty()) groups.push_back({titles[s], {&project.spaces[s]}});
  }
  return groups;
}

// Spaces that are on no storey, or alone on one, keep their titles.
std::vector<PositionGroup> groups_by_storey(const Texts& t, const ProjectPart& project) {
  const Storeys storeys = storeys_of(project);
  std::vector<const Storey*> storey_of(project.spaces.size(), nullptr);
  for (const Storey& storey : storeys.list) {
    for (const std::size_t room : storey.rooms) storey_of[room] = &storey;
  }
  std::vector<PositionGroup> groups;
  const Storey* last = nullptr;
  for (PositionGroup& room : groups_by_room(project)) {
    const Storey* own =
        storey_of[static_cast<std::size_t>(room.spaces.front() - project.spaces.data())];
    if (own != nullptr && own == last) {
      groups.back().title = storey_title(t, own->floor_z_m);
      groups.back().spaces.push_back(room.spaces.front());
      continue;
    }
    groups.push_back(std::move(room));
    last = own;
  }
  return groups;
}

bool is_straight_down(const LuminaireAim& aim) {
  constexpr double kLeast_deg = 0.05;  // what is shown as 0.0 is none
  return aim.tilt_deg && *aim.tilt_deg < kLeast_deg;
}

PositionLine position_line(const Texts& t, const SpacePart& space, const LuminaireMark& mark) {
  const double floor_z_m = space.footprint_m.empty() ? 0.0 : space.floor_z_m;
  const LuminaireAim aim = aim_of(mark);
  // A result file may hold numbers of hundreds of digits.
  constexpr std::size_t kLongest = 16;
  const auto metres = [&t](double m) {
    return shorten_end(with_minus(format_metres(t, m)), kLongest);
  };
  return {mark.label, metres(mark.position_m.x), metres(mark.position_m.y),
          metres(mark.position_m.z - floor_z_m),
          is_straight_down(aim) ? ""
          : aim.tilt_deg        ? aim_words(t, aim)
                                : "–"};
}

// Of a storey the rooms together, by marks.
std::vector<PositionLine> lines_of(const Texts& t, const PositionGroup& group) {
  std::vector<PositionLine> lines;
  for (const SpacePart* space : group.spaces) {
    for (const LuminaireMark& mark : space->luminaires)
      lines.push_back(position_line(t, *space, mark));
  }
  std::stable_sort(lines.begin(), lines.end(), [](const PositionLine& a, const PositionLine& b) {
    return comes_before(a[0], b[0]);
  });
  return lines;
}

struct ListedGroup {
  std::string title;
  std::vector<PositionLine> lines;
};

// As many luminaires as fit beside each other on a page, by their longest words.
std::size_t luminaires_across(const PositionLine& heads, const std::vector<ListedGroup>& groups) {
  constexpr double kPage = 125.0, kGap = 1.2;  // characters of 7.5 points
  constexpr std::size_t kMost = 4;
  std::size_t longest_group = 1;
  std::vector<std::size_t> widths;
  for (const std::string& head : heads) widths.push_back(display_width(head));
  for (const ListedGroup& group : groups) {
    longest_group = std::max(longest_group, group.lines.size());
    for (const PositionLine& line : group.lines) {
      for (std::size_t c = 0; c < heads.size(); ++c)
        widths[c] = std::max(widths[c], display_width(line[c]));
    }
  }
  double width = kGap;
  for (const std::size_t column : widths) width += static_cast<double>(column) + kGap;
  const auto fitting = static_cast<std::size_t>(std::max(1.0, std::floor(kPage / width)));
  return std::min({fitting, kMost, longest_group});
}

std::string group_html(const ListedGroup& group, std::size_t columns, std::size_t across) {
  constexpr std::size_t kLongestTitle = 90;
  std::string html = fmt::format(
      "<tbody>\n<tr class=\"group\"><th scope=\"rowgroup\" colspan=\"{}\">{}</th></tr>\n",
      columns * across, escape_html(shorten_name(printable(group.title), kLongestTitle)));
  for (std::size_t i = 0; i < group.lines.size(); i += across) {
    const std::size_t end = std::min(i + across, group.lines.size());
    html += "<tr>";
    for (std::size_t k = i; k < end; ++k) {
      const PositionLine& line = group.lines[k];
      html += "<th scope=\"row\">" + escape_html(line[0]) + "</th>";
      for (std::size_t c = 1; c < columns; ++c)
        html += "<td class=\"num\">" + escape_html(line[c]) + "</td>";
    }
    if (const std::size_t free = across - (end - i); free > 0)
      html += fmt::format("<td class=\"num\" colspan=\"{}\"></td>", free * columns);
    html += "</tr>\n";
  }
  return html + "</tbody>";
}

std::string heads_html(const PositionLine& heads, std::size_t across) {
  std::string html;
  for (std::size_t k = 0; k < across; ++k) {
    for (std::size_t c = 0; c < heads.size(); ++c) {
      html += fmt::format("<th scope=\"col\"{}>{}</th>", c == 0 ? "" : " class=\"num\"",
                          escape_html(heads[c]));
    }
  }
  return "<thead><tr>" + html + "</tr></thead>\n";
}

// By rooms, unless these are too many lines for a page.
std::vector<PositionGroup> chosen_groups(const Texts& t, const ProjectPart& project) {
  constexpr std::size_t kMostLines = 60, kAcross = 3;
  std::vector<PositionGroup> rooms = groups_by_room(project);
  std::size_t lines = 0;
  for (const PositionGroup& room : rooms) lines += 1 + (room.count() + kAcross - 1) / kAcross;
  return lines <= kMostLines ? std::move(rooms) : groups_by_storey(t, project);
}

}  // namespace

ClientPositions client_positions(const Texts& t, const ProjectPart& project, bool is_part,
                                 std::size_t most) {
  ClientPositions positions;
  std::vector<ListedGroup> groups;
  std::size_t all = 0;
  bool has_aim = false;
  for (const PositionGroup& group : chosen_groups(t, project)) {
    all += group.count();
    if (positions.listed == most) continue;
    ListedGroup listed{group.title, lines_of(t, group)};
    listed.lines.resize(std::min(listed.lines.size(), most - positions.listed));
    positions.listed += listed.lines.size();
    for (const PositionLine& line : listed.lines) has_aim = has_aim || !line.back().empty();
    groups.push_back(std::move(listed));
  }
  if (all == 0) return positions;
  std::string caption = t[Text::client_positions_caption];
  if (has_aim) caption += std::string(" ") + t[Text::client_positions_tilt];
  if (is_part) caption += std::string(" ") + t[Text::client_positions_part];
  if (positions.listed < all)
    caption += " " + t.say<Text::client_positions_omitted>(all - positions.listed, all);
  if (groups.empty()) {
    positions.html = "<p class=\"quiet\">" + caption + "</p>\n";
    return positions;
  }
  PositionLine heads{t[Text::luminaire_mark], "x m", "y m", t[Text::mounting_height_m]};
  if (has_aim) heads.emplace_back(t[Text::tilt]);
  const std::size_t across = luminaires_across(heads, groups);
  std::string table = "<table class=\"client-positions\"><caption>" + caption + "</caption>" +
                      heads_html(heads, across);
  for (const ListedGroup& group : groups) table += group_html(group, heads.size(), across);
  positions.html = scroll_box(t.say<Text::positions_of>(all), table + "</table>");
  return positions;
}

}  // namespace report
