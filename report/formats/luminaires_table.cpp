#include "report/document/luminaire_totals.h"
#include "report/formats/table.h"
#include "report/text/luminaire_aim.h"
#include "report/text/schedule_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

namespace report {
namespace {

constexpr std::array kLuminaireColumns{
    TableColumn{"project", "Project", 18},
    TableColumn{"space", "Space", 14},
    TableColumn{"number", "Number in the room", 10},
    TableColumn{"id", "Id", 14},
    TableColumn{"type", "Type", 16},
    TableColumn{"maker", "Maker", 18},
    TableColumn{"article", "Article number", 18},
    TableColumn{"group", "Dimming group", 12},
    TableColumn{"x_m", "x (m)", 10, 3},
    TableColumn{"y_m", "y (m)", 10, 3},
    TableColumn{"z_m", "z (m)", 10, 3},
    TableColumn{"height_m", "Height above the floor (m)", 12, 3},
    TableColumn{"tilt_deg", "Tilt (°)", 10, 1},
    TableColumn{"heading_deg", "Heading (°)", 10, 1},
    TableColumn{"turn_deg", "Turn (°)", 10, 1},
    TableColumn{"flux_lm", "Luminous flux, new (lm)", 12},
    TableColumn{"power_w", "Power (W)", 10},
    TableColumn{"maintenance_factor", "Maintenance factor", 12},
    TableColumn{"position", "Position in the schedule", 10},
    TableColumn{"product", "Product", 24},
    TableColumn{"efficacy_lm_w", "Efficacy (lm/W)", 11, 0},
    TableColumn{"colour_temperature", "Colour temperature (K)", 12},
    TableColumn{"colour_rendering", "Ra", 8},
    TableColumn{"mark", "Mark", 8}};

TableCell known(const std::optional<double>& value) {
  return value ? TableCell(TableNumber{*value}) : TableCell();
}

void visit_luminaire(const ProjectPart& project, const SpacePart& space, std::size_t index,
                     const VisitRow& visit) {
  const LuminaireMark& mark = space.luminaires[index];
  const auto type =
      std::find_if(project.luminaires.begin(), project.luminaires.end(),
                   [&](const LuminaireRow& row) { return row.type_id == mark.type_id; });
  const bool is_known = type != project.luminaires.end();
  const LuminaireAim aim = aim_of(mark);
  std::array<TableCell, kLuminaireColumns.size()> cells;
  const auto set = [&cells](std::string_view name, TableCell cell) {
    cells[column_of(kLuminaireColumns, name)] = std::move(cell);
  };
  set("project", project.path);
  set("space", space.id);
  set("number", static_cast<std::int64_t>(index + 1));
  set("id", mark.id);
  set("mark", mark.label);
  set("type", mark.type_id);
  set("group", mark.group);
  set("x_m", TableNumber{mark.position_m.x});
  set("y_m", TableNumber{mark.position_m.y});
  set("z_m", TableNumber{mark.position_m.z});
  if (!space.footprint_m.empty()) {
    set("height_m", TableNumber{mark.position_m.z - space.floor_z_m});
  }
  set("tilt_deg", known(aim.tilt_deg));
  set("heading_deg", known(aim.heading_deg));
  set("turn_deg", known(aim.turn_deg));
  if (is_known) {
    set("maker", type->maker);
    set("article", type->article());
    set("flux_lm", TableNumber{type->told_lm()});
    if (type->power_w > 0.0) {
      set("power_w", TableNumber{type->power_w});
      set("efficacy_lm_w", TableNumber{type->told_lm() / type->power_w});
    }
    set("position",
        position_letter(static_cast<std::size_t>(std::distance(project.luminaires.begin(), type))));
    set("product", type->name);
    set("colour_temperature", colour_temperature_words({}, *type));
    set("colour_rendering", colour_rendering_words({}, *type));
    set("maintenance_factor", TableNumber{type->maintenance_factor});
  }
  visit(cells);
}

void visit_luminaires(const ProjectPart& project, const VisitRow& visit) {
  for (const SpacePart& space : project.spaces) {
    for (std::size_t i = 0; i < space.luminaires.size(); ++i)
      visit_luminaire(project, space, i, visit);
  }
}

constexpr DocumentTable kLuminairesTable{kLuminaireColumns, visit_luminaires};

}  // namespace

const DocumentTable& luminaires_table() { return kLuminairesTable; }

}  // namespace report
