#include "report/html/client/client_room.h"

#include "report/document/room_lines.h"
#include "report/document/shown_plane.h"
#include "report/html/chapters/html_findings.h"
#include "report/html/drawings/html_plan.h"
#include "report/html/room/html_room.h"
#include "report/html/room/html_room_data.h"
#include "report/images/heatmap.h"
#include "report/text/clause_words.h"
#include "report/text/markup.h"
#include "report/text/notices.h"
#include "report/text/plane_names.h"
#include "report/text/room_causes.h"
#include "report/text/sentences.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

// What must be read with a room's values, each once with the planes that it is about.
class RoomNotes {
 public:
  void add(std::string place, std::string words) {
    if (words.empty()) return;
    for (auto& [known, places] : notes_) {
      if (known != words) continue;
      if (std::find(places.begin(), places.end(), place) == places.end())
        places.push_back(std::move(place));
      return;
    }
    notes_.push_back({std::move(words), {std::move(place)}});
  }

  std::string html(const Texts& t) const {
    if (notes_.empty()) return {};
    std::string list;
    for (const auto& [words, places] : notes_) {
      const std::string where = some_names(t, places);
      list +=
          "<li>" + (where.empty() ? "" : escape_html(where) + t[Text::colon]) + words + "</li>\n";
    }
    return "<ul class=\"room-notes\">\n" + list + "</ul>\n";
  }

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> notes_;  // words: HTML
};

// "Walls (7)", "task", "observer 2".
std::string line_title(const Texts& t, const SpacePart& space, const RoomLine& line) {
  if (line.parts.size() == 1) return plane_in_room(t, space, *line.parts.front().plane);
  if (line.role == "wall") return t.say<Text::client_walls>(line.parts.size());
  if (line.role == "observer") return t.say<Text::client_observers>(line.parts.size());
  std::vector<std::string> names;
  for (const RoomCause::Part& part : line.parts)
    names.push_back(plane_in_room(t, space, *part.plane));
  return some_names(t, names);
}

// What the values of a line have to be read with: of requirements, of how they were come by, and
// of how well the row's numbers are founded.
std::vector<NoteItem> items_of(const Texts& t, const RoomCause::Part& part) {
  std::vector<NoteItem> items = note_items(t, *part.finding);
  for (const calc::Message& remark : part.plane->remarks) {
    const std::vector<NoteItem> own = note_items(t, remark);
    items.insert(items.end(), own.begin(), own.end());
  }
  return items;
}

// Without how well the row's numbers are founded, which footnotes tell.
std::string clause_of(const Texts& t, const rules::Requirement& requirement) {
  return clause_words(t, without_source(requirement.clause), rules::source_of(requirement));
}

// The rows that the room's requirements are of, each once, in the order of the lines.
struct Clauses {
  std::vector<std::string> all;
  std::size_t shared = 0;  // bytes of the standard's title, where all are of one pack
  // Where there are several, each line has its own.
  std::string beside(const std::string& clause) const {
    return all.size() > 1 ? clause.substr(shared) : std::string();
  }
};

Clauses clauses_of(const Texts& t, const std::vector<RoomLine>& lines) {
  Clauses clauses;
  std::set<std::string> packs;
  for (const RoomLine& line : lines) {
    const rules::Requirement& requirement = line.parts.front().finding->requirement;
    if (requirement.clause.empty()) continue;
    packs.insert(requirement.origin.pack);
    std::string clause = clause_of(t, requirement);
    if (std::find(clauses.all.begin(), clauses.all.end(), clause) == clauses.all.end())
      clauses.all.push_back(std::move(clause));
  }
  if (packs.size() != 1 || packs.begin()->empty()) return clauses;
  std::string_view shared = clauses.all.front();
  for (const std::string& clause : clauses.all) {
    const auto [end, other] =
        std::mismatch(shared.begin(), shared.end(), clause.begin(), clause.end());
    shared = shared.substr(0, static_cast<std::size_t>(end - shared.begin()));
  }
  clauses.shared = shared.rfind(' ') + 1;  // 0 where there is none
  return clauses;
}

std::string line_html(const Texts& t, const SpacePart& space, const RoomLine& line,
                      const Clauses& clauses, const Footnotes& footnotes) {
  const RoomCause::Part& worst = line.worst();
  const rules::Finding& finding = *worst.finding;
  const rules::Requirement& requirement = finding.requirement;
  const Threshold threshold{requirement.limit, requirement.comparison};
  const char* unit = rules::unit_of(requirement);
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  std::string measured = is_judged ? escape_html(measured_words(t, finding)) : std::string("–");
  if (is_judged && line.parts.size() > 1) {
    measured +=
        "<span class=\"note\">" + escape_html(plane_in_room(t, space, *worst.plane)) + "</span>";
  }
  std::vector<NoteItem> items;
  for (const RoomCause::Part& part : line.parts) {
    const std::vector<NoteItem> own = items_of(t, part);
    items.insert(items.end(), own.begin(), own.end());
  }
  const std::string marks = footnotes.marks(items);
  const std::string clause =
      requirement.clause.empty() ? "" : clauses.beside(clause_of(t, requirement));
  const std::string note =
      clause.empty() ? "" : "<span class=\"note\">" + escape_html(clause) + "</span>";
  return fmt::format(
      "<tr class=\"{}\"><th scope=\"row\">{}</th><td>{}{}{}</td><td class=\"num\">{}</td><td "
      "class=\"num strong\">{}</td><td>{}</td></tr>\n",
      calc::name_of(finding.verdict), escape_html(line_title(t, space, line)),
      escape_html(quantity_words(t, requirement, worst.plane->kernel)),
      escape_html(scene_words(t, requirement)), marks + note,
      escape_html(format_required(t, threshold, unit)), measured,
      html_verdict(t, *worst.plane, finding));
}

