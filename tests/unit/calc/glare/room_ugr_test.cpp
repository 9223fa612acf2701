// The tabular method in rooms: against the table of the same luminaire, by turning, scaling and
// mixing, and what it is not for.
#include "calc/glare/room_ugr.h"

#include "calc/base/units.h"
#include "calc/glare/ugr_table.h"
#include "calc/photometry/web.h"

#include <glm/glm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace calc::room_ugr_test {
namespace {

constexpr std::size_t kCross = 0, kEnd = 1;  // UgrView
constexpr double kH_m = 1.8;

// Falls faster along C90 than along C0.
PhotometricWeb oblong_web(LuminousOpening opening = {OpeningShape::rectangle, 1.2, 0.3, 0.0}) {
  const std::vector<double> c{0.0, 0.5 * kPi, kPi, 1.5 * kPi, 2.0 * kPi};
  std::vector<double> gamma, cd;
  for (int k = 0; k <= 36; ++k) gamma.push_back(kPi * k / 36.0);
  for (std::size_t plane = 0; plane < c.size(); ++plane) {
    for (const double g : gamma) {
      const double cosine = std::max(0.0, std::cos(g));
      cd.push_back(600.0 * std::pow(cosine, plane % 2 == 0 ? 1.0 : 2.0));
    }
  }
  return PhotometricWeb::make(c, gamma, cd, opening, {});
}

PhotometricWeb uplight_web() {
  return PhotometricWeb::make({0.0}, {0.0, 0.5 * kPi, 0.5 * kPi + 0.02, kPi},
                              {0.0, 0.0, 900.0, 900.0}, {OpeningShape::rectangle, 1.2, 0.3, 0.0},
                              {});
}

void add_quad(Space& space, const std::string& id, std::uint32_t material,
              const std::vector<glm::dvec3>& corners) {
  Body body;
  body.id = id;
  body.vertex_m = corners;
  body.triangle = {{0, 1, 2}, {0, 2, 3}};
  body.material_of = {material, material};
  space.bodies.push_back(body);
}

// A room of x by y metres, turned about the origin, with nx by ny luminaires spread evenly.
struct Room {
  double x_m = 4.0 * kH_m, y_m = 8.0 * kH_m;
  double turn_deg = 0.0;
  double ceiling = 0.7, walls = 0.5, floor = 0.2;
  int columns = 2, rows = 4;

  glm::dvec3 turned(double x, double y, double z) const {
    const double a = radians_from_degrees(turn_deg);
    return {x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a), z};
  }
};

class RoomUgrTest : public ::testing::Test {
 protected:
  // The first luminaire of a type has its id.
  Project project_of(const Room& room) const {
    Project project;
    project.materials = {{"c", room.ceiling, {}}, {"w", room.walls, {}}, {"f", room.floor, {}}};
    project.webs = {oblong_web(), uplight_web(), oblong_web({})};
    for (std::size_t t = 0; t < project.webs.size(); ++t) {
      LuminaireType type;
      type.id = "t" + std::to_string(t);
      type.web = t;
      project.luminaire_types.push_back(type);
    }
    Space space;
    space.id = "r";
    const double top = kSeatedEye_m + kH_m + 0.1;
    space.shell = RoomShell{{}, 0.0, top};
    const std::vector<glm::dvec2> corners{
        {0, 0}, {room.x_m, 0}, {room.x_m, room.y_m}, {0, room.y_m}};
    std::vector<glm::dvec3> low, high;
    for (const glm::dvec2& c : corners) {
      low.push_back(room.turned(c.x, c.y, 0.0));
      high.push_back(room.turned(c.x, c.y, top));
      space.shell->footprint_m.emplace_back(low.back());
    }
    add_quad(space, "r.floor", 2, low);
    add_quad(space, "r.ceiling", 0, high);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      add_quad(space, "r.wall" + std::to_string(i + 1), 1, {low[i], low[j], high[j], high[i]});
    }
    project.spaces = {space};
    add_array(project, room, 0, 0.0);
    return project;
  }

  static void add_array(Project& project, const Room& room, std::size_t type, double lower_m) {
    const glm::dmat3 turned(room.turned(1, 0, 0), room.turned(0, 1, 0), {0, 0, 1});
    for (int i = 0; i < room.columns; ++i) {
      for (int j = 0; j < room.rows; ++j) {
        Luminaire luminaire;
        luminaire.id = "l" + std::to_string(project.spaces[0].luminaires.size());
        luminaire.type = type;
        luminaire.group = "all";
        luminaire.position_m =
            room.turned((i + 0.5) * room.x_m / room.columns, (j + 0.5) * room.y_m / room.rows,
                        kSeatedEye_m + kH_m - lower_m);
        luminaire.world_from_luminaire = turned;
        project.spaces[0].luminaires.push_back(luminaire);
      }
    }
  }

  static RoomUgr rated(const Project& project, const LightScene* scene = nullptr) {
    return room_ugr(project, project.spaces[0], scene);
  }
};

