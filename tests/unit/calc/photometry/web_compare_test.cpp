#include "calc/photometry/web_compare.h"

#include "tests/support/web_changes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace calc::web_compare_test {
namespace {

using test_support::angle_steps;
using test_support::crooked_light;
using test_support::make_web;
using test_support::with_opening;

PhotometricWeb web_of(const test_support::Light& light, double c_step = 15.0) {
  return make_web(angle_steps(0, 360, c_step), angle_steps(0, 90, 5), light);
}

// B(C) = scale x A(C - 90 quarters) or A(90 quarters - C).
test_support::Light turned(const test_support::Light& light, WebTurn turn, double scale = 1.0) {
  return [=](double c, double gamma) {
    const double source = turn.mirrored ? 90.0 * turn.quarters - c : c - 90.0 * turn.quarters;
    return scale * light(std::fmod(source + 720.0, 360.0), gamma);
  };
}

TEST(CompareWebs, FindsEveryTurnAndMirrorImage) {
  for (const bool mirrored : {false, true}) {
    for (int quarters = 0; quarters < 4; ++quarters) {
      const WebTurn turn{quarters, mirrored};
      const WebComparison found =
          compare_webs(web_of(crooked_light), web_of(turned(crooked_light, turn, 2.5)));
      EXPECT_EQ(found.fits.size(), 8u);
      EXPECT_TRUE(found.fits.front().turn == turn) << turn_words(found.fits.front().turn);
      EXPECT_EQ(found.alike, 1u);
      EXPECT_LT(found.fits[0].largest, 1e-12);
      EXPECT_GT(found.fits[1].rms, 0.02);
      EXPECT_NEAR(found.flux_ratio, 2.5, 1e-12);
    }
  }
}

TEST(CompareWebs, SaysWhichTurnsASymmetricLightCannotTellApart) {
  const auto light = test_support::symmetric_about_c0(crooked_light);
  const WebComparison found = compare_webs(web_of(light), web_of(turned(light, {1, false})));
  ASSERT_EQ(found.alike, 2u);
  EXPECT_TRUE((found.fits[0].turn == WebTurn{1, false}));
  EXPECT_TRUE((found.fits[1].turn == WebTurn{1, true}));

  const WebComparison quadrant =
      compare_webs(web_of(test_support::batwing), web_of(test_support::batwing));
  EXPECT_EQ(quadrant.alike, 4u);
  EXPECT_TRUE((quadrant.fits[0].turn == WebTurn{0, false}));
  EXPECT_TRUE((quadrant.fits[1].turn == WebTurn{2, false}));

  const WebComparison axial =
      compare_webs(web_of(test_support::narrow_spot),
                   make_web({0}, angle_steps(0, 90, 5), test_support::narrow_spot));
  EXPECT_EQ(axial.alike, 8u);
  EXPECT_LT(axial.fits[7].rms, 1e-12);
}

TEST(CompareWebs, LetsTheOpeningsChooseAmongTurnsThatFitAlike) {
  const PhotometricWeb spot = web_of(test_support::narrow_spot);
  const WebComparison found =
      compare_webs(with_opening(spot, {OpeningShape::rectangle, 1.2, 0.3, 0}),
                   with_opening(spot, {OpeningShape::rectangle, 0.3, 1.2, 0}));
  EXPECT_EQ(found.fits.front().turn.quarters, 1);
  EXPECT_EQ(found.openings, OpeningRelation::agree);
}

TEST(CompareWebs, ComparesTablesOfDifferentStepsAtTheCoarserAngles) {
  // The finer table departs from the coarser one between its planes only.
  const auto coarse = web_of(crooked_light, 30.0);
  const auto fine = web_of(turned(crooked_light, {3, false}), 15.0);
  for (const bool swapped : {false, true}) {
    const WebComparison found = swapped ? compare_webs(fine, coarse) : compare_webs(coarse, fine);
    EXPECT_TRUE((found.fits.front().turn == WebTurn{swapped ? 1 : 3, false}));
    EXPECT_LT(found.fits.front().rms, 0.002);  // fluxes differ by the interpolation
  }
}

TEST(CompareWebs, SeesLightBeyondTheRangeOfTheOther) {
  const auto down = make_web({0}, {0, 45, 90}, [](double, double) { return 10.0; });
  const auto both = make_web({0}, angle_steps(0, 180, 45), [](double, double) { return 10.0; });
  EXPECT_GT(compare_webs(down, both).fits.front().rms, 0.3);
}

// One of two equal bright angles is 10 % off; both at full flux weight.
TEST(CompareWebs, GivesTheResidualOverTheMaximum) {
  const auto a = make_web({0}, {0, 90, 180}, [](double, double) { return 10.0; });
  const auto b = make_web({0}, {0, 90, 180}, [](double, double g) { return g > 90 ? 8.0 : 10.0; });
  const TurnFit fit = compare_webs(a, b).fits.front();
  const double in_a = 10.0 / a.flux_lm();
  const double bright = 10.0 / b.flux_lm();
  const double dim = 8.0 / b.flux_lm();
  const double sum = 2.0 * std::pow(bright - in_a, 2) + std::pow(dim - in_a, 2);
  EXPECT_NEAR(fit.rms, std::sqrt(sum / 3.0) / bright, 1e-12);
  EXPECT_NEAR(fit.largest, (in_a - dim) / bright, 1e-12);
}

TEST(RelateOpenings, KnowsHowSizesGoWithATurn) {
  const LuminousOpening a{OpeningShape::rectangle, 1.2, 0.3, 0};
  const LuminousOpening b{OpeningShape::rectangle, 0.302, 1.198, 0};
  EXPECT_EQ(relate_openings(a, b, {1, false}), OpeningRelation::agree);
  EXPECT_EQ(relate_openings(a, b, {3, true}), OpeningRelation::agree);
  EXPECT_EQ(relate_openings(a, b, {0, false}), OpeningRelation::exchanged);
  EXPECT_EQ(relate_openings(a, b, {2, true}), OpeningRelation::exchanged);
  EXPECT_EQ(relate_openings(a, {OpeningShape::rectangle, 0.6, 0.6, 0}, {0, false}),
            OpeningRelation::differ);
  const LuminousOpening square{OpeningShape::rectangle, 0.6, 0.6, 0};
  EXPECT_EQ(relate_openings(square, square, {1, false}), OpeningRelation::indifferent);
  EXPECT_EQ(relate_openings(a, {}, {0, false}), OpeningRelation::not_stated);
}

TEST(TurnWords, NameThePlaneOfAMirrorImage) {
  EXPECT_EQ(turn_words({0, false}), "not turned");
  EXPECT_EQ(turn_words({1, false}), "turned by 90 degrees about the vertical axis (C = C + 90)");
  EXPECT_EQ(turn_words({0, true}), "mirrored at the plane C 0-C 180 (C = -C)");
  EXPECT_EQ(turn_words({3, true}), "mirrored at the plane C 135-C 315 (C = 270 - C)");
}

TEST(RelateOpenings, HeightsCountBetweenBodies) {
  const LuminousOpening low{OpeningShape::box, 1.2, 0.3, 0.2};
  const LuminousOpening high{OpeningShape::box, 1.2, 0.3, 0.4};
  const LuminousOpening flat{OpeningShape::rectangle, 1.2, 0.3, 0.0};
  EXPECT_EQ(relate_openings(low, low, {}), OpeningRelation::agree);
  EXPECT_EQ(relate_openings(low, high, {}), OpeningRelation::differ);
  EXPECT_EQ(relate_openings(low, flat, {}), OpeningRelation::agree);
}

}  // namespace
}  // namespace calc::web_compare_test