std::string requirements_table(const Texts& t, const SpacePart& space,
                               const std::vector<RoomLine>& lines, const Clauses& clauses,
                               const Footnotes& footnotes) {
  if (lines.empty()) return {};
  std::string rows;
  for (const RoomLine& line : lines) rows += line_html(t, space, line, clauses, footnotes);
  const std::string label =
      t.say<Text::requirements_of>(escape_html(title_of(space.name, space.id)));
  return scroll_box(
      label, fmt::format("<table class=\"findings\"><caption class=\"unseen\">{}</caption><thead>"
                         "<tr><th scope=\"col\">{}</th><th scope=\"col\">{}</th><th scope=\"col\" "
                         "class=\"num\">{}</th><th scope=\"col\" class=\"num\">{}</th><th "
                         "scope=\"col\">{}</th></tr></thead><tbody>\n{}</tbody></table>",
                         label, t[Text::plane], t[Text::requirement], t[Text::required],
                         t[Text::measured], t[Text::verdict], rows));
}

// Planes whose light is shown: tasks, what the project describes by itself, and routes.
bool is_charted(const PlanePart& plane) {
  if (!plane.is_computed || !is_plain_illuminance(plane) || !has_cells(plane) ||
      !has_all_values(plane)) {
    return false;
  }
  return plane.made_by.empty() ||
         std::any_of(plane.findings.begin(), plane.findings.end(),
                     [](const auto& finding) { return finding.requirement.origin.is_of_own_role; });
}

struct Chart {
  const PlanePart* plane;
  std::size_t index;
};

// Two beside each other where there are several, but a long one alone.
PlanPlace place_of(const PlanePart& plane, std::size_t charts, Paper paper) {
  constexpr double kWhole_mm = 180, kHalf_mm = 87, kStacked_mm = 140, kHigh_mm = 64, kLow_mm = 45,
                   kLong = 4;
  constexpr int kMostPieces = 5;
  const double less_mm = paper == Paper::letter ? 12 : 0;
  const glm::dvec2 size = glm::dvec2(plane.grid.columns, plane.grid.rows) *
                          glm::dvec2(plane.grid.spacing_u_m, plane.grid.spacing_v_m);
  const bool is_long = size.x > kLong * size.y || size.y > kLong * size.x;
  const double most_mm = charts == 1 ? kWhole_mm : is_long ? kStacked_mm : kHalf_mm;
  return {{most_mm, (charts == 1 ? kHigh_mm : kLow_mm) - less_mm}, is_long ? kMostPieces : 1};
}

std::string charts_html(const Texts& t, const SpacePart& space, PlaneIndex room,
                        const ColourScales& scales, Paper paper) {
  constexpr std::size_t kMostCharts = 8;
  std::vector<Chart> charts;
  for (std::size_t k = 0; k < space.planes.size(); ++k) {
    if (is_charted(space.planes[k])) charts.push_back({&space.planes[k], k});
  }
  const std::size_t left_out = charts.size() - std::min(charts.size(), kMostCharts);
  charts.resize(charts.size() - left_out);
  std::string html;
  for (const Chart& chart : charts) {
    const ShownPlane shown(*chart.plane);
    const PlanPlace place = place_of(*chart.plane, charts.size(), paper);
    html += fmt::format("<div class=\"chart\"><h3>{}</h3>\n",
                        escape_html(plane_name(t, space, *chart.plane))) +
            html_plan(t, space, *shown, scales.of(space, *shown),
                      plane_anchor({room.project, room.space, chart.index}) + "-chart", place) +
            "</div>\n";
  }
  if (html.empty()) return {};
  if (left_out > 0)
    html += "<p class=\"quiet\">" + t.say<Text::client_charts_left_out>(left_out) + "</p>\n";
  return html;
}

// So that links from other chapters arrive. Within the heading: a line of their own between it and
// what follows would be a place to break a page.
std::string anchors(const SpacePart& space, PlaneIndex room) {
  std::string html;
  for (std::size_t k = 0; k < space.planes.size(); ++k)
    html += fmt::format("<span id=\"{}\"></span>", plane_anchor({room.project, room.space, k}));
  return html;
}

