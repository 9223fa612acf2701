#pragma once
// Scenes made in code and their results: calculated as for a project file, from calc::Project on.

#include "calc/base/field.h"
#include "calc/photometry/web.h"
#include "calc/scene/project.h"
#include "calc/scene/receiver_kernel.h"
#include "calc/scene/sensor_grid.h"
#include "report/tools/selftest/box_radiosity.h"
#include "report/tools/selftest/quadrature.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace cli::selftest {

inline const glm::dvec3 kUp{0, 0, 1}, kDown{0, 0, -1};

// Returns a web with the same intensity everywhere.
calc::PhotometricWeb isotropic_web(double cd, calc::LuminousOpening opening = {});
// Returns a web of axis_cd cos gamma below, tabulated every 0.1 degrees: within 4e-7 of the cosine.
calc::PhotometricWeb lambert_web(double axis_cd, calc::LuminousOpening opening = {});

struct Point {
  glm::dvec3 position_m, normal;
};

class Scene {
 public:
  Scene();

  void add_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double rho);
  void add_quad(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, double rho);
  // Adds a box with faces in the order x0, x1, y0, y1, z0, z1.
  void add_box(const glm::dvec3& low, const glm::dvec3& size, const FaceReflectances& rho);
  void add_box(const glm::dvec3& low, const glm::dvec3& size, double rho);
  // Adds a luminaire: axis straight down and C0 along x, unless `world_from_luminaire` differs.
  void add_luminaire(const calc::PhotometricWeb& web, const glm::dvec3& position_m,
                     const glm::dmat3& world_from_luminaire = glm::dmat3(1.0));
  // Adds the previous lamp again, in another place.
  void repeat_luminaire(const glm::dvec3& position_m);
  // Adds an evenly emitting diffuse rectangle: its exitance in lm/m2 on the side of its normal.
  void add_luminous(const Rectangle& rectangle, double exitance_lm_m2);

  // Moves everything so far.
  void move(const glm::dvec3& by);

  const calc::Project& project() const { return project_; }
  double surface_m2() const;

 private:
  calc::Body& body() { return project_.spaces[0].bodies[0]; }
  std::uint32_t material(double rho);

  calc::Project project_;
};

struct Effort {
  std::uint64_t paths = 1024;  // of each of the replicates, a power of two
  std::uint64_t seed = 1;
  int jobs = 0;
};

constexpr int kReplicates = 16;

enum class Part { total, indirect, direct };

// The program's results for points of a scene.
struct Solution {
  std::string problem;  // "" = none
  calc::PlaneField field;
  calc::FluxBalance balance;
  std::uint64_t rays = 0;

  // Returns the replicates of a point; one value if nothing was sampled.
  std::vector<double> replicates(std::size_t point, Part part = Part::total) const;
  // Returns the replicates of the weighted sum over points.
  std::vector<double> replicates(const std::vector<double>& weights, Part part = Part::total) const;
};
Solution solve(const calc::Project& project, const calc::Space& space, const calc::SensorGrid& grid,
               const Effort& effort);
Solution solve(const Scene& scene, const std::vector<Point>& points, const Effort& effort,
               calc::ReceiverKernel kernel = calc::ReceiverKernel::planar);

}  // namespace cli::selftest
