#include "calc/project/spaces/energy_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/project/reading/project_elements.h"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace calc {
namespace {

using GroupNames = std::set<std::string, std::less<>>;

EnergyFactors read_factors(ElementReader& reader) {
  EnergyFactors factors;
  factors.occupancy = reader.optional_number("occupancy", kPositiveFraction);
  factors.daylight = reader.optional_number("daylight", kPositiveFraction);
  factors.constant_illuminance = reader.optional_number("constant-illuminance", kPositiveFraction);
  return factors;
}

// What differs for the luminaires of a dimming group.
void read_part(const XmlElement& element, const GroupNames& groups, IdTable& seen, EnergyUse& use,
               Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kEnergyPartElement);
  const std::string group(trim(reader.text("group")));
  const EnergyFactors factors = read_factors(reader);
  if (!factors.occupancy && !factors.daylight && !factors.constant_illuminance && reader.ok()) {
    reader.report(DiagnosticId::missing_form, reader.where(), "part",
                  "'occupancy', 'daylight' or 'constant-illuminance'");
  }
  if (group.empty()) return;
  seen.add(reader, group, 0);
  if (groups.count(group) == 0) {
    report_unknown_reference(reader, "group", "luminaire with the dimming group", group,
                             Names(groups.begin(), groups.end()));
  }
  use.of_group.emplace_back(group, factors);
}

EnergyUse read_use(const XmlElement& element, const GroupNames& groups, Diagnostics& diagnostics) {
  ElementReader reader(element, diagnostics);
  reader.allow(kEnergyElement);
  EnergyUse use;
  use.day_h = reader.number("day-hours", kHours);
  use.night_h = reader.number("night-hours", kHours);
  use.parasitic_kwh_m2 = reader.number("parasitic-kwh-m2", kNonNegative);
  use.factors = read_factors(reader);
  const double sum_h = use.day_h + use.night_h;
  if (reader.ok() && !(sum_h > 0.0 && sum_h <= kYear_h)) {
    reader.report(DiagnosticId::number_out_of_range, reader.where("night-hours"), "night-hours",
                  "energy", reader.text("night-hours"),
                  "hours that with 'day-hours' add up to more than 0 and at most 8760, one year");
  }
  IdTable seen("dimming group");
  for (const XmlElement& child : element.children) {
    if (child.name == "part") read_part(child, groups, seen, use, diagnostics);
  }
  return use;
}

// The only one in `parent`; a second one is reported.
std::optional<EnergyUse> read_only_energy(const XmlElement& parent, const std::string& owner,
                                          const GroupNames& groups, Diagnostics& diagnostics) {
  std::optional<EnergyUse> use;
  int line = 0;
  for (const XmlElement& child : parent.children) {
    if (child.name != "energy") continue;
    if (use) diagnostics.report(DiagnosticId::duplicate_id, child.where, "energy of", owner, line);
    if (!use) line = child.where.line;
    EnergyUse read = read_use(child, groups, diagnostics);
    if (!use) use = std::move(read);
  }
  return use;
}

GroupNames groups_of(const Space& space) {
  GroupNames groups;
  for (const Luminaire& luminaire : space.luminaires) {
    if (!luminaire.group.empty()) groups.insert(luminaire.group);
  }
  return groups;
}

}  // namespace

void read_energy(ProjectContext& context, const XmlElement& root) {
  const GroupNames all(context.groups.begin(), context.groups.end());
  const std::optional<EnergyUse> common =
      read_only_energy(root, "the project", all, context.diagnostics);
  std::size_t room = 0;
  for (const XmlElement& child : root.children) {
    if (child.name != "room") continue;
    Space& space = context.project.spaces.at(room++);
    space.energy = read_only_energy(child, space.id, groups_of(space), context.diagnostics);
    if (!space.energy) space.energy = common;
  }
}

}  // namespace calc
