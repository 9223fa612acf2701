#pragma once
// References for extreme cases that share no ray, no table and no random number with the program:
// brute force against every triangle in double precision, and quadrature of one reflection.

#include "calc/base/statistics.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <tbb/parallel_for.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace extreme {

using namespace test_support;

struct Reference {
  double lx = 0.0;
  double standard_error_lx = 0.0;
};

// Unoccluded illuminance (lx) of one luminaire without size: E = I cos / d^2.
inline double direct_lx(const calc::PlacedLuminaire& luminaire, const glm::dvec3& x,
                        const glm::dvec3& normal) {
  const glm::dvec3 w = luminaire.position_m - x;
  const double d = glm::length(w);
  const double cosine = glm::dot(normal, w) / d;
  if (!(cosine > 0.0)) return 0.0;
  const glm::dvec3 out = glm::transpose(luminaire.world_from_luminaire) * (-w / d);
  return luminaire.web->intensity_cd({out.x, out.y, out.z}) * luminaire.flux_scale * cosine /
         (d * d);
}

// Cosine paths from a point with the direct light of all luminaires at every hit.
class PathReference {
 public:
  explicit PathReference(const calc::PreparedScene& scene) : scene_(scene) {
    for (const glm::uvec3& t : scene.triangle) {
      const glm::dvec3 a(scene.vertex_m[t.x]), b(scene.vertex_m[t.y]), c(scene.vertex_m[t.z]);
      triangle_.push_back({a, b - a, c - a, glm::normalize(glm::cross(b - a, c - a))});
    }
  }

  double direct(const glm::dvec3& x, const glm::dvec3& normal) const {
    double lx = 0.0;
    for (const calc::PlacedLuminaire& luminaire : scene_.luminaires) {
      const double unoccluded_lx = direct_lx(luminaire, x, normal);
      if (unoccluded_lx > 0.0 && !is_blocked(x, luminaire.position_m)) lx += unoccluded_lx;
    }
    return lx;
  }

  // Direct and reflected light at a point.
  Reference total(const glm::dvec3& x, const glm::dvec3& normal, int paths) const {
    constexpr std::size_t kParts = 64;
    std::array<double, kParts> sum{}, sum_of_squares{};
    tbb::parallel_for(std::size_t{0}, kParts, [&](std::size_t part) {
      std::mt19937_64 random(
          part +
          static_cast<std::uint64_t>(1e6 * std::abs(x.x + 10.0 * x.y + 100.0 * x.z)) * kParts);
      for (int p = 0; p < paths / static_cast<int>(kParts); ++p) {
        const double lx = path_lx(x, normal, random);
        sum[part] += lx;
        sum_of_squares[part] += lx * lx;
      }
    });
    const double n =
        static_cast<double>(paths / static_cast<int>(kParts) * static_cast<int>(kParts));
    const double mean = std::accumulate(sum.begin(), sum.end(), 0.0) / n;
    const double mean_square =
        std::accumulate(sum_of_squares.begin(), sum_of_squares.end(), 0.0) / n;
    return {direct(x, normal) + mean, std::sqrt(std::max(0.0, mean_square - mean * mean) / n)};
  }

 private:
  struct Triangle {
    glm::dvec3 a, ab, ac, normal;
  };

  static constexpr double kGap_m = 1e-7;  // rays begin this far from what they left

  // [Moeller and Trumbore 1997]; edges belong to both of their triangles.
  static double distance(const Triangle& t, const glm::dvec3& origin, const glm::dvec3& direction) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const glm::dvec3 p = glm::cross(direction, t.ac);
    const double determinant = glm::dot(t.ab, p);
    if (determinant == 0.0) return kNone;
    const glm::dvec3 s = origin - t.a;
    const double u = glm::dot(s, p) / determinant;
    if (u < -1e-12 || u > 1.0 + 1e-12) return kNone;
    const glm::dvec3 q = glm::cross(s, t.ab);
    const double v = glm::dot(direction, q) / determinant;
    if (v < -1e-12 || u + v > 1.0 + 1e-12) return kNone;
    const double far = glm::dot(t.ac, q) / determinant;
    return far > kGap_m ? far : kNone;
  }

  bool is_blocked(const glm::dvec3& from, const glm::dvec3& to) const {
    const double d = glm::length(to - from);
    const glm::dvec3 direction = (to - from) / d;
    return std::any_of(triangle_.begin(), triangle_.end(), [&](const Triangle& t) {
      return distance(t, from, direction) < d - kGap_m;
    });
  }

  static glm::dvec3 cosine_direction(const glm::dvec3& normal, std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double z = 2.0 * uniform(random) - 1.0, angle = 2.0 * calc::kPi * uniform(random);
    const double r = std::sqrt(1.0 - z * z);
    const glm::dvec3 sum = normal + glm::dvec3(r * std::cos(angle), r * std::sin(angle), z);
    const double length = glm::length(sum);
    return length > 1e-9 ? sum / length : normal;
  }

  double path_lx(glm::dvec3 x, glm::dvec3 normal, std::mt19937_64& random) const {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    double lx = 0.0, weight = 1.0;
    for (int hit = 0;; ++hit) {
      const glm::dvec3 direction = cosine_direction(normal, random);
      double nearest = std::numeric_limits<double>::infinity();
      std::size_t triangle = 0;
      for (std::size_t t = 0; t < triangle_.size(); ++t) {
        const double d = distance(triangle_[t], x, direction);
        if (d < nearest) {
          nearest = d;
          triangle = t;
        }
      }
      if (std::isinf(nearest)) return lx;
      const double rho = scene_.reflectance[triangle];
      if (hit == 0) {
        weight = rho;
      } else if (uniform(random) >= rho) {
        return lx;
      }
      if (weight == 0.0) return lx;
      x += nearest * direction;
      normal = triangle_[triangle].normal;
      if (glm::dot(normal, direction) > 0.0) normal = -normal;
      lx += weight * direct(x, normal);
    }
  }

  const calc::PreparedScene& scene_;
  std::vector<Triangle> triangle_;
};

