#pragma once
// Which luminaire a surface point asks for its light, when it asks one for all.

#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace calc {

// Chosen in proportion to about the most light that each could send: by its distance, the cosine at
// the surface and the largest intensity near that direction. Half of the probability goes to all
// luminaires alike, half evenly to the channels that reach the point, so that a weak channel is
// known as well as a strong one. What a luminaire without size sends is at most its weight, so that
// one sample is never more than twice the sum of what all could send.  [METHOD, 2.4]
class LuminaireChoice {
 public:
  // The scene must outlive it.
  explicit LuminaireChoice(const PreparedScene& scene);

  struct Choice {
    std::size_t luminaire;
    double probability;
  };
  // u in [0, 1). None if no luminaire can light the point. normal: unit.
  std::optional<Choice> choose(const glm::dvec3& position_m, const glm::dvec3& normal,
                               double u) const;

 private:
  static constexpr std::size_t kBands = 32;  // of equal solid angle
  struct Lobe {
    std::array<float, kBands> most_cd;  // over the band and its neighbours
    float largest_cd;
  };
  struct Source {
    glm::vec3 position_m, axis;
    glm::mat3 luminaire_from_world;
    glm::vec3 half_m;  // half sizes of its opening along its axes
    float reach_m;     // half the diagonal of its opening
    float scale;
    std::uint32_t lobe, channel;
  };
  static Lobe lobe_of(const PhotometricWeb& web, bool is_extended);
  float most_lx(const Source& source, const glm::vec3& position_m, const glm::vec3& normal) const;
  float most_nearby_lx(const Source& source, const glm::vec3& way) const;

  std::vector<Source> sources_;
  std::vector<Lobe> lobes_;
  std::size_t channels_;
};

}  // namespace calc
