#include "report/tools/selftest/box_radiosity.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace cli::selftest {
namespace {

// Lines of the mesh, denser towards the edges of a face, where radiosity bends most.
double graded(int k, int n) { return 0.5 * (1.0 - calc::cos(calc::kPi * k / n)); }

// Mean over the midpoints of n x n parts of a patch.
template <class Patch, class Function>
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

constexpr int kCoarse = 6, kFine = 9;

}  // namespace

DirectLight isotropic_light(double intensity_cd, const glm::dvec3& source) {
  return [=](const glm::dvec3& x, const glm::dvec3& n) {
    const glm::dvec3 w = source - x;
    const double d = glm::length(w);
    return std::max(0.0, intensity_cd * glm::dot(n, w) / (d * d * d));
  };
}

DirectLight downlight(double axis_cd, const glm::dvec3& source) {
  return [=](const glm::dvec3& x, const glm::dvec3& n) {
    const glm::dvec3 w = source - x;
    const double d = glm::length(w);
    return std::max(0.0, axis_cd * w.z / d) * std::max(0.0, glm::dot(n, w)) / (d * d * d);
  };
}

BoxRadiosity::BoxRadiosity(const glm::dvec3& size, const FaceReflectances& rho, DirectLight direct,
                           int n)
    : n_(n), direct_(std::move(direct)) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < n; ++k) {
      centres_[static_cast<std::size_t>(axis)].push_back(0.5 * (graded(k, n) + graded(k + 1, n)) *
                                                         size[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      add_face(size, axis, side, rho[static_cast<std::size_t>(2 * axis + side)], n);
    }
  }
  solve();
  refine();
}

void BoxRadiosity::add_face(const glm::dvec3& size, int axis, int side, double rho, int n) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
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
      patch.rho = rho;
      patch.face = static_cast<std::size_t>(2 * axis + side);
      patches_.push_back(patch);
    }
  }
}

// polygon_factor() without a vector: it is called a million times.
double BoxRadiosity::factor(const glm::dvec3& x, const glm::dvec3& n, const Patch& patch) {
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
    sum += calc::atan2(s, glm::dot(a, b)) / s * glm::dot(c, n);
  }
  return std::abs(sum) / (2.0 * calc::kPi);
}

// The means over few points are not quite those over patches. Made symmetric (A_i F_ij = A_j F_ji)
// and scaled so that every row adds up to one, they conserve flux exactly.
std::vector<double> BoxRadiosity::factors() const {
  const std::size_t count = patches_.size();
  std::vector<double> exchange(count * count), scale(count, 1.0);  // m2
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      if (patches_[i].normal == patches_[j].normal) continue;  // same face
      const double share = patch_mean(patches_[i], 2, [&](const glm::dvec3& x) {
        return factor(x, patches_[i].normal, patches_[j]);
      });
      exchange[i * count + j] += 0.5 * share * patches_[i].area_m2();
      exchange[j * count + i] += 0.5 * share * patches_[i].area_m2();
    }
  }
  for (int round = 0; round < 40; ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < count; ++j) sum += exchange[i * count + j] * scale[j];
      scale[i] = std::sqrt(scale[i] * patches_[i].area_m2() / sum);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      exchange[i * count + j] *= scale[i] * scale[j] / patches_[i].area_m2();
    }
  }
  return exchange;
}

void BoxRadiosity::solve() {
  const std::size_t count = patches_.size();
  const std::vector<double> share = factors();
  std::vector<double> direct(count), next(count);
  for (std::size_t i = 0; i < count; ++i) {
    direct[i] = patch_mean(patches_[i], 16,
                           [&](const glm::dvec3& x) { return direct_(x, patches_[i].normal); });
  }
  std::vector<double> exitance(count, 0.0);
  indirect_lx_.assign(count, 0.0);
  double change = 1.0;
  for (int iteration = 0; iteration < 2000 && change > 1e-12; ++iteration) {
    change = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < count; ++j) sum += share[i * count + j] * exitance[j];
      indirect_lx_[i] = sum;
      next[i] = patches_[i].rho * (direct[i] + sum);
      change = std::max(change, std::abs(next[i] - exitance[i]) / std::max(next[i], 1e-300));
    }
    exitance.swap(next);
  }
}

