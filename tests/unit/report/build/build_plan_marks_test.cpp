#include "report/build/build_plan_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace report::build_plan_marks_test {
namespace {

calc::Body box(const std::string& id, const glm::dvec3& low, const glm::dvec3& high) {
  calc::Body body;
  body.id = id;
  for (int i = 0; i < 8; ++i) {
    body.vertex_m.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                               (i & 4) != 0 ? high.z : low.z);
  }
  body.triangle = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return body;
}

struct Room {
  calc::Project project;
  calc::Space space;
  calc::PreparedScene scene;
};

Room empty_room() {
  Room room;
  room.project.luminaire_types.push_back({});
  room.project.luminaire_types[0].id = "panel";
  room.space.shell = calc::RoomShell{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 0, 2.8};
  for (const char* name : {"floor", "ceiling", "wall1", "wall2", "wall3", "wall4"})
    room.space.bodies.push_back(box(name, {0, 0, 0}, {4, 3, 0.1}));
  return room;
}

double length(const BodyMark& mark) {
  double sum = 0;
  for (const auto& [from, to] : mark.lines_m) sum += glm::distance(from, to);
  return sum;
}

TEST(PlanMarks, FurnitureHasTheOutlineOfItsTop) {
  Room room = empty_room();
  room.space.bodies.push_back(box("desk", {1, 1, 0.7}, {2.6, 1.8, 0.75}));
  SpacePart part;
  add_plan_marks(room.project, room.space, room.scene, part);
  ASSERT_EQ(part.bodies.size(), 1U);  // not the room's own surfaces
  EXPECT_EQ(part.bodies[0].id, "desk");
  EXPECT_EQ(part.bodies[0].lines_m.size(), 4U);  // without the diagonal
  EXPECT_NEAR(length(part.bodies[0]), 2 * (1.6 + 0.8), 1e-12);
  EXPECT_DOUBLE_EQ(part.bodies[0].low_z_m, 0.7);
  EXPECT_DOUBLE_EQ(part.bodies[0].high_z_m, 0.75);
}

TEST(PlanMarks, VerticesMayBeRepeatedForEveryFace) {
  Room room = empty_room();
  const calc::Body shared = box("desk", {1, 1, 0}, {2, 2, 1});
  calc::Body repeated;
  for (const glm::uvec3& t : shared.triangle) {
    const auto first = static_cast<unsigned>(repeated.vertex_m.size());
    for (const unsigned v : {t.x, t.y, t.z}) repeated.vertex_m.push_back(shared.vertex_m[v]);
    repeated.triangle.emplace_back(first, first + 1, first + 2);
  }
  room.space.bodies.push_back(repeated);
  SpacePart part;
  add_plan_marks(room.project, room.space, room.scene, part);
  EXPECT_EQ(part.bodies.at(0).lines_m.size(), 4U);
}

Room room_from_file(std::vector<calc::Body> bodies) {
  Room room = empty_room();
  room.space.shell.reset();
  room.space.surfaces_file = "hall.obj";
  room.space.bodies = std::move(bodies);
  return room;
}

// A box has twelve edges; the diagonals of its sides are no lines of a drawing. Its faces are
// bodies of their own here, as in gbXML, and know each other by their places.
TEST(PlanMarks, RoomsFromFilesHaveTheLinesWhereSurfacesBend) {
  const calc::Body whole = box("hall", {0, 0, 0}, {4, 3, 2});
  std::vector<calc::Body> faces;
  for (std::size_t i = 0; i < whole.triangle.size(); i += 2) {
    calc::Body face;
    for (std::size_t k = i; k < i + 2; ++k) {
      const auto first = static_cast<unsigned>(face.vertex_m.size());
      for (int c = 0; c < 3; ++c) face.vertex_m.push_back(whole.vertex_m[whole.triangle[k][c]]);
      face.triangle.emplace_back(first, first + 1, first + 2);
    }
    faces.push_back(face);
  }
  for (const Room& room : {room_from_file({whole}), room_from_file(faces)}) {
    SpacePart part;
    add_plan_marks(room.project, room.space, room.scene, part);
    EXPECT_TRUE(part.bodies.empty());
    ASSERT_EQ(part.surface_lines_m.size(), 24U);
    double sum = 0;
    for (std::size_t i = 0; i < 24; i += 2)
      sum += glm::distance(part.surface_lines_m[i], part.surface_lines_m[i + 1]);
    EXPECT_NEAR(sum, 4 * (4 + 3 + 2), 1e-12);
    EXPECT_EQ(part.surface_lines_left_out, 0U);
  }
  // A missing side: its borders are lines, which they were already.
  faces.pop_back();
  const Room open = room_from_file(faces);
  SpacePart part;
  add_plan_marks(open.project, open.space, open.scene, part);
  EXPECT_EQ(part.surface_lines_m.size(), 24U);
}

