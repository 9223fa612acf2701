#include "report/html/chapters/html_findings.h"

#include "report/html/chapters/html_aggregates.h"
#include "report/revision/gate.h"
#include "report/revision/revision_tables.h"
#include "report/text/clause_words.h"
#include "report/text/decides.h"
#include "report/text/markup.h"
#include "report/text/pass_factor.h"
#include "report/text/plane_names.h"
#include "report/text/sentences.h"
#include "report/text/svg.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

struct Cells {
  std::string requirement, notes, required, measured, gauge, margin, place;
};

constexpr double kGaugeReach = 0.1;  // the ends of the gauge, as a margin
constexpr double kGaugeWidth = 92, kGaugeMiddle = 46, kGaugeInset = 5;

double gauge_x(const rules::Requirement& requirement, double value) {
  const double margin = rules::margin(value, requirement.comparison, requirement.limit);
  return kGaugeMiddle + std::clamp(margin / kGaugeReach, -1.0, 1.0) * (kGaugeMiddle - kGaugeInset);
}

// A dot at the value, or an arrow head where it is off the gauge.
std::string gauge_mark(const rules::Finding& finding) {
  const double x = gauge_x(finding.requirement, finding.measured.value);
  if (std::abs(finding.margin) <= kGaugeReach) {
    return fmt::format("<circle cx=\"{}\" cy=\"7\" r=\"3\"/>", svg_number(x));
  }
  const bool is_right = finding.margin > 0;
  return fmt::format("<path class=\"arrow\" d=\"M{} 7l{} -4v8z\"/>", is_right ? kGaugeWidth : 0,
                     is_right ? -7 : 7);
}

// The interval against the limit: left of the mark is not met, right is met.
std::string gauge(const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  if (finding.verdict == rules::Verdict::not_judged || !(requirement.limit > 0.0) ||
      !std::isfinite(requirement.limit) || !std::isfinite(finding.measured.value) ||
      std::isnan(finding.measured.low) || std::isnan(finding.measured.high)) {
    return {};
  }
  const double low = gauge_x(requirement, finding.measured.low);
  const double high = gauge_x(requirement, finding.measured.high);
  return fmt::format(
      "<svg class=\"gauge {0}\" width=\"{1}\" height=\"14\" viewBox=\"0 0 {1} 14\" "
      "aria-hidden=\"true\">"
      "<path class=\"axis\" d=\"M0 7h{1}\"/><path class=\"span\" d=\"M{2} 7H{3}\"/>"
      "<path class=\"limit\" d=\"M{4} 1v12\"/>{5}</svg>",
      calc::name_of(finding.verdict), kGaugeWidth, svg_number(std::min(low, high)),
      svg_number(std::max(low, high)), kGaugeMiddle, gauge_mark(finding));
}

Cells cells_of(const Texts& t, const PlanePart& plane, const rules::Finding& finding,
               const Footnotes& footnotes) {
  const rules::Requirement& requirement = finding.requirement;
  const Threshold threshold{requirement.limit, requirement.comparison};
  const char* unit = rules::unit_of(requirement);
  Cells cells;
  cells.notes = html_finding_notes(t, finding, footnotes);
  cells.requirement = escape_html(quantity_words(t, requirement, plane.kernel)) + cells.notes;
  cells.required = escape_html(format_required(t, threshold, unit));
  if (finding.verdict == rules::Verdict::not_judged) return cells;
  cells.measured = escape_html(measured_words(t, finding));
  cells.gauge = gauge(finding);
  cells.margin = escape_html(with_minus(margin_words(t, finding)));
  if (finding.place_m) cells.place = with_minus(format_position(t, *finding.place_m));
  return cells;
}

// With a capital and a full stop; of finished HTML, whose first letter may stand in a <span>.
std::string as_sentence(std::string html) {
  if (html.empty()) return html;
  const std::size_t first = html.front() == '<' ? html.find('>') + 1 : 0;
  if (html[first] >= 'a' && html[first] <= 'z')
    html[first] = static_cast<char>(html[first] - 'a' + 'A');
  return html.ends_with('.') || html.ends_with(".</span>") ? html : html + ".";
}

