#include "report/document/luminaire_totals.h"

#include <algorithm>
#include <set>
#include <string>

namespace report {
namespace {

void add(const LuminaireRow& type, std::int64_t count, LuminaireTotals& totals) {
  totals.count += count;
  totals.flux_lm += static_cast<double>(count) * type.told_lm();
  totals.power_w += static_cast<double>(count) * type.power_w;
  if (count > 0 && !(type.power_w > 0.0)) totals.is_power_known = false;
}

std::int64_t count_in(const SpacePart& space, const LuminaireRow& type) {
  return std::count_if(space.luminaires.begin(), space.luminaires.end(),
                       [&](const LuminaireMark& mark) { return mark.type_id == type.type_id; });
}

std::set<std::string> emergency_scenes(const ProjectPart& project) {
  std::set<std::string> scenes;
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings) {
        if (finding.requirement.state == rules::LightState::end_of_duration)
          scenes.insert(finding.requirement.scene);
      }
    }
  }
  return scenes;
}

}  // namespace

LuminaireTotals totals_of(const std::vector<LuminaireRow>& luminaires) {
  LuminaireTotals totals;
  for (const LuminaireRow& row : luminaires) add(row, row.count, totals);
  return totals;
}

LuminaireTotals totals_in(const ProjectPart& project, const SpacePart& space) {
  LuminaireTotals totals;
  for (const LuminaireRow& row : project.luminaires) add(row, count_in(space, row), totals);
  return totals;
}

LuminaireTotals totals_elsewhere(const ProjectPart& project) {
  LuminaireTotals totals;
  for (const LuminaireRow& row : project.luminaires) {
    std::int64_t rest = row.count;
    for (const SpacePart& space : project.spaces) rest -= count_in(space, row);
    add(row, std::max<std::int64_t>(rest, 0), totals);
  }
  return totals;
}

LuminaireTotals totals_of_emergency(const ProjectPart& project, const SpacePart& space) {
  const std::set<std::string> emergency = emergency_scenes(project);
  const auto is_of_emergency = [&](const LuminaireMark& mark) {
    bool is_lit = false, is_off = false;
    for (const SceneRow& scene : project.scenes) {
      const bool is_on = level_of(scene, mark.group) > 0.0;
      if (emergency.count(scene.id) > 0) {
        is_lit |= is_on;
      } else if (is_on) {
        return false;
      } else {
        is_off = true;
      }
    }
    return is_lit && is_off;
  };
  LuminaireTotals totals;
  for (const LuminaireRow& row : project.luminaires) {
    add(row,
        std::count_if(space.luminaires.begin(), space.luminaires.end(),
                      [&](const LuminaireMark& mark) {
                        return mark.type_id == row.type_id && is_of_emergency(mark);
                      }),
        totals);
  }
  return totals;
}

bool is_power_of_spacing(const SpacePart& space) {
  const auto drawn = static_cast<int>(space.luminaires.size());
  return space.power.is_of_spacing || (space.power.luminaires > 0 && space.footprint_m.empty() &&
                                       space.power.luminaires < drawn);
}

std::string position_letter(std::size_t row) {
  constexpr std::size_t kLetters = 26;
  std::string name;
  for (++row; row > 0; row = (row - 1) / kLetters)
    name.insert(name.begin(), static_cast<char>('A' + (row - 1) % kLetters));
  return name;
}

}  // namespace report
