// A closed box of equal reflectance against classical radiosity on a fine mesh, solved here: form
// factors by Lambert's contour formula, no ray and no random number in common with the program.
#include "calc/statistics.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using namespace test_support;

struct Patch {
  std::array<glm::dvec3, 4> corner;
  glm::dvec3 centre, normal;
  glm::dvec3 half_u, half_v;
  double area;
};

// Form factor from a differential element at x with normal n to a convex polygon, clipped at the
// element's horizon.  [Lambert 1760]
double form_factor(const glm::dvec3& x, const glm::dvec3& n, const Patch& patch) {
  std::array<glm::dvec3, 8> v;
  std::size_t count = 0;
  double highest = 0.0;
  for (const glm::dvec3& corner : patch.corner)
    highest = std::max(highest, glm::dot(corner - x, n));
  if (highest < 1e-12) return 0.0;  // in the element's own plane or behind it
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec3 a = patch.corner[k] - x;
    const glm::dvec3 b = patch.corner[(k + 1) % 4] - x;
    const double ha = glm::dot(a, n), hb = glm::dot(b, n);
    if (ha >= 0.0) v[count++] = a;
    if ((ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0))
      v[count++] = a + (b - a) * (ha / (ha - hb));
  }
  if (count < 3) return 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec3 a = glm::normalize(v[k]);
    const glm::dvec3 b = glm::normalize(v[(k + 1) % count]);
    const glm::dvec3 c = glm::cross(a, b);
    const double s = glm::length(c);
    if (s < 1e-14) continue;
    sum += std::atan2(s, glm::dot(a, b)) / s * glm::dot(c, n);
  }
  return std::abs(sum) / (2.0 * calc::kPi);
}

// Lines of the mesh, denser towards the edges of a face, where radiosity bends most.
double graded(int k, int n) { return 0.5 * (1.0 - std::cos(calc::kPi * k / n)); }

std::vector<Patch> mesh_box(const glm::dvec3& size, int n) {
  std::vector<Patch> patches;
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (const int side : {0, 1}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          Patch patch{};
          glm::dvec3 p(0.0), u(0.0), v(0.0);
          p[axis] = side * size[axis];
          p[a] = graded(i, n) * size[a];
          p[b] = graded(j, n) * size[b];
          u[a] = (graded(i + 1, n) - graded(i, n)) * size[a];
          v[b] = (graded(j + 1, n) - graded(j, n)) * size[b];
          patch.corner = {p, p + u, p + u + v, p + v};
          patch.half_u = 0.5 * u;
          patch.half_v = 0.5 * v;
          patch.centre = p + patch.half_u + patch.half_v;
          patch.normal[axis] = side == 0 ? 1.0 : -1.0;
          patch.area = u[a] * v[b];
          patches.push_back(patch);
        }
      }
    }
  }
  return patches;
}

double direct_lx(double intensity_cd, const glm::dvec3& source, const glm::dvec3& x,
                 const glm::dvec3& n) {
  const glm::dvec3 w = source - x;
  const double d = glm::length(w);
  return std::max(0.0, intensity_cd * glm::dot(n, w) / (d * d * d));
}

// Mean over the midpoints of n x n parts of a patch.
template <class Function>
double patch_mean(const Patch& patch, int n, Function&& value) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      sum += value(patch.centre + ((2 * i + 1.0) / n - 1.0) * patch.half_u +
                   ((2 * j + 1.0) / n - 1.0) * patch.half_v);
    }
  }
  return sum / (n * n);
}

// The mesh with its exitance in lm/m2, solved by Jacobi iteration of B = rho (E_direct + F B).
struct Radiosity {
  double rho, intensity_cd;
  glm::dvec3 source;
  std::vector<Patch> patches;
  std::vector<double> exitance;

  Radiosity(const glm::dvec3& size, double rho_, double intensity_cd_, const glm::dvec3& source_,
            int n)
      : rho(rho_), intensity_cd(intensity_cd_), source(source_), patches(mesh_box(size, n)) {
    const std::size_t count = patches.size();
    std::vector<double> factor(count * count), direct(count), next(count);
    for (std::size_t i = 0; i < count; ++i) {
      direct[i] = patch_mean(patches[i], 16, [&](const glm::dvec3& x) {
        return direct_lx(intensity_cd, source, x, patches[i].normal);
      });
      for (std::size_t j = 0; j < count; ++j) {
        if (patches[i].normal == patches[j].normal) continue;  // same face
        factor[i * count + j] = patch_mean(patches[i], 2, [&](const glm::dvec3& x) {
          return form_factor(x, patches[i].normal, patches[j]);
        });
      }
    }
    exitance.assign(count, 0.0);
    for (int iteration = 0; iteration < 60; ++iteration) {  // 0.6^60 = 5e-14
      for (std::size_t i = 0; i < count; ++i) {
        double sum = direct[i];
        for (std::size_t j = 0; j < count; ++j) sum += factor[i * count + j] * exitance[j];
        next[i] = rho * sum;
      }
      exitance.swap(next);
    }
  }

