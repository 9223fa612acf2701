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
#include <cstddef>
#include <cstdint>
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
  if (const LuminaireTotals emergency = totals_of_emergency(project, space); emergency.count > 0)
    notes.add(space, t.say<Text::energy_of_emergency>(emergency.count, power_words(t, emergency)));
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

// Of several rooms.
struct EnergySums {
  std::size_t rooms = 0;
  double area_m2 = 0.0, kwh = 0.0;
  LuminaireTotals luminaires;
  bool is_energy_stated = false, is_energy_known = true;  // of any; of each

  void add(const ProjectPart& project, const SpacePart& space) {
    ++rooms;
    area_m2 += space.power.area_m2;
    const LuminaireTotals own = totals_in(project, space);
    luminaires.count += own.count;
    luminaires.power_w += own.power_w;
    luminaires.is_power_known &= own.is_power_known;
    const std::optional<double> energy = energy_kwh(space);
    is_energy_stated |= space.energy.has_value();
    is_energy_known &= energy.has_value();
    kwh += energy.value_or(0.0);
  }
};

std::string sums_row(const Texts& t, const std::string& title, const EnergySums& sums) {
  const LuminaireTotals& luminaires = sums.luminaires;
  const bool has_density = luminaires.is_power_known && sums.area_m2 > 0.0;
  const char* no_energy = sums.is_energy_stated ? t[Text::not_known] : t[Text::not_stated];
  return "<tr class=\"total\"><th scope=\"row\">" + title + "</th>" +
         number_cell(format_fixed(t, sums.area_m2, 2) + " m²") +
         number_cell(fmt::format("{}", luminaires.count)) +
         number_cell(luminaires.is_power_known ? format_watts(t, luminaires.power_w) + " W"
                                               : t[Text::not_known]) +
         number_cell(has_density ? format_fixed(t, luminaires.power_w / sums.area_m2, 2) + " W/m²"
                                 : t[Text::not_known]) +
         number_cell("") +
         number_cell(sums.is_energy_known ? format_fixed(t, sums.kwh, 0) + " kWh" : no_energy) +
         number_cell(sums.is_energy_known ? format_fixed(t, sums.kwh / sums.area_m2, 1) + " kWh/m²"
                                          : "") +
         "</tr>\n";
}

// A sum by floor area is that of rooms with both area and luminaires alone: a roof or a road would
// make any number of it. Count and power of the project are those of the schedule.
std::string sums_rows(const Texts& t, const ProjectPart& project) {
  EnergySums lit;
  std::size_t dark = 0;
  double dark_m2 = 0.0;
  std::int64_t of_roads = 0;
  for (const SpacePart& space : project.spaces) {
    const std::int64_t count = totals_in(project, space).count;
    const double area_m2 = space.power.area_m2;
    if (is_power_of_spacing(space)) of_roads += count;
    if (area_m2 > 0.0 && count > 0) {
      lit.add(project, space);
    } else if (area_m2 > 0.0) {
      ++dark;
      dark_m2 += area_m2;
    }
  }
  if (lit.rooms == project.spaces.size() && totals_elsewhere(project).count == 0)
    return sums_row(t, t[Text::whole_project], lit);
  std::string rows;
  if (lit.rooms > 0) rows += sums_row(t, t.say<Text::energy_of_lit_rooms>(lit.rooms), lit);
  const LuminaireTotals all = totals_of(project.luminaires);
  std::string title = t[Text::whole_project];
  const auto add_note = [&](const std::string& words) {
    title += "<span class=\"note\">" + words + "</span>";
  };
  if (dark > 0) add_note(t.say<Text::energy_of_dark_rooms>(dark, format_fixed(t, dark_m2, 2)));
  if (of_roads > 0) add_note(t.say<Text::energy_of_roads>(of_roads));
  return rows + "<tr class=\"total\"><th scope=\"row\">" + title + "</th>" + number_cell("") +
         number_cell(fmt::format("{}", all.count)) +
         number_cell(all.is_power_known ? format_watts(t, all.power_w) + " W"
                                        : t[Text::not_known]) +
         number_cell("") + number_cell("") + number_cell("") + number_cell("") + "</tr>\n";
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
         scroll_box(title, std::string("<table class=\"energy\"><caption>") +
                               t[Text::energy_caption] + "</caption><thead><tr><th scope=\"col\">" +
                               t[Text::space] + "</th>" + head(t[Text::floor_area]) +
                               head(t[Text::luminaires]) + head(t[Text::power]) +
                               head(t[Text::power_by_area]) + head(t[Text::power_by_light]) +
                               head(t[Text::energy_of_year]) + head("LENI") +
                               "</tr></thead><tbody>\n" + rows + "</tbody>" +
                               (project.spaces.size() > 1 || elsewhere.count > 0
                                    ? "<tfoot>" + sums_rows(t, project) + "</tfoot>"
                                    : "") +
                               "</table>") +
         notes.html(t);
}

}  // namespace report
