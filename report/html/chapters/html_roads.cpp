#include "report/html/chapters/html_roads.h"

#include "report/document/one_source.h"
#include "report/document/road_facts.h"
#include "report/html/drawings/html_legend.h"
#include "report/html/drawings/road_luminance.h"
#include "report/html/drawings/road_section.h"
#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace report {
namespace {

// "Lane 1, towards +x".
std::string driver_name(const Texts& t, const calc::RoadObserver& observer) {
  return t.say<Text::road_towards>(observer.lane + 1, observer.is_oncoming ? "−x" : "+x");
}

std::string street_head(const std::vector<std::string>& columns, std::size_t words) {
  std::string cells;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    cells +=
        fmt::format("<th scope=\"col\"{}>{}</th>", i < words ? "" : " class=\"num\"", columns[i]);
  }
  return "<thead><tr>" + cells + "</tr></thead>";
}

// words: how many of the cells are no numbers; the first cell is the head of its row.
std::string street_row(const std::vector<std::string>& cells, std::size_t words) {
  std::string row = "<tr><th scope=\"row\">" + cells.front() + "</th>";
  for (std::size_t i = 1; i < cells.size(); ++i)
    row += fmt::format("<td{}>{}</td>", i < words ? "" : " class=\"num\"", cells[i]);
  return row + "</tr>\n";
}

// name: of the street; label: for screen readers, with it.
std::string street_table(const Texts& t, const std::string& name, const char* label,
                         const std::string& caption, const char* kind, const std::string& head,
                         const std::string& rows) {
  return scroll_box(name + t[Text::colon] + label,
                    fmt::format("<table class=\"{}\"><caption>{}</caption>{}<tbody>\n{}</tbody>"
                                "</table>",
                                kind, caption, head, rows));
}

std::string tilt_words(const Texts& t, double tilt_deg) {
  const bool is_whole = std::round(tilt_deg) == tilt_deg;
  return with_minus(format_fixed(t, tilt_deg, is_whole ? 0 : 1));
}

std::string arrangement_words(const Texts& t, const RoadFacts& facts) {
  switch (facts.arrangement) {
    case RoadArrangement::right:
      return t[Text::road_arrangement_right];
    case RoadArrangement::left:
      return t[Text::road_arrangement_left];
    case RoadArrangement::opposite:
      return t[Text::road_arrangement_opposite];
    case RoadArrangement::staggered:
      return t[Text::road_arrangement_staggered];
    case RoadArrangement::other:
      break;
  }
  return t.say<Text::road_arrangement_other>(facts.luminaires);
}

std::string carriageway_words(const Texts& t, const RoadPart& road) {
  const std::vector<calc::RoadObserver>& lanes = road.light.observers;
  const double lane_m = road.width_m / static_cast<double>(lanes.size());
  const std::string words = t.say<Text::road_carriageway_is>(
      format_metres(t, road.width_m), lanes.size(), format_metres(t, lane_m));
  const auto oncoming = std::count_if(
      lanes.begin(), lanes.end(), [](const calc::RoadObserver& lane) { return lane.is_oncoming; });
  return oncoming == 0 ? words : t.say<Text::road_oncoming>(words, oncoming);
}

std::string stated_of_street(const Texts& t, const RoadPart& road, const RoadFacts& facts,
                             const std::string& name) {
  const std::string surface =
      t.say<Text::road_surface_is>(escape_html(road.surface), t.number(format_shortest(road.q0)));
  const auto row = [](const char* of, const std::string& value) {
    return street_row({of, value}, 2);
  };
  const char* title = t[Text::road_stated];
  return street_table(t, name, title, title, "facts", "",
                      row(t[Text::road_carriageway], carriageway_words(t, road)) +
                          row(t[Text::road_surface], surface) +
                          row(t[Text::road_spacing], format_metres(t, road.spacing_m) + " m") +
                          row(t[Text::road_arrangement], arrangement_words(t, facts)) +
                          row(t[Text::road_setback], t[Text::not_stated]));
}

