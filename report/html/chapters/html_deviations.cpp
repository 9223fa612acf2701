#include "report/html/chapters/html_deviations.h"

#include "report/document/one_source.h"
#include "report/html/page/html_markup.h"
#include "report/text/clause_words.h"
#include "report/text/markup.h"
#include "report/text/plane_names.h"
#include "report/text/sentences.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <string>

namespace report {
namespace {

std::string by_words(const Texts& t, const calc::Waiver& by) {
  return t.say<Text::by_until>(escape_html(by.owner), escape_html(by.until));
}

std::string row_html(const std::string& kind, const std::string& where, const std::string& what,
                     const std::string& because, const std::string& by) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", kind,
      where, what, because, by);
}

std::string asked_words(const Texts& t, const PlanePart& plane, const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const Threshold threshold{requirement.limit, requirement.comparison};
  const char* unit = rules::unit_of(requirement);
  std::string words = escape_html(quantity_words(t, requirement, plane.kernel)) + " " +
                      escape_html(format_required(t, threshold, unit));
  if (finding.verdict != rules::Verdict::not_judged) {
    words += ", " + t.say<Text::measured_is>(escape_html(measured_words(t, finding)));
  }
  words += t[Text::colon];
  words += is_outside_advice(finding) ? t[Text::advice_outside] : verdict_words(t, finding.verdict);
  if (!requirement.clause.empty())
    words += "<span class=\"note\">" + escape_html(clause_words(t, requirement)) + "</span>";
  return words;
}

// A waiver without effect is said, too: somebody may think that it works.
std::string waiver_kind(const Texts& t, const rules::Finding& finding) {
  if (finding.is_waived) return t[Text::waived];
  return finding.verdict == rules::Verdict::pass ? t[Text::waiver_not_needed]
                                                 : t[Text::waiver_without_effect];
}

std::string finding_rows(const Texts& t, const PlanePart& plane, const std::string& where,
                         const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  std::string rows;
  const std::string asked = asked_words(t, plane, finding);
  if (requirement.waiver) {
    rows += row_html(waiver_kind(t, finding), where, asked, escape_html(requirement.waiver->reason),
                     by_words(t, *requirement.waiver));
  }
  for (const rules::Deviation& deviation : requirement.deviations) {
    const std::string what =
        asked + "<span class=\"note\">" + sentence_html(t, deviation.words) + "</span>";
    rows += row_html(t[deviation.is_accepted ? Text::deviation_stated : Text::deviation_not_stated],
                     where, what, deviation.stated ? escape_html(deviation.stated->reason) : "",
                     deviation.stated ? by_words(t, *deviation.stated) : "");
  }
  if (requirement.origin.is_weakened)
    rows += row_html(t[Text::weaker_than_row], where, asked,
                     sentence_html(t, without_one_source(requirement.note)), "");
  if (finding.by_tolerance) rows += row_html(t[Text::met_by_tolerance], where, asked, "", "");
  return rows;
}

// Zones that the project leaves out of a row. What of a row is not asked for other reasons is no
// deviation; the room says it.
std::string role_rows(const Texts& t, const std::string& where, const rules::RowCoverage& row,
                      const rules::RoleCoverage& role) {
  std::string rows;
  const std::string clause =
      "<span class=\"note\">" +
      escape_html(clause_words(t, row.clause, rules::source_of_pack(row.is_user_supplied))) +
      "</span>";
  for (const rules::LeftOutZone& zone : role.left_out) {
    rows += row_html(t[zone.has_ended ? Text::left_out_ended : Text::left_out_of_row], where,
                     escape_html(role_name(t, zone.zone)) + clause, escape_html(zone.by.reason),
                     by_words(t, zone.by));
  }
  return rows;
}

}  // namespace

std::string html_deviations(const Texts& t, const ProjectPart& project, std::size_t index,
                            const std::string& folder) {
  std::string rows;
  bool is_anything_asked = false;
  for (std::size_t s = 0; s < project.spaces.size(); ++s) {
    const SpacePart& space = project.spaces[s];
    const std::string room = escape_html(title_of(space.name, space.id));
    for (std::size_t k = 0; k < space.planes.size(); ++k) {
      const PlanePart& plane = space.planes[k];
      const std::string where = fmt::format("<a href=\"{}\">{}</a> <span class=\"quiet\">{}</span>",
                                            plane_href({index, s, k}, folder),
                                            escape_html(plane_name(t, space, plane)), room);
      for (const rules::Finding& finding : plane.findings) {
        is_anything_asked = true;
        rows += finding_rows(t, plane, where, finding);
      }
    }
    for (const rules::RowCoverage& row : space.coverage) {
      const std::string of =
          row.workplace.empty()
              ? room
              : escape_html(row.workplace) + " <span class=\"quiet\">" + room + "</span>";
      for (const rules::RoleCoverage& role : row.roles) rows += role_rows(t, of, row, role);
    }
  }
  for (const rules::AggregateFinding& aggregate : project.aggregates) {
    if (!aggregate.sum) continue;
    is_anything_asked = true;
    rows += finding_rows(t, PlanePart{},
                         escape_html(title_of(aggregate.building_name, aggregate.building_id)),
                         *aggregate.sum);
  }
  if (!is_anything_asked && rows.empty()) return {};
  const char* title = t[Text::deviations];
  const std::string head = fmt::format("<h3 id=\"deviations{}\">{}</h3>\n", index + 1, title);
  if (rows.empty()) return head + "<p class=\"quiet\">" + t[Text::no_deviations] + "</p>\n";
  return head + scroll_box(title, fmt::format("<table class=\"deviations\"><caption>{}</caption>"
                                              "<thead><tr><th scope=\"col\">{}</th><th "
                                              "scope=\"col\">{}</th><th scope=\"col\">{}</th><th "
                                              "scope=\"col\">{}</th><th scope=\"col\">{}</th></tr>"
                                              "</thead><tbody>\n{}</tbody></table>",
                                              t[Text::deviations_caption], t[Text::deviation_kind],
                                              t[Text::where], t[Text::requirement],
                                              t[Text::reason_column], t[Text::responsible], rows));
}

}  // namespace report
