#include "report/tools/import/dxf_drawing.h"

#include "tests/unit/report/tools/import/dxf_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace dxf_drawing_test {
namespace {

using test_support::DxfText;
using ::testing::HasSubstr;
using Kind = cli::DxfEntity::Kind;

cli::DxfDrawing drawing(const std::string& text) {
  std::string problem;
  auto read = cli::read_dxf(text, problem);
  EXPECT_EQ(problem, "");
  return read ? std::move(*read) : cli::DxfDrawing();
}

// They point into the drawing.
std::vector<cli::DxfPlaced> placed(const cli::DxfDrawing& drawing, Kind kind) {
  std::vector<cli::DxfPlaced> found;
  cli::DxfSkipped skipped;
  EXPECT_EQ(cli::visit_dxf(
                drawing,
                [&](const cli::DxfPlaced& one) {
                  if (one.entity->kind == kind) found.push_back(one);
                  return true;
                },
                skipped),
            "");
  return found;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1.0e-9) << a.x << " " << a.y << " " << a.z;
}

TEST(DxfDrawing, ReadsHeaderLayersAndEntities) {
  const cli::DxfDrawing read = drawing(DxfText()
                                           .header("AC1015", 4)
                                           .section("TABLES")
                                           .layer("Off", -7, 0)
                                           .layer("Frozen", 7, 1)
                                           .end()
                                           .section("ENTITIES")
                                           .line("a", 0, 0, 1, 2)
                                           .rectangle("b", 0, 0, 2, 3, "1F")
                                           .end()
                                           .whole());
  EXPECT_EQ(read.version, "AC1015");
  EXPECT_EQ(read.unit, 4);
  EXPECT_TRUE(read.layer.at("off").is_off);
  EXPECT_TRUE(read.layer.at("frozen").is_frozen);
  ASSERT_EQ(read.entity.size(), 2u);
  EXPECT_EQ(read.entity[1].handle, "1F");
  EXPECT_TRUE(read.entity[1].is_closed);
  EXPECT_EQ(read.entity[1].vertex.size(), 4u);
}

TEST(DxfDrawing, HiddenThingsAreCountedNotRead) {
  const cli::DxfDrawing read = drawing(DxfText()
                                           .section("TABLES")
                                           .layer("Off", -7, 0)
                                           .end()
                                           .section("ENTITIES")
                                           .line("OFF", 0, 0, 1, 2)
                                           .entity("LINE", "a")
                                           .add(67, 1)
                                           .entity("DIMENSION", "a")
                                           .entity("LINE", "a")
                                           .add(10, "x")
                                           .end()
                                           .whole());
  EXPECT_EQ(read.skipped.at({"LINE", "a", "it is in paper space, not in the model"}), 1u);
  EXPECT_EQ(read.skipped.at({"DIMENSION", "a", "not a supported kind"}), 1u);
  EXPECT_EQ(read.skipped.at({"LINE", "a", "one of its numbers cannot be read, or is beyond 1e15"}),
            1u);
  EXPECT_TRUE(placed(read, Kind::line).empty());
}

TEST(DxfDrawing, BlocksStandScaledTurnedAndMirrored) {
  DxfText text;
  text.section("BLOCKS").block("B", 1, 0).line("0", 1, 0, 2, 0).add(0, "ENDBLK").end();
  text.section("ENTITIES").insert("b", "L", 10, 20, 3, "A").add(41, 2.0).add(50, 90.0);
  text.insert("B", "L", 0, 0, 0, "C").add(41, -1.0);
  text.insert("B", "L", 5, 0, 7, "D").add(230, -1.0).add(210, 0.0).add(220, 0.0).end();
  const cli::DxfDrawing read = drawing(text.whole());
  const auto lines = placed(read, Kind::line);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].layer, "L");
  expect_near(lines[0].at(0), {10, 20, 3});
  expect_near(lines[0].at(1), {10, 22, 3});
  expect_near(lines[1].at(1), {-1, 0, 0});
  // Seen from below: x and z are the other way round.
  expect_near(lines[2].at(0), {-5, 0, -7});
  expect_near(lines[2].at(1), {-6, 0, -7});
}