std::string rows_of_street(const Texts& t, const RoadPart& road, const std::string& name) {
  std::string rows;
  for (const RoadRowPart& row : road.rows) {
    rows += street_row(
        {escape_html(row.id), escape_html(row.type_id),
         t[is_on_the_left(road, row) ? Text::road_left : Text::road_right],
         format_metres(t, row.height_m), with_minus(format_metres(t, overhang_m(road, row))),
         tilt_words(t, street_tilt_deg(road, row)), format_metres(t, row.shift_m),
         row.power_w > 0.0 ? format_watts(t, row.power_w) + " W" : t[Text::not_stated],
         format_fixed(t, row.maintenance_factor, 2)},
        3);
  }
  const char* title = t[Text::road_rows];
  return street_table(
      t, name, title, title, "facts",
      street_head({t[Text::road_row], t[Text::type], t[Text::road_side], t[Text::mounting_height_m],
                   t[Text::road_overhang_m], t[Text::road_tilt_deg], t[Text::road_shift_m],
                   t[Text::power], t[Text::maintenance_factor]},
                  3),
      rows);
}

std::string area_name(const Texts& t, const RoadFacts& facts, std::size_t index) {
  const RoadAreaPart& area = *facts.areas[index].area;
  return index == 0 ? t[Text::road_carriageway] : escape_html(title_of(area.name, area.plane_id));
}

std::string areas_of_street(const Texts& t, const RoadFacts& facts, const std::string& name) {
  std::string rows;
  for (std::size_t i = 0; i < facts.areas.size(); ++i) {
    const RoadFacts::Area& area = facts.areas[i];
    std::string classes;
    for (const calc::Message& one : area.classes)
      classes += (classes.empty() ? "" : ", ") + sentence_html(t, without_one_source(one));
    rows += street_row(
        {area_name(t, facts, i), classes.empty() ? t[Text::none] : classes,
         format_metres(t, area.area->to_y_m - area.area->from_y_m), format_fixed(t, area.m2, 1),
         area.average_lx ? format_measured(t, *area.average_lx, "lx") : t[Text::not_known]},
        2);
  }
  const char* title = t[Text::road_areas];
  return street_table(t, name, title, title, "facts",
                      street_head({t[Text::road_area], t[Text::road_class], t[Text::road_width_m],
                                   "A m²", t[Text::road_average]},
                                  2),
                      rows);
}

// One column of what drivers see.
struct SeenColumn {
  const char* head;
  rules::Metric metric;
  bool RoadFacts::Observer::*decides;
};
constexpr std::array kSeen{
    SeenColumn{"L cd/m²", rules::Metric::road_luminance, &RoadFacts::Observer::of_average},
    SeenColumn{"Uo", rules::Metric::road_uniformity, &RoadFacts::Observer::of_uo},
    SeenColumn{"Ul", rules::Metric::road_lengthwise, &RoadFacts::Observer::of_ul},
    SeenColumn{"TI %", rules::Metric::threshold_increment, &RoadFacts::Observer::of_ti},
    SeenColumn{"REI", rules::Metric::edge_ratio, &RoadFacts::Observer::of_edge_ratio}};

std::optional<calc::Estimate> seen_by(const calc::RoadObserver& observer,
                                      const RoadFacts::Observer& facts, rules::Metric metric) {
  switch (metric) {
    case rules::Metric::road_luminance:
      return observer.average_cd_m2;
    case rules::Metric::road_uniformity:
      return observer.uo;
    case rules::Metric::road_lengthwise:
      return observer.ul;
    case rules::Metric::threshold_increment:
      return observer.ti_percent;
    default:
      return facts.edge_ratio;
  }
}

