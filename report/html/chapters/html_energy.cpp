#include "report/html/chapters/html_energy.h"

#include "report/document/luminaire_totals.h"
#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/room_causes.h"
#include "report/text/room_power.h"
#include "report/text/sentences.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace report {
namespace {

std::string number_cell(const std::string& text) { return "<td class=\"num\">" + text + "</td>"; }

std::string power_words(const Texts& t, const LuminaireTotals& drawn) {
  return drawn.is_power_known ? format_watts(t, drawn.power_w) + " W" : t[Text::not_stated];
}

// Of a year, with the parasitic part; empty: not stated or not known.
std::optional<double> energy_kwh(const SpacePart& space) {
  if (!space.energy || !space.energy->problem.empty()) return {};
  return space.energy->leni_kwh_m2 * space.power.area_m2;
}

std::string energy_cells(const Texts& t, const SpacePart& space) {
  if (!space.energy) return number_cell(t[Text::not_stated]) + number_cell("");
  const std::optional<double> energy = energy_kwh(space);
  if (!energy) return number_cell(t[Text::not_known]) + number_cell("");
  return number_cell(format_fixed(t, *energy, 0) + " kWh") +
         number_cell(format_fixed(t, space.energy->leni_kwh_m2, 1) + " kWh/m²");
}

// What is said of the energy of several rooms alike stands once below the table.
class EnergyNotes {
 public:
  void add(const SpacePart& space, std::string html) {
    const std::string room(title_of(space.name, space.id));
    const auto known = std::find_if(notes_.begin(), notes_.end(),
                                    [&](const auto& note) { return note.first == html; });
    if (known != notes_.end()) return known->second.push_back(room);
    notes_.push_back({std::move(html), {room}});
  }
  std::string html(const Texts& t) const {
    std::string list;
    for (const auto& [words, rooms] : notes_) {
      list += "<li>" + escape_html(some_names(t, rooms)) + t[Text::colon] + words + "</li>\n";
    }
    return list.empty() ? list : "<ul class=\"quiet table-notes\">\n" + list + "</ul>\n";
  }

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> notes_;
};

std::string energy_row(const Texts& t, const ProjectPart& project, const SpacePart& space,
                       EnergyNotes& notes) {
  const calc::InstalledPower& power = space.power;
  const LuminaireTotals drawn = totals_in(project, space);
  const std::optional<double> density = power.density_w_m2();
  const std::optional<PowerByLight> by_light = power_by_light(space);
  std::string note;
  if (by_light) {
    note +=
        "<span class=\"note\">" + escape_html(power_plane_words(t, space, *by_light)) + "</span>";
  }
  std::string words = escape_html(title_of(space.name, space.id));
  if (space.energy) {
    const calc::Message& remark =
        space.energy->problem.empty() ? space.energy->words : space.energy->problem;
    if (!remark.empty()) notes.add(space, sentence_html(t, remark));
  }
  if (is_power_of_spacing(space)) {
    const std::string watts =
        power.without_power > 0 ? t[Text::not_stated] : format_watts(t, power.power_w) + " W";
    notes.add(space, t.say<Text::energy_of_spacing>(power.luminaires, watts));
  }
  return "<tr><th scope=\"row\">" + words + "</th>" +
         number_cell(power.area_m2 > 0.0 ? format_fixed(t, power.area_m2, 2) + " m²" : "") +
         number_cell(fmt::format("{}", drawn.count)) + number_cell(power_words(t, drawn)) +
         number_cell(density ? format_fixed(t, *density, 2) + " W/m²" : "") +
         number_cell(by_light ? format_measured(t, by_light->w_m2, "W/m²") + note : "") +
         energy_cells(t, space) + "</tr>\n";
}

// "" = none: every luminaire of the schedule is in a row.
std::string elsewhere_row(const Texts& t, const LuminaireTotals& elsewhere) {
  if (elsewhere.count == 0) return {};
  return std::string("<tr><th scope=\"row\">") + t[Text::luminaires_elsewhere] + "</th>" +
         number_cell("") + number_cell(fmt::format("{}", elsewhere.count)) +
         number_cell(power_words(t, elsewhere)) + number_cell("") + number_cell("") +
         number_cell("") + number_cell("") + "</tr>\n";
}

// Sums of what is known of every room, and of the open space; a cell says where it is not. Count
// and power are those of the schedule.
std::string sums_row(const Texts& t, const ProjectPart& project) {
  double area_m2 = 0.0, all_kwh = 0.0;
  bool has_areas = true, has_energy = true;
  for (const SpacePart& space : project.spaces) {
    area_m2 += space.power.area_m2;
    has_areas &= space.power.area_m2 > 0.0;
    const std::optional<double> energy = energy_kwh(space);
    has_energy &= energy.has_value();
    all_kwh += energy.value_or(0.0);
  }
  const LuminaireTotals all = totals_of(project.luminaires);
  if (totals_elsewhere(project).count > 0) has_areas = has_energy = false;
  return std::string("<tfoot><tr class=\"total\"><th scope=\"row\">") + t[Text::whole_project] +
         "</th>" +
         number_cell(has_areas ? format_fixed(t, area_m2, 2) + " m²" : t[Text::not_known]) +
         number_cell(fmt::format("{}", all.count)) +
         number_cell(all.is_power_known ? format_watts(t, all.power_w) + " W"
                                        : t[Text::not_known]) +
         number_cell(has_areas && all.is_power_known
                         ? format_fixed(t, all.power_w / area_m2, 2) + " W/m²"
                         : t[Text::not_known]) +
         number_cell("") +
         number_cell(has_energy ? format_fixed(t, all_kwh, 0) + " kWh" : t[Text::not_known]) +
         number_cell("") + "</tr></tfoot>";
}

}  // namespace

std::string html_energy(const Texts& t, const ProjectPart& project, std::size_t index) {
  const bool has_light =
      std::any_of(project.spaces.begin(), project.spaces.end(),
                  [](const SpacePart& space) { return !space.luminaires.empty(); });
  if (!has_light) return {};
  std::string rows;
  EnergyNotes notes;
  for (const SpacePart& space : project.spaces) rows += energy_row(t, project, space, notes);
  const LuminaireTotals elsewhere = totals_elsewhere(project);
  rows += elsewhere_row(t, elsewhere);
  const auto head = [](const char* words) {
    return std::string("<th scope=\"col\" class=\"num\">") + words + "</th>";
  };
  const char* title = t[Text::energy];
  return fmt::format("<h3 id=\"energy{}\">{}</h3>\n", index + 1, title) +
         scroll_box(
             title,
             std::string("<table class=\"energy\"><caption>") + t[Text::energy_caption] +
                 "</caption><thead><tr><th scope=\"col\">" + t[Text::space] + "</th>" +
                 head(t[Text::floor_area]) + head(t[Text::luminaires]) + head(t[Text::power]) +
                 head(t[Text::power_by_area]) + head(t[Text::power_by_light]) +
                 head(t[Text::energy_of_year]) + head("LENI") + "</tr></thead><tbody>\n" + rows +
                 "</tbody>" +
                 (project.spaces.size() > 1 || elsewhere.count > 0 ? sums_row(t, project) : "") +
                 "</table>") +
         notes.html(t);
}

}  // namespace report
