#pragma once
// Chooses one luminaire for direct light at a surface point.

#include "calc/radiosity/terms/choice_terms.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace calc {

// The probability is in proportion to about the most light that each could send: by its distance,
// the cosine at the surface and the largest intensity near that direction. Half of the probability
// is even among luminaires, half even among the channels that reach the point, so that a weak
// channel is sampled as well as a strong one. The light of a luminaire without size is at most its
// weight, so that one sample is never more than twice the possible light of all.  [METHOD, 2.4]
class LuminaireChoice {
 public:
  using Lobe = choice_terms::ChoiceLobe;
  using Source = choice_terms::ChoiceSource;

  // The scene must outlive it.
  explicit LuminaireChoice(const PreparedScene& scene);

  struct Choice {
    std::size_t luminaire;
    double probability;
  };
  // Returns a choice for u in [0, 1); empty if no luminaire can light the point. normal: unit.
  std::optional<Choice> choose(const glm::dvec3& position_m, const glm::dvec3& normal,
                               double u) const;

  // Return the tables of choose(), for devices: [luminaire], and the lobes that they name.
  std::span<const Source> sources() const { return sources_; }
  std::span<const Lobe> lobes() const { return lobes_; }

 private:
  static Lobe lobe_of(const PhotometricWeb& web, bool is_extended);

  std::vector<Source> sources_;
  std::vector<Lobe> lobes_;
  std::size_t channels_;
};

}  // namespace calc
