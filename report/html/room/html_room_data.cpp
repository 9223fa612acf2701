#include "report/html/room/html_room_data.h"

#include "calc/scene/installed_power.h"
#include "calc/scene/polygon.h"
#include "report/document/luminaire_totals.h"
#include "report/html/page/html_markup.h"
#include "report/text/luminaire_aim.h"
#include "report/text/markup.h"
#include "report/text/room_power.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

std::string square_metres(const Texts& t, double area_m2) {
  return format_fixed(t, area_m2, 2) + " m²";
}

std::string size_fact(const Texts& t, const SpacePart& space) {
  if (space.footprint_m.empty()) return {};
  glm::dvec2 low = space.footprint_m.front(), high = low;
  for (const glm::dvec2& corner : space.footprint_m) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  const glm::dvec2 size = high - low;
  const std::string words = t.say<Text::room_size>(
      format_metres(t, size.x), format_metres(t, size.y), format_metres(t, space.height_m));
  constexpr double kSame = 1e-9;
  const bool is_box =
      std::abs(calc::signed_area(space.footprint_m)) >= (1 - kSame) * size.x * size.y;
  return fact(t[Text::size], is_box ? words : words + ", " + t[Text::of_the_outline]);
}

std::vector<std::string> parts_of(std::string_view list) {
  std::vector<std::string> parts;
  while (!list.empty()) {
    const std::size_t comma = list.find(", ");
    parts.emplace_back(list.substr(0, comma));
    if (comma == std::string_view::npos) break;
    list.remove_prefix(comma + 2);
  }
  return parts;
}

// "white 0.70, oak 0.30"; of a material that reflects as it likes nothing is known but its name.
std::string materials_html(const Texts& t, const ProjectPart& project, std::string_view list) {
  std::string html;
  for (const std::string& id : parts_of(list)) {
    const auto material = std::find_if(project.materials.begin(), project.materials.end(),
                                       [&](const MaterialRow& row) { return row.id == id; });
    html += (html.empty() ? "" : ", ") + escape_html(id);
    if (material != project.materials.end())
      html += " " + format_limit(t, material->reflectance, "");
  }
  return html;
}

std::string surface_words(const Texts& t, const std::string& surface) {
  if (surface == "floor") return t[Text::surface_floor];
  if (surface == "ceiling") return t[Text::surface_ceiling];
  constexpr std::string_view kWall = "wall";
  return surface.starts_with(kWall) ? t.say<Text::surface_wall>(surface.substr(kWall.size()))
                                    : escape_html(surface);
}

// Walls of one finish are one row.
std::string surface_facts(const Texts& t, const ProjectPart& project, const SpacePart& space) {
  const auto is_wall = [](const SurfaceFinish& finish) {
    return finish.surface.starts_with("wall");
  };
  const auto first = std::find_if(space.finishes.begin(), space.finishes.end(), is_wall);
  const bool are_alike =
      std::all_of(space.finishes.begin(), space.finishes.end(), [&](const SurfaceFinish& finish) {
        return !is_wall(finish) || finish.materials == first->materials;
      });
  std::string html;
  for (const SurfaceFinish& finish : space.finishes) {
    const bool is_all = are_alike && is_wall(finish);
    if (is_all && &finish != &*first) continue;
    html += fact(is_all ? t[Text::surface_walls] : surface_words(t, finish.surface),
                 materials_html(t, project, finish.materials));
  }
  std::string objects;
  std::set<std::string> named;
  for (const BodyMark& body : space.bodies) {
    for (const std::string& id : parts_of(body.materials)) {
      if (named.insert(id).second) objects += (objects.empty() ? "" : ", ") + id;
    }
  }
  if (!objects.empty()) html += fact(t[Text::objects], materials_html(t, project, objects));
  return html;
}

std::string power_facts(const Texts& t, const ProjectPart& project, const SpacePart& space) {
  const calc::InstalledPower& power = space.power;
  if (power.luminaires == 0) return {};
  if (power.without_power > 0) {
    return fact(t[Text::power],
                t.say<Text::power_not_stated>(power.without_power, power.luminaires));
  }
  const std::string watts = format_watts(t, power.power_w) + " W";
  std::string html =
      fact(t[Text::power], is_power_of_spacing(space)
                               ? format_watts(t, totals_in(project, space).power_w) + " W, " +
                                     t.say<Text::energy_of_spacing>(power.luminaires, watts)
                               : watts);
  if (const LuminaireTotals emergency = totals_of_emergency(project, space); emergency.count > 0) {
    html +=
        fact(t[Text::emergency], t.say<Text::energy_of_emergency>(
                                     emergency.count, format_watts(t, emergency.power_w) + " W"));
  }
  const std::optional<double> density = power.density_w_m2();
  if (!density) return html;
  html += fact(t[Text::power_by_area], format_fixed(t, *density, 2) + " W/m²");
  if (const std::optional<PowerByLight> by_light = power_by_light(space)) {
    html += fact(t[Text::power_by_light],
                 t.say<Text::of_plane>(format_measured(t, by_light->w_m2, "W/m²"),
                                       escape_html(power_plane_words(t, space, *by_light))));
  }
  return html;
}

