#include "calc/meshes/gbxml.h"
#include "calc/base/file_reader.h"
#include "tests/support/gbxml_samples.h"
#include "tests/support/mesh_samples.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

namespace calc::tests::gbxml_test {
namespace {

struct Room {
  std::optional<GbxmlRoom> room;
  std::string messages;
};

Room room_of(const std::string& xml, const std::string& space = "low") {
  Diagnostics diagnostics;
  Room result;
  if (const auto building = parse_gbxml(xml, "b.xml", diagnostics)) {
    result.room = gbxml_room(*building, space, {"p.xml", 3, 0}, diagnostics);
  }
  for (const Diagnostic& d : diagnostics.all()) {
    result.messages += (result.messages.empty() ? "" : "\n") + format_diagnostic(d);
  }
  EXPECT_EQ(result.room.has_value(), !diagnostics.has_errors()) << result.messages;
  return result;
}

double area(const GbxmlPart& part) {
  double sum = 0.0;
  for (const glm::uvec3& t : part.triangle) {
    sum += 0.5 * glm::length(glm::cross(part.vertex_m[t.y] - part.vertex_m[t.x],
                                        part.vertex_m[t.z] - part.vertex_m[t.x]));
  }
  return sum;
}

// "id type": area
std::map<std::string, double> areas(const GbxmlRoom& room) {
  std::map<std::string, double> list;
  for (const GbxmlPart& part : room.part) list[part.id + " " + part.type] += area(part);
  return list;
}

TEST(Gbxml, ARoomIsTheSurfacesNextToItsSpace) {
  const Room low = room_of(two_rooms());
  ASSERT_TRUE(low.room) << low.messages;
  EXPECT_EQ(low.messages, "");
  EXPECT_EQ(low.room->name, "Low room");
  const std::map<std::string, double> found = areas(*low.room);
  ASSERT_EQ(found.size(), 7u);
  EXPECT_NEAR(found.at("slab SlabOnGrade"), 12.0, 1e-12);
  EXPECT_NEAR(found.at("west InteriorWall"), 7.5, 1e-12);
  EXPECT_NEAR(found.at("south ExteriorWall"), 8.0, 1e-12) << "without its window";
  EXPECT_NEAR(found.at("window FixedWindow"), 2.0, 1e-12);
  EXPECT_EQ(low.room->footprint_m.size(), 4u);
  EXPECT_DOUBLE_EQ(low.room->height_m, 2.5);
}

TEST(Gbxml, ASlabIsACeilingFromBelowAndAFloorFromAbove) {
  EXPECT_TRUE(areas(*room_of(two_rooms()).room).contains("deck Ceiling"));
  const Room high = room_of(two_rooms(), "high");
  EXPECT_TRUE(areas(*high.room).contains("deck InteriorFloor"));
  EXPECT_DOUBLE_EQ(high.room->floor_z_m, 2.5);
  const std::string stated =
      with(two_rooms(), R"(spaceIdRef="high"/><AdjacentSpaceId spaceIdRef="low")",
           R"(spaceIdRef="high"/><AdjacentSpaceId spaceIdRef="low" surfaceType="Air")");
  EXPECT_TRUE(areas(*room_of(stated).room).contains("deck Air"));
}

TEST(Gbxml, TheSpacesOwnOutlineIsTheFootprint) {
  const std::string outline = poly_loop({{0.1, 0.1, 0}, {3.9, 0.1, 0}, {0.1, 2.9, 0}});
  const Room low = room_of(with(two_rooms(), "Low room </Name>", "Low room </Name>" + outline));
  ASSERT_TRUE(low.room) << low.messages;
  EXPECT_EQ(low.room->footprint_m.size(), 3u);
  const std::string sloped = poly_loop({{0.1, 0.1, 0}, {3.9, 0.1, 0}, {0.1, 2.9, 0.5}});
  EXPECT_TRUE(room_of(with(two_rooms(), "Low room </Name>", "Low room </Name>" + sloped))
                  .room->footprint_m.empty());
  // Without an outline, a floor in two pieces is none.
  const std::string piece =
      gbxml_surface("more", "SlabOnGrade", {"low"}, {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  EXPECT_TRUE(
      room_of(with(two_rooms(), "</Campus>", piece + "</Campus>")).room->footprint_m.empty());
}

TEST(Gbxml, PrefixesAndUnitsAreUnderstood) {
  std::string xml = with(two_rooms(), "\"Meters\"", "\"Feet\"");
  for (const std::string tag :
       {"gbXML", "Campus", "Surface", "PolyLoop", "Coordinate", "Opening", "Space", "Building",
        "CartesianPoint", "AdjacentSpaceId", "PlanarGeometry", "Name"}) {
    for (const std::string start : {"<", "</"}) {
      for (std::size_t at = xml.find(start + tag); at != std::string::npos;
           at = xml.find(start + tag, at + 1)) {
        const char next = xml[at + start.size() + tag.size()];
        if (next == ' ' || next == '>' || next == '/') xml.insert(at + start.size(), "ns0:");
      }
    }
  }
  EXPECT_TRUE(is_gbxml(xml));
  const Room low = room_of(xml);
  ASSERT_TRUE(low.room) << low.messages;
  EXPECT_NEAR(areas(*low.room).at("slab SlabOnGrade"), 12.0 * 0.3048 * 0.3048, 1e-12);
}

TEST(Gbxml, OverlappingOpeningsCountOnce) {
  const std::string two =
      gbxml_opening("a", "FixedWindow", {{1, 0, 1}, {3, 0, 1}, {3, 0, 2}, {1, 0, 2}}) +
      // An arrow: concave, and half of it over the first one.
      gbxml_opening("b", "NonSlidingDoor", {{2, 0, 0}, {3.5, 0, 1.5}, {2, 0, 1}, {0.5, 0, 1.5}});
  const Room low = room_of(two_rooms(two));
  ASSERT_TRUE(low.room) << low.messages;
  const std::map<std::string, double> found = areas(*low.room);
  double all = 0.0;
  for (const char* id : {"south ExteriorWall", "a FixedWindow", "b NonSlidingDoor"}) {
    all += found.at(id);
  }
  EXPECT_NEAR(all, 10.0, 1e-9);
  EXPECT_NEAR(found.at("a FixedWindow"), 2.0, 1e-9);
  // The arrow has 1.5 m2, of which 0.5 above z = 1 and within x = 1 to 3 lie in the window.
  EXPECT_LT(found.at("b NonSlidingDoor"), 1.5);
}

// A spike in a floor, one in a window, a keyhole in a ceiling: all of their light is there.
TEST(Gbxml, BrokenOutlinesAreMendedAndSaid) {
  const std::string floor =
      poly_loop({{0, 0, 0}, {0, 3, 0}, {4, 3, 0}, {4, 7, 9}, {4, 3, 0}, {4, 0, 0}, {4, 0, 0}});
  const std::string window =
      gbxml_opening("window", "FixedWindow",
                    {{1, 0, 1}, {3, 0, 1}, {3, 0, 2}, {3, 0, 2.4}, {3, 0, 2}, {1, 0, 2}});
  const std::string deck = poly_loop({{0, 0, 2.5},
                                      {1, 1, 2.5},
                                      {1, 2, 2.5},
                                      {3, 2, 2.5},
                                      {3, 1, 2.5},
                                      {1, 1, 2.5},
                                      {0, 0, 2.5},
                                      {4, 0, 2.5},
                                      {4, 3, 2.5},
                                      {0, 3, 2.5}});
  std::string xml =
      with(two_rooms(window), poly_loop({{0, 0, 0}, {0, 3, 0}, {4, 3, 0}, {4, 0, 0}}), floor);
  xml = with(xml, poly_loop({{0, 0, 2.5}, {4, 0, 2.5}, {4, 3, 2.5}, {0, 3, 2.5}}), deck);
  const Room low = room_of(xml);
  ASSERT_TRUE(low.room) << low.messages;
  const std::map<std::string, double> found = areas(*low.room);
  EXPECT_NEAR(found.at("slab SlabOnGrade"), 12.0, 1e-12);
  EXPECT_NEAR(found.at("window FixedWindow"), 2.0, 1e-12);
  EXPECT_NEAR(found.at("south ExteriorWall"), 8.0, 1e-12);
  EXPECT_NEAR(found.at("deck Ceiling"), 10.0, 1e-12);
  EXPECT_EQ(low.room->footprint_m.size(), 4u);
  EXPECT_DOUBLE_EQ(low.room->height_m, 2.5);
  EXPECT_EQ(low.room->polygons_mended, 3u);
  EXPECT_EQ(low.room->polygons_left_out, 0u);
  EXPECT_NE(low.messages.find(
                "warning[gbxml-mended]: 3 polygons around space 'low' were mended and keep their "
                "areas: 1 doubled corner, 2 spikes, 1 joined hole or part; the longest part that "
                "was removed is 9.85 m, at (4.000, 7.000, 9.000) m, of 'slab'"),
            std::string::npos)
      << low.messages;
}

TEST(Gbxml, WhatCannotBeMendedIsMissingWithItsArea) {
  const std::string tie = poly_loop({{0, 0, 0}, {4, 3, 0}, {4, 0, 0}, {0, 3, 0}});
  const Room low =
      room_of(with(two_rooms(), poly_loop({{0, 0, 0}, {0, 3, 0}, {4, 3, 0}, {4, 0, 0}}), tie));
  ASSERT_TRUE(low.room) << low.messages;
  EXPECT_EQ(low.room->polygons_left_out, 1u);
  EXPECT_NE(
      low.messages.find("'slab' was left out: it has no area or its sides cross; 6 m2 are missing"),
      std::string::npos)
      << low.messages;
}

TEST(Gbxml, BentSurfacesAreKeptAndSaid) {
  const std::string bent = poly_loop({{0, 0, 0}, {0, 3, 0}, {4, 3, 0.004}, {4, 0, 0}});
  const Room low =
      room_of(with(two_rooms(), poly_loop({{0, 0, 0}, {0, 3, 0}, {4, 3, 0}, {4, 0, 0}}), bent));
  ASSERT_TRUE(low.room) << low.messages;
  EXPECT_NEAR(areas(*low.room).at("slab SlabOnGrade"), 12.0, 1e-4);
  EXPECT_NE(low.messages.find("warning[gbxml-bent]: 1 polygons around space 'low' are not flat"),
            std::string::npos)
      << low.messages;
}

TEST(Gbxml, OpeningsThatDoNotFitAreWarnedOf) {
  const Room beyond = room_of(
      two_rooms(gbxml_opening("w", "FixedWindow", {{3, 0, 1}, {5, 0, 1}, {5, 0, 2}, {3, 0, 2}})));
  EXPECT_NE(beyond.messages.find("warning[gbxml-opening-beyond]: opening 'w' reaches beyond its "
                                 "surface, or over another opening, by 1 of 2 m2"),
            std::string::npos)
      << beyond.messages;
  const Room away = room_of(
      two_rooms(gbxml_opening("w", "FixedWindow", {{1, 1, 1}, {3, 1, 1}, {3, 1, 2}, {1, 1, 2}})));
  EXPECT_NE(
      away.messages.find("warning[gbxml-left-out]: 'w' was left out: it is not in its surface"),
      std::string::npos)
      << away.messages;
  EXPECT_NEAR(areas(*away.room).at("south ExteriorWall"), 10.0, 1e-12);
}

TEST(Gbxml, UnknownSpacesAndEmptyOnesAreErrors) {
  EXPECT_EQ(room_of(two_rooms(), "lo").messages,
            "p.xml:3: error[gbxml-no-space]: 'b.xml' has no space 'lo' (it has 3 others); did "
            "you mean 'low'?");
  EXPECT_EQ(room_of(two_rooms(), "empty").messages,
            "p.xml:3: error[gbxml-no-surfaces]: 'b.xml': no surface is next to space 'empty', so "
            "it is not a room");
}

TEST(Gbxml, BrokenFilesAreErrorsAtTheirLine) {
  EXPECT_EQ(room_of(with(two_rooms(), "Meters", "Ells")).messages,
            "b.xml:3: error[gbxml-broken]: gbXML file: lengthUnit 'Ells' is unknown; allowed: "
            "Kilometers, "
            "Meters, Centimeters, Millimeters, Miles, Yards, Feet or Inches");
  EXPECT_NE(room_of(with(two_rooms(), "<Coordinate>4</Coordinate>", "<Coordinate>nan</Coordinate>"))
                .messages.find("error[gbxml-broken]: gbXML file: the coordinate 'nan' is not a "
                               "number up to 1e+09 m"),
            std::string::npos);
  EXPECT_NE(room_of(with(two_rooms(), "<Coordinate>4</Coordinate>", ""))
                .messages.find("a point has 2 coordinates; 3 are needed"),
            std::string::npos);
  EXPECT_FALSE(room_of(with(two_rooms(), "</Campus>", "")).room);
}

TEST(Gbxml, RootElementsAreTold) {
  EXPECT_TRUE(is_gbxml(two_rooms()));
  EXPECT_FALSE(is_gbxml("<luxgate version='1'><!-- gbXML --></luxgate>"));
  EXPECT_FALSE(is_gbxml("<!-- <gbXML> --><luxgate/>"));
  EXPECT_FALSE(is_gbxml("v 0 0 0"));
}

TEST(Gbxml, AnyCutOfAFileEndsWell) {
  const std::string xml = two_rooms();
  for (std::size_t size = 0; size < xml.size(); size += 3) room_of(xml.substr(0, size));
}

// Data that is not part of the program: LUXGATE_SHARED_DATA names its folder.
TEST(Gbxml, RealBuildingsAreRead) {
  const char* folder = std::getenv("LUXGATE_SHARED_DATA");
  if (folder == nullptr) GTEST_SKIP() << "LUXGATE_SHARED_DATA is not set";
  const std::filesystem::path meshes = std::filesystem::path(folder) / "photometry/meshes";
  if (!std::filesystem::exists(meshes)) GTEST_SKIP() << "no meshes in LUXGATE_SHARED_DATA";
  std::size_t rooms = 0;
  for (const auto& entry : std::filesystem::directory_iterator(meshes)) {
    std::string bytes = DiskFileReader().read(entry.path().string()).bytes;
    if (!is_gbxml(bytes)) continue;
    Diagnostics diagnostics;
    const auto building =
        parse_gbxml(std::move(bytes), entry.path().filename().string(), diagnostics);
    ASSERT_TRUE(building) << entry.path();
    for (const GbxmlSpace& space : building->space) {
      if (gbxml_room(*building, space.id, {}, diagnostics)) ++rooms;
    }
  }
  EXPECT_GT(rooms, 20u);
}

}  // namespace
}  // namespace calc::tests::gbxml_test
