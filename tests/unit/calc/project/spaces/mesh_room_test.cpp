// <room file="..."> of a mesh in a project.

#include "calc/scene/sensor_grid.h"
#include "tests/support/mesh_rooms.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace calc::tests::mesh_room_test {
namespace {

using test_support::ObjText;
using ::testing::HasSubstr;

constexpr glm::dvec3 kLow{0, 0, 0}, kHigh{4, 3, 2.5};

Loaded load_room(const std::string& obj, const std::string& more = "",
                 const std::string& inside = "") {
  MemoryFileReader files = project_files(in_project(
      fmt::format(R"(<room id="r" file="hall.obj" units="m" up="z" material="white"{}>{}</room>)",
                  more, inside)));
  files.add("dir/hall.obj", obj);
  return load(files);
}

const Space& room_of(const Loaded& loaded) { return loaded.project->spaces.at(0); }

TEST(MeshRoom, FacesMayLookInwardOrOutwardAndItIsSaid) {
  const std::string plane = R"(<luminaire id="l" type="spot" position="2 1.5 2.4"/>)"
                            R"(<plane id="task" height="0.75"/>)";
  const Loaded in = load_room(ObjText().box("hall", kLow, kHigh, true).text(), "", plane);
  ASSERT_TRUE(in.project) << in.messages;
  EXPECT_EQ(in.messages, "");
  const Space& space = room_of(in);
  EXPECT_FALSE(space.shell);
  EXPECT_FALSE(space.is_open_space());
  EXPECT_EQ(space.surfaces_file, "hall.obj");
  EXPECT_TRUE(space.is_from_mesh);
  ASSERT_EQ(space.bodies.size(), 1u);
  EXPECT_EQ(space.bodies[0].id, "r.shell");
  EXPECT_TRUE(space.bodies[0].encloses_room);
  EXPECT_FALSE(space.bodies[0].is_closed);
  EXPECT_EQ(space.outline_m.size(), 4u);
  const auto& area = std::get<PlanarArea>(space.planes.at(0).area);
  EXPECT_DOUBLE_EQ(area.origin_m.z, 0.75);
  EXPECT_GT(area.normal().z, 0.0);
  ASSERT_EQ(space.notes.size(), 1u);
  EXPECT_EQ(
      space.notes[0],
      "the room's surfaces come from 'hall.obj', a closed shell of 30 m³; its faces point into "
      "the room");
  const Loaded out = load_room(ObjText().box("hall", kLow, kHigh, false).text());
  ASSERT_TRUE(out.project) << out.messages;
  EXPECT_THAT(room_of(out).notes.at(0).english(),
              HasSubstr("faces point out of the room, which has no effect"));
  const Loaded mixed = load_room(ObjText().box("hall", kLow, kHigh, true, -1, 3).text());
  ASSERT_TRUE(mixed.project) << mixed.messages;
  EXPECT_THAT(room_of(mixed).notes.at(0).english(),
              HasSubstr("point into the room (10 triangles) and out of it (2)"));
}

TEST(MeshRoom, PointsInTheRoomStayThoseOutsideAndInSolidsAreDropped) {
  const std::string plane =
      R"(<luminaire id="l" type="spot" position="2 1.5 2.4"/><plane id="p" origin="-1 0 0.8" )"
      R"(u="5 0 0" v="0 3 0" count="10 6"/>)";
  for (const bool inward : {true, false}) {
    const Loaded loaded = load_room(ObjText()
                                        .box("hall", kLow, kHigh, inward)
                                        .box("column", {1, 1, 0.1}, {1.5, 2, 2}, false)
                                        .text(),
                                    R"( shell="1")", plane);
    ASSERT_TRUE(loaded.project) << loaded.messages;
    ASSERT_EQ(room_of(loaded).bodies.size(), 2u);
    EXPECT_EQ(room_of(loaded).bodies[1].id, "r.solid1");
    EXPECT_TRUE(room_of(loaded).bodies[1].is_closed);
    Diagnostics diagnostics;
    const auto grid = make_sensor_grid(room_of(loaded).planes.at(0), room_of(loaded), diagnostics);
    ASSERT_TRUE(grid);
    std::map<DropReason, std::size_t> dropped;
    for (const auto& point : grid->dropped) ++dropped[point.reason];
    EXPECT_EQ(dropped[DropReason::outside_room], 12u);  // two columns of six
    EXPECT_EQ(dropped[DropReason::inside_solid], 2u);
    EXPECT_EQ(grid->position_m.size(), 46u);
  }
}

TEST(MeshRoom, ASolidThatLooksTheOtherWayMayBeTheRoomInThickWalls) {
  const std::string thick =
      ObjText().box("house", kLow, kHigh, false).box("hall", {1, 1, 0.1}, {2, 2, 2}, true).text();
  EXPECT_EQ(
      load_room(thick).messages,
      "dir/p.xml:4:14: error[mesh-room-not-clear]: room 'r': luxgate cannot tell which part "
      "of 'hall.obj' is the room: shell 2 is inside shell 1 and has faces that look the other "
      "way; it may be a solid in the room, or the room within thick walls; name one with "
      "shell=\"...\": 1 ('house', 4 x 3 x 2.5 m), 2 ('hall', 1 x 1 x 1.9 m), or \"all\" (the "
      "room is the space between all surfaces, such as thick walls)");
  const Loaded chosen = load_room(thick, R"( shell="2")");
  ASSERT_TRUE(chosen.project) << chosen.messages;
  ASSERT_EQ(room_of(chosen).bodies.size(), 1u);
  EXPECT_THAT(room_of(chosen).notes.at(0).english(),
              HasSubstr("a closed shell of 1.9 m³; its faces point into the room"));
  EXPECT_THAT(chosen.messages, HasSubstr("warning[mesh-room-left-out]: room 'r': 12 triangles"));
  EXPECT_EQ(room_of(load_room(thick, R"( shell="1")")).bodies.size(), 2u);
  EXPECT_THAT(load_room(ObjText()
                            .box("house", kLow, kHigh, false)
                            .box("hall", {0.2, 0.2, 0.2}, {3.8, 2.8, 2.3}, false)
                            .text())
                  .messages,
              HasSubstr("shell 2 is inside shell 1 and fills most of it"));
  EXPECT_THAT(load_room(thick, R"( shell="3")").messages,
              HasSubstr("attribute 'shell' of <room>: 3 is not allowed; expected one of: 1 ('ho"));
}

// What touches the room from outside stands in no part of it, however small it is.
TEST(MeshRoom, ShellsThatTouchFromOutsideAreBesideIt) {
  for (const auto& [low, high] :
       {std::pair(glm::dvec3(1, 1, 2.5), glm::dvec3(2, 2, 3.5)),  // on the roof
        std::pair(glm::dvec3(4, 1, 0), glm::dvec3(5, 2, 1))}) {   // at a wall
    EXPECT_THAT(
        load_room(ObjText().box("a", kLow, kHigh, true).box("b", low, high, true).text()).messages,
        HasSubstr("2 closed shells are side by side"));
  }
  // From floor to ceiling, all corners are on the room's surface.
  const Loaded column = load_room(
      ObjText().box("a", kLow, kHigh, true).box("b", {1, 1, 0}, {1.2, 1.2, 2.5}, false).text(),
      R"( shell="1")");
  ASSERT_TRUE(column.project) << column.messages;
  EXPECT_EQ(room_of(column).bodies.size(), 2u);
}

TEST(MeshRoom, ManyShellsThatFillItTogetherMayBeTheRooms) {
  ObjText building;
  building.box("hull", {0, 0, 0}, {9, 7, 3}, false);
  building.box("a", {0.1, 0.1, 0.1}, {4.4, 3.4, 2.9}, false);
  building.box("b", {4.6, 0.1, 0.1}, {8.9, 3.4, 2.9}, false);
  building.box("c", {0.1, 3.6, 0.1}, {4.4, 6.9, 2.9}, false);
  building.box("d", {4.6, 3.6, 0.1}, {8.9, 6.9, 2.9}, false);
  EXPECT_THAT(load_room(building.text()).messages,
              HasSubstr("fills most of it together with larger shells"));
}

// A shell with a gap does not tell inside from outside, but what lies beyond all of it is outside.
TEST(MeshRoom, PointsBeyondAnOpenShellAreOutside) {
  const Loaded loaded = load_room(
      ObjText().box("hall", kLow, kHigh, true, 3).text(), "",
      R"(<luminaire id="l" type="spot" position="2 1.5 2.4"/><plane id="p" origin="-1 0 0.8" )"
      R"(u="5 0 0" v="0 3 0" count="10 6"/>)");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_THAT(loaded.messages, HasSubstr("mesh-room-open"));
  const Space& space = room_of(loaded);
  Diagnostics diagnostics;
  const auto grid = make_sensor_grid(space.planes.at(0), space, diagnostics);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->dropped.size(), 12u);
  for (const DroppedPoint& point : grid->dropped) EXPECT_EQ(point.reason, DropReason::outside_room);
}

