#include "report/html/room/html_plane.h"

#include "report/document/shown_plane.h"
#include "report/html/chapters/html_findings.h"
#include "report/html/drawings/html_plan.h"
#include "report/html/room/html_contributions.h"
#include "report/html/room/html_convergence.h"
#include "report/html/room/html_levels.h"
#include "report/html/room/html_values.h"
#include "report/images/heatmap.h"
#include "report/text/decides.h"
#include "report/text/markup.h"
#include "report/text/pass_factor.h"
#include "report/text/plane_names.h"
#include "report/text/point_thresholds.h"
#include "report/text/sentences.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

// With "±", or without anything where the ends, which the next cell has, are needed to say it.
std::string value_cell(const Texts& t, const calc::Estimate& estimate, const char* unit,
                       const Thresholds& thresholds) {
  const std::string measured = format_measured(t, estimate, unit, thresholds);
  const EstimateText text = format_estimate(estimate, unit, thresholds);
  const bool has_ends = !text.spread.empty() && measured.find("±") == std::string::npos;
  if (!has_ends) return measured;
  return t.number(text.value) + (*unit == '\0' ? "" : std::string(" ") + unit);
}

std::string statistic(const char* name, rules::Metric metric, const Thresholds& thresholds,
                      const std::string& value, const std::string& interval) {
  return fmt::format(
      "<tr data-statistic=\"{}\"{}><th scope=\"row\">{}</th><td class=\"num strong\">{}</td><td "
      "class=\"num "
      "quiet\">{}</td></tr>\n",
      calc::name_of(metric), limits_attribute(thresholds), name, value, interval);
}

std::string statistics_table(const Texts& t, const PlanePart& plane) {
  const std::string of =
      is_plain_illuminance(plane) ? "" : std::string(" ") + of_plane_words(t, plane);
  const char* unit = plane_unit(plane);
  const bool has_average = !calc::is_plain_number(plane.derived);
  const auto row = [&](const char* name, const calc::Estimate& estimate, const char* of_unit,
                       rules::Metric metric) {
    const Thresholds thresholds = statistic_thresholds(plane, metric);
    const bool is_below =
        plane.derived == calc::DerivedQuantity::ugr && is_below_ugr_scale(estimate, thresholds);
    return statistic(name, metric, thresholds,
                     is_below ? escape_html(value_words(t, plane, estimate, thresholds))
                              : value_cell(t, estimate, of_unit, thresholds),
                     is_below ? "" : format_interval(t, estimate, of_unit, thresholds));
  };
  using enum rules::Metric;
  const std::string extremes = row(t[Text::statistic_minimum], plane.minimum, unit, minimum) +
                               row(t[Text::statistic_maximum], plane.maximum, unit, maximum);
  return std::string("<table class=\"facts\"><caption>") + t[Text::statistics] + of +
         "</caption><thead><tr><th "
         "scope=\"col\">" +
         state_words(t, plane) +
         "</th>"
         "<th scope=\"col\" class=\"num\">" +
         t[Text::value] + "</th><th scope=\"col\" class=\"num\">" + t[Text::interval] +
         "</th></tr></thead><tbody>\n" +
         (has_average
              ? row(t[Text::statistic_average], plane.average, unit, average) + extremes +
                    row(t[Text::statistic_uo], plane.uniformity_min_avg, "", uniformity_min_avg) +
                    row(t[Text::statistic_ud], plane.uniformity_min_max, "", uniformity_min_max)
              : extremes) +
         "</tbody></table>\n";
}

// Averages of the two parts as a bar; "" where there is no light at all.
std::string share_bar(const Texts& t, const PlanePart& plane) {
  if (calc::is_plain_number(plane.derived)) return {};
  double direct = 0.0, indirect = 0.0;
  for (const PointRow& point : plane.points) {
    direct += point.direct_lx;
    indirect += point.indirect_lx;
  }
  if (!(direct + indirect > 0.0)) return {};
  const double share = direct / (direct + indirect);
  return fmt::format(
      "<div class=\"share\"><div class=\"share-bar\" aria-hidden=\"true\"><span "
      "style=\"width:{}%\"></span></div>"
      "<p><span><i class=\"direct\"></i>{}</span><span><i class=\"indirect\"></i>{}"
      "</span></p></div>\n",
      format_fixed(share * 100.0, 1), t.say<Text::direct_share>(format_share(t, share)),
      t.say<Text::indirect_share>(format_share(t, 1.0 - share)));
}

