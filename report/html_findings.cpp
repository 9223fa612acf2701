#include "report/html_findings.h"

#include "report/html_aggregates.h"
#include "report/pass_factor.h"
#include "report/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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
      verdict_key(finding.verdict), kGaugeWidth, svg_number(std::min(low, high)),
      svg_number(std::max(low, high)), kGaugeMiddle, gauge_mark(finding));
}

// What must be read with the quantity: clause, state, scene, remarks; "" if there is nothing.
std::string notes_html(const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  std::string notes;
  const auto note = [&notes](const std::string& text) {
    notes += (notes.empty() ? "" : " · ") + text;
  };
  if (!requirement.clause.empty()) note(escape_html(requirement.clause));
  if (requirement.state != rules::LightState::maintained) note(state_name(requirement.state));
  if (!requirement.scene.empty()) note("scene " + escape_html(requirement.scene));
  if (const std::string words = note_words(finding); !words.empty()) note(escape_html(words));
  return notes.empty() ? "" : "<span class=\"note\">" + notes + "</span>";
}

Cells cells_of(const PlanePart& plane, const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const Threshold threshold{requirement.limit, requirement.comparison};
  const char* unit = rules::unit_of(requirement);
  Cells cells;
  cells.notes = notes_html(finding);
  cells.requirement = escape_html(quantity_words(requirement, plane.kernel)) + cells.notes;
  cells.required = escape_html(format_required(threshold, unit));
  if (finding.verdict == rules::Verdict::not_judged) return cells;
  cells.measured = format_measured(finding.measured, unit, threshold);
  cells.gauge = gauge(finding);
  cells.margin = with_minus(format_margin(finding.margin));
  if (finding.place_m) cells.place = with_minus(format_position(*finding.place_m));
  return cells;
}

// Reason and closeness as sentences; finished HTML, "" if there is nothing to say.
std::string remarks(const rules::Finding& finding) {
  std::string text = finding.reason;
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  if (!text.empty() && text.back() != '.') text += '.';
  if (finding.is_close) {
    std::string words = close_words(finding);
    words[0] = 'C';
    text += (text.empty() ? "" : " ") + words + ".";
  }
  if (const std::string words = pass_factor_words(finding); !words.empty())
    text += (text.empty() ? "" : " ") + words;
  return escape_html(text);
}

// data-sort: the page's script makes these heads buttons.
std::string head_cells(bool is_sortable) {
  const char* sort = is_sortable ? " data-sort=\"\"" : "";
  return fmt::format(
      "<th scope=\"col\"{0}>Verdict</th><th scope=\"col\"{0}>Requirement</th>"
      "<th scope=\"col\" class=\"num\"{0}>Required</th>"
      "<th scope=\"col\" class=\"num\"{0}>Measured</th>"
      "<th scope=\"col\" class=\"gauge-head\"><span class=\"unseen\">Interval against the "
      "limit</span><span aria-hidden=\"true\">−10 % · limit · +10 %</span></th>"
      "<th scope=\"col\" class=\"num\"{0}>Margin</th>"
      "<th scope=\"col\" class=\"num\">At, m</th>",
      sort);
}

// In the order in which verdicts ask for attention.
int rank(rules::Verdict verdict) {
  switch (verdict) {
    case rules::Verdict::not_judged:
      return 0;
    case rules::Verdict::fail:
      return 1;
    case rules::Verdict::undecided:
      return 2;
    case rules::Verdict::pass:
      break;
  }
  return 3;
}

std::string finding_cells(const PlanePart& plane, const rules::Finding& finding) {
  const Cells cells = cells_of(plane, finding);
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  return fmt::format(
      "<td data-v=\"{}\">{}</td><td data-v=\"{}\">{}</td><td class=\"num\" data-v=\"{}\">{}</td>"
      "<td class=\"num strong\" data-v=\"{}\">{}</td><td class=\"gauge-cell\">{}</td>"
      "<td class=\"num\" data-v=\"{}\">{}</td><td class=\"num place\">{}</td>",
      rank(finding.verdict), badge(finding.verdict),
      escape_html(quantity_words(finding.requirement)), cells.requirement,
      format_shortest(finding.requirement.limit), cells.required,
      is_judged ? format_shortest(finding.measured.value) : "", cells.measured, cells.gauge,
      is_judged ? format_shortest(finding.margin) : "", cells.margin, cells.place);
}

