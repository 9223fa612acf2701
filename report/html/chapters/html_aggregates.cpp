#include "report/html/chapters/html_aggregates.h"

#include "report/document/one_source.h"
#include "report/html/page/html_markup.h"
#include "report/text/aggregate_words.h"
#include "report/text/clause_words.h"
#include "report/text/markup.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace report {
namespace {

// Clause and remarks under the title; finished HTML.
std::string notes_html(const Texts& t, const rules::AggregateFinding& finding) {
  std::string notes = escape_html(clause_words(t, finding));
  const auto add = [&notes](const std::string& text) {
    if (!text.empty()) notes += (notes.empty() ? "" : " · ") + text;
  };
  if (finding.is_waived) add(t[Text::waived]);
  if (finding.sum) {
    add(escape_html(aggregate_note(t, finding)));
    return notes.empty() ? "" : "<span class=\"note\">" + notes + "</span>";
  }
  add(sentence_html(t, without_one_source(finding.note)));
  add(aggregate_remark(t, finding));
  return notes.empty() ? "" : "<span class=\"note\">" + notes + "</span>";
}

// Rooms of a sum are not judged one by one.
std::string member_text(const Texts& t, const ProjectPart& project,
                        const rules::AggregateFinding& finding,
                        const rules::AggregateMember& member) {
  const auto room = std::find_if(project.spaces.begin(), project.spaces.end(),
                                 [&](const SpacePart& space) { return space.id == member.name; });
  std::string text =
      finding.sum ? escape_html(room == project.spaces.end() ? std::string_view(member.name)
                                                             : title_of(room->name, room->id))
                  : fmt::format("{} {}", verdict_symbol(member.verdict), escape_html(member.name));
  if (finding.sum && member.value)
    text += " " + format_fixed(t, *member.value, 2);  // in the unit of what was found
  if (member.area_m2)
    text += " <span class=\"quiet\">" + t.number(format_fixed(*member.area_m2, 1)) + " m²</span>";
  if (member.is_waived) text += std::string(" (") + t[Text::waived] + ")";
  return text;
}

std::string members_html(const Texts& t, const ProjectPart& project,
                         const rules::AggregateFinding& finding, AggregatesFor reader) {
  constexpr std::size_t kMostMembers = 100;  // of a building with very many rooms
  if (reader == AggregatesFor::client && !finding.sum &&
      finding.over == rules::AggregateOver::checks) {
    const auto met =
        std::count_if(finding.members.begin(), finding.members.end(),
                      [](const auto& member) { return member.verdict == rules::Verdict::pass; });
    return t.say<Text::met_of>(met, finding.members.size());
  }
  std::string members;
  for (std::size_t i = 0; i < std::min(finding.members.size(), kMostMembers); ++i) {
    members +=
        (members.empty() ? "" : "<br/>") + member_text(t, project, finding, finding.members[i]);
  }
  if (finding.members.size() > kMostMembers) {
    members += "<br/>" + t.say<Text::more_left_out>(finding.members.size() - kMostMembers);
  }
  return members;
}

std::string rows_of(const Texts& t, const ProjectPart& project,
                    const rules::AggregateFinding& finding, AggregatesFor reader) {
  std::string html = fmt::format(
      "<tr class=\"{}\"><td>{}</td><th scope=\"row\">{}{}</th><td>{}</td><td>{}</td>"
      "<td class=\"strong\">{}</td><td>{}</td></tr>\n",
      calc::name_of(finding.verdict),
      badge(t, finding.verdict, rules::counts(rules::outcome_of(finding))),
      escape_html(aggregate_title(t, finding)), notes_html(t, finding),
      escape_html(aggregate_place(project, finding)), escape_html(aggregate_required(t, finding)),
      escape_html(aggregate_measured(t, finding)), members_html(t, project, finding, reader));
  if (finding.reason.empty()) return html;
  return html + fmt::format("<tr class=\"remark\"><td></td><td colspan=\"5\">{}</td></tr>\n",
                            sentence_html(t, finding.reason));
}

// The classes of streets, whose requirements count one by one, stand in the chapter of the roads.
bool is_class_of_road(const ProjectPart& project, const rules::AggregateFinding& finding) {
  return finding.kind == rules::AggregateKind::row_class &&
         std::any_of(project.spaces.begin(), project.spaces.end(), [&](const SpacePart& space) {
           return space.road && space.id == finding.space_id;
         });
}

}  // namespace

std::string html_aggregates(const Texts& t, const ProjectPart& project, std::size_t index,
                            AggregatesFor reader) {
  std::string rows;
  for (const rules::AggregateFinding& finding : project.aggregates) {
    if (reader == AggregatesFor::client && is_class_of_road(project, finding)) continue;
    rows += rows_of(t, project, finding, reader);
  }
  if (rows.empty()) return {};
  const char* title = t[Text::aggregates_and_classes];
  const std::string table = fmt::format(
      "<table class=\"findings aggregates\"><caption class=\"unseen\">{}</caption><thead><tr><th "
      "scope=\"col\">{}</th><th scope=\"col\">{}</th><th scope=\"col\">{}</th><th "
      "scope=\"col\">{}</th><th scope=\"col\">{}</th><th scope=\"col\">{}</th></tr></thead>"
      "<tbody>\n{}</tbody></table>",
      title, t[Text::verdict], t[Text::rule_of_pack], t[Text::where], t[Text::required],
      t[Text::found], t[Text::members], rows);
  return fmt::format("<h3 id=\"aggregates{}\">{}</h3>\n", index + 1, title) +
         scroll_box(title, table);
}

std::vector<std::string> html_aggregate_items(const Texts& t, const ProjectPart& project,
                                              std::size_t index, rules::Verdict verdict) {
  if (project.aggregates.empty()) return {};
  std::vector<std::string> items;
  for (const rules::AggregateFinding& finding : project.aggregates) {
    if (finding.verdict != verdict || outcome_of(finding) == rules::Outcome::nothing_asked)
      continue;
    items.push_back(fmt::format(
        "<li>{}<div><p><a href=\"#aggregates{}\">{}</a> <span class=\"quiet\">{}</span></p>"
        "<p><b>{}</b> ({}) {}</p>{}</div></li>\n",
        badge(t, verdict), index + 1, escape_html(aggregate_title(t, finding)),
        t.say<Text::in_room>(escape_html(aggregate_place(project, finding))),
        escape_html(aggregate_measured(t, finding)), escape_html(aggregate_required(t, finding)),
        notes_html(t, finding),
        finding.reason.empty()
            ? ""
            : "<p class=\"quiet\">" + sentence_html(t, finding.reason) + "</p>"));
  }
  return items;
}

}  // namespace report
