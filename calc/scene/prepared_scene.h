#pragma once
// A space ready for rays: triangles in one list, shifted to a local origin, luminaires resolved.

#include "calc/base/diagnostics.h"
#include "calc/base/field.h"
#include "calc/scene/project.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace calc {

// Returns the distance by which ray ends are lifted off a surface along its normal, in a scene of
// this extent: covers float rounding of local coordinates (32 ulp of the largest one) and 1e-6 of
// the extent. [METHOD, 8.1]
double ray_offset_m(double extent_m);

// Returns the distance up to which a point counts as in a surface: 4 ulp of the largest coordinate,
// the error of rounding corners to float.
inline double touching_m(double ray_offset_m) { return ray_offset_m / 8.0; }

// The sizes that determine the ends of rays in a space. Near is everything within four diagonals of
// its shell, or, without a shell, of its luminaires and planes: things beyond must not move the
// begin of rays farther off the surfaces that matter.
struct SceneScale {
  glm::dvec3 origin_m{0.0};     // world; the middle of what is near
  double extent_m = 1.0;        // length of the diagonal of what is near; 1 if there is nothing
  double whole_extent_m = 1.0;  // of everything
  // How far rounding to float moves near surfaces along their normals, where this exceeds the
  // rounding of near coordinates: for triangles with other corners far away.
  double rounding_m = 0.0;

  double ray_offset_m() const;
};
SceneScale scale_of(const Space& space);

// The points for which a luminaire counts: nearer than this along a horizontal axis and across it.
// For roads, where a standard limits the light; light itself has no such limit.
struct LightReach {
  glm::dvec2 along{1.0, 0.0};  // unit
  double distance_m = 0.0;

  bool holds(const glm::dvec3& source_m, const glm::dvec3& point_m) const;
};

struct PlacedLuminaire {
  glm::dvec3 position_m{0.0};  // local
  glm::dmat3 world_from_luminaire{1.0};
  const PhotometricWeb* web = nullptr;  // owned by the Project, which must outlive the scene
  double flux_scale = 1.0;              // multiplies the web's intensity
  LuminousOpening opening;
  std::uint32_t channel = 0;          // index into PreparedScene::channels
  std::optional<LightReach> reach{};  // of points alone; empty: everywhere
};

// A space in local coordinates: world minus origin_m, subtracted in double before anything is
// rounded to float.
struct PreparedScene {
  glm::dvec3 origin_m{0.0};
  std::vector<glm::vec3> vertex_m;
  std::vector<glm::uvec3> triangle;  // no zero-area triangles
  std::vector<double> reflectance;   // per triangle, [0, 1]
  std::vector<std::uint32_t> body;   // per triangle, index into Space::bodies
  std::vector<std::string> body_id;  // of Space::bodies, for messages
  std::vector<PlacedLuminaire> luminaires;
  std::vector<LightChannel>
      channels;               // distinct (group, maintenance factor) pairs, in order of first use
  double extent_m = 1.0;      // as SceneScale says; > 0
  double far_extent_m = 0.0;  // of everything, if it is more than is near; else 0
  double rounding_m = 0.0;    // as SceneScale says
  std::size_t degenerate_triangles = 0;  // left out

  double whole_extent_m() const { return std::max(extent_m, far_extent_m); }
  // Returns the offset for places near; see lift_at() for others.
  double ray_offset_m() const { return SceneScale{{}, extent_m, 0.0, rounding_m}.ray_offset_m(); }
};

// Returns the factor for the intensities of a luminaire's web, with the tilt of its lamp.
double installed_flux_scale(const Project& project, const Luminaire& luminaire);

PreparedScene prepare_scene(const Project& project, const Space& space);

}  // namespace calc
