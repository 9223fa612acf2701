#pragma once
// Light leaving luminaires: as sources for light paths, and directly at a point.

#include "calc/photometry/web_sampling.h"
#include "calc/radiosity/sampling/identity.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace calc {

// Unoccluded illuminance (lx) at a receiver from intensity leaving `source_m`, with
// all of the luminaire's intensity put into that one point: E = I k / d^2 (k = cos for a plane, 0
// behind it). Times flux_scale. d = 0 gives 0: a receiver on the luminaire itself is refused before
// (find_touching_luminaire).
double point_illuminance_lx(const PlacedLuminaire& luminaire, const glm::dvec3& source_m,
                            const Receiver& receiver);

// Where shadow rays towards a point of a flat opening end: lifted along the luminaire's axis to the
// receiver's side, so that a luminaire flush with the ceiling is not hidden by the ceiling.
glm::dvec3 lifted_source_m(const PlacedLuminaire& luminaire, const glm::dvec3& source_m,
                           const glm::dvec3& receiver_m, double offset_m);

struct EmittedRay {
  glm::dvec3 origin_m;   // lifted
  glm::dvec3 direction;  // unit, world axes
};

// All luminaires of a scene as one source of light paths.
class Emitter {
 public:
  // is_unlit: [luminaire], 1 = lights no reflecting surface (find_unlit_surfaces()), so that no
  // path starts there; may be empty.
  explicit Emitter(const PreparedScene& scene, std::span<const std::uint8_t> is_unlit = {});

  double flux_lm() const { return flux_lm_; }  // of all luminaires, initial, full output
  // Of the luminaires that paths start from.
  double traced_flux_lm() const { return traced_flux_lm_; }
  double flux_lm(std::size_t luminaire) const { return luminaire_flux_lm_[luminaire]; }

  // u in [0, 1): luminaire in file order. Half of the probability goes by flux, half evenly to the
  // channels and by flux within them, so that a weak channel is known as well as a strong one.
  std::size_t choose_luminaire(double u) const;
  // Of choosing one of the first luminaires; luminaires + 1 entries, the last about 1.
  const std::vector<double>& cumulative() const { return cumulative_; }
  // Flux over probability of choosing it: what a path from this luminaire stands for.
  double path_flux_lm(std::size_t luminaire) const { return path_flux_lm_[luminaire]; }
  // direction by exact inversion of the web; position evenly over the opening as seen along it.
  EmittedRay emit(std::size_t luminaire, std::array<double, 2> direction_u,
                  std::array<double, 2> opening_u, double offset_m) const;

  // Of this emitter and its scene, see new_identity().
  std::uint64_t identity() const { return identity_; }
  const PreparedScene& scene() const { return scene_; }
  // One per distinct web, and which of them is a luminaire's.
  const std::vector<WebSampler>& samplers() const { return samplers_; }
  std::size_t sampler_of(std::size_t luminaire) const { return sampler_of_[luminaire]; }

 private:
  std::uint64_t identity_ = new_identity();
  const PreparedScene& scene_;
  std::vector<WebSampler> samplers_;     // one per distinct web
  std::vector<std::size_t> sampler_of_;  // per luminaire
  std::vector<double> luminaire_flux_lm_, path_flux_lm_;
  std::vector<double> cumulative_;  // probability; luminaires + 1 entries
  double flux_lm_ = 0.0, traced_flux_lm_ = 0.0;
};

// Index of a luminaire without size within `distance_m` of the point, or with a luminous body
// around it, so that its illuminance there has no meaning; or -1.
int find_touching_luminaire(const PreparedScene& scene, const glm::dvec3& point_m,
                            double distance_m);

}  // namespace calc