// A floor of many triangles has straight borders all the same, and their order means nothing.
TEST(PlanMarks, StraightRunsAreOneLine) {
  constexpr unsigned kSide = 5;
  calc::Body floor;
  for (unsigned i = 0; i <= kSide; ++i) {
    for (unsigned k = 0; k <= kSide; ++k) floor.vertex_m.emplace_back(0.1 * i, 0.3 * k, 0.0);
  }
  for (unsigned i = 0; i < kSide; ++i) {
    for (unsigned k = 0; k < kSide; ++k) {
      const unsigned a = i * (kSide + 1) + k, b = a + 1, c = a + kSide + 1, d = c + 1;
      floor.triangle.emplace_back(a, c, b);
      floor.triangle.emplace_back(b, c, d);
    }
  }
  const auto lines_of = [](const Room& room) {
    SpacePart part;
    add_plan_marks(room.project, room.space, room.scene, part);
    return part.surface_lines_m;
  };
  const Room room = room_from_file({floor});
  const std::vector<glm::dvec3> lines = lines_of(room);
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines[0], glm::dvec3(0, 0, 0));
  EXPECT_EQ(lines[7], glm::dvec3(0.1 * kSide, 0.3 * kSide, 0));
  std::reverse(floor.triangle.begin(), floor.triangle.end());
  for (glm::uvec3& t : floor.triangle) t = {t.y, t.z, t.x};
  EXPECT_EQ(lines_of(room_from_file({floor})), lines);
  // A wall of one triangle on it: the border is a line of the floor, and one of the wall.
  calc::Body wall;
  wall.vertex_m = {{0, 0, 0}, {0.1 * kSide, 0, 0}, {0, 0, 1}};
  wall.triangle = {{0, 1, 2}};
  EXPECT_EQ(lines_of(room_from_file({floor, wall})).size(), 14U);
}

TEST(PlanMarks, OfTooManyLinesTheLongestAreKept) {
  std::vector<calc::Body> bodies;
  for (int i = 0; i < 200; ++i)  // twelve lines each
    bodies.push_back(box("b", {2.0 * i, 0, 0}, {2.0 * i + 0.5, 0.5, 0.5 + (i == 150 ? 1.0 : 0.0)}));
  const Room room = room_from_file(bodies);
  SpacePart part;
  add_plan_marks(room.project, room.space, room.scene, part);
  EXPECT_EQ(part.surface_lines_m.size(), 2 * kMostSurfaceLines);
  EXPECT_EQ(part.surface_lines_left_out, 2400 - kMostSurfaceLines);
  EXPECT_EQ(glm::distance(part.surface_lines_m[0], part.surface_lines_m[1]), 1.5);
}

TEST(PlanMarks, ScreenIsALine) {
  Room room = empty_room();
  calc::Body screen;
  screen.vertex_m = {{1, 1, 0}, {3, 1, 0}, {3, 1, 1.2}, {1, 1, 1.2}};
  screen.triangle = {{0, 1, 2}, {0, 2, 3}};
  room.space.bodies.push_back(screen);
  SpacePart part;
  add_plan_marks(room.project, room.space, room.scene, part);
  ASSERT_EQ(part.bodies.at(0).lines_m.size(), 2U);
  EXPECT_NEAR(length(part.bodies[0]), 4, 1e-12);  // 2 m, below and above
}

TEST(PlanMarks, FineMeshesBecomeTheirHull) {
  Room room = empty_room();
  calc::Body disk;
  constexpr unsigned kCorners = 200;
  disk.vertex_m.emplace_back(2, 2, 1);
  for (unsigned i = 0; i < kCorners; ++i) {
    const double turn = 6.283185307179586 * i / kCorners;
    const double radius = i % 2 == 0 ? 1.0 : 0.9;
    disk.vertex_m.emplace_back(2 + radius * std::cos(turn), 2 + radius * std::sin(turn), 1);
    disk.triangle.emplace_back(0, 1 + i, 1 + (i + 1) % kCorners);
  }
  room.space.bodies.push_back(disk);
  SpacePart part;
  add_plan_marks(room.project, room.space, room.scene, part);
  EXPECT_EQ(part.bodies.at(0).lines_m.size(), kCorners / 2);
}