// Reason and closeness as sentences; finished HTML, "" if there is nothing to say.
std::string remarks(const Texts& t, const SpacePart& space, const rules::Finding& finding) {
  std::string text = as_sentence(sentence_html(t, finding.reason));
  if (finding.is_close) {
    std::string words = close_words(t, finding);
    words[0] = static_cast<char>(words[0] - 'a' + 'A');
    text += (text.empty() ? "" : " ") + escape_html(words) + ".";
  }
  if (const std::string words = remedy_words(t, space, finding); !words.empty())
    text += (text.empty() ? "" : " ") + escape_html(words);
  return text;
}

// data-sort: the page's script makes these heads buttons.
std::string head_cells(const Texts& t, bool is_sortable) {
  const char* sort = is_sortable ? " data-sort=\"\"" : "";
  return fmt::format(
      "<th scope=\"col\"{0}>{1}</th><th scope=\"col\"{0}>{2}</th>"
      "<th scope=\"col\" class=\"num\"{0}>{3}</th>"
      "<th scope=\"col\" class=\"num\"{0}>{4}</th>"
      "<th scope=\"col\" class=\"gauge-head\"><span class=\"unseen\">{5}</span>"
      "<span aria-hidden=\"true\">{6}</span></th>"
      "<th scope=\"col\" class=\"num\"{0}>{7}</th>"
      "<th scope=\"col\" class=\"num\">{8}</th>",
      sort, t[Text::verdict], t[Text::requirement], t[Text::required], t[Text::measured],
      t[Text::interval_against_limit], t[Text::gauge_scale], t[Text::margin], t[Text::at_m]);
}

// For sorting, the gravest first; advice that is not kept to is none of them.
int gravity_of(const rules::Finding& finding) {
  return rules::gravity_rank(is_outside_advice(finding) ? rules::Verdict::pass : finding.verdict);
}

// Class of a row: the page's filter goes by it.
std::string_view row_class(const rules::Finding& finding) {
  return is_outside_advice(finding) ? "advice" : calc::name_of(finding.verdict);
}

std::string finding_cells(const Texts& t, const PlanePart& plane, const rules::Finding& finding,
                          const Footnotes& footnotes) {
  const Cells cells = cells_of(t, plane, finding, footnotes);
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  return fmt::format(
      "<td data-v=\"{}\">{}</td><td data-v=\"{}\">{}</td><td class=\"num\" data-v=\"{}\">{}</td>"
      "<td class=\"num strong\" data-v=\"{}\">{}</td><td class=\"gauge-cell\">{}</td>"
      "<td class=\"num\" data-v=\"{}\">{}</td><td class=\"num place\">{}</td>",
      gravity_of(finding), html_verdict(t, plane, finding),
      escape_html(quantity_words(t, finding.requirement)), cells.requirement,
      format_shortest(finding.requirement.limit), cells.required,
      is_judged ? format_shortest(finding.measured.value) : "", cells.measured, cells.gauge,
      is_judged ? format_shortest(finding.margin) : "", cells.margin, cells.place);
}

std::string plane_link(const Texts& t, PlaneIndex index, const SpacePart& space,
                       const PlanePart& plane, const std::string& folder) {
  return fmt::format("<a href=\"{}\">{}</a>", plane_href(index, folder),
                     escape_html(plane_name(t, space, plane)));
}

// The first cell of a row. Where a plane has several rows the further ones show its name only when
// they stand alone.
std::string row_head(const Texts& t, PlaneIndex index, const SpacePart& space,
                     const PlanePart& plane, const std::string& folder, bool is_first) {
  return fmt::format(
      "<th scope=\"row\" data-v=\"{}\"><span class=\"{}\">{}</span><span class=\"note "
      "lone\">{}</span></th>",
      escape_html(title_of(plane.name, plane.id)), is_first ? "first" : "again",
      is_first ? plane_link(t, index, space, plane, folder)
               : escape_html(plane_name(t, space, plane)),
      escape_html(title_of(space.name, space.id)));
}

std::string average_words(const Texts& t, const PlanePart& plane) {
  const std::string value = format_measured(t, plane.average, plane_unit(plane));
  if (is_plain_illuminance(plane)) return t.say<Text::average_value>(value);
  return t.say<Text::average_of_value>(of_plane_words(t, plane), value);
}