TEST(MeshRoom, ShellsSideBySideAreAnError) {
  const std::string two =
      ObjText().box("a", kLow, kHigh, true).box("b", {5, 0, 0}, {9, 3, 2.4}, true).text();
  EXPECT_THAT(load_room(two).messages,
              HasSubstr("2 closed shells are side by side; name one with shell=\"...\": 1 ('a', "
                        "4 x 3 x 2.5 m), 2 ('b', 4 x 3 x 2.4 m)"));
  const Loaded loaded = load_room(two, R"( shell="2")");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_DOUBLE_EQ(room_of(loaded).bodies.at(0).vertex_m.at(0).x, 5.0);
  // Walls in common are told apart by the objects.
  const std::string beside =
      ObjText().box("a", kLow, kHigh, true).box("b", {4, 0, 0}, {8, 3, 2.5}, true).text();
  EXPECT_THAT(load_room(beside).messages, HasSubstr("2 closed shells are side by side"));
}

TEST(MeshRoom, LeaksAreMeasuredAndAllowed) {
  const Loaded loaded = load_room(ObjText().box("hall", kLow, kHigh, true, 1).text());
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_EQ(loaded.messages,
            "dir/p.xml:4:14: warning[mesh-room-open]: room 'r': the surfaces of 'hall.obj' are not "
            "closed: 4 edges, 14 m together, have no neighbour; the longest, 4 m, begins at "
            "(0.000, 0.000, 2.500) m; light may escape there, and luxgate cannot tell which points "
            "are outside the room\n"
            "dir/p.xml: warning[project-without-planes]: the project has no <plane>: there is "
            "nothing to calculate");
  EXPECT_FALSE(room_of(loaded).bodies.at(0).encloses_room);
  EXPECT_FALSE(room_of(loaded).bodies.at(0).is_closed);
  EXPECT_EQ(room_of(loaded).outline_m.size(), 4u);
  EXPECT_TRUE(room_of(loaded).notes.empty());
}

