#pragma once
// Computes illuminance on the surfaces of a room, for pictures: at the corners of a mesh, linear
// between them.

#include "calc/base/message.h"
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/looks/cutaway.h"
#include "calc/scene/prepared_scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace calc {

struct SurfaceLightSettings {
  std::size_t points = 1500;  // about so many at first, and as many again where light changes
  std::size_t most_points = 60'000;  // a mesh of more corners is refused
  int replicates = 4;
  std::uint64_t paths = 2048;  // per replicate, a power of two: fewer are hardly quicker
  std::uint64_t seed = 1;
  int jobs = 0;                 // never changes a result
  std::function<bool()> go_on;  // may be empty; false stops with a problem
};

// Maintained illuminance, every luminaire at full output.
struct LitSurfaces {
  Message problem;                    // why there is nothing; "" = there is
  std::vector<glm::vec3> position_m;  // local
  std::vector<float> lx;              // [position]
  std::vector<glm::uvec3> triangle;   // counter-clockwise as seen from the lit side
  std::vector<std::uint32_t> side;    // of each triangle, index into the sides given
  // Relative standard error of the sampling before smoothing, root mean square over the positions
  // whose indirect light was sampled.
  double error_share = 0.0;
};

// Uses the same estimators as for planes (solve_illuminance()), at points on the given sides. Edges
// are split until they are short beside the room, then twice again where illuminance changes most
// along them; edges of shadows are as sharp as the shortest edges. Indirect light, the noisier and
// smoother part, is sampled at the corners before these last splits and averaged with adjacent
// corners. The result depends on the arguments only.
LitSurfaces light_surfaces(const PreparedScene& scene, std::span<const SurfaceSide> sides,
                           const SurfaceLightSettings& settings, Gatherer& gatherer);

}  // namespace calc