const UgrRow& row_of(const std::vector<UgrRow>& table, double x, double y) {
  return *std::find_if(table.begin(), table.end(),
                       [&](const UgrRow& row) { return row.x_per_h == x && row.y_per_h == y; });
}

// Along the room C0 lies across the sight, across it along: each of the table's rooms and views
// once, and the larger one counts.
TEST_F(RoomUgrTest, IsTheLargerOfTheTablesTwoViews) {
  const PhotometricWeb web = oblong_web();
  const std::vector<UgrRow> table = *ugr_table(web);
  const double along = row_of(table, 4, 8).ugr[kEnd][0];
  const double across = row_of(table, 8, 4).ugr[kCross][0];
  EXPECT_GT(std::abs(along - across), 0.3);
  const RoomUgr result = rated(project_of({}));
  EXPECT_EQ(result.problem, "");
  EXPECT_NEAR(result.ugr.value, std::max(along, across), 1e-9);
  EXPECT_EQ(result.ugr.low, result.ugr.value);
  EXPECT_EQ(result.ugr.high, result.ugr.value);
  EXPECT_NE(result.words.english().find("8.00 H x 4.00 H, H = 1.80 m above eyes at 1.2 m"),
            std::string::npos)
      << result.words;
}

TEST_F(RoomUgrTest, DoesNotHangOnWhereTheRoomIsTurnedTo) {
  const double value = rated(project_of({})).ugr.value;
  for (const double turn_deg : {17.0, 90.0, 200.0}) {
    EXPECT_NEAR(rated(project_of({.turn_deg = turn_deg})).ugr.value, value, 1e-9) << turn_deg;
  }
}

// The same shapes in H are the same rooms.
TEST_F(RoomUgrTest, HangsOnTheRoomInMultiplesOfHOnly) {
  Project lower = project_of({.x_m = 4.0 * 0.9, .y_m = 8.0 * 0.9});
  for (Luminaire& luminaire : lower.spaces[0].luminaires)
    luminaire.position_m.z = kSeatedEye_m + 0.9;
  EXPECT_NEAR(rated(lower).ugr.value, rated(project_of({})).ugr.value, 1e-9);
}

// L^2 grows with the square of the flux, the background with itself.
TEST_F(RoomUgrTest, RisesByEightLogarithmsOfTheFlux) {
  Project project = project_of({});
  const double value = rated(project).ugr.value;
  project.luminaire_types[0].flux_scale = 2.0;
  EXPECT_NEAR(rated(project).ugr.value, value + 8.0 * std::log10(2.0), 1e-9);
  const LightScene half{"half", {{"all", 0.5}}, {}};
  EXPECT_NEAR(rated(project, &half).ugr.value, value, 1e-9);
  const LightScene off{"off", {{"all", 0.0}}, {}};
  EXPECT_NE(rated(project, &off).problem.english().find("is lit"), std::string::npos);
}

// As a table has it, but not brighter than its brightest column.
TEST_F(RoomUgrTest, CountsReflectancesUpToThoseOfTables) {
  const PhotometricWeb web = oblong_web();
  const std::vector<UgrRow> table = *ugr_table(web);
  const auto expected = [&](std::size_t k) {
    return std::max(row_of(table, 4, 8).ugr[kEnd][k], row_of(table, 8, 4).ugr[kCross][k]);
  };
  for (std::size_t k = 0; k < kUgrReflectances.size(); ++k) {
    const UgrReflectances& rho = kUgrReflectances[k];
    const Room room{.ceiling = rho.ceiling, .walls = rho.walls, .floor = rho.floor};
    EXPECT_NEAR(rated(project_of(room)).ugr.value, expected(k), 1e-9) << k;
  }
  const Room bright{.ceiling = 0.9, .walls = 0.8, .floor = 0.6};
  EXPECT_NEAR(rated(project_of(bright)).ugr.value, expected(0), 1e-9);
}