std::string drivers_of_street(const Texts& t, const RoadPart& road, const RoadFacts& facts,
                              const std::string& name) {
  std::vector<std::string> head{t[Text::road_observer]}, required{t[Text::required]};
  std::vector<std::vector<std::string>> rows;
  for (const calc::RoadObserver& observer : road.light.observers)
    rows.push_back({driver_name(t, observer)});
  bool is_asked = false;
  for (const SeenColumn& column : kSeen) {
    const rules::Requirement* asked = road_requirement(facts, column.metric);
    const char* unit = column.metric == rules::Metric::threshold_increment ? "%" : "";
    std::optional<Threshold> limit;
    if (asked != nullptr) limit = {asked->limit, asked->comparison};
    is_asked = is_asked || limit;
    head.push_back(column.head);
    required.push_back(limit ? escape_html(format_required(t, *limit, unit)) : "–");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const RoadFacts::Observer& one = facts.observers[i];
      const auto estimate = seen_by(road.light.observers[i], one, column.metric);
      const std::string number = estimate ? format_measured(t, *estimate, "", limit) : "–";
      rows[i].push_back(one.*column.decides ? "<strong>" + number + "</strong>" : number);
    }
  }
  if (is_asked) rows.push_back(required);
  std::string html;
  for (const std::vector<std::string>& row : rows) html += street_row(row, 1);
  const std::string light =
      road.scene.empty() ? t[Text::full_output] : t.say<Text::road_scene>(escape_html(road.scene));
  return street_table(t, name, t[Text::road_observer], t.say<Text::road_observers>(light),
                      "drivers", street_head(head, 1), html);
}

// "Lane 1, towards +x, decides L, Uo".
std::string driver_title(const Texts& t, const calc::RoadObserver& observer,
                         const RoadFacts::Observer& facts) {
  std::string what;
  const auto add = [&](bool decides, const char* sign) {
    if (decides) what += (what.empty() ? "" : ", ") + std::string(sign);
  };
  add(facts.of_average, "L");
  add(facts.of_uo, "Uo");
  add(facts.of_ul, "Ul");
  add(facts.of_ti, "TI");
  add(facts.of_edge_ratio, "REI");
  const std::string name = driver_name(t, observer);
  return what.empty() ? name : t.say<Text::road_chart_decides>(name, what);
}

// At most so many, ascending: those that decide before others.
std::vector<std::size_t> charted_observers(const RoadFacts& facts) {
  constexpr std::size_t kMostCharts = 12;
  std::vector<std::size_t> charted(facts.observers.size());
  std::iota(charted.begin(), charted.end(), std::size_t{0});
  if (charted.size() <= kMostCharts) return charted;
  std::stable_partition(charted.begin(), charted.end(),
                        [&](std::size_t i) { return facts.observers[i].decides(); });
  charted.resize(kMostCharts);
  std::sort(charted.begin(), charted.end());
  return charted;
}

std::string charts_of_street(const Texts& t, const RoadPart& road, const RoadFacts& facts,
                             const std::string& name) {
  const ColourScale scale = road_luminance_scale(road.light);
  std::string html = "<div class=\"road-charts\">\n";
  const std::vector<std::size_t> charted = charted_observers(facts);
  for (const std::size_t i : charted) {
    const calc::RoadObserver& observer = road.light.observers[i];
    const std::string title = driver_title(t, observer, facts.observers[i]);
    const std::optional<std::size_t>& same = facts.observers[i].same_as;
    if (same && std::binary_search(charted.begin(), charted.end(), *same)) {
      html += "<p class=\"quiet\">" +
              t.say<Text::road_chart_same>(title, driver_name(t, road.light.observers[*same])) +
              "</p>\n";
      continue;
    }
    const double before_m =
        observer.is_oncoming ? observer.eye_m.x - road.spacing_m : -observer.eye_m.x;
    const std::string label = t.say<Text::road_chart>(name + ", " + driver_name(t, observer));
    html += "<figure class=\"layout-figure\">\n<h5>" + t.say<Text::road_chart>(title) + "</h5>\n" +
            scroll_box(label, road_luminance(t, road, i, scale, label)) + "<figcaption>" +
            t.say<Text::road_chart_caption>(format_fixed(t, before_m, 0),
                                            format_metres(t, observer.eye_m.z)) +
            "</figcaption></figure>\n";
  }
  if (const std::size_t rest = facts.observers.size() - charted.size(); rest > 0)
    html += "<p class=\"quiet\">" + t.say<Text::road_charts_left_out>(rest) + "</p>\n";
  return html + html_colour_bar(t, scale, {}, {}, "") + "</div>\n";
}