std::string plane_link(PlaneIndex index, const PlanePart& plane, const std::string& folder) {
  return fmt::format("<a href=\"{}\">{}</a>", plane_href(index, folder),
                     escape_html(title_of(plane.name, plane.id)));
}

// The first cell of a row. Where a plane has several rows the further ones show its name only when
// they stand alone.
std::string row_head(PlaneIndex index, const SpacePart& space, const PlanePart& plane,
                     const std::string& folder, bool is_first) {
  return fmt::format(
      "<th scope=\"row\" data-v=\"{}\"><span class=\"{}\">{}</span><span class=\"note "
      "lone\">{}</span></th>",
      escape_html(title_of(plane.name, plane.id)), is_first ? "first" : "again",
      is_first ? plane_link(index, plane, folder) : escape_html(title_of(plane.name, plane.id)),
      escape_html(title_of(space.name, space.id)));
}

std::string average_words(const PlanePart& plane) {
  const std::string value = format_measured(plane.average_lx, "lx");
  if (is_plain_illuminance(plane)) return "Average " + value;
  return fmt::format("Average of {} {}", plane_words(plane), value);
}

std::string statistics_words(const PlanePart& plane) {
  if (calc::is_plain_number(plane.derived)) {
    return fmt::format("{}: minimum {}, maximum {}", plane_words(plane),
                       format_measured(plane.minimum_lx, ""),
                       format_measured(plane.maximum_lx, ""));
  }
  return fmt::format("{}, minimum {}, Uo {}", average_words(plane),
                     format_measured(plane.minimum_lx, "lx"),
                     format_measured(plane.uniformity_min_avg, ""));
}

// A plane without requirements still has a line: nothing is left out silently.
std::string plain_row(const std::string& head, const PlanePart& plane) {
  if (!plane.is_computed) {
    return fmt::format(
        "<tr class=\"finding not-judged\">{}<td data-v=\"0\">not computed</td><td "
        "colspan=\"6\">{}</td></tr>\n",
        head, escape_html(plane.reason));
  }
  return fmt::format(
      "<tr class=\"finding no-limit\">{}<td class=\"quiet\" data-v=\"4\">no limit</td><td "
      "class=\"quiet\" colspan=\"6\">{}.</td></tr>\n",
      head, statistics_words(plane));
}

std::string plane_rows(PlaneIndex index, const SpacePart& space, const PlanePart& plane,
                       const std::string& folder) {
  std::string html;
  for (const rules::Finding& finding : plane.findings) {
    const bool is_first = &finding == &plane.findings.front();
    html += fmt::format("<tr class=\"finding {}{}\">{}{}</tr>\n", verdict_key(finding.verdict),
                        is_first ? "" : " same", row_head(index, space, plane, folder, is_first),
                        finding_cells(plane, finding));
  }
  return plane.findings.empty() ? plain_row(row_head(index, space, plane, folder, true), plane)
                                : html;
}

// "2 fail, 1 pass" of a room.
std::string room_words(const SpacePart& space) {
  std::array<int, 4> counts{};
  int waived = 0;
  for (const PlanePart& plane : space.planes) {
    for (const rules::Finding& finding : plane.findings) {
      if (finding.is_waived)
        ++waived;
      else
        ++counts.at(static_cast<std::size_t>(rank(finding.verdict)));
    }
  }
  std::string words;
  const auto add = [&words](int count, const char* word) {
    if (count > 0) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, word);
  };
  add(counts[0], "not judged");
  add(counts[1], "fail");
  add(counts[2], "undecided");
  add(counts[3], "pass");
  add(waived, "waived");
  return words;
}

