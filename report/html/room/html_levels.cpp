#include "report/html/room/html_levels.h"

#include "calc/base/names.h"
#include "report/document/shown_plane.h"
#include "report/html/drawings/html_plan.h"
#include "report/html/drawings/plan_cells.h"
#include "report/html/page/html_markup.h"
#include "report/images/heatmap.h"
#include "report/text/markup.h"
#include "report/text/point_thresholds.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace report {
namespace {

bool follows_levels(const PlanePart& plane) {
  // Groups have no values of direct light alone, nor of another state.
  const auto& asked = plane.asked_light;
  if (asked && (asked->direct_only || asked->state != rules::LightState::maintained)) return false;
  if (!plane.is_computed || plane.groups.empty() || plane.points.empty() ||
      calc::is_plain_number(plane.derived) || plane.points.size() > kMostSvgCells ||
      !has_all_values(plane)) {
    return false;
  }
  return plane.groups.size() == 1 ||
         std::none_of(plane.groups.begin(), plane.groups.end(),
                      [](const GroupShare& share) { return share.point_lx.empty(); });
}

// That all luminaires share; empty: they do not.
std::optional<double> common_maintenance(const ProjectPart& project) {
  std::optional<double> common;
  for (const LuminaireRow& row : project.luminaires) {
    if (row.count == 0) continue;
    if (common && *common != row.maintenance_factor) return std::nullopt;
    common = row.maintenance_factor;
  }
  return common;
}

std::string slider(const std::string& words, const std::string& attributes,
                   const std::string& value) {
  return fmt::format(
      "<label><span>{}</span> <input type=\"range\" {}/> <output>{}</output></label>\n", words,
      attributes, value);
}

std::string group_slider(const Texts& t, const std::string& group, bool is_only) {
  const std::string words =
      !group.empty() ? escape_html(group) : t[is_only ? Text::all_luminaires : Text::no_group];
  // As it stands in an attribute of the project, which the page shows as text.
  const std::string xml = escape_html(group);
  return slider(
      words, fmt::format("min=\"0\" max=\"100\" value=\"100\" data-group=\"{}\"", escape_html(xml)),
      "100 %");
}

std::string maintenance_slider(const Texts& t, const ProjectPart& project) {
  const std::optional<double> common = common_maintenance(project);
  const double now = common.value_or(1.0);
  const std::string value = format_shortest(now);
  return slider(t[common ? Text::part_maintenance_factor : Text::all_maintenance_factors],
                fmt::format("min=\"{}\" max=\"{}\" step=\"0.01\" value=\"{}\" data-now=\"{}\"{}",
                            format_shortest(std::min(0.3, now)),
                            format_shortest(common ? std::max(1.0, now) : 1.5), value, value,
                            common ? " data-is-common=\"1\"" : ""),
                t.number((common ? "" : "× ") + format_shortest(std::round(now * 1000) / 1000)));
}

// One for each light scene of the project, and one back.
std::string buttons(const Texts& t, const ProjectPart& project,
                    const std::vector<std::string>& groups) {
  std::string html =
      fmt::format("<button type=\"reset\">{}</button>", t[Text::levels_as_calculated]);
  for (const SceneRow& scene : project.scenes) {
    std::string levels;
    for (const std::string& group : groups)
      levels += (levels.empty() ? "" : " ") + format_shortest(level_of(scene, group));
    html += fmt::format(" <button type=\"button\" data-levels=\"{}\">{}</button>", levels,
                        t.say<Text::levels_of_scene>(escape_html(scene.id)));
  }
  return html;
}

struct LightAtPoints {
  std::size_t group = 0;  // of the room's
  double average_lx = 0;
  std::vector<double> point_lx;
};

std::vector<LightAtPoints> light_of(const PlanePart& plane,
                                    const std::vector<std::string>& groups) {
  std::vector<LightAtPoints> light;
  for (const GroupShare& share : plane.groups) {
    const auto at = std::find(groups.begin(), groups.end(), share.group) - groups.begin();
    light.push_back({static_cast<std::size_t>(at), share.average_lx.value, share.point_lx});
  }
  if (light.size() > 1) return light;
  light.front().average_lx = plane.average.value;
  for (const PointRow& point : plane.points) light.front().point_lx.push_back(point.measured.value);
  return light;
}

std::string share_digits(double value) { return fmt::format("{:.{}g}", value, kShareDigits); }

std::string light_attribute(const PlanePart& plane, const std::vector<std::string>& groups,
                            const std::vector<std::size_t>& order) {
  std::string text;
  for (const LightAtPoints& light : light_of(plane, groups)) {
    text += fmt::format("{}{}:{}:", text.empty() ? "" : ";", light.group,
                        share_digits(light.average_lx));
    for (std::size_t i = 0; i < order.size(); ++i)
      text += (i == 0 ? "" : " ") + share_digits(light.point_lx[order[i]]);
  }
  return " data-light=\"" + text + "\"";
}

// Of the points' places in the table of values, which has its first row on top.
std::string cells_attribute(const PlanePart& plane, const std::vector<std::size_t>& order) {
  std::string text;
  for (const std::size_t i : order) {
    const PointRow& point = plane.points[i];
    text += fmt::format("{}{}", text.empty() ? "" : " ",
                        (plane.grid.rows - 1 - point.row) * plane.grid.columns + point.column);
  }
  return " data-cells=\"" + text + "\"";
}

std::string scale_attributes(const ColourScale& scale) {
  std::string borders, colours, inks;
  for (int band = 0; band < scale.bands; ++band) {
    const Rgb colour = band_colour(scale, band);
    borders += (band == 0 ? "" : " ") + fmt::format("{:.9g}", scale.border(band));
    colours += (band == 0 ? "" : " ") + hex_colour(colour);
    inks += fmt::format("{}{}", band == 0 ? "" : " ", needs_dark_text(colour) ? "#000" : "#fff");
  }
  return fmt::format(" data-scale=\"{}\" data-colours=\"{}\" data-inks=\"{}\"", borders, colours,
                     inks);
}

// "≥ 150 lx, ≤ 900 lx"
std::string limit_words(const Texts& t, const PlanePart& plane) {
  std::string words;
  for (const Threshold& threshold : point_thresholds(plane).list)
    words += (words.empty() ? "" : ", ") + format_required(t, threshold, plane_unit(plane));
  return words.empty() ? words : " data-limit-words=\"" + escape_html(words) + "\"";
}

}  // namespace

