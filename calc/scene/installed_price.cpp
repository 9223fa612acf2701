#include "calc/scene/installed_price.h"

namespace calc {

InstalledPrice installed_price(const Project& project, const Space& space) {
  InstalledPrice sum;
  for (const Luminaire& luminaire : space.luminaires) {
    const LuminaireType& type = project.luminaire_types[luminaire.type];
    if (!type.counts_as_luminaire()) continue;
    ++sum.luminaires;
    sum.price += type.price.value_or(0.0);
    if (!type.price) ++sum.without_price;
  }
  return sum;
}

}  // namespace calc