std::string statistics_words(const Texts& t, const PlanePart& plane) {
  if (calc::is_plain_number(plane.derived)) {
    return t.say<Text::extremes>(plane_words(t, plane),
                                 escape_html(value_words(t, plane, plane.minimum)),
                                 escape_html(value_words(t, plane, plane.maximum)));
  }
  return t.say<Text::statistics_line>(average_words(t, plane),
                                      format_measured(t, plane.minimum, plane_unit(plane)),
                                      format_measured(t, plane.uniformity_min_avg, ""));
}

// A plane without requirements still has a line: nothing is left out silently.
std::string plain_row(const Texts& t, const std::string& head, const PlanePart& plane) {
  if (!plane.is_computed) {
    return fmt::format(
        "<tr class=\"finding not-judged\">{}<td data-v=\"0\">{}</td><td "
        "colspan=\"6\">{}</td></tr>\n",
        head, t[Text::not_computed], sentence_html(t, plane.reason));
  }
  return fmt::format(
      "<tr class=\"finding no-limit\">{}<td class=\"quiet\" data-v=\"4\">{}</td><td "
      "class=\"quiet\" colspan=\"6\">{}.</td></tr>\n",
      head, t[Text::no_limit], statistics_words(t, plane));
}

std::string plane_rows(const Texts& t, PlaneIndex index, const SpacePart& space,
                       const PlanePart& plane, const std::string& folder,
                       const Footnotes& footnotes) {
  std::string html;
  for (const rules::Finding& finding : plane.findings) {
    const bool is_first = &finding == &plane.findings.front();
    html += fmt::format("<tr class=\"finding {}{}\">{}{}</tr>\n", row_class(finding),
                        is_first ? "" : " same", row_head(t, index, space, plane, folder, is_first),
                        finding_cells(t, plane, finding, footnotes));
  }
  return plane.findings.empty()
             ? plain_row(t, row_head(t, index, space, plane, folder, true), plane)
             : html;
}

// "2 fail, 1 pass" of a room.
std::string room_words(const Texts& t, const SpacePart& space) {
  const VerdictCounts counts = count_verdicts(space);
  std::string words;
  const auto add = [&](int count, const char* word) {
    if (count > 0) words += (words.empty() ? "" : ", ") + t.say<Text::count_of>(count, word);
  };
  for (const rules::Verdict verdict : rules::kGravestFirst)
    add(counts.of(verdict), verdict_words(t, verdict));
  add(counts.waived, t[Text::waived]);
  return words;
}

std::string room_rows(const Texts& t, const ProjectPart& project, std::size_t p, std::size_t s,
                      bool is_only, const std::string& folder, const Footnotes& footnotes) {
  const SpacePart& space = project.spaces[s];
  const std::string building = is_only ? ""
                                       : escape_html(title_of(project.name, project.path)) +
                                             " <span class=\"sep\">›</span> ";
  std::string html = fmt::format(
      "<tbody><tr class=\"group\"><th scope=\"rowgroup\" colspan=\"8\">{}{} <span "
      "class=\"quiet\">{}</span></th></tr>\n",
      building, escape_html(title_of(space.name, space.id)), room_words(t, space));
  for (std::size_t k = 0; k < space.planes.size(); ++k)
    html += plane_rows(t, {p, s, k}, space, space.planes[k], folder, footnotes);
  return html + "</tbody>\n";
}

std::string attention_item(const Texts& t, PlaneIndex index, const SpacePart& space,
                           const PlanePart& plane, const rules::Finding& finding,
                           const std::string& folder, const Footnotes& footnotes) {
  const Cells cells = cells_of(t, plane, finding, footnotes);
  std::string told = escape_html(quantity_words(t, finding.requirement, plane.kernel)) + " " +
                     cells.required + " " + cells.notes;
  if (!cells.measured.empty()) {
    told = t.say<Text::value_for_quantity>(
        "<b>" + cells.measured + "</b>",
        escape_html(quantity_words(t, finding.requirement, plane.kernel)), cells.required);
    if (std::isfinite(finding.margin)) told += " " + t.say<Text::margin_of>(cells.margin);
    told += " " + cells.notes;
  }
  const std::string remark = remarks(t, space, finding);
  return fmt::format(
      "<li><div>{}</div><div><p>{} <span class=\"quiet\">{}</span></p><p>{}</p>{}</div></li>\n",
      html_verdict(t, plane, finding), plane_link(t, index, space, plane, folder),
      t.say<Text::in_room>(escape_html(title_of(space.name, space.id))), told,
      remark.empty() ? "" : "<p class=\"quiet\">" + remark + "</p>");
}

