#pragma once
// Scenes and planes for tests of proofs and forecast.

#include "calc/proofs/point_set.h"
#include "tests/support/scenes.h"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace proof_scenes {

// n x n points over the square from `corner` with the sides u, v (world), normals all the same.
inline calc::SensorGrid square_grid(const glm::dvec3& corner, const glm::dvec3& u,
                                    const glm::dvec3& v, const glm::dvec3& normal, int n = 5) {
  calc::SensorGrid grid;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      grid.position_m.push_back(corner + (i + 0.5) / n * u + (k + 0.5) / n * v);
      grid.normal.push_back(normal);
      grid.column.push_back(k);
      grid.row.push_back(i);
    }
  }
  return grid;
}

// Upward, at a height.
inline calc::SensorGrid work_plane(double low, double high, double height_m, int n = 5) {
  const double side = high - low;
  return square_grid({low, low, height_m}, {side, 0, 0}, {0, side, 0}, {0, 0, 1}, n);
}

// A grid's points as a set, with what they refer to.
struct Points {
  Points(const calc::PreparedScene& scene, const calc::SensorGrid& grid,
         calc::ReceiverKernel kernel = calc::ReceiverKernel::planar)
      : position_m(calc::local_positions_m(scene, grid)),
        set{position_m, grid.normal, kernel},
        bounds(calc::bounds_of(set)) {}
  std::vector<glm::dvec3> position_m;
  calc::PointSet set;
  calc::PointBounds bounds;
};

// 1000 cd up to `degrees` from the axis and dark from `dark_degrees` on; a ramp between.
inline calc::PhotometricWeb spot_web(double degrees, double dark_degrees,
                                     calc::LuminousOpening opening = {}) {
  const double step = calc::kPi / 180.0;
  return calc::PhotometricWeb::make({0.0}, {0.0, degrees * step, dark_degrees * step, calc::kPi},
                                    {1000.0, 1000.0, 0.0, 0.0}, opening, {});
}

// Columns of world_from_luminaire for an axis: gamma = 0 goes along it.
inline glm::dmat3 aimed(const glm::dvec3& axis) {
  const glm::dvec3 z = -glm::normalize(axis);
  const glm::dvec3 aside = std::abs(z.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 y = glm::normalize(glm::cross(z, aside));
  return {glm::cross(y, z), y, z};
}

inline void add_aimed(calc::PreparedScene& scene, const calc::PhotometricWeb& web,
                      const glm::dvec3& position_m, const glm::dvec3& axis) {
  test_support::add_luminaire(scene, web, position_m);
  scene.luminaires.back().world_from_luminaire = aimed(axis);
}

inline glm::dvec3 random_unit(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

}  // namespace proof_scenes
