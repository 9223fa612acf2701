#include "report/html_aggregates.h"

#include "report/aggregate_words.h"
#include "report/html_markup.h"
#include "report/words.h"

#include <fmt/format.h>

namespace report {
namespace {

// Clause and remarks under the title; finished HTML.
std::string notes_html(const rules::AggregateFinding& finding) {
  std::string notes = escape_html(finding.clause);
  if (finding.is_waived) notes += notes.empty() ? "waived" : " · waived";
  if (const std::string words = aggregate_note(finding); !words.empty()) {
    notes += (notes.empty() ? "" : " · ") + escape_html(words);
  }
  return notes.empty() ? "" : "<span class=\"note\">" + notes + "</span>";
}

std::string member_text(const rules::AggregateMember& member) {
  std::string text = fmt::format("{} {}", verdict_symbol(member.verdict), escape_html(member.name));
  if (member.is_waived) text += " (waived)";
  return text;
}

std::string rows_of(const ProjectPart& project, const rules::AggregateFinding& finding) {
  std::string members;
  for (const rules::AggregateMember& member : finding.members) {
    members += (members.empty() ? "" : "<br/>") + member_text(member);
  }
  std::string html = fmt::format(
      "<tr class=\"{}\"><td>{}</td><th scope=\"row\">{}{}</th><td>{}</td><td>{}</td>"
      "<td class=\"strong\">{}</td><td>{}</td></tr>\n",
      verdict_key(finding.verdict), badge(finding.verdict), escape_html(aggregate_title(finding)),
      notes_html(finding), escape_html(aggregate_place(project, finding)),
      escape_html(aggregate_required(finding)), escape_html(aggregate_measured(finding)), members);
  if (finding.reason.empty()) return html;
  return html + fmt::format("<tr class=\"remark\"><td></td><td colspan=\"5\">{}</td></tr>\n",
                            escape_html(finding.reason));
}

}  // namespace

std::string html_aggregates(const ProjectPart& project, std::size_t index) {
  if (project.aggregates.empty()) return {};
  std::string rows;
  for (const rules::AggregateFinding& finding : project.aggregates) {
    rows += rows_of(project, finding);
  }
  return fmt::format("<h3 id=\"aggregates{}\">Aggregates and classes</h3>\n", index + 1) +
         scroll_box("Aggregates and classes",
                    "<table class=\"findings aggregates\"><caption class=\"unseen\">Aggregates and "
                    "classes</caption><thead><tr><th scope=\"col\">Verdict</th><th "
                    "scope=\"col\">Rule</th><th scope=\"col\">Where</th><th "
                    "scope=\"col\">Required</th><th scope=\"col\">Found</th><th "
                    "scope=\"col\">Members</th></tr></thead><tbody>\n" +
                        rows + "</tbody></table>");
}

std::vector<std::string> html_aggregate_items(const Document& document, rules::Verdict verdict) {
  std::vector<std::string> items;
  for (std::size_t p = 0; p < document.projects.size(); ++p) {
    const ProjectPart& project = document.projects[p];
    for (const rules::AggregateFinding& finding : project.aggregates) {
      if (finding.verdict != verdict || finding.severity != rules::Severity::shall) continue;
      items.push_back(fmt::format(
          "<li>{}<div><p><a href=\"#aggregates{}\">{}</a> <span class=\"quiet\">in {}</span></p>"
          "<p><b>{}</b> for {} {}</p>{}</div></li>\n",
          badge(verdict), p + 1, escape_html(aggregate_title(finding)),
          escape_html(aggregate_place(project, finding)), escape_html(aggregate_measured(finding)),
          escape_html(aggregate_required(finding)), notes_html(finding),
          finding.reason.empty() ? ""
                                 : "<p class=\"quiet\">" + escape_html(finding.reason) + "</p>"));
    }
  }
  return items;
}

}  // namespace report
