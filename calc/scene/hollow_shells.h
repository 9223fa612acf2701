#pragma once
// Finds places inside objects that are not closed: exported without their bottom, or with gaps.

#include "calc/scene/project.h"
#include "calc/scene/solids.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>
#include <vector>

namespace calc {

// unclear: all but one or two of the tested directions are closed.
enum class HollowSide { outside, unclear, inside };

struct HollowPlace {
  HollowSide side = HollowSide::outside;
  const Body* shell = nullptr;  // that it is in, one of Space::open_shells; null outside
};

// The winding of triangles does not matter. A shell around a luminaire counts as a room, not an
// object; places in it are outside.
class HollowShells {
 public:
  // Returns whether there is air at a place.
  using IsAir = std::function<bool(const glm::dvec3&)>;

  // Serves points within the region. The space must outlive it.
  HollowShells(const Space& space, const BoundingBox& region);

  // Looks from the point along seven lines both ways: a direction is closed if it meets the shell,
  // or leaves the shell's box where there is no air just behind it, as below a thing on the floor.
  // A large shell is sorted at the first point in its box, and costs little after it.
  HollowPlace around(const glm::dvec3& point, const IsAir& is_air) const;

 private:
  class LineView;
  class Shell;

  std::vector<std::shared_ptr<const Shell>> shells_;
};

}  // namespace calc