std::string room_rows(const Document& document, std::size_t p, std::size_t s,
                      const std::string& folder) {
  const ProjectPart& project = document.projects[p];
  const SpacePart& space = project.spaces[s];
  const std::string building =
      document.projects.size() == 1
          ? ""
          : escape_html(title_of(project.name, project.path)) + " <span class=\"sep\">›</span> ";
  std::string html = fmt::format(
      "<tbody><tr class=\"group\"><th scope=\"rowgroup\" colspan=\"8\">{}{} <span "
      "class=\"quiet\">{}</span></th></tr>\n",
      building, escape_html(title_of(space.name, space.id)), room_words(space));
  for (std::size_t k = 0; k < space.planes.size(); ++k)
    html += plane_rows({p, s, k}, space, space.planes[k], folder);
  return html + "</tbody>\n";
}

std::string attention_item(PlaneIndex index, const SpacePart& space, const PlanePart& plane,
                           const rules::Finding& finding, const std::string& folder) {
  const Cells cells = cells_of(plane, finding);
  std::string told = escape_html(quantity_words(finding.requirement, plane.kernel)) + " " +
                     cells.required + " " + cells.notes;
  if (!cells.measured.empty()) {
    told =
        fmt::format("<b>{}</b> for {} {}", cells.measured,
                    escape_html(quantity_words(finding.requirement, plane.kernel)), cells.required);
    told += fmt::format(" (margin {})", cells.margin) + " " + cells.notes;
  }
  const std::string remark = remarks(finding);
  return fmt::format(
      "<li>{}<div><p>{} <span class=\"quiet\">in {}</span></p><p>{}</p>{}</div></li>\n",
      badge(finding.verdict), plane_link(index, plane, folder),
      escape_html(title_of(space.name, space.id)), told,
      remark.empty() ? "" : "<p class=\"quiet\">" + remark + "</p>");
}

// Of one verdict, the furthest from its limit first.
void add_attention(const Document& document, rules::Verdict verdict, const std::string& folder,
                   std::vector<std::string>& items) {
  std::vector<std::pair<double, std::string>> found;
  for_each_plane(document, [&](PlaneIndex index, const ProjectPart&, const SpacePart& space,
                               const PlanePart& plane) {
    for (const rules::Finding& finding : plane.findings) {
      if (finding.verdict != verdict) continue;
      const bool is_judged = verdict != rules::Verdict::not_judged;
      found.emplace_back(is_judged ? finding.margin : 0.0,
                         attention_item(index, space, plane, finding, folder));
    }
  });
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [margin, item] : found) items.push_back(std::move(item));
  for (std::string& item : html_aggregate_items(document, verdict))
    items.push_back(std::move(item));
  if (verdict != rules::Verdict::not_judged) return;
  for (const ProjectPart& project : document.projects) {
    if (project.is_judged) continue;
    items.push_back(fmt::format(
        "<li>{}<div><p><b>{}</b></p><p>The project could not be read or calculated; its messages "
        "are listed below.</p></div></li>\n",
        badge(verdict), escape_html(project.path)));
  }
}

constexpr const char* kTools =
    "<div class=\"tools\" id=\"summary-tools\" hidden=\"hidden\"><label>Find <input "
    "type=\"search\" placeholder=\"plane, room, clause\"/></label><label>Verdict <select>"
    "<option value=\"\">all</option><option value=\"fail\">fail</option>"
    "<option value=\"undecided\">undecided</option><option value=\"not-judged\">not judged</option>"
    "<option value=\"pass\">pass</option></select></label><output></output></div>\n";

}  // namespace

