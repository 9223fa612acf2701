#pragma once
// Predicates on what a scene provably does not need. Each returns true only if omitting it changes
// nothing beyond a ray's own blur, PreparedScene::ray_offset_m(); false means "not proved", never
// "disproved". None traces a ray. [METHOD, 8.3]

#include "calc/proofs/beam.h"
#include "calc/proofs/point_set.h"
#include "calc/scene/prepared_scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace calc {

// Returns whether there is no indirect light anywhere. Proof: indirect light is light that left a
// surface, and every surface's exitance is its reflectance, 0, times its irradiance. O(triangles).
bool no_reflection(const PreparedScene& scene);

struct ReflectionView {
  std::vector<std::uint8_t> sees_reflection;  // [point]: 0 = proved that indirect light is 0 there
};

// Finds points in front of whose tangent plane no reflecting surface reaches. Proof: a planar
// receiver weighs light by max(0, cos), and the cosine towards any point of a triangle is at most 0
// if it is at all three corners (it is linear along the triangle, times 1 / distance). Corners up
// to ray_offset_m() in front count as behind: a ray starts that much in front of its point, and
// they are behind its start. Kernels that have no back see every reflecting surface. O(triangles +
// points) for few different normals; for more, the surfaces' bounding box replaces them once
// kMostCornerTests are used up.
ReflectionView find_reflection_view(const PreparedScene& scene, const PointSet& points);
inline constexpr std::size_t kMostCornerTests = 20'000'000;

// Returns [luminaire]: 1 = no light path from it ever leaves a reflecting surface. Proof: its beam
// misses every reflecting triangle (beam_misses(), whatever is between), so that each of its paths
// first meets a black surface, and ends there, or nothing. After kMostBeamTests tests of a triangle
// or a body's box the remaining luminaires are not proved. beams: beams_of(scene), also below.
std::vector<std::uint8_t> find_unlit_surfaces(const PreparedScene& scene,
                                              const std::vector<Beam>& beams);
inline constexpr std::size_t kMostBeamTests = 1'000'000;

// Returns [luminaire]: 1 = its direct light is 0 at every point. Proof: either its beam misses a
// box that holds all points; or, for every normal that occurs, the whole opening is behind the
// lowest of the tangent planes, so that the cosine is negative at every point. The margin, 1e-7 of
// the largest length, is far above the rounding of doubles.  O(points + luminaires).
std::vector<std::uint8_t> find_dark_luminaires(const PreparedScene& scene,
                                               const std::vector<Beam>& beams,
                                               const PointBounds& bounds);

}  // namespace calc
