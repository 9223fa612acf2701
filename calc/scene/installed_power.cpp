#include "calc/scene/installed_power.h"

#include "calc/base/sentences.h"
#include "calc/scene/polygon.h"

#include <cmath>

namespace calc {

Message InstalledPower::problem() const {
  if (without_power > 0) {
    return of_other_flux == 0
               ? say<Sentence::no_power>(without_power, luminaires)
               : say<Sentence::power_of_other_flux>(without_power, luminaires, of_other_flux);
  }
  // A building file's rooms and the open space have no outline here.
  if (!(area_m2 > 0.0)) return say<Sentence::no_floor_area>();
  return luminaires > 0 ? Message() : say<Sentence::no_luminaire>();
}

std::optional<double> InstalledPower::density_w_m2() const {
  if (!problem().empty()) return std::nullopt;
  return power_w / area_m2;
}

InstalledPower installed_power(const Project& project, const Space& space) {
  InstalledPower power;
  power.is_of_spacing = space.road.has_value();
  // Each row has one luminaire for each field.
  for (const Luminaire& luminaire : space.road ? space.road->rows : space.luminaires) {
    const LuminaireType& type = project.luminaire_types[luminaire.type];
    if (!type.counts_as_luminaire()) continue;
    const double power_w = type.power_w;
    ++power.luminaires;
    ++power.luminaires_of[{luminaire.group, type.id}];
    power.power_w += power_w;
    if (power_w > 0.0) continue;
    ++power.without_power;
    if (type.file_power_w > 0.0) ++power.of_other_flux;
  }
  if (space.shell) power.area_m2 = std::abs(signed_area(space.shell->footprint_m));
  return power;
}

}  // namespace calc
