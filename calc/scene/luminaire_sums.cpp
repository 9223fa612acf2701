#include "calc/scene/luminaire_sums.h"

#include "calc/base/units.h"

#include <algorithm>
#include <utility>

namespace calc {
namespace {

// One emitter alone stands for itself.
std::vector<TypeEmitter> emitters_of(const Project& project, const LuminaireType& type) {
  if (!type.emitters.empty()) return type.emitters;
  return {{static_cast<std::size_t>(&type - project.luminaire_types.data()), {}}};
}

double emitter_intensity_cd(const Project& project, const TypeEmitter& emitter,
                            const glm::dvec3& direction) {
  const LuminaireType& type = project.luminaire_types[emitter.type];
  const glm::dvec3 own = glm::transpose(emitter.place.turn) * direction;
  return project.webs[type.web].intensity_cd({own.x, own.y, own.z}) * type.flux_scale;
}

// Those of the table; the light of the others is not axial where this one is.
std::vector<double> planes_rad(const PhotometricWeb& web) {
  if (!web.is_axial()) return web.c_rad();
  constexpr int kPlanes = 72;
  std::vector<double> planes;
  for (int plane = 0; plane < kPlanes; ++plane) planes.push_back(2.0 * kPi * plane / kPlanes);
  return planes;
}

}  // namespace

double luminaire_flux_lm(const Project& project, const LuminaireType& type) {
  double flux_lm = 0.0;
  for (const TypeEmitter& emitter : emitters_of(project, type)) {
    const LuminaireType& own = project.luminaire_types[emitter.type];
    flux_lm += project.webs[own.web].flux_lm() * own.flux_scale;
  }
  return flux_lm;
}

double luminaire_intensity_cd(const Project& project, const LuminaireType& type,
                              const std::array<double, 3>& direction) {
  double sum_cd = 0.0;
  for (const TypeEmitter& emitter : emitters_of(project, type)) {
    sum_cd += emitter_intensity_cd(project, emitter, {direction[0], direction[1], direction[2]});
  }
  return sum_cd;
}

double luminaire_peak_cd(const Project& project, const LuminaireType& type) {
  const std::vector<TypeEmitter> emitters = emitters_of(project, type);
  if (emitters.size() == 1) return project.webs[type.web].max_intensity_cd() * type.flux_scale;
  double peak_cd = 0.0;
  for (const TypeEmitter& emitter : emitters) {
    const PhotometricWeb& web = project.webs[project.luminaire_types[emitter.type].web];
    for (const double c_rad : planes_rad(web)) {
      for (const double gamma_rad : web.gamma_rad()) {
        const std::array<double, 3> own = web.from_table(direction_of({c_rad, gamma_rad}));
        const glm::dvec3 world = emitter.place.turn * glm::dvec3(own[0], own[1], own[2]);
        peak_cd =
            std::max(peak_cd, luminaire_intensity_cd(project, type, {world.x, world.y, world.z}));
      }
    }
  }
  return peak_cd;
}

int luminaires_of_type(const Project& project, std::size_t type) {
  std::ptrdiff_t count = 0;
  for (const Space& space : project.spaces) {
    count += std::count_if(space.luminaires.begin(), space.luminaires.end(),
                           [type](const Luminaire& luminaire) { return luminaire.type == type; });
  }
  return static_cast<int>(count);
}

std::vector<Luminaire> with_all_emitters(const Project& project,
                                         std::vector<Luminaire> luminaires) {
  std::vector<Luminaire> all;
  for (Luminaire& luminaire : luminaires) {
    const bool has_several = luminaire.type < project.luminaire_types.size() &&
                             !project.luminaire_types[luminaire.type].emitters.empty();
    if (!has_several) {
      all.push_back(std::move(luminaire));
      continue;
    }
    const LuminaireType& type = project.luminaire_types[luminaire.type];
    for (const TypeEmitter& emitter : type.emitters) {
      Luminaire part = luminaire;
      part.type = emitter.type;
      part.position_m += luminaire.world_from_luminaire * emitter.place.position_m;
      part.world_from_luminaire = luminaire.world_from_luminaire * emitter.place.turn;
      // "type/emitter" to "luminaire/emitter".
      const std::string& type_id = project.luminaire_types[emitter.type].id;
      if (emitter.type != luminaire.type) part.id += type_id.substr(type.id.size());
      all.push_back(std::move(part));
    }
  }
  return all;
}

}  // namespace calc