std::string tools(const Texts& t) {
  std::string choices = fmt::format("<option value=\"\">{}</option>", t[Text::all]);
  for (const rules::Verdict verdict : {rules::Verdict::fail, rules::Verdict::undecided,
                                       rules::Verdict::not_judged, rules::Verdict::pass}) {
    choices += fmt::format("<option value=\"{}\">{}</option>", calc::name_of(verdict),
                           verdict_words(t, verdict));
  }
  return fmt::format(
      "<div class=\"tools\" id=\"summary-tools\" hidden=\"hidden\"><label>{} <input "
      "type=\"search\" placeholder=\"{}\"/></label><label>{} <select>{}</select></label>"
      "<output></output></div>\n",
      t[Text::find], t[Text::find_hint], t[Text::verdict], choices);
}

std::string banner_sentence(const Texts& t, rules::Outcome outcome, const VerdictCounts& counts) {
  switch (outcome) {
    case rules::Outcome::not_judged:
      break;
    case rules::Outcome::warned:
      return t[Text::warnings_count];
    case rules::Outcome::fail:
      return t[Text::not_all_met];
    case rules::Outcome::undecided:
      return t[Text::not_all_decided];
    case rules::Outcome::pass:
      if (counts.deviating > 0) return t.say<Text::all_met_with_deviations>(counts.deviating);
      return t[counts.waived > 0 ? Text::all_met_or_waived : Text::all_met];
    case rules::Outcome::waived:
      return t[Text::all_waived];
    case rules::Outcome::nothing_asked:
      return t[Text::nothing_asked];
  }
  return t[counts.fail > 0 ? Text::not_all_judged_or_met : Text::not_all_judged];
}

// Its class gives the banner the tone of a verdict; what is waived is accepted. Where nothing was
// asked there is no verdict: grey is set here, so that the style of all other pages stays as it is.
std::string banner_attributes(rules::Outcome outcome) {
  const auto like = [](rules::Verdict verdict) {
    return fmt::format("class=\"banner {}\"", calc::name_of(verdict));
  };
  switch (outcome) {
    case rules::Outcome::not_judged:
    case rules::Outcome::warned:
      break;
    case rules::Outcome::fail:
      return like(rules::Verdict::fail);
    case rules::Outcome::undecided:
      return like(rules::Verdict::undecided);
    case rules::Outcome::pass:
    case rules::Outcome::waived:
      return like(rules::Verdict::pass);
    case rules::Outcome::nothing_asked:
      return "class=\"banner nothing-asked\" style=\"--tone: var(--none); --tone-soft: "
             "var(--none-soft)\"";
  }
  return like(rules::Verdict::not_judged);
}

}  // namespace

std::string html_finding_notes(const Texts& t, const rules::Finding& finding,
                               const Footnotes& footnotes) {
  const rules::Requirement& requirement = finding.requirement;
  const std::vector<NoteItem> items = note_items(t, finding);
  std::string notes;
  const auto note = [&notes](const std::string& text) {
    if (!text.empty()) notes += (notes.empty() ? "" : " · ") + text;
  };
  // Behind the clause only where no remark says the same.
  const bool is_told = std::any_of(items.begin(), items.end(),
                                   [](const NoteItem& item) { return item.source.has_value(); });
  note(
      escape_html(clause_words(t, is_told ? without_source(requirement.clause) : requirement.clause,
                               rules::source_of(requirement))));
  if (requirement.state != rules::LightState::maintained)
    note(light_state_words(t, requirement.state));
  if (!requirement.scene.empty()) note(t.say<Text::scene>(escape_html(requirement.scene)));
  note(footnotes.inline_html(items));
  const std::string marks = footnotes.marks(items);
  if (notes.empty() && marks.empty()) return {};
  return "<span class=\"note\">" + notes + (notes.empty() || marks.empty() ? "" : " ") + marks +
         "</span>";
}

