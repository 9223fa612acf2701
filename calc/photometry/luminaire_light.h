#pragma once
// The light of a whole luminaire: of a single emitter, or of several that shine together.

#include "calc/photometry/web.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace calc {

// A place in the luminaire: the emitter's own axes are x = C0, y = C90, -z = gamma 0.
struct EmitterPlace {
  glm::dvec3 position_m{0.0};  // centre of its luminous opening
  glm::dmat3 turn{1.0};        // luminaire from emitter, orthonormal
};

struct EmitterLight {
  PhotometricWeb web;
  std::string id;  // as it is chosen; "" = the only one of a file
  EmitterPlace place;
};

// At least one emitter. A single emitter is in the middle, not turned. The middle of several is
// that of the box around their centres, and the axes are those of the luminaire's model.
struct LuminaireLight {
  std::vector<EmitterLight> emitters;

  double flux_lm() const;  // of all
  double power_w() const;  // of all; 0 = one of them does not state it
};

}  // namespace calc