bool is_of_room_page(NoticeKind kind) {
  switch (kind) {
    case NoticeKind::in_part:
    case NoticeKind::left_out:
    case NoticeKind::changed:
    case NoticeKind::doubt:
      return true;
    case NoticeKind::note:
    case NoticeKind::row:
    case NoticeKind::remark:
      break;
  }
  return false;
}

// What a plane came to of which nothing is required, or why it came to nothing.
std::string unasked_html(const Texts& t, const PlanePart& plane) {
  if (!plane.is_computed) return t.say<Text::not_computed_because>(sentence_html(t, plane.reason));
  const char* unit = plane_unit(plane);
  if (calc::is_plain_number(plane.derived)) {
    return escape_html(t.say<Text::brief_extremes>(format_measured(t, plane.minimum, unit),
                                                   format_measured(t, plane.maximum, unit)));
  }
  return t.say<Text::brief_statistics>(format_measured(t, plane.average, unit),
                                       format_measured(t, plane.minimum, unit),
                                       format_measured(t, plane.uniformity_min_avg, ""));
}

// The causes of its room tell its reason.
bool is_cause(const rules::Finding& finding) {
  return finding.verdict != rules::Verdict::pass &&
         outcome_of(finding) != rules::Outcome::nothing_asked;
}

RoomNotes notes_of(const Texts& t, const SpacePart& space, const Footnotes& footnotes) {
  RoomNotes notes;
  for (const PlanePart& plane : space.planes) {
    const std::string name = plane_in_room(t, space, plane);
    if (is_charted(plane)) notes.add(name, escape_html(other_light_words(t, *ShownPlane(plane))));
    for (const rules::Finding& finding : plane.findings) {
      notes.add(name, escape_html(close_words(t, finding)));
      if (!is_cause(finding)) notes.add(name, sentence_html(t, finding.reason));
      for (const NoteItem& item : note_items(t, finding))
        if (!footnotes.has(item)) notes.add(name, item.html);
    }
    if (plane.findings.empty()) notes.add(name, unasked_html(t, plane));
  }
  for (const Notice& notice : notices_of(space)) {
    if (!is_of_room_page(notice.kind)) continue;
    notes.add(notice.plane == nullptr ? "" : plane_in_room(t, space, *notice.plane),
              escape_html(notice_words(t, notice)));
  }
  return notes;
}

}  // namespace

std::string client_notes(const Texts& t, const ProjectPart& project, const Footnotes& footnotes) {
  RoomNotes notes;
  for (const Notice& notice : notices_of(project)) {
    if (is_of_room_page(notice.kind)) continue;
    const std::string room(title_of(notice.space->name, notice.space->id));
    if (notice.kind != NoticeKind::remark) {
      notes.add(room, escape_html(notice_words(t, notice)));
      continue;
    }
    for (const NoteItem& item : note_items(t, *notice.message))
      if (!footnotes.has(item)) notes.add(room, item.html);
  }
  const std::string list = notes.html(t);
  return list.empty() ? list : fmt::format("<h3>{}</h3>\n{}", t[Text::client_notes_title], list);
}

std::string client_causes(const Texts& t, const RoomSummary& room) {
  if (room.causes.empty()) return {};
  std::string html;
  for (const RoomCause& cause : room.causes) {
    const CauseWords words = cause_words(t, room, cause);
    html +=
        "<li>" + outcome_badge(t, cause.outcome) + "<div><p>" + escape_html(words.what) + "</p>";
    for (const std::string& more : words.more)
      html += "<p class=\"note\">" + escape_html(more) + "</p>";
    html += "</div></li>\n";
  }
  return "<ul class=\"attention\">\n" + html + "</ul>\n";
}

std::string client_room(const Texts& t, const ProjectPart& project, PlaneIndex room,
                        const std::string& title, const RoomSummary* summary,
                        const ColourScales& scales, Paper paper, const Footnotes& footnotes) {
  const SpacePart& space = project.spaces[room.space];
  const std::vector<RoomLine> lines = room_lines(space);
  const Clauses clauses = clauses_of(t, lines);
  const std::string asked_by = fmt::format("{}", fmt::join(clauses.all, ", "));
  const std::string facts = html_room_facts(t, project, space);
  std::string html =
      fmt::format("<section class=\"client-room\"><header><h2 id=\"{}\">{}{}</h2>{}{}</header>\n",
                  space_anchor(room.project, room.space), escape_html(title), anchors(space, room),
                  summary == nullptr ? "" : outcome_badge(t, summary->outcome),
                  asked_by.empty() ? "" : "<p class=\"quiet\">" + escape_html(asked_by) + "</p>");
  if (!facts.empty())
    html += "<table class=\"facts room-data\"><caption class=\"unseen\">" +
            std::string(t[Text::room_data]) + "</caption><tbody>\n" + facts + "</tbody></table>\n";
  html += "<div class=\"charts\">\n" + charts_html(t, space, room, scales, paper) +
          html_room(t, space, true) + "</div>\n";
  if (summary != nullptr) html += client_causes(t, *summary);
  html += requirements_table(t, space, lines, clauses, footnotes) +
          notes_of(t, space, footnotes).html(t);
  return html + "</section>\n";
}

}  // namespace report