// Indirect illuminance of a face at y: by parabolas through the centres of three patches each way.
double BoxRadiosity::indirect_at(const glm::dvec3& y, std::size_t face) const {
  const auto axis = static_cast<glm::length_t>(face / 2);
  const auto n = static_cast<std::size_t>(n_);
  std::array<std::array<double, 3>, 2> weight{};
  std::array<std::size_t, 2> first{};
  for (std::size_t k = 0; k < 2; ++k) {
    const glm::length_t along = (axis + 1 + static_cast<glm::length_t>(k)) % 3;
    const std::vector<double>& at = centres_[static_cast<std::size_t>(along)];
    std::size_t c = 0;
    while (c + 3 < n && y[along] > 0.5 * (at[c + 1] + at[c + 2])) ++c;
    first[k] = c;
    const double x = y[along], a = at[c], b = at[c + 1], d = at[c + 2];
    weight[k] = {(x - b) * (x - d) / ((a - b) * (a - d)), (x - a) * (x - d) / ((b - a) * (b - d)),
                 (x - a) * (x - b) / ((d - a) * (d - b))};
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum += weight[0][i] * weight[1][j] *
             indirect_lx_[face * n * n + (first[0] + i) * n + first[1] + j];
    }
  }
  return std::max(0.0, sum);
}

// Split until each part is small beside its distance, then by 2 x 2 Gauss points; parts that are
// small beside the room by the contour formula.
double BoxRadiosity::part_lx(const Patch& part, const glm::dvec3& x, const glm::dvec3& n) const {
  if (part.rho == 0.0) return 0.0;
  const double size = 2.0 * std::max(glm::length(part.half_u), glm::length(part.half_v));
  const auto lx_at = [&](const glm::dvec3& y) {
    return direct_(y, part.normal) + indirect_at(y, part.face);
  };
  if (size <= 0.4 * glm::length(part.centre - x)) {
    constexpr double kGauss = 0.57735026918962576;  // 1 / sqrt(3)
    double lx = 0.0;
    for (const double s : {-kGauss, kGauss}) {
      for (const double t : {-kGauss, kGauss}) {
        const glm::dvec3 y = part.centre + s * part.half_u + t * part.half_v, w = y - x;
        const double cosines = -glm::dot(w, n) * glm::dot(w, part.normal), d2 = glm::dot(w, w);
        if (glm::dot(w, n) > 0.0 && cosines > 0.0) lx += lx_at(y) * cosines / (d2 * d2);
      }
    }
    return part.rho * part.area_m2() / (4.0 * calc::kPi) * lx;
  }
  if (size < 5e-4) return factor(x, n, part) * part.rho * lx_at(part.centre);
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

// The values between the patches' centres, gathered anew from themselves a few times: what is left
// of the constant patches' error falls by the reflectance each time.
void BoxRadiosity::refine() {
  for (int sweep = 0; sweep < 4; ++sweep) {
    std::vector<double> next;
    for (const Patch& patch : patches_) next.push_back(indirect_lx(patch.centre, patch.normal));
    indirect_lx_.swap(next);
  }
}

double BoxRadiosity::indirect_lx(const glm::dvec3& x, const glm::dvec3& n) const {
  double sum = 0.0;
  for (const Patch& patch : patches_) sum += part_lx(patch, x, n);
  return sum;
}

BoxReference::BoxReference(const glm::dvec3& size, const FaceReflectances& rho,
                           const DirectLight& direct)
    : coarse_(size, rho, direct, kCoarse), fine_(size, rho, direct, kFine) {}

KnownValue BoxReference::indirect_lx(const glm::dvec3& x, const glm::dvec3& n) const {
  constexpr double kFloor = 3e-4;  // of the sums between the patches' centres
  constexpr double kLeft = static_cast<double>(kCoarse) / (kFine - kCoarse);
  const double fine_lx = fine_.indirect_lx(x, n);
  const double difference = std::abs(coarse_.indirect_lx(x, n) / fine_lx - 1.0);
  return {fine_lx, kLeft * difference + kFloor};
}

}  // namespace cli::selftest
