// Points inside things whose mesh is not closed: left out, as inside closed ones and boxes.
#include "calc/scene/sensor_grid.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace calc::tests::open_shells_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A box of quads with shared corners; without: its faces bottom, top, front, back, left and right
// (0 to 5) that are left out.
std::string box_obj(const std::vector<int>& without, double size_m = 2.0) {
  const std::array<std::string, 6> faces{"1 2 3 4", "5 6 7 8", "1 2 6 5",
                                         "4 3 7 8", "1 4 8 5", "2 3 7 6"};
  std::string obj;
  for (const double z : {0.0, size_m}) {
    const std::string at = std::to_string(z) + "\n", side = std::to_string(size_m);
    obj += "v 0 0 " + at + "v " + side + " 0 " + at + "v " + side + " " + side + " " + at + "v 0 " +
           side + " " + at;
  }
  for (int i = 0; i < 6; ++i) {
    if (std::find(without.begin(), without.end(), i) != without.end()) continue;
    obj += "f " + faces[static_cast<std::size_t>(i)] + "\n";
  }
  return obj;
}

struct Made {
  std::size_t kept = 0, inside = 0;
  std::string messages;
};

// In a room of 8 x 6 x 4 m; the points are those of a plane of 4 in the middle of a box of 2 m.
Made make_in_room(const std::string& obj, const std::string& position,
                  const std::string& luminaire = "4 3 3.5", const std::string& plane_z = "1") {
  MemoryFileReader files = project_files(
      in_project("<room id='r' size='8 6 4' ceiling='white' walls='white' floor='white'>"
                 "<luminaire id='l' type='spot' position='" +
                 luminaire +
                 "'/>"
                 "<mesh id='m' file='m.obj' units='m' up='z' material='white' position='" +
                 position +
                 "'/>"
                 "<plane id='p' origin='0.6 0.6 " +
                 plane_z + "' u='0.8 0 0' v='0 0.8 0' count='2 2'/></room>"));
  files.add("dir/m.obj", obj);
  Diagnostics diagnostics;
  const auto project = load_project(files, "dir/p.xml", diagnostics);
  EXPECT_TRUE(project);
  Made made;
  if (!project) return made;
  const Space& space = project->spaces.at(0);
  const auto grid = make_sensor_grid(space.planes.at(0), space, diagnostics);
  for (const Diagnostic& one : diagnostics.all()) made.messages += format_diagnostic(one) + "\n";
  made.kept = grid ? grid->position_m.size() : 0;
  made.inside = 4 - made.kept;
  return made;
}

TEST(OpenShells, WithoutItsBottomOnTheFloorItIsClosed) {
  const Made made = make_in_room(box_obj({0}), "0 0 0");
  EXPECT_EQ(made.inside, 4u);
  EXPECT_THAT(
      made.messages,
      HasSubstr("warning[points-in-open-mesh]: plane 'p': 4 of 4 points are left out; they are "
                "inside 'm', whose mesh is not closed"));
}

// Without what faces the floor, a wall and another wall, from floor to ceiling, and with a gap.
TEST(OpenShells, WhatItStandsAtClosesIt) {
  EXPECT_EQ(make_in_room(box_obj({0, 2, 4}), "0 0 0").inside, 4u);
  EXPECT_EQ(make_in_room(box_obj({0, 2}), "0 0 0.005").inside, 4u);
  EXPECT_EQ(make_in_room(box_obj({0, 1}, 4.0), "0 0 0", "6 4 3.5").inside, 4u);
}

TEST(OpenShells, ATableAShelfAndAChestAreNotClosed) {
  EXPECT_EQ(make_in_room(box_obj({2, 3, 4, 5}), "0 0 0").kept, 4u);  // top and bottom alone
  EXPECT_EQ(make_in_room(box_obj({1}), "0 0 0").kept, 4u);
  EXPECT_EQ(make_in_room(box_obj({3}), "0 0 0").kept, 4u);
  // Half a metre above the floor, and on a table's legs.
  EXPECT_EQ(make_in_room(box_obj({0}), "0 0 0.5").kept, 4u);
}

// Points beside it, on it, and above what it stands on.
TEST(OpenShells, PlacesAroundItStay) {
  EXPECT_EQ(make_in_room(box_obj({0}), "3 2 0").kept, 4u);
  EXPECT_EQ(make_in_room(box_obj({0}), "0 0 0", "4 3 3.5", "2").kept, 4u);
  EXPECT_EQ(make_in_room(box_obj({0}), "0 0 0", "4 3 3.5", "2.5").kept, 4u);
}

// A lining of the room, whose luminaire is in it or let into its ceiling.
TEST(OpenShells, AroundALuminaireItIsARoom) {
  for (const std::string luminaire : {"1 1 1.9", "1 1 2", "1 1 2.05"}) {
    const Made made = make_in_room(box_obj({0}), "0 0 0", luminaire);
    EXPECT_EQ(made.kept, 4u) << luminaire;
    EXPECT_THAT(made.messages, Not(HasSubstr("open-mesh"))) << luminaire;
  }
}

// A box among sheets: the file is not closed, and what is in the box is inside all the same.
TEST(OpenShells, APartThatIsClosedHasAnInside) {
  const std::string sheet = "v 5 5 1\nv 6 5 1\nv 6 6 1.5\nf 9 10 11\n";
  EXPECT_EQ(make_in_room(box_obj({}) + sheet, "0 0 0").inside, 4u);
}

// All but a hatch in its top.
TEST(OpenShells, NearlyClosedIsSaid) {
  const std::string hatch =
      "v 0.9 0.9 2\nv 1.1 0.9 2\nv 1.1 1.1 2\nv 0.9 1.1 2\n"
      "f 5 6 10 9\nf 6 7 11 10\nf 7 8 12 11\nf 8 5 9 12\n";
  const Made under = make_in_room(box_obj({0, 1}) + hatch, "-0.2 -0.2 0");
  EXPECT_EQ(under.kept, 1u) << "below the hatch";
  EXPECT_THAT(under.messages, HasSubstr("warning[points-nearly-in-open-mesh]: plane 'p': 1 of 4"));
  EXPECT_THAT(under.messages, HasSubstr("warning[points-in-open-mesh]: plane 'p': 3 of 4"));
}

// A curtain, a terrain and a sheet under the ceiling enclose nothing.
TEST(OpenShells, SheetsEncloseNothing) {
  std::string wave;
  for (int i = 0; i <= 40; ++i) {
    const std::string at = std::to_string(0.05 * i) + " " + std::to_string(1.0 + 0.1 * (i % 2));
    wave += "v " + at + " 0\nv " + at + " 4\n";
  }
  for (int i = 0; i < 40; ++i) {
    const int v = 2 * i + 1;
    wave += "f " + std::to_string(v) + " " + std::to_string(v + 2) + " " + std::to_string(v + 3) +
            " " + std::to_string(v + 1) + "\n";
  }
  const Made made = make_in_room(wave, "0 0 0");
  EXPECT_EQ(made.kept, 4u);
  EXPECT_THAT(made.messages, Not(HasSubstr("open-mesh")));
  EXPECT_EQ(make_in_room(box_obj({0, 2, 3, 4, 5}), "0 0 0").kept, 4u);
}

}  // namespace
}  // namespace calc::tests::open_shells_test