// "A MIRL NIV 2800" by the schedule, where it has the type.
std::string type_words(const ProjectPart& project, const std::string& type_id) {
  for (std::size_t i = 0; i < project.luminaires.size(); ++i) {
    const LuminaireRow& row = project.luminaires[i];
    if (row.type_id == type_id)
      return position_letter(i) + " " + escape_html(title_of(row.name, row.type_id));
  }
  return escape_html(type_id);
}

std::string luminaire_facts(const Texts& t, const ProjectPart& project, const SpacePart& space) {
  std::vector<std::pair<std::string, int>> count;
  for (const LuminaireMark& mark : space.luminaires) {
    auto found = std::find_if(count.begin(), count.end(),
                              [&](const auto& known) { return known.first == mark.type_id; });
    if (found == count.end()) found = count.insert(count.end(), {mark.type_id, 0});
    ++found->second;
  }
  std::string words;
  for (const auto& [type, number] : count)
    words += fmt::format("{}{} × {}", words.empty() ? "" : ", ", number, type_words(project, type));
  return words.empty() ? "" : fact(t[Text::luminaires], words);
}

std::string position_row(const Texts& t, const SpacePart& space, std::size_t index) {
  const LuminaireMark& mark = space.luminaires[index];
  const LuminaireAim aim = aim_of(mark);
  const auto number = [&](double metres) {
    return "<td class=\"num\">" + with_minus(format_metres(t, metres)) + "</td>";
  };
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td>{}{}{}<td "
      "class=\"num\">{}</td><td class=\"num\">{}</td></tr>\n",
      escape_html(mark.label), escape_html(mark.id), escape_html(mark.type_id),
      escape_html(mark.group), number(mark.position_m.x), number(mark.position_m.y),
      number(mark.position_m.z - space.floor_z_m), aim_words(t, aim),
      aim.turn_deg ? format_fixed(t, *aim.turn_deg, 1) + "°" : "");
}

std::string positions(const Texts& t, const SpacePart& space) {
  if (space.luminaires.empty()) return {};
  std::string rows;
  const std::size_t shown = std::min(space.luminaires.size(), kMostLuminaireRows);
  for (std::size_t i = 0; i < shown; ++i) rows += position_row(t, space, i);
  const auto head = [](const char* name, bool is_number) {
    return fmt::format("<th scope=\"col\"{}>{}</th>", is_number ? " class=\"num\"" : "", name);
  };
  const std::string heads = head(t[Text::luminaire_mark], false) +
                            head(t[Text::luminaire_id], false) + head(t[Text::type], false) +
                            head(t[Text::group_column], false) + head("x m", true) +
                            head("y m", true) + head(t[Text::mounting_height_m], true) +
                            head(t[Text::tilt], true) + head("C0", true);
  std::string caption = t[Text::positions_caption];
  if (!space.surface_lines_m.empty()) caption += std::string(" ") + t[Text::heights_over_zero];
  if (shown < space.luminaires.size())
    caption += " " + t.say<Text::shown_are_first>(shown, space.luminaires.size());
  return fmt::format(
      "<details class=\"list\"><summary>{}</summary>\n{}</details>\n",
      t.say<Text::positions_of>(space.luminaires.size()),
      scroll_box(t.say<Text::positions_in>(escape_html(title_of(space.name, space.id))),
                 "<table class=\"positions\"><caption>" + caption + "</caption><thead><tr>" +
                     heads + "</tr></thead><tbody>\n" + rows + "</tbody></table>"));
}

}  // namespace

std::string html_room_facts(const Texts& t, const ProjectPart& project, const SpacePart& space) {
  std::string rows = size_fact(t, space);
  if (space.power.area_m2 > 0.0)
    rows += fact(t[Text::floor_area], square_metres(t, space.power.area_m2));
  return rows + surface_facts(t, project, space) + luminaire_facts(t, project, space) +
         power_facts(t, project, space);
}

std::string html_room_data(const Texts& t, const ProjectPart& project, const SpacePart& space) {
  const std::string rows = html_room_facts(t, project, space);
  if (rows.empty()) return {};
  // A short table of places stands beside the figures on paper.
  constexpr std::size_t kBeside = 30;
  const bool is_beside = !space.luminaires.empty() && space.luminaires.size() <= kBeside;
  return std::string("<div class=\"space-figures") + (is_beside ? " beside" : "") +
         "\">\n<table class=\"facts narrow room-data\"><caption>" + t[Text::room_data] +
         "</caption><tbody>\n" + rows + "</tbody></table>\n" + positions(t, space) + "</div>\n";
}

}  // namespace report