// Smaller rooms than tables have count as 2 H, longer ones as 12 H.
TEST_F(RoomUgrTest, EndsWhereTablesEnd) {
  const Room small{.x_m = 1.5 * kH_m, .y_m = 1.8 * kH_m},
      smallest{.x_m = 2.0 * kH_m, .y_m = 2.0 * kH_m};
  EXPECT_NEAR(rated(project_of(small)).ugr.value, rated(project_of(smallest)).ugr.value, 1e-9);
  const Room longer{.x_m = 8.0 * kH_m, .y_m = 30.0 * kH_m},
      longest{.x_m = 8.0 * kH_m, .y_m = 12.0 * kH_m};
  EXPECT_NEAR(rated(project_of(longer)).ugr.value, rated(project_of(longest)).ugr.value, 1e-9);
}

TEST_F(RoomUgrTest, SaysWhatARoomBeyondTablesCountsAs) {
  const auto words_of = [&](double x_h, double y_h) {
    return rated(project_of({.x_m = x_h * kH_m, .y_m = y_h * kH_m})).words;
  };
  EXPECT_NE(words_of(1.5, 30.0).english().find("the room counts as 12.00 H x 2.00 H"),
            std::string::npos);
  EXPECT_EQ(words_of(2.0, 12.0).english().find("counts as"), std::string::npos);
}

// So many kinds are no regular array, and each would cost time and memory.
TEST_F(RoomUgrTest, IsNotOfManyKinds) {
  Project project = project_of({.columns = 1, .rows = 1});
  for (int i = 0; i < 16; ++i) add_array(project, {.columns = 1, .rows = 1}, 0, 0.02 * (i + 1));
  EXPECT_NE(rated(project).problem.english().find("more than 16 kinds"), std::string::npos);
  project.spaces[0].luminaires.pop_back();
  EXPECT_EQ(rated(project).problem, "");
}

// Two kinds at two heights, by hand from their arrays: the sums, each by H^2 and its number.
TEST_F(RoomUgrTest, OfAMixtureIsThatOfTheSumsAndAtMostOfTheWorst) {
  const Room room;
  Project project = project_of(room);
  constexpr double kLower_m = 0.6;
  add_array(project, {.columns = 1, .rows = 3}, 0, kLower_m);
  const PhotometricWeb web = oblong_web();
  const UgrReflectances rho{0.7, 0.5, 0.2};
  double value = -1e9, worst = -1e9;
  for (const bool is_along : {true, false}) {
    const double across_m = is_along ? room.x_m : room.y_m,
                 along_m = is_along ? room.y_m : room.x_m;
    const glm::dmat3 frame =
        is_along ? glm::dmat3(1.0) : glm::dmat3({0, 1, 0}, {-1, 0, 0}, {0, 0, 1});
    const UgrLuminaire luminaire(web, frame);
    double sources = 0.0, background = 0.0;
    for (const auto& [number, h_m] : {std::pair{8.0, kH_m}, std::pair{3.0, kH_m - kLower_m}}) {
      const UgrArray array =
          luminaire.in_room(std::min(12.0, across_m / h_m), std::min(12.0, along_m / h_m));
      worst = std::max(worst, ugr_of(array.sources, array.background(rho)));
      sources += number * array.sources / (h_m * h_m);
      background += number * array.background(rho) / (h_m * h_m);
    }
    value = std::max(value, 8.0 * std::log10(0.25 * sources / background));
  }
  const RoomUgr result = rated(project);
  EXPECT_NEAR(result.ugr.value, value, 1e-9);
  EXPECT_NEAR(result.ugr.high, worst, 1e-9);
  EXPECT_GT(result.ugr.high, result.ugr.value + 0.01);
  EXPECT_EQ(result.ugr.low, result.ugr.value);
  EXPECT_NE(result.words.english().find("2 kinds"), std::string::npos) << result.words;
}

// Light that goes up alone has no source in the field, and only makes the background of others
// brighter.
TEST_F(RoomUgrTest, OfIndirectLightIsNothing) {
  Project project = project_of({});
  add_array(project, {}, 1, 0.3);
  EXPECT_LT(rated(project).ugr.value, rated(project_of({})).ugr.value);
  for (Luminaire& luminaire : project.spaces[0].luminaires) luminaire.type = 1;
  EXPECT_EQ(rated(project).problem, "");
  EXPECT_TRUE(is_nothing(rated(project).ugr));
}