TEST(DxfDrawing, RowsAndColumnsAreManyReferences) {
  DxfText text;
  text.section("BLOCKS").block("B").line("0", 0, 0, 1, 0).add(0, "ENDBLK").end();
  text.section("ENTITIES").insert("B", "L", 0, 0, 0, "A").add(50, 90.0);
  text.add(70, 2).add(71, 3).add(44, 10.0).add(45, 100.0).end();
  const cli::DxfDrawing read = drawing(text.whole());
  const auto inserts = placed(read, Kind::insert);
  ASSERT_EQ(inserts.size(), 6u);
  expect_near(inserts[1].at(0), {0, 10, 0});
  expect_near(inserts[2].at(0), {-100, 0, 0});
  EXPECT_EQ(inserts[3].key, "A_1_1");
}

TEST(DxfDrawing, ReferencesHaveTheirAttributes) {
  DxfText text;
  text.section("BLOCKS").block("B").add(0, "ENDBLK").end();
  text.section("ENTITIES").insert("B", "L", 0, 0).add(66, 1);
  text.entity("ATTRIB", "0").add(1, "2800").add(2, "HEIGHT").entity("SEQEND", "L");
  text.entity("ATTRIB", "0").add(1, "lost").add(2, "HEIGHT").end();
  const cli::DxfDrawing read = drawing(text.whole());
  ASSERT_EQ(read.entity.size(), 1u);
  ASSERT_EQ(read.entity[0].attribute.size(), 1u);
  EXPECT_EQ(read.entity[0].attribute[0], std::pair(std::string("HEIGHT"), std::string("2800")));
  EXPECT_EQ(read.skipped.at({"ATTRIB", "0", "it does not belong to an INSERT"}), 1u);
}

TEST(DxfDrawing, ArcsAreChordsWithinTheError) {
  DxfText text;
  text.section("ENTITIES").entity("LWPOLYLINE", "a").add(70, 1);
  text.add(10, 1.0).add(20, 0.0).add(42, 1.0).add(10, -1.0).add(20, 0.0).add(42, 1.0).end();
  const cli::DxfDrawing read = drawing(text.whole());
  const auto circles = placed(read, Kind::polyline);
  ASSERT_EQ(circles.size(), 1u);
  const std::vector<glm::dvec3> corner = circles[0].corners(0.001);
  EXPECT_GT(corner.size(), 60u);
  EXPECT_LT(corner.size(), 100u);
  for (std::size_t i = 0; i < corner.size(); ++i) {
    EXPECT_NEAR(glm::length(corner[i]), 1.0, 1.0e-12);
    const glm::dvec3 middle = 0.5 * (corner[i] + corner[(i + 1) % corner.size()]);
    EXPECT_GT(glm::length(middle), 1.0 - 0.001);
  }
  // Counter-clockwise: a positive bulge from (1, 0) goes up.
  EXPECT_GT(corner[1].y, 0.0);
}