std::vector<std::string> level_groups(const SpacePart& space) {
  std::vector<std::string> groups;
  for (const PlanePart& plane : space.planes) {
    if (!follows_levels(plane)) continue;
    for (const GroupShare& share : plane.groups) {
      if (std::find(groups.begin(), groups.end(), share.group) == groups.end())
        groups.push_back(share.group);
    }
  }
  return groups;
}

std::string html_levels(const Texts& t, const ProjectPart& project,
                        const std::vector<std::string>& groups) {
  if (groups.empty()) return {};
  std::string sliders;
  for (const std::string& group : groups) sliders += group_slider(t, group, groups.size() == 1);
  return fmt::format(
      "<details class=\"levels\" hidden=\"hidden\" data-decimal=\"{}\" data-preview=\"{}\" "
      "data-stays=\"{}\" data-note=\"{}\" data-missed=\"{}\" "
      "data-saved=\"{}\">\n<summary>{}</summary>\n<form autocomplete=\"off\">\n<p "
      "class=\"quiet\">{}</p>\n<div class=\"sliders\">\n{}{}</div>\n<p>{}</p>\n<p "
      "role=\"status\" hidden=\"hidden\">{} <code></code></p>\n<p class=\"nameless\" "
      "hidden=\"hidden\">{}</p>\n</form>\n</details>\n",
      t.number("0.1").substr(1, 1), t[Text::preview], t[Text::preview_stays], t[Text::preview_note],
      t[Text::preview_missed], t[Text::preview_saved], t[Text::levels_title], t[Text::levels_words],
      sliders, maintenance_slider(t, project), buttons(t, project, groups),
      t[Text::levels_in_the_project], t[Text::levels_need_a_group]);
}

std::string level_attributes(const Texts& t, const SpacePart& space, const PlanePart& own_plane,
                             const ColourScales& scales, const std::vector<std::string>& groups) {
  if (!follows_levels(own_plane)) return {};
  // Cells are in the order of the drawing; what levels make of them hangs on the groups' light.
  const ShownPlane shown(own_plane);
  const PlanePart& plane = *shown;
  std::vector<std::size_t> order;
  std::string scale;
  if (has_cells(plane)) {
    const ColourScale colours = scales.of(space, plane).scale;
    for (const auto& [band, points] : points_by_band(plane, colours)) {
      for (const PointRow* point : points)
        order.push_back(static_cast<std::size_t>(point - plane.points.data()));
    }
    scale = cells_attribute(plane, order) + scale_attributes(colours);
  } else {
    for (std::size_t i = 0; i < plane.points.size(); ++i) order.push_back(i);
  }
  return light_attribute(own_plane, groups, order) + scale +
         limits_attribute(point_thresholds(own_plane)) + limit_words(t, plane) + " data-unit=\"" +
         escape_html(t.number(plane_unit(plane))) + "\"";
}

std::string limits_attribute(const Thresholds& thresholds) {
  std::string text;
  for (const Threshold& threshold : thresholds.list) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ";", calc::name_of(threshold.comparison),
                        format_shortest(threshold.limit));
  }
  return text.empty() ? text : " data-limits=\"" + text + "\"";
}

}  // namespace report
