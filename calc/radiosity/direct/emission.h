#pragma once
// Light from luminaires: as sources for light paths, and directly at a point.

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

// Returns the unoccluded illuminance (lx) at a receiver with all of the luminaire's intensity at
// the point `source_m`: E = I k / d^2 (k = cos for a plane, 0 behind it), times flux_scale. d = 0
// gives 0: a receiver on the luminaire itself is refused before (find_touching_luminaire).
double point_illuminance_lx(const PlacedLuminaire& luminaire, const glm::dvec3& source_m,
                            const Receiver& receiver);

// Returns the end of shadow rays towards a point of a flat opening: lifted along the luminaire's
// axis to the receiver's side, so that the ceiling does not hide a luminaire flush with it.
glm::dvec3 lifted_source_m(const PlacedLuminaire& luminaire, const glm::dvec3& source_m,
                           const glm::dvec3& receiver_m, double offset_m);

struct EmittedRay {
  glm::dvec3 origin_m;   // lifted
  glm::dvec3 direction;  // unit, world axes
};

// All luminaires of a scene as a single source of light paths.
class Emitter {
 public:
  // is_unlit: [luminaire], 1 = lights no reflecting surface (find_unlit_surfaces()), so that no
  // path starts there; may be empty.
  explicit Emitter(const PreparedScene& scene, std::span<const std::uint8_t> is_unlit = {});

  double flux_lm() const { return flux_lm_; }  // of all luminaires, initial, full output
  // Returns the flux of the luminaires that paths start from.
  double traced_flux_lm() const { return traced_flux_lm_; }
  double flux_lm(std::size_t luminaire) const { return luminaire_flux_lm_[luminaire]; }

  // Returns a luminaire in file order for u in [0, 1). Half of the probability is by flux, half
  // even among channels and by flux within them, so that weak channels are well sampled, too.
  std::size_t choose_luminaire(double u) const;
  // Returns the cumulative probabilities of luminaires: luminaires + 1 entries, the last about 1.
  const std::vector<double>& cumulative() const { return cumulative_; }
  // Returns the flux of a path from this luminaire: its flux over its probability.
  double path_flux_lm(std::size_t luminaire) const { return path_flux_lm_[luminaire]; }
  // Samples direction by exact inversion of the web, position evenly over the opening along it.
  EmittedRay emit(std::size_t luminaire, std::array<double, 2> direction_u,
                  std::array<double, 2> opening_u, double offset_m) const;

  // Returns the identity of this emitter and its scene, see new_identity().
  std::uint64_t identity() const { return identity_; }
  const PreparedScene& scene() const { return scene_; }
  // Return one sampler per distinct web, and the index of a luminaire's sampler.
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

// Returns the index of a luminaire without size within `distance_m` of the point, or with a
// luminous body around it, so that its illuminance there has no meaning; or -1.
int find_touching_luminaire(const PreparedScene& scene, const glm::dvec3& point_m,
                            double distance_m);

}  // namespace calc
