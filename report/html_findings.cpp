#include "report/html_findings.h"

#include "report/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace report {
namespace {

struct Cells {
  std::string requirement, required, measured, gauge, margin, place;
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
  if (finding.verdict == rules::Verdict::not_judged || !(requirement.limit > 0.0)) return {};
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

std::string requirement_html(const rules::Finding& finding, calc::ReceiverKernel kernel) {
  const rules::Requirement& requirement = finding.requirement;
  std::string html = escape_html(quantity_words(requirement, kernel));
  std::string notes;
  const auto note = [&notes](const std::string& text) {
    notes += (notes.empty() ? "" : " · ") + text;
  };
  if (!requirement.clause.empty()) note(escape_html(requirement.clause));
  if (requirement.state != rules::LightState::maintained) note(state_name(requirement.state));
  if (!requirement.scene.empty()) note("scene " + escape_html(requirement.scene));
  if (const std::string words = note_words(finding); !words.empty()) note(escape_html(words));
  if (!notes.empty()) html += "<span class=\"note\">" + notes + "</span>";
  return html;
}

Cells cells_of(const PlanePart& plane, const rules::Finding& finding) {
  const rules::Requirement& requirement = finding.requirement;
  const Threshold threshold{requirement.limit, requirement.comparison};
  const char* unit = rules::unit_of(requirement);
  Cells cells;
  cells.requirement = requirement_html(finding, plane.kernel);
  cells.required = format_required(threshold, unit);
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
    text +=
        (text.empty() ? "" : " ") + std::string("Close: usual rounding would change the verdict.");
  }
  return escape_html(text);
}

constexpr const char* kHead =
    "<th scope=\"col\">Verdict</th><th scope=\"col\">Requirement</th><th scope=\"col\" "
    "class=\"num\">Required</th>"
    "<th scope=\"col\" class=\"num\">Measured</th>"
    "<th scope=\"col\" class=\"gauge-head\"><span aria-hidden=\"true\">−10 % · limit · +10 "
    "%</span></th>"
    "<th scope=\"col\" class=\"num\">Margin</th>"
    "<th scope=\"col\" class=\"num\">At, m</th>";

std::string finding_cells(const PlanePart& plane, const rules::Finding& finding) {
  const Cells cells = cells_of(plane, finding);
  return fmt::format(
      "<td>{}</td><td>{}</td><td class=\"num\">{}</td><td class=\"num strong\">{}</td>"
      "<td class=\"gauge-cell\">{}</td><td class=\"num\">{}</td><td class=\"num place\">{}</td>",
      badge(finding.verdict), cells.requirement, cells.required, cells.measured, cells.gauge,
      cells.margin, cells.place);
}

std::string plane_link(PlaneIndex index, const SpacePart& space, const PlanePart& plane) {
  return fmt::format("<a href=\"#{}\">{}</a><span class=\"note\">{}</span>", plane_anchor(index),
                     escape_html(title_of(plane.name, plane.id)),
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
std::string plain_row(PlaneIndex index, const SpacePart& space, const PlanePart& plane) {
  const std::string link = plane_link(index, space, plane);
  if (!plane.is_computed) {
    return fmt::format(
        "<tr><th scope=\"row\">{}</th><td>not computed</td><td colspan=\"6\">{}</td></tr>\n", link,
        escape_html(plane.reason));
  }
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"quiet\">no limit</td><td class=\"quiet\" "
      "colspan=\"6\">{}.</td></tr>\n",
      link, statistics_words(plane));
}

std::string plane_rows(PlaneIndex index, const SpacePart& space, const PlanePart& plane) {
  std::string html;
  for (const rules::Finding& finding : plane.findings) {
    const bool is_first = &finding == &plane.findings.front();
    html += fmt::format("<tr class=\"{}{}\"><th scope=\"row\">{}</th>{}</tr>\n",
                        verdict_key(finding.verdict), is_first ? "" : " same",
                        is_first ? plane_link(index, space, plane)
                                 : fmt::format("<span class=\"unseen\">{}</span>",
                                               escape_html(title_of(plane.name, plane.id))),
                        finding_cells(plane, finding));
  }
  return plane.findings.empty() ? plain_row(index, space, plane) : html;
}

std::string attention_item(PlaneIndex index, const SpacePart& space, const PlanePart& plane,
                           const rules::Finding& finding) {
  const Cells cells = cells_of(plane, finding);
  std::string told = cells.requirement + " " + cells.required;
  if (!cells.measured.empty()) {
    told =
        fmt::format("<b>{}</b> for {} {}", cells.measured,
                    escape_html(quantity_words(finding.requirement, plane.kernel)), cells.required);
    told += fmt::format(" (margin {})", cells.margin);
  }
  const std::string remark = remarks(finding);
  return fmt::format(
      "<li>{}<div><p><a href=\"#{}\">{}</a> <span class=\"quiet\">in "
      "{}</span></p><p>{}</p>{}</div></li>\n",
      badge(finding.verdict), plane_anchor(index), escape_html(title_of(plane.name, plane.id)),
      escape_html(title_of(space.name, space.id)), told,
      remark.empty() ? "" : "<p class=\"quiet\">" + remark + "</p>");
}

std::string attention_of(const Document& document, rules::Verdict verdict) {
  std::string html;
  for_each_plane(document, [&](PlaneIndex index, const ProjectPart&, const SpacePart& space,
                               const PlanePart& plane) {
    for (const rules::Finding& finding : plane.findings) {
      if (finding.verdict == verdict) html += attention_item(index, space, plane, finding);
    }
  });
  if (verdict != rules::Verdict::not_judged) return html;
  for (const ProjectPart& project : document.projects) {
    if (project.is_judged) continue;
    html += fmt::format(
        "<li>{}<div><p><b>{}</b></p><p>The project could not be read or calculated; its messages "
        "are listed below.</p></div></li>\n",
        badge(verdict), escape_html(project.path));
  }
  return html;
}

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

std::string html_attention(const Document& document) {
  std::string items = attention_of(document, rules::Verdict::not_judged);
  items += attention_of(document, rules::Verdict::fail);
  items += attention_of(document, rules::Verdict::undecided);
  if (items.empty()) return {};
  return "<section aria-labelledby=\"attention\"><h2 id=\"attention\">Needs attention</h2>\n<ul "
         "class=\"attention\">\n" +
         items + "</ul></section>\n";
}

std::string html_summary(const Document& document) {
  std::string table = fmt::format(
      "<table class=\"summary\"><caption>Every plane and every requirement. ± and the bar give the "
      "{} confidence interval, which holds over all looks of the plane at its growing results; the "
      "margin is relative to the limit, positive is on the good side.</caption>\n"
      "<thead><tr><th scope=\"col\">Plane</th>{}</tr></thead>\n",
      format_percent(document.provenance.confidence), kHead);
  for (std::size_t p = 0; p < document.projects.size(); ++p) {
    const ProjectPart& project = document.projects[p];
    table += "<tbody>";
    if (document.projects.size() > 1) {
      table += fmt::format(
          "<tr class=\"group\"><th scope=\"rowgroup\" colspan=\"8\">{} <span "
          "class=\"quiet\">{}</span></th></tr>\n",
          escape_html(title_of(project.name, project.path)),
          project.name.empty() ? "" : escape_html(project.path));
    }
    if (!project.is_judged) {
      table += fmt::format(
          "<tr class=\"not-judged\"><th scope=\"row\">–</th><td>{}</td><td colspan=\"6\">could not "
          "be "
          "read or calculated</td></tr>\n",
          badge(rules::Verdict::not_judged));
    }
    for (std::size_t s = 0; s < project.spaces.size(); ++s) {
      for (std::size_t k = 0; k < project.spaces[s].planes.size(); ++k) {
        table += plane_rows({p, s, k}, project.spaces[s], project.spaces[s].planes[k]);
      }
    }
    table += "</tbody>\n";
  }
  return "<section aria-labelledby=\"summary\"><h2 id=\"summary\">Summary</h2>\n" +
         scroll_box("Summary of all planes", table + "</table>") + "</section>\n";
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
          label, kHead, rows));
}

}  // namespace report