// What each dimming group gives, and what it would take for it alone to make up for what is
// missing; "" where all light is in one nameless group.
std::string groups_table(const Texts& t, const PlanePart& plane) {
  if (plane.groups.empty() || (plane.groups.size() == 1 && plane.groups[0].group.empty()))
    return {};
  std::string rows;
  for (const GroupShare& share : plane.groups) {
    std::string notes;
    for (const rules::Finding& finding : plane.findings) {
      const std::optional<double> factor = group_pass_factor(finding, plane, share);
      if (!factor) continue;
      notes += "<span class=\"note\">" +
               t.say<Text::group_meets>(
                   factor_text(t, *factor), escape_html(quantity_words(t, finding.requirement)),
                   escape_html(format_required(
                       t, {finding.requirement.limit, finding.requirement.comparison}, "lx"))) +
               "</span>";
    }
    rows += fmt::format(
        "<tr><th scope=\"row\">{}{}</th><td class=\"num strong\">{}</td><td class=\"num "
        "quiet\">{}</td><td class=\"num\">{}</td></tr>\n",
        share.group.empty() ? t[Text::no_group] : escape_html(share.group), notes,
        format_measured(t, share.average_lx, "lx"), format_cell(t, share.direct_lx),
        format_share(t, share.average_lx.value / plane.average.value));
  }
  return fmt::format(
      "<table class=\"facts groups\"><caption>{}</caption><thead><tr><th "
      "scope=\"col\">{}</th><th scope=\"col\" class=\"num\">lx</th><th "
      "scope=\"col\" class=\"num\">{}</th><th scope=\"col\" "
      "class=\"num\">{}</th></tr></thead><tbody>\n{}</tbody></table>\n",
      t[plane.asked_light ? Text::light_by_group_full : Text::light_by_group],
      t[Text::average_from], t[Text::direct], t[Text::share_column], rows);
}

std::string dropped_words(const Texts& t, const calc::SensorGrid& grid) {
  if (grid.dropped.empty()) return t[Text::none];
  std::map<calc::DropReason, std::size_t> count;
  std::set<std::string> bodies;
  for (const calc::DroppedPoint& point : grid.dropped) {
    ++count[point.reason];
    if (!point.body.empty()) bodies.insert(point.body);
  }
  std::string text;
  for (const auto& [reason, number] : count) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, drop_words(t, reason));
  }
  if (bodies.empty()) return text;
  std::string names;
  for (const std::string& body : bodies) names += (names.empty() ? "" : ", ") + escape_html(body);
  return text + " (" + names + ")";
}

// ", 0.80 m above the floor" for horizontal planes in rooms.
std::string height_words(const Texts& t, const SpacePart& space, const calc::SensorGrid& grid,
                         const glm::dvec3& normal) {
  if (!is_horizontal(normal) || space.footprint_m.empty()) return {};
  const std::string height = format_metres(grid.origin_m.z - space.floor_z_m);
  if (height == "0.00") return std::string(", ") + t[Text::on_the_floor];
  return ", " + t.say<Text::above_the_floor>(with_minus(t.number(height)));
}

// With the direction that semicylindrical points of a grid look in; a list has many.
std::string quantity_fact(const Texts& t, const PlanePart& plane) {
  if (is_plain_illuminance(plane)) return t[Text::planar_illuminance];
  std::string words = plane_words(t, plane);
  if (!calc::has_look(plane.kernel, plane.derived) || plane.grid.columns == 0) {
    return words;
  }
  const glm::dvec3& look = plane.points.front().normal;
  return words + ", " + t.say<Text::looking_to>(with_minus(heading_words(t, look)));
}

std::string place_facts(const Texts& t, const SpacePart& space, const calc::SensorGrid& grid) {
  const glm::dvec3 normal = glm::cross(grid.u, grid.v);
  return fact(t[Text::grid_margin], format_metres(t, grid.margin_m) + " m") +
         fact(t[Text::position],
              with_minus(orientation_words(t, normal)) + height_words(t, space, grid, normal));
}

std::string route_facts(const Texts& t, const calc::RouteGrid& route) {
  return fact(
             t[Text::escape_route],
             t.say<Text::route_size>(format_metres(t, calc::route_length_m(route.line)),
                                     format_metres(t, route.line.width_m), route.stations.size())) +
         fact(t[Text::position],
              t.say<Text::above_walking_surface>(format_metres(t, route.height_m)));
}