// Why there is none.
std::string no_density_words(const Texts& t, const RoadFacts& facts) {
  if (!facts.power_w) return t[Text::road_no_power];
  if (facts.do_areas_overlap) return t[Text::road_areas_overlap];
  const bool is_lit = std::all_of(facts.areas.begin(), facts.areas.end(),
                                  [](const auto& area) { return area.average_lx.has_value(); });
  return t[is_lit ? Text::not_known : Text::road_no_light];
}

std::string annual_words(const Texts& t, const ProjectPart& project, const RoadFacts& facts) {
  constexpr double kThousand_h = 1000.0;
  const std::optional<double>& hours = project.maintenance_plan.use_h;
  const std::optional<double> energy = facts.energy_kwh_m2(hours.value_or(kThousand_h));
  if (!energy) return t[facts.power_w ? Text::not_known : Text::road_no_power];
  const std::string number = format_fixed(t, *energy, 2);
  return hours ? t.say<Text::road_aeci_of>(number, format_fixed(t, *hours, 0))
               : t.say<Text::road_aeci_none>(number);
}

std::string energy_of_street(const Texts& t, const ProjectPart& project, const RoadPart& road,
                             const RoadFacts& facts, const std::string& name) {
  const std::string spacing = format_metres(t, road.spacing_m);
  const std::optional<double> by_length = facts.power_w_km(road);
  const std::optional<calc::Estimate>& density = facts.power_density_w_lx_m2;
  const char* no_power = t[Text::road_no_power];
  const auto row = [](const std::string& what, const std::string& value) {
    return street_row({what, value}, 2);
  };
  const char* title = t[Text::road_energy];
  return street_table(
      t, name, title, title, "facts", "",
      row(t.say<Text::road_luminaires>(spacing), fmt::format("{}", facts.luminaires)) +
          row(t.say<Text::road_power>(spacing),
              facts.power_w ? format_watts(t, *facts.power_w) + " W" : no_power) +
          row(t[Text::road_power_km], by_length       ? format_fixed(t, *by_length, 0) + " W/km"
                                      : facts.power_w ? t[Text::not_known]
                                                      : no_power) +
          row(t[Text::road_pdi],
              density ? format_measured(t, *density, "W/(lx·m²)") : no_density_words(t, facts)) +
          row(t[Text::road_aeci], annual_words(t, project, facts)));
}

std::string street_html(const Texts& t, const ProjectPart& project, const SpacePart& space) {
  const RoadPart& road = *space.road;
  const RoadFacts facts = road_facts(space);
  const std::string name = escape_html(title_of(space.name, space.id));
  return "<h4>" + name + "</h4>\n" + road_section(t, road, name) +
         stated_of_street(t, road, facts, name) + rows_of_street(t, road, name) +
         areas_of_street(t, facts, name) + drivers_of_street(t, road, facts, name) +
         charts_of_street(t, road, facts, name) + energy_of_street(t, project, road, facts, name);
}

}  // namespace

std::string html_roads(const Texts& t, const ProjectPart& project, std::size_t index) {
  std::string streets;
  for (const SpacePart& space : project.spaces) {
    if (space.road) streets += street_html(t, project, space);
  }
  if (streets.empty()) return {};
  return fmt::format("<h3 id=\"roads{}\">{}</h3>\n", index + 1, t[Text::roads]) + streets;
}

}  // namespace report
