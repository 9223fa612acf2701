#pragma once
// The batch seam between the calculation and whatever sums light vertices: CPU here, OpenGL in
// gpu/.

#include "calc/radiosity/light_vertex.h"
#include "calc/radiosity/rays.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace calc {

// Points that receive light, local coordinates.
struct Receivers {
  std::span<const glm::dvec3> position_m;
  std::span<const glm::dvec3> normal;  // unit

  std::size_t size() const { return position_m.size(); }
};

class Gatherer {
 public:
  virtual ~Gatherer() = default;

  // Adds to sum_lx[channel * receivers + i], in units of lx, the illuminance at receiver i from
  // every light vertex,
  //   sum over vertices v of flux_v / pi * min(G(x_i, v), bound_v) * V(x_i, v),   G = cos_x cos_v /
  //   d^2,
  // always summed in the same order, so that the result is the same in bits for any number of
  // threads. Returns the number of shadow rays traced.
  virtual std::uint64_t gather(const Tracer& tracer, const Receivers& receivers,
                               const LightVertices& vertices, std::span<double> sum_lx) = 0;

  // For reports: "cpu (Embree 3.13.5)".
  virtual std::string description() const = 0;
};

// Embree ray packets on all threads of the current TBB arena.
std::unique_ptr<Gatherer> make_cpu_gatherer();

}  // namespace calc
