#pragma once
// The surface that people walk on: floors, treads of stairs, landings, ramps.

#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace calc {

// The search range for a walking surface, from the height of a route's line.
inline constexpr double kWalkingSearchDown_m = 0.5;
inline constexpr double kWalkingStepUp_m = 0.3;    // what is higher is not walked on
inline constexpr double kWalkingSearchUp_m = 1.0;  // up to here it stands in the way

// Returns the height at which a vertical line meets a triangle, edges included; empty: nowhere, or
// along the whole of an upright one.
std::optional<double> height_at(const std::array<glm::dvec3, 3>& corner_m, const glm::dvec2& at_m);

class WalkingSurface {
 public:
  // Holds all bodies of the space that a place within these bounds (world coordinates) may meet;
  // the space must outlive it.
  WalkingSurface(const Space& space, const glm::dvec3& lowest_m, const glm::dvec3& highest_m);

  struct Found {
    std::optional<double> z_m;              // of the surface; empty: none
    const std::string* obstacle = nullptr;  // instead: id of the body that stands there
  };
  // Returns the highest surface between kWalkingSearchDown_m below and kWalkingSearchUp_m above
  // `at_m`: an obstacle if it is more than kWalkingStepUp_m above it. In the open space the ground
  // z = 0 is a surface, too, where there is none below.
  Found below(const glm::dvec3& at_m) const;

 private:
  struct Piece {
    std::array<glm::dvec3, 3> corner_m;
    glm::dvec2 low_m, high_m;
    const Body* body;
  };

  std::vector<Piece> pieces_;
  bool has_ground_;
};

}  // namespace calc
