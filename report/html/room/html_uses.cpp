#include "report/html/room/html_uses.h"

#include "report/document/row_uses.h"
#include "report/html/page/html_markup.h"
#include "report/text/clause_words.h"
#include "report/text/markup.h"
#include "report/text/plane_names.h"
#include "report/text/room_overview.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace report {
namespace {

std::string number_cell(const std::string& text) { return "<td class=\"num\">" + text + "</td>"; }

// Of the smallest margin; none: nothing has one.
struct Nearest {
  std::string margin, place;  // "Office 3 / Desk" and what is required; HTML
};

Nearest nearest_of(const Texts& t, const ProjectPart& project, const RowUse& use) {
  if (!use.margin) return {};
  for (const SpacePart& space : project.spaces) {
    if (space.id != use.room) continue;
    for (const PlanePart& plane : space.planes) {
      if (plane.id != use.plane) continue;
      for (const rules::Finding& finding : plane.findings) {
        if (finding.requirement.id != use.requirement) continue;
        return {escape_html(margin_words(t, finding)),
                escape_html(std::string(title_of(space.name, space.id)) + " / " +
                            plane_in_room(t, space, plane)) +
                    "<span class=\"note\">" + escape_html(quantity_words(t, finding.requirement)) +
                    "</span>"};
      }
    }
  }
  return {};
}

std::string row_of(const Texts& t, const ProjectPart& project, const RowUse& use) {
  // No tick where the row is nowhere known to be met.
  const bool is_less =
      use.outcome == rules::Outcome::pass && !(use.is_met() && use.is_wholly_judged());
  const Text less = use.is_wholly_judged() ? Text::met_with_exceptions : Text::use_in_part;
  const std::string verdict = is_less ? std::string("– ") + t[less]
                                      : fmt::format("{} {}", outcome_symbol(use.outcome),
                                                    escape_html(outcome_words(t, use.outcome)));
  const Nearest nearest = nearest_of(t, project, use);
  return fmt::format("<tr><th scope=\"row\">{}</th>",
                     escape_html(clause_words(t, use.clause,
                                              rules::source_of_pack(use.is_user_supplied)))) +
         number_cell(fmt::format("{}", use.rooms.size())) + "<td>" + verdict + "</td>" +
         number_cell(t.say<Text::so_many_of>(use.met, use.requirements)) +
         number_cell(t.say<Text::so_many_of>(use.whole - use.open, use.times)) +
         number_cell(nearest.margin) + "<td>" + nearest.place + "</td></tr>\n";
}

// A limit stays with its sign where a narrow cell takes two lines.
std::string unbroken(std::string cell) {
  for (const std::string_view sign : {"≥ ", "≤ "}) {
    for (std::size_t at = cell.find(sign); at != std::string::npos; at = cell.find(sign, at))
      cell.replace(at + sign.size() - 1, 1, "\u00a0");
  }
  return cell;
}

// Only documents with such rooms have it.
constexpr const char* kAreaStyle = "padding-left: 1.2em; font-weight: 400";

// Its verdict, and its name with a link.
std::string room_cells(const Texts& t, const PlaneIndex& room, const RoomOverview::Row& row,
                       const std::string& folder) {
  const std::string address = folder.empty() ? "#" + space_anchor(room.project, room.space)
                                             : fmt::format("{}/{}", folder, page_name(room));
  return fmt::format("<tr><td>{}</td><th scope=\"row\"><a href=\"{}\">{}</a></th>",
                     outcome_badge(t, row.outcome), address, escape_html(row.cells[1]));
}

}  // namespace

std::string html_rooms(const Texts& t, const ProjectPart& project, std::size_t index,
                       const std::string& folder) {
  const RoomOverview table = room_overview(t, project);
  if (table.rows.empty()) return {};
  const auto class_of = [&](std::size_t column) {
    return table.is_number(column) ? " class=\"num\"" : "";
  };
  std::string head, rows;
  for (std::size_t c = 0; c < table.head.size(); ++c) {
    head += fmt::format("<th scope=\"col\"{}>{}</th>", class_of(c), escape_html(table.head[c]));
  }
  for (const RoomOverview::Row& row : table.rows) {
    if (row.is_area) {
      rows += fmt::format("<tr><td>{}</td><th scope=\"row\" style=\"{}\">{}</th>",
                          outcome_badge(t, row.outcome), kAreaStyle, escape_html(row.cells[1]));
    } else {
      rows += room_cells(t, {index, row.space, 0}, row, folder);
    }
    for (std::size_t c = 2; c < row.cells.size(); ++c) {
      const bool is_count = table.columns[c] == RoomOverview::Column::met;  // "38 of 38"
      rows += fmt::format("<td{}{}>{}</td>", class_of(c),
                          is_count ? " style=\"white-space: nowrap\"" : "",
                          unbroken(escape_html(row.cells[c])));
    }
    rows += "</tr>\n";
  }
  const char* title = t[Text::overview_title];
  return scroll_box(title, std::string("<table class=\"rooms\"><caption class=\"unseen\">") +
                               title + "</caption><thead><tr>" + head + "</tr></thead><tbody>\n" +
                               rows + "</tbody></table>");
}

std::string html_uses(const Texts& t, const ProjectPart& project, std::size_t index) {
  const std::vector<RowUse> uses = row_uses(project);
  std::set<std::string> rooms;
  for (const RowUse& use : uses) rooms.insert(use.rooms.begin(), use.rooms.end());
  if (rooms.size() < 2) return {};
  std::string rows;
  for (const RowUse& use : uses) rows += row_of(t, project, use);
  const auto head = [](const char* words, bool is_number) {
    return std::string("<th scope=\"col\"") + (is_number ? " class=\"num\">" : ">") + words +
           "</th>";
  };
  const char* title = t[Text::uses];
  return fmt::format("<h3 id=\"uses{}\">{}</h3>\n", index + 1, title) +
         scroll_box(title, std::string("<table class=\"uses\"><caption>") + t[Text::uses_caption] +
                               "</caption><thead><tr>" + head(t[Text::row_of_pack], false) +
                               head(t[Text::rooms], true) + head(t[Text::verdict], false) +
                               head(t[Text::requirements_met], true) +
                               head(t[Text::judged_as_a_whole], true) +
                               head(t[Text::smallest_margin], true) + head(t[Text::where], false) +
                               "</tr></thead><tbody>\n" + rows + "</tbody></table>");
}

}  // namespace report
