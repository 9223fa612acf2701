#pragma once
// Whether a luminaire's luminous body has room where it was placed.

#include "calc/photometry/web.h"
#include "calc/scene/box_shelf.h"
#include "calc/scene/project.h"
#include "calc/scene/solids.h"

#include <optional>
#include <vector>

namespace calc {

// The flat opening of the same outline as seen from below.
LuminousOpening flattened(const LuminousOpening& opening);

class OpeningFit {
 public:
  // space must outlive this object.
  explicit OpeningFit(const Space& space) : space_(space) {}
  OpeningFit(const OpeningFit&) = delete;
  OpeningFit& operator=(const OpeningFit&) = delete;

  // Whether a surface cuts through the body's bounding box, as the ceiling does through that of a
  // luminaire placed at its height: light from the part beyond would be lost. Surfaces that touch
  // it within 1e-6 m do not, nor does its own housing. Flat openings are never cut.
  bool is_cut(const LuminousOpening& opening, const Luminaire& luminaire);
  // What the calculation uses for this luminaire: the opening, flattened if a surface cuts it.
  LuminousOpening fitted(const LuminousOpening& opening, const Luminaire& luminaire);

 private:
  const Space& space_;
  std::vector<BoundingBox> body_box_;
  std::optional<BoxShelf> bodies_;  // made when first needed
};

}  // namespace calc