std::string html_verdict(const Texts& t, const PlanePart& plane, const rules::Finding& finding) {
  std::string html = badge_of(t, finding.requirement, finding.verdict, decides(finding));
  const auto note = [&html](const std::string& words) {
    html += "<span class=\"note\">" + words + "</span>";
  };
  if (is_outside_advice(finding)) note(escape_html(advice_range_words(t, plane, finding)));
  if (finding.is_waived) note(t[Text::waived]);
  return html;
}

std::string html_verdict_banner(const Texts& t, const DocumentFrame& frame, const DocumentEnd& end,
                                const std::string& link) {
  const Totals& totals = end.totals;
  const VerdictCounts& counts = totals.verdicts;
  const bool is_part = !end.provenance.selection.empty();
  const bool is_good =
      totals.outcome == rules::Outcome::pass || totals.outcome == rules::Outcome::waived;
  const rules::Outcome outcome =
      is_part && is_good ? rules::Outcome::nothing_asked : totals.outcome;
  const std::string part = escape_html(selection_words(end.provenance, t));
  std::string errors;
  for (const calc::Diagnostic& error : document_errors(end)) {
    errors += "<p>" + escape_html(calc::format_diagnostic(error)) + "</p>";
  }
  std::string chips;
  for (const rules::Verdict verdict : rules::kGravestFirst) {
    const int count = counts.of(verdict);
    chips += fmt::format("<li class=\"{}{}\"><b>{}</b> {}</li>", calc::name_of(verdict),
                         count == 0 ? " none" : "", count, verdict_words(t, verdict));
  }
  std::string gate;
  const std::string words = frame.revised == nullptr ? "" : gate_words(*frame.revised, t);
  if (!words.empty()) {
    const rules::Outcome of_gate = gate_outcome(*frame.revised);
    gate = fmt::format(
        "<div {}><span class=\"seal\" aria-hidden=\"true\">{}</span><div><p "
        "class=\"outcome\">{}</p></div></div>\n",
        banner_attributes(of_gate), outcome_symbol(of_gate), escape_html(words));
  }
  return gate + fmt::format(
                    "<div {}><span class=\"seal\" aria-hidden=\"true\">{}</span><div><p "
                    "class=\"outcome\">{}</p>"
                    "<p>{}</p>{}</div><ul class=\"counts\">{}</ul></div>\n",
                    banner_attributes(outcome), outcome_symbol(outcome),
                    is_part && is_good ? part : banner_sentence(t, outcome, counts),
                    summary_words(t, totals) + link + (is_part && !is_good ? " · " + part : ""),
                    errors, chips);
}

HtmlAttention::Item HtmlAttention::kept(const std::string& html, double margin) {
  const Item item{margin, items_.size(), html.size()};
  items_.write(html);
  return item;
}

void HtmlAttention::add_findings(const ProjectPart& project, std::size_t index,
                                 rules::Verdict verdict, const Footnotes& footnotes, Items& items) {
  constexpr double kFurthest = -std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < project.spaces.size(); ++s) {
    const SpacePart& space = project.spaces[s];
    for (std::size_t k = 0; k < space.planes.size(); ++k) {
      const PlanePart& plane = space.planes[k];
      for (const rules::Finding& finding : plane.findings) {
        if (finding.verdict != verdict || outcome_of(finding) == rules::Outcome::nothing_asked)
          continue;
        const bool is_judged = verdict != rules::Verdict::not_judged;
        items.findings.push_back(
            kept(attention_item(t_, {index, s, k}, space, plane, finding, folder_, footnotes),
                 is_judged ? rules::margin_or(finding, kFurthest) : 0.0));
      }
    }
  }
}

void HtmlAttention::add(const ProjectPart& project, std::size_t index, const Footnotes& footnotes) {
  for (const rules::Verdict verdict : rules::kGravestFirst) {
    if (verdict == rules::Verdict::pass) continue;
    Items& items = by_verdict_[verdict];
    add_findings(project, index, verdict, footnotes, items);
    for (const std::string& html : html_aggregate_items(t_, project, index, verdict)) {
      items.aggregates.push_back(kept(html));
    }
    if (verdict != rules::Verdict::not_judged || project.is_judged) continue;
    items.projects.push_back(
        kept(fmt::format("<li>{}<div><p><b>{}</b></p><p>{}</p></div></li>\n", badge(t_, verdict),
                         escape_html(project.path), t_[Text::project_unreadable_messages])));
  }
}

