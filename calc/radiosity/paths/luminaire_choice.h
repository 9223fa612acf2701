#pragma once
// Which luminaire a surface point asks for its light, when it asks one for all.

#include "calc/radiosity/terms/choice_terms.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace calc {

// Chosen in proportion to about the most light that each could send: by its distance, the cosine at
// the surface and the largest intensity near that direction. Half of the probability goes to all
// luminaires alike, half evenly to the channels that reach the point, so that a weak channel is
// known as well as a strong one. What a luminaire without size sends is at most its weight, so that
// one sample is never more than twice the sum of what all could send.  [METHOD, 2.4]
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
  // u in [0, 1). None if no luminaire can light the point. normal: unit.
  std::optional<Choice> choose(const glm::dvec3& position_m, const glm::dvec3& normal,
                               double u) const;

  // What it goes by, for devices: [luminaire], and the lobes that they name.
  std::span<const Source> sources() const { return sources_; }
  std::span<const Lobe> lobes() const { return lobes_; }

 private:
  static Lobe lobe_of(const PhotometricWeb& web, bool is_extended);

  std::vector<Source> sources_;
  std::vector<Lobe> lobes_;
  std::size_t channels_;
};

}  // namespace calc
