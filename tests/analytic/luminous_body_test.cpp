// Luminous bodies and lines near a point, against closed forms and against sums over their surface.
#include "calc/base/statistics.h"
#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/direct/emission.h"
#include "calc/scene/opening.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <utility>

namespace luminous_body_test {
namespace {

using namespace test_support;

using calc::kPi;
using calc::LuminousOpening;
using calc::OpeningShape;

// Intensity that a body of even luminance has in each direction: luminance times outline.
using Outline = std::function<double(const glm::dvec3&)>;

calc::PhotometricWeb even_luminance_web(const LuminousOpening& opening, double luminance,
                                        const Outline& outline_m2) {
  constexpr int kC = 360, kGamma = 180;
  std::vector<double> c_rad, gamma_rad, cd;
  for (int g = 0; g <= kGamma; ++g) gamma_rad.push_back(kPi * g / kGamma);
  for (int c = 0; c <= kC; ++c) {
    c_rad.push_back(c == kC ? 2.0 * kPi : 2.0 * kPi * c / kC);
    for (const double gamma : gamma_rad) {
      const auto d = calc::direction_of({2.0 * kPi * (c % kC) / kC, gamma});
      cd.push_back(luminance * outline_m2({d[0], d[1], d[2]}));
    }
  }
  return calc::PhotometricWeb::make(c_rad, gamma_rad, cd, opening, {});
}

calc::Estimate illuminance(const calc::PhotometricWeb& web, const glm::dmat3& axes,
                           const glm::dvec3& point_m, const glm::dvec3& normal) {
  calc::PreparedScene scene;
  add_luminaire(scene, web, {0, 0, 0});
  scene.luminaires[0].world_from_luminaire = axes;
  scene.extent_m = 10.0;
  calc::SensorGrid grid;
  grid.position_m = {point_m};
  grid.normal = {normal};
  const calc::SpaceSolution solution = solve_with_paths(scene, grid, 7, 256, 16, 4);
  return calc::t_interval(replicates_at(solution.fields[0], 0), 0.999);
}

void expect_value(const calc::Estimate& lx, double expected, double table_error) {
  EXPECT_NEAR(lx.value / expected, 1.0, 2e-3 + table_error);
  EXPECT_LE(lx.low, expected * (1.0 + table_error));
  EXPECT_GE(lx.high, expected * (1.0 - table_error));
  EXPECT_LT(lx.half_width(), 5e-3 * expected);
}

TEST(LuminousSphere, IsAPointAtItsCentreAtAnyDistance) {
  const LuminousOpening ball{OpeningShape::ellipsoid, 0.4, 0.4, 0.4};
  const double luminance = 5000.0, outline_m2 = kPi * 0.04;
  const calc::PhotometricWeb web = calc::PhotometricWeb::make(
      {0.0}, {0.0, kPi}, {luminance * outline_m2, luminance * outline_m2}, ball, {});
  const glm::dvec3 towards = glm::normalize(glm::dvec3(0.3, -0.5, -0.7));
  for (const double d : {0.21, 0.25, 0.5, 2.0}) {
    SCOPED_TRACE(d);
    expect_value(illuminance(web, glm::dmat3(1.0), d * towards, -towards),
                 luminance * outline_m2 / (d * d), 0.0);
  }
}

// Lambert's law for each visible part of the surface: the second method, without outlines.
double surface_sum_lx(const LuminousOpening& body, double luminance, const glm::dvec3& point_m,
                      const glm::dvec3& normal) {
  const glm::dvec3 half = 0.5 * body.size_m();
  constexpr int kSide = 400;
  double sum = 0.0;
  const auto add = [&](const glm::dvec3& x, const glm::dvec3& outward_area_m2) {
    const glm::dvec3 to_point = point_m - x;
    const double d2 = glm::dot(to_point, to_point);
    const double leaving = glm::dot(outward_area_m2, to_point);
    const double arriving = -glm::dot(normal, to_point);
    if (leaving > 0.0 && arriving > 0.0) sum += luminance * leaving * arriving / (d2 * d2);
  };
  if (body.shape == OpeningShape::box) {
    for (int axis = 0; axis < 3; ++axis) {
      const int a = (axis + 1) % 3, b = (axis + 2) % 3;
      for (const double side : {-1.0, 1.0}) {
        glm::dvec3 area(0.0);
        area[axis] = side * 4.0 * half[a] * half[b] / (kSide * kSide);
        for (int i = 0; i < kSide * kSide; ++i) {
          glm::dvec3 x(0.0);
          x[axis] = side * half[axis];
          x[a] = half[a] * (2.0 * (i % kSide + 0.5) / kSide - 1.0);
          x[b] = half[b] * (2.0 * (i / kSide + 0.5) / kSide - 1.0);
          add(x, area);
        }
      }
    }
    return sum;
  }
  // Cylinders, circular: the side, then the ends in rings.
  const int axis = body.shape == OpeningShape::cylinder_c0 ? 0 : 2;
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const double radius = half[a], length = 2.0 * half[axis];
  for (int i = 0; i < kSide * kSide; ++i) {
    const double angle = 2.0 * kPi * (i % kSide + 0.5) / kSide;
    const double share = (i / kSide + 0.5) / kSide;
    glm::dvec3 outward(0.0);
    outward[a] = std::cos(angle);
    outward[b] = std::sin(angle);
    glm::dvec3 x = radius * outward;
    x[axis] = length * (share - 0.5);
    add(x, outward * (2.0 * kPi * radius * length / (kSide * kSide)));
    for (const double side : {-1.0, 1.0}) {
      glm::dvec3 end = share * radius * outward, area(0.0);
      end[axis] = side * half[axis];
      area[axis] = side * 2.0 * kPi * share * radius * radius / (kSide * kSide);
      add(end, area);
    }
  }
  return sum;
}

struct Body {
  LuminousOpening opening;
  Outline outline_m2;
};

std::vector<Body> bodies() {
  return {{{OpeningShape::box, 0.6, 0.2, 0.3},
           [](const glm::dvec3& d) {
             return 0.06 * std::abs(d.x) + 0.18 * std::abs(d.y) + 0.12 * std::abs(d.z);
           }},
          {{OpeningShape::cylinder, 0.2, 0.2, 0.8},
           [](const glm::dvec3& d) {
             return kPi * 0.01 * std::abs(d.z) + 0.16 * std::hypot(d.x, d.y);
           }},
          {{OpeningShape::cylinder_c0, 1.2, 0.1, 0.1}, [](const glm::dvec3& d) {
             return kPi * 0.0025 * std::abs(d.x) + 0.12 * std::hypot(d.y, d.z);
           }}};
}

TEST(LuminousBody, AgreesWithTheSumOverItsSurface) {
  const glm::dmat3 level(1.0);
  for (const Body& body : bodies()) {
    const double luminance = 3000.0;
    const calc::PhotometricWeb web = even_luminance_web(body.opening, luminance, body.outline_m2);
    for (const auto& [point_m, normal] :
         {std::pair<glm::dvec3, glm::dvec3>{{0.0, 0.0, -0.6}, {0, 0, 1}},
          {{0.3, 0.4, -0.5}, {-0.5, -0.6, 0.6}},
          {{0.9, 0.1, 0.05}, {-1, 0, 0}},
          {{0.05, 0.35, -0.1}, {0, -1, 0}},
          {{1.5, 2.0, -2.5}, {0, 0, 1}}}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(body.opening.shape) << " at " << point_m.x
                                      << " " << point_m.y << " " << point_m.z);
      const glm::dvec3 n = glm::normalize(normal);
      const double expected = surface_sum_lx(body.opening, luminance, point_m, n);
      ASSERT_GT(expected, 0.0);
      expect_value(illuminance(web, level, point_m, n), expected, 4e-4);
    }
  }
}

TEST(LuminousBody, TurnsWithItsLuminaire) {
  const Body body = bodies()[0];
  const calc::PhotometricWeb web = even_luminance_web(body.opening, 3000.0, body.outline_m2);
  const glm::dmat3 axes{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};  // luminaire x -> y -> z -> x
  const glm::dvec3 point_m(0.5, 0.4, -0.3);
  const glm::dvec3 normal = glm::normalize(-point_m);
  const double expected = surface_sum_lx(body.opening, 3000.0, glm::transpose(axes) * point_m,
                                         glm::transpose(axes) * normal);
  expect_value(illuminance(web, axes, point_m, normal), expected, 4e-4);
}

// What leaves as light paths is the web's light, from the visible side of the body.
TEST(LuminousBody, LightPathsLeaveFromTheOutline) {
  for (const Body& body : bodies()) {
    const calc::PhotometricWeb web = even_luminance_web(body.opening, 1.0, body.outline_m2);
    calc::PreparedScene scene;
    add_luminaire(scene, web, {0, 0, 0});
    const calc::Emitter emitter(scene);
    const glm::dvec3 half = 0.5 * body.opening.size_m();
    glm::dvec3 mean_along(0.0);
    int outside = 0, inward = 0;
    constexpr int kPaths = 400000;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < kPaths; ++i) {
      const std::array<double, 2> direction{uniform(random), uniform(random)};
      const std::array<double, 2> place{uniform(random), uniform(random)};
      const calc::EmittedRay ray = emitter.emit(0, direction, place, 0.0);
      outside += glm::any(glm::greaterThan(glm::abs(ray.origin_m), half + 1e-12)) ? 1 : 0;
      inward +=
          calc::is_inside_opening(scene.luminaires[0], ray.origin_m + 1e-6 * ray.direction, 0.0)
              ? 1
              : 0;
      mean_along += glm::dvec3(ray.origin_m * ray.direction) / static_cast<double>(kPaths);
    }
    EXPECT_EQ(outside, 0);
    EXPECT_EQ(inward, 0);
    // Even luminance: x even on the surface, w with density cos / pi about n, whose mean is 2/3 n.
    // Thus E[x_k w_k] = 2/3 of the mean of x_k n_k, which is V / A by the divergence theorem.
    const double volume = body.opening.shape == OpeningShape::box ? 8.0 * half.x * half.y * half.z
                          : body.opening.shape == OpeningShape::cylinder
                              ? kPi * half.x * half.y * 2.0 * half.z
                              : kPi * half.y * half.z * 2.0 * half.x;
    const double area_m2 = web.flux_lm() / kPi;
    const double expected = volume / area_m2 * 2.0 / 3.0;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(mean_along[axis], expected, 0.05 * expected) << axis;
    }
  }
}

