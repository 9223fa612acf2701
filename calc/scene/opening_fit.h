#pragma once
// Tests whether a luminaire's luminous body fits at its place.

#include "calc/photometry/web.h"
#include "calc/scene/box_shelf.h"
#include "calc/scene/project.h"
#include "calc/scene/solids.h"

#include <optional>
#include <vector>

namespace calc {

// Returns the flat opening with the same outline seen from below.
LuminousOpening flattened(const LuminousOpening& opening);

class OpeningFit {
 public:
  // space must outlive this object.
  explicit OpeningFit(const Space& space) : space_(space) {}
  OpeningFit(const OpeningFit&) = delete;
  OpeningFit& operator=(const OpeningFit&) = delete;

  // Returns whether a surface cuts through the body's bounding box, as a ceiling cuts a luminaire
  // placed at its height: light from the part beyond would be lost. Surfaces that touch it within
  // 1e-6 m and its own housing do not count. Flat openings are never cut.
  bool is_cut(const LuminousOpening& opening, const Luminaire& luminaire);
  // Returns the opening for the calculation, flattened if a surface cuts it.
  LuminousOpening fitted(const LuminousOpening& opening, const Luminaire& luminaire);

 private:
  const Space& space_;
  std::vector<BoundingBox> body_box_;
  std::optional<BoxShelf> bodies_;  // made when first needed
};

}  // namespace calc