TEST(DxfDrawing, ChordsSayWhereALimitLeavesThemFartherAway) {
  constexpr double kError = 1.0e-3;
  DxfText text;
  text.section("BLOCKS").block("B").entity("CIRCLE", "0").at(0, 0).add(40, 1000.0);
  text.add(0, "ENDBLK").end().section("ENTITIES");
  text.entity("CIRCLE", "a").at(0, 0).add(40, 1000.0);  // 2222 chords are enough
  text.entity("CIRCLE", "a").at(0, 0).add(40, 1.0e6);
  text.entity("LWPOLYLINE", "a").add(70, 0).add(10, 0.0).add(20, 0.0).add(42, 1.0e10);
  text.add(10, 1.0).add(20, 0.0);
  text.insert("B", "a", 0, 0).add(41, 1000.0).end();
  const cli::DxfDrawing read = drawing(text.whole());
  const auto circles = placed(read, Kind::circle);
  ASSERT_EQ(circles.size(), 3u);
  double reached = 0.0;
  EXPECT_LT(circles[0].corners(kError, &reached).size(), 2500u);
  EXPECT_EQ(reached, kError);
  const std::vector<glm::dvec3> corner = circles[1].corners(kError, &reached);
  ASSERT_EQ(corner.size(), 4096u);
  EXPECT_NEAR(reached, 1.0e6 - glm::length(0.5 * (corner[0] + corner[1])), 1.0e-6);
  EXPECT_GT(reached, 0.29);
  circles[2].corners(kError, &reached);  // stretched 1000 times
  EXPECT_NEAR(reached, 0.294, 0.01);
  const auto lines = placed(read, Kind::polyline);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].corners(kError, &reached).size(), 2u);
  EXPECT_EQ(reached, 5.0e9);
}

TEST(DxfDrawing, HatchLoopsAreOutlines) {
  DxfText text;
  text.section("ENTITIES").entity("HATCH", "a", "5").at(0, 0).add(91, 2);
  text.add(92, 3).add(72, 0).add(73, 1).add(93, 3);
  text.add(10, 0.0).add(20, 0.0).add(10, 4.0).add(20, 0.0).add(10, 0.0).add(20, 3.0).add(97, 0);
  text.add(92, 1).add(93, 2).add(72, 1).add(10, 1.0).add(20, 0.0).add(11, -1.0).add(21, 0.0);
  text.add(72, 2).add(10, 0.0).add(20, 0.0).add(40, 1.0).add(50, 180.0).add(51, 360.0).add(73, 1);
  text.add(97, 0).end();
  const cli::DxfDrawing read = drawing(text.whole());
  ASSERT_EQ(read.entity.size(), 2u);
  EXPECT_EQ(read.entity[0].vertex.size(), 3u);
  EXPECT_EQ(read.entity[1].handle, "5_1");
  ASSERT_EQ(read.entity[1].vertex.size(), 3u);
  EXPECT_NEAR(read.entity[1].vertex[1].bulge, std::tan(3.14159265358979 / 8.0), 1.0e-12);
}