TEST(PlanMarks, LuminairesHaveTheirOpeningAndDirection) {
  Room room = empty_room();
  calc::Luminaire luminaire;
  luminaire.position_m = {1, 2, 2.8};
  luminaire.group = "row 1";
  const double turn = 0.5;
  luminaire.world_from_luminaire =
      glm::dmat3(std::cos(turn), std::sin(turn), 0, -std::sin(turn), std::cos(turn), 0, 0, 0, 1);
  room.space.luminaires = {luminaire, luminaire};
  calc::PlacedLuminaire placed;
  placed.world_from_luminaire = luminaire.world_from_luminaire;
  room.scene.luminaires = {placed, placed};
  room.scene.luminaires[0].opening = {calc::OpeningShape::rectangle, 1.2, 0.3, 0};
  SpacePart part;
  add_plan_marks(room.project, room.space, room.scene, part);
  ASSERT_EQ(part.luminaires.size(), 2U);
  const LuminaireMark& mark = part.luminaires[0];
  EXPECT_EQ(mark.type_id, "panel");
  EXPECT_EQ(mark.group, "row 1");
  EXPECT_NEAR(mark.c0.x, std::cos(turn), 1e-12);
  EXPECT_EQ(mark.axis, glm::dvec3(0, 0, -1));
  ASSERT_EQ(mark.outline_m.size(), 4U);
  const glm::dvec2 corner(1 + 0.6 * std::cos(turn) - 0.15 * std::sin(turn),
                          2 + 0.6 * std::sin(turn) + 0.15 * std::cos(turn));
  EXPECT_TRUE(std::any_of(mark.outline_m.begin(), mark.outline_m.end(),
                          [&](const glm::dvec2& p) { return glm::distance(p, corner) < 1e-12; }));
  EXPECT_TRUE(part.luminaires[1].outline_m.empty());  // a point
}

TEST(PlanMarks, SurfacesAndBodiesNameTheirMaterials) {
  Room room = empty_room();
  room.project.materials = {{"white", 0.8, {}}, {"wood", 0.3, {}}};
  room.space.id = "office";
  for (calc::Body& body : room.space.bodies) {
    body.id = "office." + body.id;
    body.material_of.assign(12, 0);
  }
  room.space.bodies.push_back(box("desk", {1, 1, 0.7}, {2, 2, 0.75}));
  room.space.bodies.back().material_of.assign(12, 1);
  room.space.bodies.back().material_of[3] = 0;
  SpacePart part;
  add_plan_marks(room.project, room.space, room.scene, part);
  ASSERT_EQ(part.finishes.size(), 6U);
  EXPECT_EQ(part.finishes[2].surface, "wall1") << "so that a room may have another id";
  EXPECT_EQ(part.finishes[2].materials, "white");
  ASSERT_EQ(part.bodies.size(), 1U);
  EXPECT_EQ(part.bodies[0].materials, "wood, white");
}

TEST(PlanMarks, TooManyBodiesAreCounted) {
  Room room = empty_room();
  for (std::size_t i = 0; i < kMostBodies + 3; ++i)
    room.space.bodies.push_back(box("chair", {1, 1, 0}, {2, 2, 1}));
  SpacePart part;
  add_plan_marks(room.project, room.space, room.scene, part);
  EXPECT_EQ(part.bodies.size(), kMostBodies);
  EXPECT_EQ(part.bodies_left_out, 3U);
}

TEST(PlanMarks, HousingsAreNoFurniture) {
  Room room = empty_room();
  for (std::size_t i = 0; i < kMostBodies + 3; ++i) {
    room.space.bodies.push_back(box("l.housing", {1, 1, 2}, {2, 2, 2.1}));
    room.space.bodies.back().housing_of = "l";
  }
  room.space.bodies.push_back(box("chair", {1, 1, 0}, {2, 2, 1}));
  SpacePart part;
  add_plan_marks(room.project, room.space, room.scene, part);
  ASSERT_EQ(part.bodies.size(), 1U);
  EXPECT_EQ(part.bodies[0].id, "chair");
  EXPECT_EQ(part.bodies_left_out, 0U);
}

}  // namespace
}  // namespace report::build_plan_marks_test
