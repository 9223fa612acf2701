#include "calc/project/objects/frame.h"

#include "calc/base/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace calc::frame_test {
namespace {

constexpr double kTolerance = 1.0e-14;

void expect_near(const glm::dvec3& found, const glm::dvec3& expected) {
  EXPECT_NEAR(found.x, expected.x, kTolerance);
  EXPECT_NEAR(found.y, expected.y, kTolerance);
  EXPECT_NEAR(found.z, expected.z, kTolerance);
}

void expect_rotation(const glm::dmat3& frame) {
  const glm::dmat3 product = glm::transpose(frame) * frame;
  for (int i = 0; i < 3; ++i) expect_near(product[i], glm::dmat3(1.0)[i]);
  EXPECT_NEAR(glm::determinant(frame), 1.0, kTolerance);
}

TEST(LuminaireFrame, IsTheIdentityStraightDown) {
  const glm::dmat3 frame = luminaire_frame({0, 0, -3}, 0.0);
  expect_near(frame[0], {1, 0, 0});
  expect_near(frame[1], {0, 1, 0});
  expect_near(frame[2], {0, 0, 1});
}

TEST(LuminaireFrame, RotationTurnsC0CounterClockwiseSeenFromAbove) {
  const double angle = radians_from_degrees(30.0);
  const glm::dmat3 frame = luminaire_frame({0, 0, -1}, angle);
  expect_near(frame[0], {std::cos(angle), std::sin(angle), 0});
  expect_near(frame[1], {-std::sin(angle), std::cos(angle), 0});
}

TEST(LuminaireFrame, StraightUpIsHalfATurnAboutX) {
  const glm::dmat3 frame = luminaire_frame({0, 0, 1}, 0.0);
  expect_near(frame[0], {1, 0, 0});
  expect_near(frame[1], {0, -1, 0});
  expect_near(frame[2], {0, 0, -1});
}

TEST(LuminaireFrame, TiltTowardsXTurnsC0Up) {
  // 90 degrees about -y: -z goes to x, x goes to z, y stays.
  const glm::dmat3 frame = luminaire_frame({1, 0, 0}, 0.0);
  expect_near(frame[0], {0, 0, 1});
  expect_near(frame[1], {0, 1, 0});
  expect_near(frame[2], {-1, 0, 0});
}

TEST(LuminaireFrame, SmallestRotationKeepsTheDirectionAcrossTheTilt) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -0.5));
  const glm::dmat3 frame = luminaire_frame(axis, 0.0);
  expect_rotation(frame);
  expect_near(frame[2], -axis);
  const glm::dvec3 across = glm::normalize(glm::dvec3(2, -1, 0));
  expect_near(frame * across, across);
}

TEST(LuminaireFrame, StaysARotationNextToTheSpecialAxes) {
  for (const double z : {-1.0, 1.0}) {
    for (const double tilt : {1.0e-3, 1.0e-8, 1.0e-12, 1.0e-16}) {
      const glm::dmat3 frame = luminaire_frame({0.6 * tilt, -0.8 * tilt, z}, 1.0);
      expect_rotation(frame);
      EXPECT_NEAR(frame[2].z, -z, 1.0e-6);
    }
  }
}

TEST(LuminaireFrameTowards, TakesThePartOfC0AcrossTheAxis) {
  const auto frame = luminaire_frame_towards({0, 0, -2}, {3, 0, 5});
  ASSERT_TRUE(frame);
  expect_near((*frame)[0], {1, 0, 0});
  expect_near((*frame)[1], {0, 1, 0});
  expect_near((*frame)[2], {0, 0, 1});
}

TEST(LuminaireFrameTowards, AgreesWithTheRotationForm) {
  const glm::dvec3 axis(0.3, -0.7, -0.2);
  const glm::dmat3 expected = luminaire_frame(axis, 0.8);
  const auto frame = luminaire_frame_towards(axis, expected[0] + 2.0 * axis);
  ASSERT_TRUE(frame);
  for (int i = 0; i < 3; ++i) expect_near((*frame)[i], expected[i]);
}

TEST(LuminaireFrameTowards, RefusesParallelAndZero) {
  EXPECT_FALSE(luminaire_frame_towards({0, 1, 0}, {0, -4, 0}));
  EXPECT_FALSE(luminaire_frame_towards({0, 1, 0}, {0, 0, 0}));
}

}  // namespace
}  // namespace calc::frame_test