// A Lambertian strip without width, its middle above the point.
TEST(LambertLine, UnderItsMiddle) {
  const double length = 1.5, axis_cd = 400.0;
  const calc::PhotometricWeb web =
      lambert_web(axis_cd, 900, {OpeningShape::rectangle, length, 0.0, 0.0});
  for (const double h : {0.3, 0.75, 1.5, 7.5}) {
    SCOPED_TRACE(h);
    const double x = 0.5 * length;
    const double expected =
        2.0 * axis_cd / length * h * h *
        (x / (2.0 * h * h * (x * x + h * h)) + std::atan(x / h) / (2.0 * h * h * h));
    expect_value(illuminance(web, glm::dmat3(1.0), {0, 0, -h}, {0, 0, 1}), expected, 2e-6);
  }
}

TEST(LuminousBody, PointsInsideAreRefused) {
  const Body body = bodies()[1];
  const calc::PhotometricWeb web = even_luminance_web(body.opening, 1.0, body.outline_m2);
  calc::PreparedScene scene;
  add_luminaire(scene, web, {1, 1, 1});
  EXPECT_EQ(calc::find_touching_luminaire(scene, {1.0, 1.05, 1.3}, 1e-6), 0);
  EXPECT_EQ(calc::find_touching_luminaire(scene, {1.08, 1.08, 1.0}, 1e-6),
            -1);  // beside the round
  EXPECT_EQ(calc::find_touching_luminaire(scene, {1.0, 1.0, 1.41}, 1e-6), -1);
}

}  // namespace
}  // namespace luminous_body_test
