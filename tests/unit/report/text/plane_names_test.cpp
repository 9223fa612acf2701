#include "report/text/plane_names.h"

#include <gtest/gtest.h>

#include <string>

namespace report::plane_names_test {
namespace {

PlanePart made(const std::string& id, const std::string& name) {
  PlanePart plane;
  plane.id = id;
  plane.name = name;
  plane.made_by = calc::Message::words("workplace");
  return plane;
}

SpacePart office() {
  SpacePart space;
  space.footprint_m = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  space.planes = {made("use-1.01.task", "Use: task"), made("use-1.01.wall.2", "wall 2"),
                  made("use-1.01.observer.1", "Use: observer 1"),
                  made("use-1.01.cylinder", "Use: cylinder")};
  PlanePart& observer = space.planes[2];
  observer.derived = calc::DerivedQuantity::ugr;
  PointRow point;
  point.position_m = {1, 1, 1.2};
  point.normal = {1, 0, 0};
  observer.points = {point};
  return space;
}

TEST(PlaneNames, AreOfTheirPlaceInTheRoom) {
  const SpacePart space = office();
  EXPECT_EQ(plane_name({}, space, space.planes[0]), "Task");
  EXPECT_EQ(plane_name({}, space, space.planes[1]), "Wall 2");
  EXPECT_EQ(plane_name({}, space, space.planes[2]), "Observer 1, looking to wall 2");
  EXPECT_EQ(plane_name({}, space, space.planes[3]), "Cylindrical illuminance");
  EXPECT_EQ(plane_name({}, space, made("use-1.01.iMac", "Use: iMac")), "iMac") << "of its own pack";
  EXPECT_EQ(plane_in_room({}, space, space.planes[1]), "wall 2");
  EXPECT_EQ(plane_in_room({}, space, space.planes[2]), "observer 1");
}

TEST(PlaneNames, AreInTheLanguageOfTheReader) {
  const SpacePart space = office();
  const Texts german(Language::german, true), french(Language::french, true);
  EXPECT_EQ(plane_name(german, space, space.planes[2]), "Beobachter 1, Blick zu Wand 2");
  EXPECT_EQ(plane_name(french, space, space.planes[3]), "Éclairement cylindrique");
  EXPECT_EQ(plane_in_room(german, space, space.planes[1]), "Wand 2");
}

// Two workplaces: each has its own task, and they share the walls.
TEST(PlaneNames, NameTheWorkplaceWhereThereAreSeveral) {
  SpacePart space = office();
  space.planes.push_back(made("board.task", "Board: task"));
  EXPECT_EQ(plane_name({}, space, space.planes[0]), "Use: task");
  EXPECT_EQ(plane_name({}, space, space.planes[1]), "Wall 2");
  EXPECT_EQ(plane_name({}, space, space.planes[4]), "Board: task");
  space.planes[4].name = "iMac: task";
  EXPECT_EQ(plane_name({}, space, space.planes[4]), "iMac: task") << "the project's own word";
}

TEST(PlaneNames, OfTheProjectStayAsTheyAre) {
  SpacePart space = office();
  PlanePart own;
  own.id = "court.task";
  EXPECT_EQ(plane_name({}, space, own), "court.task");
  own.name = "court: task";
  EXPECT_EQ(plane_name({}, space, own), "court: task");
  EXPECT_EQ(plane_in_room({}, space, own), "court: task");
  EXPECT_EQ(made_role(own), "");
}

TEST(PlaneNames, HaveRolesOfAnyPack) {
  EXPECT_EQ(role_name({}, "open-area"), "open area");
  EXPECT_EQ(role_name({}, "wall.12"), "wall 12");
  EXPECT_EQ(role_name({}, "ta"), "ta");
}

}  // namespace
}  // namespace report::plane_names_test