TEST(MeshRoom, ClosedFurnitureInAnOpenShellIsNotTheRoom) {
  const Loaded loaded = load_room(ObjText()
                                      .box("hall", kLow, kHigh, true, 2)
                                      .box("desk", {1, 1, 0.7}, {2, 2, 0.75}, false)
                                      .text());
  ASSERT_TRUE(loaded.project) << loaded.messages;
  ASSERT_EQ(room_of(loaded).bodies.size(), 2u);
  EXPECT_EQ(room_of(loaded).bodies[0].triangle.size(), 10u);
  EXPECT_FALSE(room_of(loaded).bodies[0].encloses_room);
  EXPECT_TRUE(room_of(loaded).bodies[1].is_closed);
}

// A floor, a ceiling and four walls, each of them a box.
TEST(MeshRoom, WithAllTheRoomLiesBetweenTheSolids) {
  ObjText text;
  text.box("floor", {0, 0, -0.2}, {4, 3, 0}, false).box("roof", {0, 0, 2.5}, {4, 3, 2.7}, false);
  text.box("south", {0, -0.2, -0.2}, {4, 0, 2.7}, false);
  text.box("north", {0, 3, -0.2}, {4, 3.2, 2.7}, false);
  text.box("west", {-0.2, -0.2, -0.2}, {0, 3.2, 2.7}, false);
  text.box("east", {4, -0.2, -0.2}, {4.2, 3.2, 2.7}, false);
  EXPECT_THAT(load_room(text.text()).messages, HasSubstr("6 closed shells are side by side"));
  const Loaded loaded = load_room(text.text(), R"( shell="all")",
                                  R"(<luminaire id="l" type="spot" position="2 1.5 2.4"/>)"
                                  R"(<plane id="p" origin="-0.2 0 0.8" u="4.4 0 0" v="0 3 0" )"
                                  R"(count="22 3"/>)");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const Space& space = room_of(loaded);
  ASSERT_EQ(space.bodies.size(), 6u);
  for (const Body& body : space.bodies) {
    EXPECT_TRUE(body.is_closed);
    EXPECT_FALSE(body.encloses_room);
  }
  EXPECT_TRUE(space.outline_m.empty());
  EXPECT_THAT(space.notes.at(0).english(),
              HasSubstr("between 6 closed solids and 0 other triangles"));
  Diagnostics diagnostics;
  const auto grid = make_sensor_grid(space.planes.at(0), space, diagnostics);
  ASSERT_TRUE(grid);
  EXPECT_TRUE(grid->has_unknown_walls);
  EXPECT_EQ(grid->position_m.size(), 60u);  // six of 66 lie in the walls
  EXPECT_THAT(load_room(text.text(), R"( shell="some")").messages,
              HasSubstr("attribute 'shell' of <room>: some is not allowed; expected one of: 1 ("));
  EXPECT_THAT(load_room(kTableObj, R"( shell="all")").messages,
              HasSubstr("error[mesh-room-encloses-nothing]"));
}

