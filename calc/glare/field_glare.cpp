#include "calc/glare/field_glare.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/glare/luminaires_seen.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/scene_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace calc {
namespace {

constexpr int kDirections = 24, kEveryThird = 3;  // the first of three are those of 45 degrees
constexpr double kVeil = 10.0;                    // of theta in degrees
constexpr double kNarrow_deg = 1.5, kWide_deg = 60.0;
constexpr double kSmallest_deg = 0.1;  // nobody looks so straight into a lamp

struct FieldSource {
  glm::dvec3 position_m;
  const PhotometricWeb* web;
  glm::dmat3 luminaire_from_world;
  double factor;
};

std::vector<FieldSource> sources_of(const Project& project, const Space& space,
                                    const LightScene* scene) {
  std::vector<FieldSource> sources;
  for (const Luminaire& luminaire : space.luminaires) {
    const double factor =
        installed_flux_scale(project, luminaire) * level_in_scene(scene, luminaire.group);
    if (!(factor > 0.0)) continue;
    sources.push_back({luminaire.position_m,
                       &project.webs[project.luminaire_types[luminaire.type].web],
                       glm::transpose(luminaire.world_from_luminaire), factor});
  }
  return sources;
}

std::array<glm::dvec3, kDirections> looks(const glm::dvec3& along) {
  const double down_rad = radians_from_degrees(kFieldLook_deg);
  const glm::dvec3 across(-along.y, along.x, 0.0);
  std::array<glm::dvec3, kDirections> found{};
  for (int i = 0; i < kDirections; ++i) {
    const double turn_rad = 2.0 * kPi * i / kDirections;
    const glm::dvec3 flat = calc::cos(turn_rad) * along + calc::sin(turn_rad) * across;
    found[static_cast<std::size_t>(i)] =
        calc::cos(down_rad) * flat - glm::dvec3(0.0, 0.0, calc::sin(down_rad));
  }
  return found;
}

// By both readings of what lies beside the line of sight and on it.
struct Veil {
  double least = 0.0, most = 0.0;
};

}  // namespace

Estimate field_veiling(const Project& project, const Space& space, const LightScene* scene,
                       const std::vector<glm::dvec3>& points_m, const glm::dvec3& along) {
  const std::vector<FieldSource> sources = sources_of(project, space, scene);
  const std::array<glm::dvec3, kDirections> look = looks(along);
  Estimate highest;
  double lowest_m = std::numeric_limits<double>::infinity();  // of eyes and luminaires
  for (const FieldSource& source : sources) lowest_m = std::min(lowest_m, source.position_m.z);
  for (const glm::dvec3& point : points_m) {
    const glm::dvec3 eye = point + glm::dvec3(0.0, 0.0, kFieldEye_m);
    lowest_m = std::min(lowest_m, eye.z);
    std::array<Veil, kDirections> veils{};
    for (const FieldSource& source : sources) {
      const glm::dvec3 way = source.position_m - eye;
      const double squared_m2 = glm::dot(way, way);
      if (!(squared_m2 > 0.0)) {  // in the eye itself
        for (Veil& veil : veils) veil.most = std::numeric_limits<double>::infinity();
        continue;
      }
      const glm::dvec3 towards = way / std::sqrt(squared_m2);
      const glm::dvec3 out = source.luminaire_from_world * -towards;
      const double lx =
          source.factor * source.web->intensity_cd(std::array{out.x, out.y, out.z}) / squared_m2;
      if (!(lx > 0.0)) continue;
      for (std::size_t i = 0; i < look.size(); ++i) {
        const double cosine = glm::dot(look[i], towards);
        if (!(cosine > 0.0)) continue;
        const double theta_deg = degrees_from_radians(calc::acos(std::min(1.0, cosine)));
        const double narrow_deg = std::max(theta_deg, kNarrow_deg);
        const double as_it_is_deg = std::max(theta_deg, kSmallest_deg);
        const double eye_lx = kVeil * lx * cosine;
        if (theta_deg <= kWide_deg) veils[i].least += eye_lx / (narrow_deg * narrow_deg);
        veils[i].most += eye_lx / (as_it_is_deg * as_it_is_deg);
      }
    }
    for (std::size_t i = 0; i < veils.size(); ++i) {
      highest.high = std::max(highest.high, veils[i].most);
      if (i % kEveryThird == 0) highest.value = std::max(highest.value, veils[i].least);
    }
  }
  highest.low = may_hide_luminaires(space, lowest_m) ? 0.0 : highest.value;
  return highest;
}

double field_glare(double veiling_cd_m2, double average_lx, double reflectance) {
  constexpr double kOfField = 0.035, kPower = 0.9, kBase = 27.0, kSlope = 24.0;
  if (!(veiling_cd_m2 > 0.0)) return -std::numeric_limits<double>::infinity();
  const double field_cd_m2 = kOfField * reflectance * average_lx / kPi;
  return kBase + kSlope * (calc::log10(veiling_cd_m2) - kPower * calc::log10(field_cd_m2));
}

}  // namespace calc