void HtmlAttention::copy_to(Sink& sink) const {
  constexpr std::size_t kOpen = 20;  // more are folded
  if (is_empty()) return;
  std::vector<Item> all;
  for (const rules::Verdict verdict : rules::kGravestFirst) {
    const auto found = by_verdict_.find(verdict);
    if (found == by_verdict_.end()) continue;
    const auto& [findings, aggregates, projects] = found->second;
    const auto first = all.insert(all.end(), findings.begin(), findings.end());
    // The furthest from its limit first.
    std::stable_sort(first, all.end(),
                     [](const Item& a, const Item& b) { return a.margin < b.margin; });
    all.insert(all.end(), aggregates.begin(), aggregates.end());
    all.insert(all.end(), projects.begin(), projects.end());
  }
  sink.write(std::string("<section aria-labelledby=\"attention\"><h2 id=\"attention\">") +
             t_[Text::needs_attention] + "</h2>\n<ul class=\"attention\">\n");
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == kOpen) {
      sink.write(fmt::format("</ul>\n<details><summary>{}</summary><ul class=\"attention\">\n",
                             t_.say<Text::more>(all.size() - kOpen)));
    }
    sink.write(items_.read(all[i].begin, all[i].length));
  }
  sink.write(all.size() > kOpen ? "</ul></details></section>\n" : "</ul></section>\n");
}

std::string html_summary_title(const Texts& t, bool is_folded) {
  return fmt::format("<section aria-labelledby=\"summary\"><h2 id=\"summary\">{}</h2>\n{}",
                     t[Text::summary],
                     is_folded ? fmt::format("<details class=\"list\"><summary>{}</summary>\n",
                                             t[Text::summary_of_planes])
                               : "");
}

std::string html_summary_start(const Texts& t, const std::string& region, double confidence) {
  return tools(t) + scroll_box_start(region) +
         fmt::format(
             "<table class=\"summary\"><caption>{}</caption>\n"
             "<thead><tr><th scope=\"col\" data-sort=\"\">{}</th>{}</tr></thead>\n",
             t.say<Text::summary_caption>(format_percent(t, confidence)), t[Text::plane],
             head_cells(t, true));
}

std::string html_summary_rows(const Texts& t, const ProjectPart& project, std::size_t index,
                              bool is_only, const std::string& folder, const Footnotes& footnotes) {
  std::string rows;
  if (!project.is_judged) {
    rows += fmt::format(
        "<tbody><tr class=\"finding not-judged\"><th scope=\"row\" data-v=\"{0}\">{0}</th><td "
        "data-v=\"0\">{1}</td><td colspan=\"6\">{2}</td></tr></tbody>\n",
        escape_html(title_of(project.name, project.path)), badge(t, rules::Verdict::not_judged),
        t[Text::could_not_be_read]);
  }
  for (std::size_t s = 0; s < project.spaces.size(); ++s)
    rows += room_rows(t, project, index, s, is_only, folder, footnotes);
  return rows;
}

std::string html_summary_end(bool is_folded) {
  return std::string("</table>") + kScrollBoxEnd +
         (is_folded ? "</details></section>\n" : "</section>\n");
}

std::string html_plane_findings(const Texts& t, const SpacePart& space, const PlanePart& plane,
                                const Footnotes& footnotes) {
  if (plane.findings.empty()) return {};
  std::string rows, notes;
  for (const rules::Finding& finding : plane.findings) {
    rows += fmt::format("<tr class=\"{}\">{}</tr>\n", row_class(finding),
                        finding_cells(t, plane, finding, footnotes));
    const std::string remark = remarks(t, space, finding);
    if (remark.empty()) continue;
    rows += fmt::format("<tr class=\"remark\"><td></td><td colspan=\"6\">{}</td></tr>\n", remark);
  }
  const std::string label = t.say<Text::requirements_of>(escape_html(plane_name(t, space, plane)));
  return scroll_box(
      label,
      fmt::format(
          "<table class=\"findings\"><caption class=\"unseen\">{}</caption><thead><tr>{}</tr>"
          "</thead><tbody>\n{}</tbody></table>",
          label, head_cells(t, false), rows));
}

}  // namespace report