// What hangs upside down shines the other way.
TEST_F(RoomUgrTest, KnowsWhatHangsUpsideDown) {
  Project project = project_of({});
  for (Luminaire& luminaire : project.spaces[0].luminaires) {
    luminaire.world_from_luminaire = glm::dmat3({1, 0, 0}, {0, -1, 0}, {0, 0, -1});
  }
  EXPECT_TRUE(is_nothing(rated(project).ugr)) << rated(project).problem;
  for (Luminaire& luminaire : project.spaces[0].luminaires) luminaire.type = 1;
  EXPECT_TRUE(std::isfinite(rated(project).ugr.value));
}

TEST_F(RoomUgrTest, SaysWhatItIsNotFor) {
  const auto problem_after = [&](const auto& change) {
    Project project = project_of({});
    change(project.spaces[0]);
    const std::string problem = rated(project).problem.english();
    EXPECT_EQ(why_no_room_ugr(project, project.spaces[0], nullptr), problem);
    return problem;
  };
  const auto expect = [&](const char* words, const auto& change) {
    const std::string problem = problem_after(change);
    EXPECT_NE(problem.find(words), std::string::npos) << words << ": " << problem;
  };
  EXPECT_EQ(problem_after([](Space&) {}), "");
  expect("floor, walls and ceiling", [](Space& space) { space.shell.reset(); });
  expect("rectangular", [](Space& space) { space.shell->footprint_m[2] *= 0.8; });
  expect("'l3' is not level", [](Space& space) {
    space.luminaires[3].world_from_luminaire =
        glm::dmat3({1, 0, 0}, {0, 0.9962, 0.0872}, {0, -0.0872, 0.9962});
  });
  expect("'l0' is 1.10 m above", [](Space& space) { space.luminaires[0].position_m.z = 1.1; });
  expect("'l2' has no luminous area", [](Space& space) { space.luminaires[2].type = 2; });
  expect("no luminaire", [](Space& space) { space.luminaires.clear(); });
  expect("'l1' is not in the room", [](Space& space) { space.luminaires[1].position_m.z = 9.0; });
  expect("'l1' is not in the room", [](Space& space) { space.luminaires[1].position_m.x = -0.1; });
  expect("spread evenly", [](Space& space) { space.luminaires.pop_back(); });
  expect("spread evenly", [](Space& space) { space.luminaires[1].position_m.y += 1.0; });
  expect("spread evenly", [](Space& space) {  // all at one end of the room
    for (Luminaire& luminaire : space.luminaires) luminaire.position_m.y *= 0.5;
  });
}

// Without width there is no area to shine from, and a ceiling that shines is too large for UGR.
TEST_F(RoomUgrTest, IsNotOfLinesNorOfCeilings) {
  const auto problem_of = [&](double length_m, double width_m) {
    Project project = project_of({});
    project.webs[0] = oblong_web({OpeningShape::rectangle, length_m, width_m, 0.0});
    return rated(project).problem;
  };
  EXPECT_NE(problem_of(1.2, 0.0).english().find("no luminous area"), std::string::npos);
  EXPECT_EQ(problem_of(1.2, 1.2), "");
  EXPECT_NE(problem_of(1.3, 1.2).english().find("luminous area of 1.56 m²"), std::string::npos);
}

// The same orientation in two ways, heights apart by less than a centimetre, and luminaires that
// are turned in turn.
TEST_F(RoomUgrTest, KnowsLuminairesThatAreAlike) {
  const double value = rated(project_of({})).ugr.value;
  Project project = project_of({});
  std::vector<Luminaire>& luminaires = project.spaces[0].luminaires;
  for (std::size_t i = 0; i < luminaires.size(); i += 2) {
    const double sign = i % 4 == 0 ? 1e-17 : -1e-17;
    luminaires[i].world_from_luminaire =
        glm::dmat3({-1.0, sign, 0.0}, {-sign, -1.0, 0.0}, {0, 0, 1});
    luminaires[i].position_m.z += 0.004;
  }
  EXPECT_EQ(rated(project).problem, "");
  EXPECT_NEAR(rated(project).ugr.value, value, 0.05);
  for (std::size_t i = 0; i < luminaires.size(); i += 2) {
    luminaires[i].world_from_luminaire = glm::dmat3({0, 1, 0}, {-1, 0, 0}, {0, 0, 1});
  }
  EXPECT_EQ(rated(project).problem, "");
  EXPECT_GT(rated(project).ugr.high, rated(project).ugr.value);
}

TEST_F(RoomUgrTest, IsNotKnownInABlackRoom) {
  const Room black{.ceiling = 0.0, .walls = 0.0, .floor = 0.0};
  EXPECT_NE(rated(project_of(black)).problem.english().find("no light is reflected"),
            std::string::npos);
}

}  // namespace
}  // namespace calc::room_ugr_test
