#include "report/tools/import/dxf_design.h"

#include "calc/scene/polygon.h"
#include "report/tools/import/dxf_outlines.h"
#include "report/tools/import/dxf_unit.h"
#include "tests/unit/report/tools/import/dxf_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace dxf_design_test {
namespace {

using test_support::DxfText;
using ::testing::HasSubstr;

cli::ImportMap a_map() {
  cli::ImportMap map;
  map.room.push_back({"ROOM", "NAME", 2.8, 0.7, 0.5, 0.2, {}, false, 1});
  cli::MapLuminaire luminaire;
  luminaire.type = "LUM*";
  luminaire.height = {cli::FromAttribute{"H"}, cli::FromZ{}};
  map.luminaire.push_back(luminaire);
  return map;
}

cli::Design design(const std::string& text, const cli::ImportMap& map,
                   const std::string& unit = "mm") {
  std::string problem;
  const auto drawing = cli::read_dxf(text, problem);
  EXPECT_TRUE(drawing) << problem;
  auto made = cli::design_of_dxf(*drawing, "plan.dxf", map, unit, problem);
  EXPECT_EQ(problem, "");
  return made ? std::move(*made) : cli::Design();
}

bool has_note(const cli::Design& design, cli::DesignNote::Kind kind, const std::string& part,
              std::size_t count = 1) {
  for (const cli::DesignNote& note : design.note) {
    const std::string all = note.what + ": " + note.why;
    if (note.kind == kind && all.find(part) != all.npos && note.count == count) return true;
  }
  return false;
}
using NoteKind = cli::DesignNote::Kind;

TEST(DxfDesign, OutlinesAreRoomsWithTheirNames) {
  DxfText text;
  text.section("ENTITIES").rectangle("room", 0, 0, 6000, 4000, "1F");
  text.entity("TEXT", "NAME").at(100, 100).add(1, "Office");
  text.entity("TEXT", "NAME").at(100, 3000).add(1, "101").end();
  const cli::Design made = design(text.whole(), a_map());
  ASSERT_EQ(made.room.size(), 1u);
  EXPECT_EQ(made.room[0].name, "101 Office");
  EXPECT_EQ(made.room[0].source.key, "1F");
  EXPECT_DOUBLE_EQ(calc::signed_area(made.room[0].outline_m), 24.0);
  EXPECT_TRUE(has_note(made, NoteKind::left_out, "the drawing has no block LUM*"));
}

TEST(DxfDesign, LinesThatMeetAreAnOutline) {
  DxfText text;
  text.section("ENTITIES").line("ROOM", 0, 0, 6000, 0).line("ROOM", 6000, 4000, 6000, 0);
  text.line("ROOM", 6000, 4000, 0, 4000).line("ROOM", 0, 0.4, 0, 4000);
  text.line("ROOM", 9000, 0, 9000, 5).end();
  const cli::Design made = design(text.whole(), a_map());
  ASSERT_EQ(made.room.size(), 1u);
  EXPECT_NEAR(calc::signed_area(made.room[0].outline_m), 24.0, 0.01);
  EXPECT_TRUE(has_note(made, NoteKind::left_out, "lines do not meet"));
}

TEST(DxfDesign, OpenOutlinesAreClosedOnlyOnRequest) {
  DxfText text;
  text.section("ENTITIES").entity("LWPOLYLINE", "ROOM").add(70, 0);
  text.add(10, 0).add(20, 0).add(10, 5000).add(20, 0).add(10, 5000).add(20, 4000).end();
  cli::ImportMap map = a_map();
  EXPECT_TRUE(design(text.whole(), map).room.empty());
  map.room[0].closes = true;
  EXPECT_EQ(design(text.whole(), map).room.size(), 1u);
}

DxfText& loop(DxfText& text, double x, double y, double width, double depth) {
  text.add(92, 3).add(72, 0).add(73, 1).add(93, 4);
  text.add(10, x).add(20, y).add(10, x + width).add(20, y);
  text.add(10, x + width).add(20, y + depth).add(10, x).add(20, y + depth);
  return text.add(97, 0);
}

// A room with a courtyard in which a house stands.
TEST(DxfDesign, LoopsOfAHatchWithinItAreHoles) {
  DxfText text;
  text.section("ENTITIES").entity("HATCH", "ROOM", "5").at(0, 0).add(91, 3);
  loop(text, 4000, 4000, 2000, 2000);
  loop(text, 0, 0, 10000, 10000);
  loop(text, 3000, 3000, 4000, 4000);
  text.entity("HATCH", "ROOM", "6").at(0, 0).add(91, 1);
  loop(text, 1000, 1000, 1500, 1500).end();
  const cli::Design made = design(text.whole(), a_map());
  ASSERT_EQ(made.room.size(), 3u);
  EXPECT_EQ(calc::signed_area(made.room[0].outline_m), 4.0);
  EXPECT_TRUE(made.room[0].hole_m.empty());
  EXPECT_EQ(calc::signed_area(made.room[1].outline_m), 100.0);
  ASSERT_EQ(made.room[1].hole_m.size(), 1u);
  EXPECT_EQ(calc::signed_area(made.room[1].hole_m[0]), -16.0);
  // Of another hatch: both are rooms.
  EXPECT_TRUE(has_note(made, NoteKind::doubt, "its outline is inside that of another room", 1));
}

TEST(DxfDesign, CrossingOutlinesAreLeftOut) {
  DxfText text;
  text.section("ENTITIES").entity("LWPOLYLINE", "ROOM").add(70, 1);
  text.add(10, 0).add(20, 0).add(10, 5000).add(20, 4000).add(10, 5000).add(20, 0);
  text.add(10, 0).add(20, 4000).end();
  const cli::Design made = design(text.whole(), a_map());
  EXPECT_TRUE(made.room.empty());
  EXPECT_TRUE(has_note(made, NoteKind::left_out, "its sides cross or touch each other"));
}

TEST(DxfDesign, CurvesThatAreTooLargeForTheirChordsAreSaid) {
  DxfText text;
  text.section("ENTITIES").rectangle("ROOM", 0, 0, 6000, 4000);
  text.entity("ARC", "ROUTE").at(0, 0).add(40, 5.0e10).add(50, 0.0).add(51, 90.0);
  text.entity("ARC", "ROUTE").at(0, 0).add(40, 2000.0).add(50, 0.0).add(51, 90.0).end();
  cli::ImportMap map = a_map();
  map.route.emplace_back();
  map.route[0].layer = "ROUTE";
  const cli::Design made = design(text.whole(), map);
  EXPECT_EQ(made.route.size(), 1u);
  EXPECT_TRUE(has_note(made, NoteKind::doubt, "its chords are up to 1 m from it, not 0.001 m"));
}

DxfText with_luminaires() {
  DxfText text;
  text.section("BLOCKS").block("LUM_A").line("0", -300, 0, 300, 0).add(0, "ENDBLK").end();
  text.section("ENTITIES").rectangle("ROOM", 0, 0, 6000, 4000);
  return text;
}

TEST(DxfDesign, HeightsComeInTheOrderOfTheMap) {
  DxfText text = with_luminaires();
  text.insert("LUM_A", "L", 1000, 1000, 2500, "A").add(66, 1);
  text.entity("ATTRIB", "0").add(1, "2,7 m").add(2, "H").entity("SEQEND", "L");
  text.insert("LUM_A", "L", 2000, 1000, 2500, "B");
  text.insert("LUM_A", "L", 3000, 1000, 0, "C");
  text.insert("LUM_A", "L", 4000, 1000, 2500, "D").add(66, 1);
  text.entity("ATTRIB", "0").add(1, "high").add(2, "H").entity("SEQEND", "L").end();
  const cli::Design made = design(text.whole(), a_map());
  ASSERT_EQ(made.luminaire.size(), 4u);
  EXPECT_DOUBLE_EQ(made.luminaire[0].position_m.z, 2.7);
  EXPECT_DOUBLE_EQ(made.luminaire[1].position_m.z, 2.5);
  EXPECT_FALSE(made.luminaire[2].has_height);
  EXPECT_DOUBLE_EQ(made.luminaire[3].position_m.z, 2.5);
  EXPECT_TRUE(has_note(made, NoteKind::doubt, "its attribute H is not a height"));
}

TEST(DxfDesign, PartsAtOnePlaceAreOneLuminaire) {
  DxfText text = with_luminaires();
  text.insert("LUM_A", "L", 1000, 1000, 2500, "A").insert("LUM_A", "L", 1000, 1000, 2500, "B");
  text.insert("LUM_A", "L", 1000, 1001, 2500, "C").end();
  const cli::Design made = design(text.whole(), a_map());
  EXPECT_EQ(made.luminaire.size(), 2u);
  EXPECT_TRUE(has_note(made, NoteKind::taken, "parts of a luminaire"));
}

TEST(DxfDesign, TurnsAndMirrorsAreKept) {
  DxfText text = with_luminaires();
  text.insert("LUM_A", "L", 1000, 1000, 2500, "A").add(50, -90.27);
  text.insert("LUM_A", "L", 2000, 1000, 2500, "B").add(41, -1.0).add(50, 90.0);
  text.insert("LUM_A", "L", 3000, 1000, 2500, "C").add(210, 1.0).add(220, 0.0).add(230, 0.0).end();
  const cli::Design made = design(text.whole(), a_map());
  ASSERT_EQ(made.luminaire.size(), 2u);
  EXPECT_NEAR(made.luminaire[0].rotation_deg, 269.73, 1.0e-9);
  EXPECT_TRUE(made.luminaire[1].is_mirrored);
  EXPECT_DOUBLE_EQ(made.luminaire[1].rotation_deg, 270.0);
  EXPECT_TRUE(has_note(made, NoteKind::left_out, "it is tilted"));
}

// Of faces and meshes only the box is written, and how high they are drawn is said.
TEST(DxfDesign, FacesOfFurnitureAreSaid) {
  DxfText text;
  text.section("BLOCKS").block("CHAIR");
  text.entity("3DFACE", "0").at(0, 0, 450).add(11, 500).add(21, 0).add(31, 450);
  text.add(12, 500).add(22, 500).add(32, 450).add(13, 0).add(23, 500).add(33, 450);
  text.entity("POLYLINE", "0").at(0, 0).add(66, 1).add(70, 64);
  text.entity("VERTEX", "0").at(0, 0, 0).add(70, 192);
  text.entity("VERTEX", "0").at(500, 500, 900).add(70, 192);
  text.entity("VERTEX", "0").at(0, 0, 0).add(70, 128).add(71, 1).entity("SEQEND", "0");
  text.add(0, "ENDBLK").end().section("ENTITIES").rectangle("ROOM", 0, 0, 6000, 4000);
  text.insert("CHAIR", "F", 2000, 1000).add(43, 2.0);
  text.entity("3DFACE", "F").at(0, 0).add(11, 1).add(21, 0).add(12, 1).add(22, 1).end();
  cli::ImportMap map = a_map();
  map.furniture.push_back({"", "F", 0.75, 0.4, 1});
  const cli::Design made = design(text.whole(), map);
  ASSERT_EQ(made.box.size(), 1u);
  EXPECT_DOUBLE_EQ(made.box[0].size_m.z, 0.75);
  EXPECT_TRUE(
      has_note(made, NoteKind::taken,
               "its block has 1 3DFACE, SOLID and TRACE and 1 meshes; only the upright box around "
               "them is written. It is 0.75 m high as the map says, and 1.8"));
  EXPECT_TRUE(has_note(made, NoteKind::left_out, "loose faces are not furniture"));
}

// So that a small file cannot ask for days of work, or for all memory.
TEST(DxfDesign, BlocksThatMultiplyAreRefusedSoon) {
  const auto problem_of = [](const std::string& text, const cli::ImportMap& map) {
    std::string problem;
    const auto drawing = cli::read_dxf(text, problem);
    EXPECT_TRUE(drawing) << problem;
    EXPECT_FALSE(cli::design_of_dxf(*drawing, "plan.dxf", map, "mm", problem));
    return problem;
  };
  DxfText lamps = with_luminaires();
  lamps.insert("LUM_A", "L", 1, 1, 2500).add(70, 400).add(71, 400).end();
  EXPECT_EQ(problem_of(lamps.whole(), a_map()), "this drawing has more than 100000 luminaires");
  DxfText names = with_luminaires();
  names.insert("LUM_A", "L", 1, 1, 2500).add(70, 300).add(71, 300).add(44, 1.0).add(45, 1.0);
  names.add(66, 1).entity("ATTRIB", "0").add(1, std::string(5000, 'x')).add(2, "N");
  names.entity("SEQEND", "0").end();
  EXPECT_THAT(problem_of(names.whole(), a_map()), HasSubstr("more than 100000000 bytes long"));
  DxfText circles;  // a room of 1000 corners, 100 times at one place
  circles.section("BLOCKS").block("B").entity("CIRCLE", "0").at(0, 0).add(40, 200000.0);
  circles.add(0, "ENDBLK").end().section("ENTITIES");
  circles.insert("B", "ROOM", 0, 0).add(70, 100).end();
  std::string problem;
  const auto drawing = cli::read_dxf(circles.whole(), problem);
  ASSERT_TRUE(drawing);
  const auto made = cli::design_of_dxf(*drawing, "plan.dxf", a_map(), "mm", problem);
  ASSERT_TRUE(made) << problem;
  EXPECT_EQ(made->room.size(), 100u);
  EXPECT_TRUE(has_note(*made, NoteKind::doubt, "not all were compared"));
}

TEST(DxfDesign, SoManyCrossingOutlinesAreNotMended) {
  cli::PlanPiece star;
  star.is_closed = true;
  for (int i = 0; i < 2000; ++i) {
    const double angle = 2.4 * i;
    star.point.emplace_back(5000.0 * std::cos(angle), 5000.0 * std::sin(angle), 0.0);
  }
  const cli::PlanOutlines found =
      cli::find_outlines(std::vector<cli::PlanPiece>(2000, star), 1.0, false);
  EXPECT_TRUE(found.outline.empty());
  ASSERT_EQ(found.failure.size(), 2000u);
  EXPECT_EQ(found.failure.front().why, "its sides cross or touch each other");
  EXPECT_THAT(found.failure.back().why, HasSubstr("was not checked"));
}

TEST(DxfDesign, BlocksThatAreTooMuchToMeasureAreLeftOut) {
  DxfText text;
  text.section("BLOCKS").block("A").line("0", 0, 0, 1, 1).add(0, "ENDBLK");
  text.block("B").insert("A", "0", 0, 0).add(70, 700).add(71, 700).add(0, "ENDBLK");
  text.block("C").line("0", 0, 0, 500, 500).add(0, "ENDBLK");
  text.end().section("ENTITIES").rectangle("ROOM", 0, 0, 6000, 4000);
  text.insert("C", "F", 1000, 1000).insert("B", "F", 2000, 1000).end();
  cli::ImportMap map = a_map();
  map.furniture.push_back({"", "F", 0.75, 0.4, 1});
  std::string problem;
  const auto drawing = cli::read_dxf(text.whole(), problem);
  ASSERT_TRUE(drawing);
  std::size_t work = 1000;
  EXPECT_EQ(cli::extent_of_block(*drawing, "C", work).problem, "");
  EXPECT_LT(work, 1000u);
  const cli::DxfExtent large = cli::extent_of_block(*drawing, "B", work);
  EXPECT_FALSE(large.is_any);
  EXPECT_EQ(large.problem, "measuring the blocks of this drawing takes too long");
  EXPECT_EQ(design(text.whole(), map).box.size(), 2u);
}

TEST(DxfDesign, FurnitureIsABoxAsTheBlockStands) {
  DxfText text;
  text.section("BLOCKS").block("DESK", 100, 0).rectangle("0", 100, 0, 1600, 800);
  text.add(0, "ENDBLK").end();
  text.section("ENTITIES").rectangle("ROOM", 0, 0, 6000, 4000);
  text.insert("DESK", "F", 3000, 1000, 0, "A").add(50, 90.0).end();
  cli::ImportMap map = a_map();
  map.furniture.push_back({"DESK", "", 0.75, 0.4, 9});
  const cli::Design made = design(text.whole(), map);
  ASSERT_EQ(made.box.size(), 1u);
  EXPECT_NEAR(made.box[0].centre_m.x, 2.6, 1.0e-12);
  EXPECT_NEAR(made.box[0].centre_m.y, 1.8, 1.0e-12);
  EXPECT_NEAR(made.box[0].size_m.x, 1.6, 1.0e-12);
  EXPECT_DOUBLE_EQ(made.box[0].rotation_deg, 90.0);
}

TEST(DxfDesign, FarDrawingsGetAnOriginOfTheirOwn) {
  DxfText text;
  text.section("ENTITIES").rectangle("ROOM", 4500123456.0, 100.0, 6000, 4000).end();
  const cli::Design made = design(text.whole(), a_map());
  EXPECT_EQ(made.origin_m, glm::dvec3(4500000.0, 0.0, 0.0));
  ASSERT_EQ(made.room.size(), 1u);
  EXPECT_NEAR(made.room[0].outline_m[0].x, 123.456, 1.0e-6);
}

TEST(DxfDesign, WhatIsAskedForAndHiddenIsSaid) {
  DxfText text;
  text.section("TABLES").layer("ROOM", -7, 0).end();
  text.section("ENTITIES").rectangle("ROOM", 0, 0, 6000, 4000).entity("DIMENSION", "ROOM").end();
  const cli::Design made = design(text.whole(), a_map());
  EXPECT_TRUE(made.room.empty());
  EXPECT_TRUE(has_note(made, NoteKind::left_out, "its layer is off or frozen"));
  EXPECT_TRUE(has_note(made, NoteKind::left_out, "DIMENSION: not a supported kind"));
}

TEST(ImportUnit, StatedUnitsWin) {
  const cli::ImportUnit unit = cli::choose_unit("mm", "--unit", 1, true, {});
  EXPECT_EQ(unit.name, "mm");
  EXPECT_EQ(unit.reason, "stated by --unit; the header says in");
}

TEST(ImportUnit, HeadersAreBelievedOnlyWhereRoomsAreRooms) {
  const std::vector<double> areas = {24.0e6, 30.0e6, 36.0e6};
  EXPECT_EQ(cli::choose_unit("", "", 4, false, areas).name, "mm");
  // The same in inches: 20000 m2.
  const cli::ImportUnit inch = cli::choose_unit("", "", 1, false, areas);
  EXPECT_EQ(inch.name, "");
  EXPECT_THAT(inch.problem, HasSubstr("30 m2 in mm"));
  // No room from 1.5 to 900 m2 passes with inch and mm exchanged, either way.
  for (double area = 1.5; area < 900.0; area *= 1.1) {
    const double inch_m = 0.0254, mm_m = 0.001;
    EXPECT_EQ(cli::choose_unit("", "", 1, false, {area / (mm_m * mm_m)}).name, "") << area;
    EXPECT_EQ(cli::choose_unit("", "", 4, false, {area / (inch_m * inch_m)}).name, "") << area;
  }
  EXPECT_NE(cli::choose_unit("", "", 4, true, areas).problem, "");
  EXPECT_NE(cli::choose_unit("", "", {}, false, areas).problem, "");
  EXPECT_NE(cli::choose_unit("", "", 4, false, {}).problem, "");
}

TEST(SuggestMap, IsReadBack) {
  DxfText text = with_luminaires();
  text.insert("LUM_A", "L", 1000, 1000, 2500).end();
  std::string problem;
  const auto drawing = cli::read_dxf(text.whole(), problem);
  ASSERT_TRUE(drawing);
  std::string map = cli::suggest_map(*drawing, "plan.dxf");
  EXPECT_THAT(map, HasSubstr("\"LUM_A\": 1 times, on \"L\""));
  calc::Diagnostics diagnostics;
  EXPECT_TRUE(cli::read_import_map(map, "map.toml", diagnostics));
  // With the first room taken in.
  const std::size_t at = map.find("# [[room]]");
  ASSERT_NE(at, map.npos);
  for (std::size_t line = at; map[line] == '#'; line = map.find('\n', line) + 1) map.erase(line, 2);
  const auto read = cli::read_import_map(map, "map.toml", diagnostics);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->room.size(), 1u);
}

}  // namespace
}  // namespace dxf_design_test
