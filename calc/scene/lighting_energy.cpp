#include "calc/scene/lighting_energy.h"

#include "calc/base/sentences.h"

#include <fmt/format.h>

#include <algorithm>

namespace calc {
namespace {

constexpr double kNotStated = 1.0;  // saves nothing

// Of one group: its own, else those of the whole space.
EnergyFactors factors_of(const EnergyUse& use, const std::string& group) {
  EnergyFactors factors = use.factors;
  const auto own = std::find_if(use.of_group.begin(), use.of_group.end(),
                                [&](const auto& entry) { return entry.first == group; });
  if (own == use.of_group.end()) return factors;
  const EnergyFactors& other = own->second;
  if (other.occupancy) factors.occupancy = other.occupancy;
  if (other.daylight) factors.daylight = other.daylight;
  if (other.constant_illuminance) factors.constant_illuminance = other.constant_illuminance;
  return factors;
}

// Hours at full output that take as much in a year.
double full_hours(const EnergyUse& use, const EnergyFactors& factors) {
  const double occupancy = factors.occupancy.value_or(kNotStated);
  return factors.constant_illuminance.value_or(kNotStated) * occupancy *
         (use.day_h * factors.daylight.value_or(kNotStated) + use.night_h);
}

Message number(const char* name, double value) {
  return Message::number(fmt::format("{} {:.6g}", name, value));
}

Message factor_words(const char* name, const std::optional<double>& factor) {
  return factor ? number(name, *factor) : say<Sentence::factor_assumed>(name);
}

Message words_of(const EnergyUse& use, const Space& space) {
  Message words =
      joined({factor_words("Fc", use.factors.constant_illuminance),
              factor_words("Fo", use.factors.occupancy), factor_words("FD", use.factors.daylight)},
             ", ");
  for (const auto& [group, own] : use.of_group) {
    const bool is_here = std::any_of(
        space.luminaires.begin(), space.luminaires.end(),
        [&name = group](const Luminaire& luminaire) { return luminaire.group == name; });
    if (!is_here) continue;
    Message factors;
    for (const auto& [name, factor] :
         {std::pair("Fc", own.constant_illuminance), std::pair("Fo", own.occupancy),
          std::pair("FD", own.daylight)}) {
      if (factor) append(factors, number(name, *factor), " ");
    }
    append(words, say<Sentence::factors_of_group>(group, factors), ", ");
  }
  append(words, say<Sentence::parasitic>(use.parasitic_kwh_m2), ", ");
  return say<Sentence::energy_stated>(use.day_h, use.night_h, words);
}

}  // namespace

LightingEnergy lighting_energy(const Project& project, const Space& space,
                               const InstalledPower& power) {
  LightingEnergy energy;
  energy.problem = power.problem();
  if (energy.problem.empty() && !space.energy) {
    energy.problem = say<Sentence::no_hours>();
  }
  if (!energy.problem.empty()) return energy;
  for (const Luminaire& luminaire : space.luminaires) {
    const double kwh = project.luminaire_types[luminaire.type].power_w / 1000.0 *
                       full_hours(*space.energy, factors_of(*space.energy, luminaire.group));
    energy.lighting_kwh += kwh;
    energy.kwh_of_group[luminaire.group] += kwh;
  }
  energy.leni_kwh_m2 = energy.lighting_kwh / power.area_m2 + space.energy->parasitic_kwh_m2;
  energy.words = words_of(*space.energy, space);
  return energy;
}

}  // namespace calc
