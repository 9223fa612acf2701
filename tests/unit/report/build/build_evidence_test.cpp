#include "report/build/build_evidence.h"

#include "tests/support/sample_document.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace report::build_evidence_test {
namespace {

// Two points, two replicates; group "a" in two channels of different maintenance, group "b".
calc::PlaneField field_of_groups() {
  calc::PlaneField field;
  field.points = 2;
  field.replicates = 2;
  field.channels = {{"a", 0.8}, {"b", 0.5}, {"a", 1.0}};
  field.direct_exact_lx = {100, 200, 40, 60, 10, 10};  // [channel][point]
  field.indirect_lx = {10, 10, 4, 4, 1, 1, 12, 12, 6, 6, 1, 1};
  field.looks_planned = 3;
  field.counters = {4096, 10, 20, 30, {2, 1}};
  return field;
}

TEST(Evidence, GroupsAddUpToThePlane) {
  const calc::PlaneField field = field_of_groups();
  const std::vector<GroupShare> groups = build_groups(field, calc::DerivedQuantity::none, 0.95);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].group, "a");
  EXPECT_DOUBLE_EQ(groups[0].direct_lx, 0.8 * 150 + 10);
  EXPECT_DOUBLE_EQ(groups[0].average_lx.value, 0.8 * (150 + 11) + 11);
  EXPECT_DOUBLE_EQ(groups[1].average_lx.value, 0.5 * (50 + 5));
  EXPECT_LT(groups[1].average_lx.low, groups[1].average_lx.value);
  const PlaneLook look = build_look(field, calc::DerivedQuantity::none, {}, 0.95);
  EXPECT_DOUBLE_EQ(look.average.value, groups[0].average_lx.value + groups[1].average_lx.value);
}

TEST(Evidence, GroupsHaveTheirLightAtPoints) {
  calc::PlaneField field = field_of_groups();
  std::vector<GroupShare> groups = build_groups(field, calc::DerivedQuantity::none, 0.95);
  EXPECT_EQ(groups[0].point_lx, (std::vector<double>{99.8, 179.8}));
  EXPECT_EQ(groups[1].point_lx, (std::vector<double>{22.5, 32.5}));
  field.direct_exact_lx[2] = 40.123456789;
  groups = build_groups(field, calc::DerivedQuantity::none, 0.95);
  EXPECT_EQ(groups[1].point_lx[0], 22.5617);  // 22.5617283945
  for (calc::LightChannel& channel : field.channels) channel.group = "a";
  groups = build_groups(field, calc::DerivedQuantity::none, 0.95);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_TRUE(groups[0].point_lx.empty());  // they are the plane's own
}

TEST(Evidence, LightAtPointsHasABound) {
  for (const std::size_t points : {kMostShareValues / 2, kMostShareValues / 2 + 1}) {
    calc::PlaneField field;
    field.points = points;
    field.replicates = 1;
    field.channels = {{"a", 1.0}, {"b", 1.0}};
    field.direct_exact_lx.assign(2 * points, 1.0);
    const auto groups = build_groups(field, calc::DerivedQuantity::none, 0.95);
    EXPECT_EQ(groups[0].point_lx.size(), points > kMostShareValues / 2 ? 0U : points);
  }
}

TEST(Evidence, LookSaysWhatWasDoneAndFound) {
  const std::vector<rules::Finding> findings{
      sample_finding(rules::Metric::average, 500, estimate(400, 8))};
  const PlaneLook look = build_look(field_of_groups(), calc::DerivedQuantity::none, findings, 0.95);
  EXPECT_EQ(look.paths, 4096U);
  EXPECT_EQ(look.rays, 60U);
  EXPECT_EQ(look.points, 1U);  // of the last look
  ASSERT_EQ(look.findings.size(), 1U);
  EXPECT_EQ(look.findings[0].verdict, rules::Verdict::fail);
  EXPECT_EQ(look.findings[0].measured.high, 408);
}

}  // namespace
}  // namespace report::build_evidence_test