// Of the calculation, and so not of a preview.
std::string calculated_fact(std::string_view name, std::string_view value) {
  std::string row = fact(name, value);
  return row.insert(std::string_view("<tr").size(), " class=\"calculated\"");
}

// What of it no footnote tells, and the numbers of those that do.
std::string noted(const std::string& html, const std::vector<NoteItem>& items,
                  const Footnotes& footnotes) {
  const std::string marks = footnotes.marks(items);
  return html.empty() || marks.empty() ? html + marks : html + " " + marks;
}

std::string rule_words(const Texts& t, const calc::Message& rule, const Footnotes& footnotes) {
  const std::vector<NoteItem> sources = source_items(t, rule);
  const bool is_told = !sources.empty() &&
                       std::all_of(sources.begin(), sources.end(),
                                   [&](const NoteItem& source) { return footnotes.has(source); });
  return is_told ? noted(sentence_html(t, without_source(rule)), sources, footnotes)
                 : sentence_html(t, rule);
}

// "90: without a strip along the outline of 0.5 m", of each mask that requirements of it have.
std::string counting_points(const Texts& t, const PlanePart& plane) {
  std::vector<std::string> masks;
  for (const rules::Finding& finding : plane.findings) {
    const rules::Requirement& of = finding.requirement;
    if (of.mask.id.empty() || finding.points_used == 0) continue;
    std::string words = fmt::format("{}", finding.points_used) + t[Text::colon] +
                        (of.mask_words.empty() ? escape_html(mask_name(t, of.mask.id))
                                               : sentence_html(t, of.mask_words));
    if (std::find(masks.begin(), masks.end(), words) == masks.end())
      masks.push_back(std::move(words));
  }
  return fmt::format("{}", fmt::join(masks, "; "));
}

std::string grid_table(const Texts& t, const SpacePart& space, const PlanePart& plane,
                       const Footnotes& footnotes) {
  const calc::SensorGrid& grid = plane.grid;
  std::string rows = fact(t[Text::quantity], quantity_fact(t, plane));
  if (!plane.made_by.empty()) rows += fact(t[Text::made_by], sentence_html(t, plane.made_by));
  if (!plane.changed.empty())
    rows += fact(t[Text::changed], escape_html(sentence(t, plane.changed)));
  rows += fact(t[Text::rule], rule_words(t, grid.rule, footnotes));
  if (grid.columns > 0) {
    rows += fact(t[Text::cells], fmt::format("{} × {}", grid.columns, grid.rows));
    rows += fact(t[Text::spacing], fmt::format("{} × {} m", format_metres(t, grid.spacing_u_m),
                                               format_metres(t, grid.spacing_v_m)));
    rows += grid.route ? route_facts(t, *grid.route) : place_facts(t, space, grid);
  }
  for (const calc::Message& remark : plane.remarks) {
    const std::vector<NoteItem> items = note_items(t, remark);
    rows += calculated_fact(t[Text::method], noted(footnotes.inline_html(items), items, footnotes));
  }
  rows += fact(t[Text::points], fmt::format("{}", plane.points.size()));
  if (const std::string counting = counting_points(t, plane); !counting.empty())
    rows += fact(t[Text::points_counting], counting);
  rows += fact(t[Text::left_out], dropped_words(t, grid));
  rows += calculated_fact(t[Text::sampling], stop_words(t, plane.stop));
  if (const std::string looks = looks_words(t, plane); !looks.empty())
    rows += calculated_fact(t[Text::looks], looks);
  if (const std::string doubt = doubt_words(t, plane); !doubt.empty())
    rows += fact(t[Text::doubt], doubt);
  if (plane.counters.paths > 0)
    rows += calculated_fact(t[Text::light_paths], format_count(plane.counters.paths));
  return std::string("<table class=\"facts\"><caption>") + t[Text::grid_and_sampling] +
         "</caption><tbody>\n" + rows + "</tbody></table>\n";
}

// Nothing of it needs a look: passes that are waived, close or due to a tolerance do.
bool is_all_passed(const PlanePart& plane) {
  return plane.is_computed && !plane.findings.empty() && doubt_words(plane).empty() &&
         std::all_of(plane.findings.begin(), plane.findings.end(),
                     [](const rules::Finding& finding) {
                       return finding.verdict == rules::Verdict::pass && !finding.is_waived &&
                              !finding.is_close && !finding.by_tolerance &&
                              finding.requirement.deviations.empty();
                     });
}