TEST(MeshRoom, AFlatSheetIsNoRoom) {
  EXPECT_THAT(load_room(kTableObj).messages,
              HasSubstr("error[mesh-room-encloses-nothing]: room 'r': the surfaces of 'hall.obj'"));
}

TEST(MeshRoom, UnitsAxesAndPlaceAreThoseOfMeshes) {
  MemoryFileReader files = project_files(in_project(
      R"(<room id="r" file="hall.obj" units="mm" up="y" position="10 0 1" rotation="90" material="white"/>)"));
  // Depth is -z when y is up.
  files.add("dir/hall.obj", ObjText().box("hall", {0, 0, -3000}, {4000, 2500, 0}, true).text());
  const Loaded loaded = load(files);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  BoundingBox box;
  for (const glm::dvec3& p : room_of(loaded).bodies.at(0).vertex_m) box.add(p);
  EXPECT_LT(glm::length(box.lower - glm::dvec3(7, 0, 1)), 1e-9);
  EXPECT_LT(glm::length(box.upper - glm::dvec3(10, 4, 3.5)), 1e-9);
  EXPECT_EQ(room_of(loaded).outline_m.size(), 4u);
  EXPECT_THAT(load(in_project(R"(<room id="r" file="table.obj" material="white"/>)")).messages,
              HasSubstr("<room> needs the attribute 'units'"));
}

TEST(MeshRoom, WhatTheFileIsDecidesWhichAttributesThereAre) {
  EXPECT_THAT(load(in_project(R"(<room id="r" file="house.xml" material="white"/>)")).messages,
              HasSubstr("'space'"));
  EXPECT_THAT(
      load(in_project(R"(<room id="r" file="house.xml" space="low" units="m" material="white"/>)"))
          .messages,
      HasSubstr("unknown attribute 'units' of <room>"));
  EXPECT_THAT(
      load_room(ObjText().box("hall", kLow, kHigh, true).text(), R"( space="low")").messages,
      HasSubstr("unknown attribute 'space' of <room>"));
  EXPECT_EQ(load(in_project(R"(<room id="r" file="none.obj" units="m" up="z" material="white"/>)"))
                .messages,
            "dir/p.xml:4:14: error[file-not-readable]: cannot read 'dir/none.obj': No such file or "
            "directory");
}

