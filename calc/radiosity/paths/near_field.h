#pragma once
// Splits the geometry term near surfaces: bounded for light vertices, the rest by short rays.
// Together they are the whole term, without clamping.  [KK04, with a bound that follows the density
// of light vertices: METHOD, 4.3]

#include "calc/radiosity/direct/emission.h"
#include "calc/radiosity/paths/light_vertex.h"
#include "calc/radiosity/paths/luminaire_choice.h"
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/radiosity/sampling/short_rays.h"
#include "calc/radiosity/terms/path_terms.h"
#include "calc/scene/surface_summary.h"

#include <glm/glm.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace calc {

class Cut;
class VertexTree;
class VertexBounds;

// Bounds the geometry term: b(y) = max(b_min, kappa N (E_dir(y) + E_amb) / Phi). N E / Phi is the
// number of light vertices per m^2, hence 1 / b is the area that 1 / kappa of them share. Closer
// than its own spacing the pool cannot resolve 1/d^2, so there, and only there, short rays replace
// it. Any function of y only keeps the sum unbiased as long as both sides use the same.
class GeometryBound {
 public:
  // paths: light paths of the batch whose vertices are bounded.
  GeometryBound(const Tracer& tracer, const Emitter& emitter, std::uint64_t paths);

  // Returns the bound, 1/m^2, at a surface point with unit normal (the side in question).
  double at(const glm::dvec3& position_m, const glm::dvec3& normal) const {
    return at_lifted(tracer_.lift(position_m, normal), normal);
  }
  // Returns the same for a position already lifted off its surface.
  double at_lifted(const glm::dvec3& position_m, const glm::dvec3& normal) const;
  // Returns the smallest possible bound.
  double smallest() const { return smallest_; }
  // Terms of at_lifted() besides the scene, for devices.
  struct Terms {
    double smallest_per_m2 = 1.0;
    double vertices_per_lumen = 0.0;  // kappa N / Phi
    double ambient_per_m2 = 0.0;      // kappa N E_amb / Phi
    // Light of all luminaires together that lifts the bound above the smallest one.
    double needed_lx = 0.0;
    // Light of a luminaire below which it is omitted: it could not lift the bound by its share.
    double least_lx = 0.0;
  };
  Terms terms() const;
  // Returns the distance beyond which no geometry term exceeds any bound.
  double reach_m() const { return reach_m_; }

 private:
  const Tracer& tracer_;
  double smallest_ = 1.0;  // 1/m^2
  double reach_m_ = 1.0;
  double vertices_per_lumen_ = 0.0;  // kappa N / Phi
  double ambient_per_m2_ = 0.0;      // kappa N E_amb / Phi
};

// Returns cos_x cos_y / d^2 of x with normal nx, y with ny; 0 if either faces away or d = 0.
inline double geometry_term(const glm::dvec3& x, const glm::dvec3& nx, const glm::dvec3& y,
                            const glm::dvec3& ny) {
  return connection_geometry(ReceiverKernel::planar, nx, ny, y - x);
}

// The common data of short rays of one replicate and round.
struct NearField {
  const Tracer& tracer;
  const GeometryBound& bound;
  const LuminaireChoice& luminaires;
  const VertexTree& tree;
  const VertexBounds& vertex_bounds;
  const Cut& cut;  // of the whole pool; continues the rays
  std::size_t channels;
  double deadline_s = 0.0;  // see is_past(): what is left undone then is to be thrown away
  // Set where a chain of rays does not end within kMostReflections; may be null. The sums are then
  // useless.
  std::atomic<bool>* has_endless_chain = nullptr;
};

// Returns the reach of short rays of the first round: a third of the mean free path.
double near_reach_m(const SurfaceSummary& surfaces);

// Adds to sums[channel * stride] the mean over the rays of
//   max(0, 1 - b(y) / G) rho(y) (E_dir(y) + E_far(y) + E_near(y)),   y = first hit of a ray within
//   reach, drawn with density cos / pi (evenly on the sphere for receivers without a back),
// where E_dir(y) uses one luminaire (LuminaireChoice), E_far(y) a few vertices drawn from the pool
// and E_near(y) one more ray, ended by roulette on its weight. largest: raised to the largest
// single ray's contribution. Returns the rays traced. found: the light and the rest that a
// ShortRayCaster found for the request; empty: the rays are traced here.
std::uint64_t add_near_field(const NearField& field, const NearFieldRequest& request,
                             const std::optional<PointLight>& found, double* sums,
                             std::size_t stride, float& largest);

}  // namespace calc