  // Exitance at one surface point, from the patches' constant values: far smoother than those.
  double exitance_at(const glm::dvec3& y, const glm::dvec3& normal) const {
    double sum = direct_lx(intensity_cd, source, y, normal);
    for (std::size_t j = 0; j < patches.size(); ++j) {
      sum += exitance[j] * form_factor(y, normal, patches[j]);
    }
    return rho * sum;
  }

  // Illuminance from one patch, split until each part is small beside its distance.
  double part_lx(const Patch& part, const glm::dvec3& x, const glm::dvec3& n) const {
    const double factor = form_factor(x, n, part);
    if (factor == 0.0) return 0.0;
    const double size = 2.0 * std::max(glm::length(part.half_u), glm::length(part.half_v));
    if (size <= 0.7 * glm::length(part.centre - x) || size < 1e-3) {
      return factor * exitance_at(part.centre, part.normal);
    }
    double sum = 0.0;
    for (const double s : {-0.5, 0.5}) {
      for (const double t : {-0.5, 0.5}) {
        Patch quarter = part;
        quarter.half_u *= 0.5;
        quarter.half_v *= 0.5;
        quarter.centre += s * part.half_u + t * part.half_v;
        quarter.corner = {quarter.centre - quarter.half_u - quarter.half_v,
                          quarter.centre + quarter.half_u - quarter.half_v,
                          quarter.centre + quarter.half_u + quarter.half_v,
                          quarter.centre - quarter.half_u + quarter.half_v};
        sum += part_lx(quarter, x, n);
      }
    }
    return sum;
  }

  double indirect_lx(const glm::dvec3& x, const glm::dvec3& n) const {
    double sum = 0.0;
    for (const Patch& patch : patches) sum += part_lx(patch, x, n);
    return sum;
  }
};

TEST(BoxRadiosity, PointsOfARoomAgreeWithTheMatrixSolution) {
  const glm::dvec3 size(4.0, 3.0, 2.5);
  const glm::dvec3 source(1.4, 1.1, 1.9);
  const double rho = 0.6, intensity = 100.0;
  calc::SensorGrid grid;
  grid.position_m = {{2, 1.5, 0.75}, {0.005, 1.5, 0.75}, {0.005, 0.005, 0.005}, {3.9, 2.9, 2.0},
                     {2, 1.5, 0.0},  {0.2, 2.995, 1.2},  {0.3, 1.0, 1.25}};
  grid.normal = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 0, -1}};

  // Two meshes: their difference bounds the finer one's error.
  const Radiosity coarse(size, rho, intensity, source, 7);
  const Radiosity fine(size, rho, intensity, source, 14);

  const calc::PhotometricWeb web = isotropic_web(intensity);
  calc::PreparedScene scene;
  add_box(scene, {0, 0, 0}, size, rho);
  add_luminaire(scene, web, source);
  set_extent(scene);
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 21, 8192);
  const calc::PlaneField& field = solution.fields[0];
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    SCOPED_TRACE(i);
    const double truth = fine.indirect_lx(grid.position_m[i], grid.normal[i]);
    const double mesh_error =
        std::abs(truth - coarse.indirect_lx(grid.position_m[i], grid.normal[i]));
    std::vector<double> indirect;
    for (std::size_t r = 0; r < field.replicates; ++r) {
      indirect.push_back(total_lx(field, r, i) - field.direct_exact_lx[i]);
    }
    const calc::Estimate measured = calc::t_interval(indirect, 0.999);
    std::printf("point %zu: matrix %.4f +- %.2f %%, luxgate %.4f +- %.2f %%, ratio %.4f\n", i,
                truth, 100 * mesh_error / truth, measured.value,
                100 * measured.half_width() / measured.value, measured.value / truth);
    EXPECT_LE(measured.low, truth + mesh_error);
    EXPECT_GE(measured.high, truth - mesh_error);
    EXPECT_NEAR(measured.value / truth, 1.0, 0.02);
    EXPECT_LT(mesh_error / truth, 0.02);  // the test must be able to see errors
    EXPECT_NEAR(field.direct_exact_lx[i],
                direct_lx(intensity, source, grid.position_m[i], grid.normal[i]),
                1e-5 * field.direct_exact_lx[i]);
  }
}

}  // namespace
