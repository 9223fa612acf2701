#include "report/build/build_luminaire_shares.h"

#include "calc/scene/separate_luminaires.h"
#include "report/html/room/html_contributions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace report::build_luminaire_shares_test {
namespace {

using testing::HasSubstr;
using testing::Not;

// Points at x = 0 and 1 with so much light; the second has less.
PlanePart plane_of_two() {
  PlanePart plane;
  plane.is_computed = true;
  plane.points.resize(2);
  plane.points[0].measured = {300, 300, 300};
  plane.points[1].measured = {200, 200, 200};
  plane.points[1].position_m = {1, 0, 0};
  plane.average = {250, 250, 250};
  return plane;
}

std::vector<calc::Luminaire> lamps(std::size_t count) {
  std::vector<calc::Luminaire> list(count);
  for (std::size_t i = 0; i < count; ++i) {
    list[i].id = "L" + std::to_string(i + 1);
    list[i].position_m = {static_cast<double>(i), 0, 3};
  }
  return list;
}

std::vector<calc::LuminaireType> one_type() {
  calc::LuminaireType type;
  type.id = "panel";
  return {type};
}

// Two luminaires of one group at two points, two replicates; indirect light is sampled.
calc::PlaneField field_of_two() {
  calc::PlaneField field;
  field.points = 2;
  field.replicates = 2;
  field.channels = {{"a", 0.5}, {"a", 0.8}};
  field.direct_exact_lx = {100, 20, 10, 200};        // [channel][point]
  field.indirect_lx = {10, 10, 4, 4, 14, 10, 6, 4};  // [replicate][channel][point]
  return field;
}

TEST(LuminaireShares, AreWhatEachGivesAtEachPoint) {
  const LuminaireShares shares =
      build_luminaire_shares(field_of_two(), lamps(2), one_type(), plane_of_two(), 0.95);
  EXPECT_EQ(shares.minimum_at_m, glm::dvec3(1, 0, 0));
  EXPECT_EQ(shares.others, 0U);
  ASSERT_EQ(shares.largest.size(), 2U);
  const LuminaireShare& most = shares.largest[0];
  EXPECT_EQ(most.id, "L2");
  EXPECT_EQ(most.type_id, "panel");
  EXPECT_DOUBLE_EQ(most.direct_lx, 0.8 * 105);
  EXPECT_DOUBLE_EQ(most.average_lx.value, 0.8 * (105 + 4.5));
  EXPECT_LT(most.average_lx.low, most.average_lx.value);
  EXPECT_DOUBLE_EQ(most.minimum_direct_lx, 0.8 * 200);
  EXPECT_DOUBLE_EQ(most.minimum_lx.value, 0.8 * 204);
  EXPECT_DOUBLE_EQ(most.minimum_lx.low, most.minimum_lx.high);  // its replicates agree there
  EXPECT_EQ(shares.largest[1].id, "L1");
  EXPECT_DOUBLE_EQ(shares.largest[1].average_lx.value, 0.5 * (60 + 11));
  EXPECT_DOUBLE_EQ(shares.largest[1].minimum_lx.value, 0.5 * 30);
}

TEST(LuminaireShares, OfFourPlanesAreTheirMean) {
  calc::PlaneField field;
  field.points = 10;  // the cylinder and four planes at each of two points
  field.replicates = 2;
  field.channels = {{"", 1.0}};
  field.direct_exact_lx = {999, 999, 1, 10, 2, 20, 3, 30, 6, 60};
  PlanePart plane = plane_of_two();
  plane.derived = calc::DerivedQuantity::four_planes;
  const LuminaireShares shares = build_luminaire_shares(field, lamps(1), one_type(), plane, 0.95);
  ASSERT_EQ(shares.largest.size(), 1U);
  EXPECT_DOUBLE_EQ(shares.largest[0].average_lx.value, 16.5);
  EXPECT_DOUBLE_EQ(shares.largest[0].minimum_lx.value, 30);
  EXPECT_DOUBLE_EQ(shares.largest[0].average_lx.high, 16.5);  // nothing was sampled
}

// Luminaire i gives i + 1 lx everywhere.
LuminaireShares shares_of(std::size_t count) {
  calc::PlaneField field;
  field.points = 2;
  field.replicates = 2;
  for (std::size_t i = 0; i < count; ++i) {
    field.channels.push_back({"", 1.0});
    for (int k = 0; k < 2; ++k) field.direct_exact_lx.push_back(static_cast<double>(i) + 1.0);
  }
  return build_luminaire_shares(field, lamps(count), one_type(), plane_of_two(), 0.95);
}

TEST(LuminaireShares, OfManyTheLargestAreNamed) {
  EXPECT_EQ(shares_of(11).largest.size(), 11U);
  EXPECT_EQ(shares_of(11).others, 0U);
  const LuminaireShares shares = shares_of(300);
  ASSERT_EQ(shares.largest.size(), kMostLuminaireShares);
  EXPECT_EQ(shares.largest[0].id, "L300");
  EXPECT_EQ(shares.others, 290U);
  EXPECT_DOUBLE_EQ(shares.rest.average_lx.value, 290.0 * 291.0 / 2.0);
  EXPECT_DOUBLE_EQ(shares.rest.minimum_direct_lx, 290.0 * 291.0 / 2.0);
}

TEST(LuminaireShares, RatingsHaveNone) {
  PlanePart plane = plane_of_two();
  plane.derived = calc::DerivedQuantity::ugr;
  EXPECT_TRUE(
      build_luminaire_shares(field_of_two(), lamps(2), one_type(), plane, 0.95).largest.empty());
}

TEST(LuminaireShares, PageShowsThemOnlyWhereThereAre) {
  PlanePart plane = plane_of_two();
  EXPECT_EQ(html_contributions({}, plane), "");
  plane.by_luminaire = shares_of(12);
  plane.by_luminaire.largest[0].id = "<b>";
  plane.by_luminaire.largest[1].group = "<i>";
  const std::string html = html_contributions({}, plane);
  EXPECT_THAT(html, HasSubstr("&lt;b&gt;"));
  EXPECT_THAT(html, HasSubstr("&lt;i&gt;"));
  EXPECT_THAT(html, Not(HasSubstr("<b>")));
  EXPECT_THAT(html, HasSubstr("2 others"));
  EXPECT_THAT(html, HasSubstr("panel at (10.00, 0.00, 3.00)"));
}

TEST(SeparateLuminaires, KeepGroupAndMaintenance) {
  calc::PreparedScene scene;
  scene.channels = {{"a", 0.8}, {"b", 0.7}};
  scene.luminaires.resize(3);
  scene.luminaires[1].channel = 1;
  calc::separate_luminaires(scene);
  ASSERT_EQ(scene.channels.size(), 3U);
  EXPECT_EQ(scene.channels[1].group, "b");
  EXPECT_EQ(scene.channels[2].group, "a");
  EXPECT_EQ(scene.channels[2].maintenance_factor, 0.8);
  for (std::uint32_t l = 0; l < 3; ++l) EXPECT_EQ(scene.luminaires[l].channel, l);
}

}  // namespace
}  // namespace report::build_luminaire_shares_test