// Light of all luminaires once reflected by a rectangle and nothing in the way:
//   E = integral rho / pi E_dir(y) cos cos / d^2 dA,
// 3 x 3 Gauss points per cell, cells at most half as large as their distance from the point and
// from the luminaires.
class OneReflection {
 public:
  OneReflection(const calc::PreparedScene& scene, const glm::dvec3& corner, const glm::dvec3& u,
                const glm::dvec3& v, const glm::dvec3& normal, double rho, double largest_m = 1e300)
      : scene_(scene),
        corner_(corner),
        u_(u),
        v_(v),
        normal_(normal),
        rho_(rho),
        largest_m_(largest_m) {}

  double lx(const glm::dvec3& x, const glm::dvec3& normal, std::uint32_t channel = 0) const {
    return part_lx({x, normal, channel}, corner_, u_, v_);
  }

 private:
  struct Point {
    glm::dvec3 x, normal;
    std::uint32_t channel;
  };

  double part_lx(const Point& point, const glm::dvec3& corner, const glm::dvec3& u,
                 const glm::dvec3& v) const {
    const double size = std::max(glm::length(u), glm::length(v));
    const glm::dvec3 centre = corner + 0.5 * (u + v);
    double distance = glm::length(centre - point.x);
    for (const calc::PlacedLuminaire& luminaire : scene_.luminaires) {
      distance = std::min(distance, glm::length(centre - luminaire.position_m));
    }
    if (size > 0.5 * distance || size > largest_m_) {
      const glm::dvec3 a = 0.5 * u, b = 0.5 * v;
      return part_lx(point, corner, a, b) + part_lx(point, corner + a, a, b) +
             part_lx(point, corner + b, a, b) + part_lx(point, corner + a + b, a, b);
    }
    constexpr double kNode[3] = {0.1127016653792583, 0.5, 0.8872983346207417};
    constexpr double kWeight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        sum += kWeight[i] * kWeight[j] * integrand(point, corner + kNode[i] * u + kNode[j] * v);
      }
    }
    return sum * glm::length(glm::cross(u, v));
  }

  double integrand(const Point& point, const glm::dvec3& y) const {
    const glm::dvec3 w = y - point.x;
    const double cx = glm::dot(point.normal, w), cy = -glm::dot(normal_, w);
    if (!(cx > 0.0) || !(cy > 0.0)) return 0.0;
    const double d2 = glm::dot(w, w);
    double lit_lx = 0.0;
    for (const calc::PlacedLuminaire& luminaire : scene_.luminaires) {
      if (luminaire.channel == point.channel) lit_lx += direct_lx(luminaire, y, normal_);
    }
    return rho_ / calc::kPi * lit_lx * cx * cy / (d2 * d2);
  }

  const calc::PreparedScene& scene_;
  glm::dvec3 corner_, u_, v_, normal_;
  double rho_, largest_m_;
};

inline calc::SensorGrid points_of(std::vector<glm::dvec3> position_m,
                                  std::vector<glm::dvec3> normal) {
  calc::SensorGrid grid;
  grid.position_m = std::move(position_m);
  grid.normal = std::move(normal);
  return grid;
}

// The value at point i lies within its 99.9 % interval (and four standard errors) of the reference,
// and the interval is no wider than `widest` of the reference: it could not hold just anything.
inline void expect_right(const std::vector<double>& replicates, const Reference& truth,
                         double widest) {
  const calc::Estimate e = calc::t_interval(replicates, 0.999);
  const double allowed = 4.0 * truth.standard_error_lx + 2e-6 * truth.lx;
  std::printf("  expected %.6g +- %.2g %%, got %.6g, interval %.6g to %.6g (%.2g %%)\n", truth.lx,
              100 * truth.standard_error_lx / truth.lx, e.value, e.low, e.high,
              100 * e.half_width() / truth.lx);
  EXPECT_GT(e.value, 0.0);
  EXPECT_LE(e.low, truth.lx + allowed);
  EXPECT_GE(e.high, truth.lx - allowed);
  EXPECT_LE(e.half_width(), widest * truth.lx);
}

inline void expect_right(const calc::PlaneField& field, std::size_t i, const Reference& truth,
                         double widest) {
  ASSERT_EQ(field.problem, "");
  ASSERT_LT(i, field.points);
  expect_right(replicates_at(field, i), truth, widest);
  if (!field.unseen.empty()) {
    EXPECT_EQ(field.unseen[i], 0);
  }
  if (!field.largest_share.empty()) {
    EXPECT_LT(field.largest_share[i], 0.1f);
  }
}

}  // namespace extreme