// What a folded card still says: one badge for each verdict that it holds, another where it decides
// nothing, and the average.
std::string badges(const Texts& t, const PlanePart& plane) {
  std::string html;
  const auto add = [&](rules::Verdict verdict, bool decides_something) {
    const auto count = std::count_if(
        plane.findings.begin(), plane.findings.end(), [&](const rules::Finding& finding) {
          return finding.verdict == verdict && decides(finding) == decides_something &&
                 !is_outside_advice(finding);
        });
    if (count == 0) return;
    html += badge(t, verdict, decides_something) +
            (count > 1 ? fmt::format("<span class=\"quiet\">×{}</span> ", count) : " ");
  };
  for (const rules::Verdict verdict : rules::kGravestFirst) {
    add(verdict, true);
    add(verdict, false);
  }
  const auto outside =
      std::find_if(plane.findings.begin(), plane.findings.end(),
                   [](const rules::Finding& finding) { return is_outside_advice(finding); });
  if (outside != plane.findings.end())
    html += badge_of(t, outside->requirement, outside->verdict, false) + " ";
  if (!plane.is_computed) return html;
  const auto brief = [&](const calc::Estimate& estimate, const char* unit, rules::Metric metric) {
    const Thresholds thresholds = statistic_thresholds(plane, metric);
    return calc::is_plain_number(plane.derived)
               ? escape_html(value_words(t, plane, estimate, thresholds))
               : format_measured(t, estimate, unit, thresholds);
  };
  if (calc::is_plain_number(plane.derived)) {  // such have no average
    return html + fmt::format("<span class=\"brief\">{}</span>",
                              t.say<Text::brief_range>(
                                  brief(plane.minimum, plane_unit(plane), rules::Metric::minimum),
                                  brief(plane.maximum, plane_unit(plane), rules::Metric::maximum)));
  }
  return html +
         fmt::format("<span class=\"brief\">{}</span>",
                     t.say<Text::brief_average>(
                         brief(plane.average, plane_unit(plane), rules::Metric::average),
                         brief(plane.uniformity_min_avg, "", rules::Metric::uniformity_min_avg)));
}

}  // namespace

// The anchor is inside the fold: a browser that goes there opens it.
std::string html_plane(const Texts& t, PlaneIndex index, const SpacePart& space,
                       const PlanePart& own_plane, const ColourScales& scales, bool folds_passed,
                       const std::vector<std::string>& groups, Paper paper,
                       const Footnotes& footnotes) {
  const ShownPlane shown(own_plane);
  const PlanePart& plane = *shown;
  const std::string anchor = plane_anchor(index);
  const std::string title = escape_html(plane_name(t, space, plane));
  std::string html = fmt::format(
      "<article class=\"plane\" aria-labelledby=\"{0}-title\"><details class=\"card\"{3}>\n"
      "<summary><h4 id=\"{0}-title\">{1} <span class=\"id\">{2}</span></h4> <span "
      "class=\"on-paper room-name\">{6}</span> {4}</summary>\n"
      "<div id=\"{0}\"{5}>\n",
      anchor, title, plane.name.empty() ? "" : escape_html(plane.id),
      folds_passed && is_all_passed(plane) ? "" : " open=\"open\"", badges(t, plane),
      level_attributes(t, space, own_plane, scales, groups),
      escape_html(title_of(space.name, space.id)));
  if (!plane.is_computed) {
    html += "<p class=\"message\">" +
            t.say<Text::not_computed_because>(sentence_html(t, plane.reason)) + "</p>\n";
    return html + html_plane_findings(t, space, plane, footnotes) + "</div></details></article>\n";
  }
  html += html_plane_findings(t, space, plane, footnotes);
  if (const std::string words = other_light_words(t, plane); !words.empty())
    html += "<div class=\"calculated\"><p class=\"message\">" + escape_html(words) + "</p></div>\n";
  html += "<div class=\"split\">\n";
  if (has_cells(plane) && has_all_values(plane))
    html += html_plan(t, space, plane, scales.of(space, plane), anchor, place_beside_tables(paper));
  html += "<div class=\"side\">\n" + statistics_table(t, plane) + share_bar(t, plane) +
          groups_table(t, own_plane) + grid_table(t, space, plane, footnotes) + "</div>\n</div>\n";
  return html + html_contributions(t, own_plane) + html_looks(t, space, plane) +
         html_values(t, space, plane) + "</div></details></article>\n";
}

}  // namespace report