TEST(MeshRoom, PlanesThatNeedAFloorOrWallsSayWhatIsMissing) {
  const std::string box = ObjText().box("hall", kLow, kHigh, true).text();
  EXPECT_THAT(load_room(box, "", R"(<plane id="p" on="wall1"/>)").messages,
              HasSubstr("error[mesh-room-plane]: 'on' of <plane>: the walls of a mesh room"));
  EXPECT_THAT(load_room(box, "", R"(<workplace id="w" pack="x" row="y"/>)").messages,
              HasSubstr("error[workplace-needs-room]"));
  // A tetrahedron on its tip.
  EXPECT_THAT(load_room("v 0 0 0\nv 1 0 2\nv -1 1 2\nv -1 -1 2\nf 1 2 3\nf 1 3 4\nf 1 4 2\n"
                        "f 2 4 3\n",
                        "", R"(<plane id="p" height="0.75"/>)")
                  .messages,
              HasSubstr("error[mesh-room-plane]: 'height' of <plane>: the lowest faces of this"));
}

TEST(MeshRoom, ThingsOutsideAreSaid) {
  EXPECT_THAT(load_room(ObjText().box("hall", kLow, kHigh, false).text(), "",
                        R"(<luminaire id="l" type="spot" position="2 1.5 2.6"/>
<box id="b" size="1 1 1" position="6 0 0" material="white"/>)")
                  .messages,
              ::testing::AllOf(HasSubstr("luminaire 'l' is outside room 'r'"),
                               HasSubstr("object 'b' is outside room 'r'")));
}

// The square twice: as the node "low", and 3 m higher as a part of "high".
std::string two_squares_gltf() {
  return with(with(kSquareGltf, R"("nodes":[0])", R"("nodes":[0,1])"),
              R"([{"name":"tile","mesh":0}])",
              R"([{"name":"low","mesh":0},{"name":"high","translation":[0,3,0],"children":[2]},)"
              R"({"name":"part","mesh":0}])");
}

TEST(MeshRoom, AStoreyIsANodeOfTheFile) {
  MemoryFileReader files = project_files(in_project(
      R"(<mesh id="m" file="a.gltf" node="high" material="white"/><mesh id="all" file="a.gltf" )"
      R"(material="white"/>)"));
  files.add("dir/a.gltf", two_squares_gltf());
  files.add("dir/tile.bin", square_bytes());
  const Loaded loaded = load(files);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const std::vector<Body>& bodies = room_of(loaded).bodies;
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0].triangle.size(), 2u);
  EXPECT_EQ(bodies[1].triangle.size(), 4u);
  for (const glm::dvec3& p : bodies[0].vertex_m) EXPECT_GE(p.z, 3.0);
  const auto messages = [&](const std::string& room, const std::string& gltf) {
    MemoryFileReader with_room = project_files(in_project(room));
    with_room.add("dir/a.gltf", gltf);
    with_room.add("dir/tile.bin", square_bytes());
    with_room.add("dir/hall.obj", ObjText().box("hall", kLow, kHigh, true).text());
    return load(with_room).messages;
  };
  EXPECT_EQ(
      messages(R"(<room id="r" file="a.gltf" node="hig" material="white"/>)", two_squares_gltf()),
      "dir/a.gltf: error[mesh-node]: node 'hig': the scene has no node of this name (3 "
      "others); did you mean 'high'?");
  EXPECT_THAT(messages(R"(<room id="r" file="a.gltf" node="low" material="white"/>)",
                       with(two_squares_gltf(), R"("name":"part")", R"("name":"low")")),
              HasSubstr("2 nodes of the scene have this name"));
  EXPECT_THAT(
      messages(R"(<room id="r" file="a.gltf" node="low" material="white"/>)", two_squares_gltf()),
      HasSubstr("error[mesh-room-encloses-nothing]"));
  EXPECT_THAT(
      messages(R"(<room id="r" file="hall.obj" units="m" up="z" node="low" material="white"/>)",
               two_squares_gltf()),
      HasSubstr("error[mesh-node]: node 'low': only glTF files have nodes"));
}

}  // namespace
}  // namespace calc::tests::mesh_room_test