double area_of(const std::vector<glm::dvec3>& corner) {
  double twice = 0.0;
  for (std::size_t i = 0; i < corner.size(); ++i) {
    const glm::dvec3 &a = corner[i], &b = corner[(i + 1) % corner.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

// A circle of radius 3 as a rational spline of degree 2.
DxfText& circle_as_spline(DxfText& text, double last_knot, double weight) {
  text.entity("SPLINE", "a", "7").add(70, 5).add(71, 2).add(72, 12).add(73, 9);
  for (const double knot : {0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, last_knot, 4.0, 4.0}) {
    text.add(40, knot);
  }
  for (int i = 0; i < 9; ++i) text.add(41, i % 2 == 0 ? 1.0 : weight);
  const double x[] = {3, 3, 0, -3, -3, -3, 0, 3, 3}, y[] = {0, 3, 3, 3, 0, -3, -3, -3, 0};
  for (int i = 0; i < 9; ++i) text.at(x[i], y[i]);
  return text;
}

TEST(DxfDrawing, EllipsesAndSplinesAreTheirClosedForms) {
  constexpr double kPi = 3.14159265358979323846, kError = 1.0e-3;
  DxfText text;
  text.section("ENTITIES");
  text.entity("ELLIPSE", "a").at(3, 4).add(11, 5.0).add(21, 1.0).add(31, 0.0).add(40, 0.4);
  text.add(41, 0.0).add(42, 2.0 * kPi);
  circle_as_spline(text, 4.0, std::sqrt(0.5)).end();
  const cli::DxfDrawing read = drawing(text.whole());
  const auto found = placed(read, Kind::curve);
  ASSERT_EQ(found.size(), 2u);
  // Chords lie within: the area is too small by at most the error along the whole line.
  const double ellipse = area_of(found[0].corners(kError)), of_ellipse = 0.4 * 26.0 * kPi;
  EXPECT_LT(ellipse, of_ellipse);
  EXPECT_GT(ellipse, of_ellipse - kError * 2.0 * kPi * std::sqrt(26.0));
  const double circle = area_of(found[1].corners(kError)), of_circle = 9.0 * kPi;
  EXPECT_LT(circle, of_circle);
  EXPECT_GT(circle, of_circle - kError * 6.0 * kPi);
  for (const glm::dvec3& corner : found[1].corners(kError)) {
    EXPECT_NEAR(glm::length(corner), 3.0, 1.0e-12);
  }
}

TEST(DxfDrawing, LargeSplinesSayHowFarTheirChordsAre) {
  DxfText text;
  text.section("ENTITIES").entity("SPLINE", "a").add(70, 0).add(71, 2);
  for (const double knot : {0.0, 0.0, 0.0, 1.0, 1.0, 1.0}) text.add(40, knot);
  text.at(0, 0).at(2.0e6, 4.0e6).at(4.0e6, 0).end();
  const cli::DxfDrawing read = drawing(text.whole());
  const auto found = placed(read, Kind::curve);
  ASSERT_EQ(found.size(), 1u);
  double reached = 0.0;
  found[0].corners(10.0, &reached);
  EXPECT_EQ(reached, 10.0);
  const std::vector<glm::dvec3> corner = found[0].corners(1.0e-3, &reached);
  double farthest = 0.0;  // of the parabola y = 2 x - x^2 / 2e6 from the middles of the chords
  for (std::size_t i = 0; i + 1 < corner.size(); ++i) {
    const glm::dvec3 middle = 0.5 * (corner[i] + corner[i + 1]);
    farthest = std::max(farthest, 2.0 * middle.x - middle.x * middle.x / 2.0e6 - middle.y);
  }
  EXPECT_GT(reached, 1.0);
  EXPECT_GT(reached, 0.5 * farthest);
  EXPECT_LE(reached, 1.0e-6 * std::sqrt(32.0) * 1.0e6);
}

TEST(DxfDrawing, SplinesThatAreNoneAreCountedWithTheirReason) {
  const auto why = [](const std::string& text) {
    const cli::DxfDrawing read = drawing(text);
    EXPECT_TRUE(read.entity.empty());
    return read.skipped.empty() ? std::string() : read.skipped.begin()->first[2];
  };
  DxfText back, weight, fit, degree;
  back.section("ENTITIES");
  EXPECT_EQ(why(circle_as_spline(back, 2.5, 1.0).end().whole()),
            "its knots are not in ascending order");
  weight.section("ENTITIES");
  EXPECT_EQ(why(circle_as_spline(weight, 4.0, -1.0).end().whole()),
            "one of its weights is not above 0");
  fit.section("ENTITIES").entity("SPLINE", "a").add(71, 3).add(11, 0.0).add(21, 1.0).end();
  EXPECT_EQ(why(fit.whole()), "it has no control points");
  degree.section("ENTITIES").entity("SPLINE", "a").add(71, 2000000).at(0, 0).end();
  EXPECT_EQ(why(degree.whole()), "its degree is not 1 to 25");
}

TEST(DxfDrawing, SolidsAreFaces) {
  DxfText text;
  text.section("ENTITIES").entity("SOLID", "a").at(0, 0).add(11, 4.0).add(21, 0.0);
  text.add(12, 0.0).add(22, 3.0).add(13, 4.0).add(23, 3.0).end();
  const cli::DxfDrawing read = drawing(text.whole());
  const auto found = placed(read, Kind::face);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(area_of(found[0].corners(0.1)), 12.0);
}

TEST(DxfDrawing, OldPolylinesAndMeshes) {
  DxfText text;
  text.section("ENTITIES").entity("POLYLINE", "a").at(0, 0, 2.5).add(66, 1).add(70, 1);
  text.entity("VERTEX", "a").at(1, 2).add(42, 0.5).entity("VERTEX", "a").at(3, 4);
  text.entity("VERTEX", "a").at(9, 9).add(70, 16).entity("SEQEND", "a");
  text.entity("POLYLINE", "a").at(0, 0).add(66, 1).add(70, 64);
  text.entity("VERTEX", "a").at(1, 2, 3).add(70, 192);
  text.entity("VERTEX", "a").at(0, 0, 0).add(70, 128).add(71, 1).entity("SEQEND", "a").end();
  const cli::DxfDrawing read = drawing(text.whole());
  ASSERT_EQ(read.entity.size(), 2u);
  ASSERT_EQ(read.entity[0].vertex.size(), 2u);
  expect_near(read.entity[0].vertex[0].at, {1, 2, 2.5});
  EXPECT_EQ(read.entity[0].vertex[0].bulge, 0.5);
  EXPECT_EQ(read.entity[1].kind, Kind::mesh);
  EXPECT_EQ(read.entity[1].vertex.size(), 1u);
}

TEST(DxfDrawing, DynamicBlocksHaveTheNameThatPeopleKnow) {
  DxfText text;
  text.section("TABLES");
  text.add(0, "BLOCK_RECORD").add(5, "1A").add(2, "Lamp");
  text.add(0, "BLOCK_RECORD").add(5, "2B").add(2, "*U7").add(1001, "AcDbBlockRepBTag");
  text.add(1070, 1).add(1005, "1A").end();
  text.section("BLOCKS").block("*U7").add(0, "ENDBLK").end();
  text.section("ENTITIES").insert("*U7", "L", 0, 0).end();
  const cli::DxfDrawing read = drawing(text.whole());
  ASSERT_EQ(read.entity.size(), 1u);
  EXPECT_EQ(read.entity[0].block, "Lamp");
  EXPECT_EQ(read.entity[0].block_in_file, "*U7");
}

TEST(DxfDrawing, BlocksThatNestForEverAreRefused) {
  DxfText circle;
  circle.section("BLOCKS").block("A").insert("A", "0", 0, 0).add(0, "ENDBLK").end();
  circle.section("ENTITIES").insert("A", "0", 0, 0).end();
  DxfText many;  // 1000^3 references
  many.section("BLOCKS").block("A").add(0, "ENDBLK");
  many.block("B").insert("A", "0", 0, 0).add(70, 1000).add(0, "ENDBLK");
  many.block("C").insert("B", "0", 0, 0).add(70, 1000).add(0, "ENDBLK").end();
  many.section("ENTITIES").insert("C", "0", 0, 0).add(70, 1000).end();
  cli::DxfSkipped skipped;
  const auto all = [](const cli::DxfPlaced&) { return true; };
  EXPECT_THAT(cli::visit_dxf(drawing(circle.whole()), all, skipped),
              HasSubstr("contain themselves"));
  EXPECT_THAT(cli::visit_dxf(drawing(many.whole()), all, skipped), HasSubstr("more than 1000000"));
}

TEST(DxfDrawing, FilesThatWereCutAreRefused) {
  const std::string text = DxfText().section("ENTITIES").line("a", 0, 0, 1, 2).end().without_end();
  EXPECT_THAT(drawing(text).end_doubt, HasSubstr("0 EOF, is missing"));
  for (std::size_t size = 0; size < text.size() - 1; ++size) {
    std::string problem;
    EXPECT_FALSE(cli::read_dxf(text.substr(0, size), problem)) << size;
    EXPECT_NE(problem, "");
  }
}

}  // namespace
}  // namespace dxf_drawing_test