std::string html_verdict_banner(const Document& document) {
  const VerdictCounts counts = count_verdicts(document);
  const rules::Verdict overall = overall_verdict(document);
  const bool is_empty =
      counts.pass + counts.fail + counts.undecided + counts.not_judged + counts.waived == 0;
  const char* sentence = "Nothing was judged";
  switch (overall) {
    case rules::Verdict::pass:
      sentence =
          counts.waived > 0 ? "All requirements are met or waived" : "All requirements are met";
      if (counts.pass == 0) sentence = "No requirement is judged: all are waived";
      break;
    case rules::Verdict::fail:
      sentence = "Not all requirements are met";
      break;
    case rules::Verdict::undecided:
      sentence = "No requirement fails, but not all are decided";
      break;
    case rules::Verdict::not_judged:
      if (!is_empty || has_uncomputed_plane(document)) sentence = "Not everything could be judged";
      if (counts.fail > 0) {
        sentence = "Not everything could be judged, and not all requirements are met";
      }
      break;
  }
  const std::array<std::pair<rules::Verdict, int>, 4> all{
      {{rules::Verdict::not_judged, counts.not_judged},
       {rules::Verdict::fail, counts.fail},
       {rules::Verdict::undecided, counts.undecided},
       {rules::Verdict::pass, counts.pass}}};
  std::string chips;
  for (const auto& [verdict, count] : all) {
    chips += fmt::format("<li class=\"{}{}\"><b>{}</b> {}</li>", verdict_key(verdict),
                         count == 0 ? " none" : "", count, rules::verdict_name(verdict));
  }
  return fmt::format(
      "<div class=\"banner {}\"><span class=\"seal\" aria-hidden=\"true\">{}</span><div><p "
      "class=\"outcome\">{}</p>"
      "<p>{}</p></div><ul class=\"counts\">{}</ul></div>\n",
      verdict_key(overall), verdict_symbol(overall), sentence, summary_words(document), chips);
}

std::string html_attention(const Document& document, const std::string& folder) {
  constexpr std::size_t kOpen = 20;  // more are folded
  std::vector<std::string> items;
  add_attention(document, rules::Verdict::not_judged, folder, items);
  add_attention(document, rules::Verdict::fail, folder, items);
  add_attention(document, rules::Verdict::undecided, folder, items);
  if (items.empty()) return {};
  std::string html =
      "<section aria-labelledby=\"attention\"><h2 id=\"attention\">Needs attention</h2>\n<ul "
      "class=\"attention\">\n";
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i == kOpen) {
      html += fmt::format("</ul>\n<details><summary>{} more</summary><ul class=\"attention\">\n",
                          items.size() - kOpen);
    }
    html += items[i];
  }
  return html + (items.size() > kOpen ? "</ul></details></section>\n" : "</ul></section>\n");
}

std::string html_summary(const Document& document, const std::string& folder) {
  std::string table = fmt::format(
      "<table class=\"summary\"><caption>Every plane and every requirement. ± and the bar give the "
      "{} confidence interval, which holds over all looks of the plane at its growing results; the "
      "margin is relative to the limit, positive is on the good side.</caption>\n"
      "<thead><tr><th scope=\"col\" data-sort=\"\">Plane</th>{}</tr></thead>\n",
      format_percent(document.provenance.confidence), head_cells(true));
  for (std::size_t p = 0; p < document.projects.size(); ++p) {
    const ProjectPart& project = document.projects[p];
    if (!project.is_judged) {
      table += fmt::format(
          "<tbody><tr class=\"finding not-judged\"><th scope=\"row\" data-v=\"{0}\">{0}</th><td "
          "data-v=\"0\">{1}</td><td colspan=\"6\">could not be read or "
          "calculated</td></tr></tbody>\n",
          escape_html(title_of(project.name, project.path)), badge(rules::Verdict::not_judged));
    }
    for (std::size_t s = 0; s < project.spaces.size(); ++s)
      table += room_rows(document, p, s, folder);
  }
  return "<section aria-labelledby=\"summary\"><h2 id=\"summary\">Summary</h2>\n" +
         std::string(kTools) + scroll_box("Summary of all planes", table + "</table>") +
         "</section>\n";
}

std::string html_plane_findings(const PlanePart& plane) {
  if (plane.findings.empty()) return {};
  std::string rows, notes;
  for (const rules::Finding& finding : plane.findings) {
    rows += fmt::format("<tr class=\"{}\">{}</tr>\n", verdict_key(finding.verdict),
                        finding_cells(plane, finding));
    const std::string remark = remarks(finding);
    if (remark.empty()) continue;
    rows += fmt::format("<tr class=\"remark\"><td></td><td colspan=\"6\">{}</td></tr>\n", remark);
  }
  const std::string label = "Requirements of " + escape_html(title_of(plane.name, plane.id));
  return scroll_box(
      label,
      fmt::format(
          "<table class=\"findings\"><caption class=\"unseen\">{}</caption><thead><tr>{}</tr>"
          "</thead><tbody>\n{}</tbody></table>",
          label, head_cells(false), rows));
}

}  // namespace report
