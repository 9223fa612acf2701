// The light on roads against hand work, other programs, a second derivation and symmetry.
#include "calc/road/road_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace calc::road_light_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

PhotometricWeb uniform_web(double cd = 1000.0) {
  return PhotometricWeb::make({0.0}, {0.0, std::numbers::pi}, {cd, cd}, {}, {});
}

// Smooth, brighter to C90, symmetric about the plane of C90.
double smooth_cd(double c_rad, double gamma_rad) {
  if (gamma_rad >= 0.5 * std::numbers::pi) return 0.0;
  return 2000.0 * std::cos(gamma_rad) * (1.0 + 4.0 * std::pow(std::sin(gamma_rad), 4)) *
         (1.0 + 0.5 * std::sin(c_rad));
}
// Without that symmetry.
double skew_cd(double c_rad, double gamma_rad) {
  return smooth_cd(c_rad, gamma_rad) * (1.0 + 0.3 * std::cos(c_rad + 0.4));
}

// So fine that it is within 2e-5 of the function: the error of linear interpolation falls by the
// square of the step, and a file of 2.5 x 1 degree was 1.5e-4 off.
PhotometricWeb sampled(double (*cd_of)(double, double)) {
  constexpr int kC = 720, kGamma = 360;  // half and quarter degrees
  std::vector<double> c, gamma, cd;
  for (int i = 0; i <= kC; ++i) c.push_back(2.0 * std::numbers::pi * i / kC);
  for (int k = 0; k <= kGamma; ++k) gamma.push_back(0.5 * std::numbers::pi * k / kGamma);
  for (int i = 0; i <= kC; ++i)
    for (const double g : gamma)
      cd.push_back(std::max(0.0, cd_of(c[static_cast<std::size_t>(i % kC)], g)));
  return PhotometricWeb::make(c, gamma, cd, {}, {});
}
const PhotometricWeb& smooth_web() {
  static const PhotometricWeb web = sampled(smooth_cd);
  return web;
}
const PhotometricWeb& skew_web() {
  static const PhotometricWeb web = sampled(skew_cd);
  return web;
}

// C90 to +y, raised there by the tilt, then turned to the left about z.
glm::dmat3 aimed(double tilt_deg, double turn_deg = 0.0) {
  const double ct = std::cos(tilt_deg * kDegree), st = std::sin(tilt_deg * kDegree);
  const double cz = std::cos(turn_deg * kDegree), sz = std::sin(turn_deg * kDegree);
  const glm::dmat3 tilted({1, 0, 0}, {0, ct, st}, {0, -st, ct});
  const glm::dmat3 turned({cz, sz, 0}, {-sz, cz, 0}, {0, 0, 1});
  return turned * tilted;
}

RoadLayout empty_road(double spacing_m, double lane_m, int lanes, std::string_view surface) {
  RoadLayout road;
  road.spacing_m = spacing_m;
  road.width_m = lane_m * lanes;
  road.lanes = lanes;
  road.is_oncoming.assign(static_cast<std::size_t>(lanes), false);
  road.table = r_table(surface);
  road.q0 = road.table->q0;
  road.right_strip_m = road.left_strip_m = lane_m;
  return road;
}

RoadRow row_of(const PhotometricWeb& web, double height_m, double y_m, double maintenance,
               double shift_m, const glm::dmat3& road_from_luminaire) {
  return {&web, 1.0, maintenance, height_m, y_m, shift_m, road_from_luminaire};
}

// One luminaire at x = 0: the others are out of reach.
RoadLayout one_luminaire(const PhotometricWeb& web, double height_m, double maintenance,
                         double y_m = 0.0) {
  RoadLayout road = empty_road(1000.0, 3.5, 2, "R3");
  road.rows.push_back(row_of(web, height_m, y_m, maintenance, 0.0, aimed(0.0)));
  return road;
}

// --- one luminaire ------------------------------------------------------------------------------

TEST(RoadLight, OneLuminaireAgreesWithHandWork) {
  const PhotometricWeb web = uniform_web();
  const RoadLayout road = one_luminaire(web, 10.0, 0.9);
  const struct {
    glm::dvec2 point, eye;
    double cd_m2, lx;
  } cases[] = {{{-20, 0}, {-80, 0}, 0.2934, 0.804984472},
               {{20, 0}, {-40, 0}, 0.0342, 0.804984472},
               {{0, 0}, {-60, 0}, 0.2646, 9.0},  // under it
               {{-10, 5}, {-70, 5}, 0.175956279, 2.66666667},
               {{0, 7}, {-60, 1.75}, 0.143699961, 4.94838073},
               {{15, -3}, {-45, 2}, 0.0538031064, 1.47442542}};
  for (const auto& one : cases) {
    const RoadLevel level = road_luminance_cd_m2(road, one.point, one.eye);
    EXPECT_NEAR(level.maintained, one.cd_m2, 1e-9) << one.point.x << " " << one.point.y;
    EXPECT_NEAR(level.initial, one.cd_m2 / 0.9, 1.2e-9);
    EXPECT_NEAR(road_point_illuminance_lx(road, one.point), one.lx, 1e-8);
  }
}

// A surface that looks alike from everywhere: L = q0 E, on the nodes exactly.
TEST(RoadLight, MattSurfaceIsQ0TimesIlluminance) {
  RTable matt{"matt", 0.07, false, {}};
  for (std::size_t i = 0; i < kRTableTans; ++i)
    matt.r_1e4[i].fill(700.0 / std::pow(1.0 + kRTableTan[i] * kRTableTan[i], 1.5));
  const PhotometricWeb web = uniform_web();
  RoadLayout road = one_luminaire(web, 10.0, 0.9);
  road.table = &matt;
  for (const double q0 : {0.07, 0.1}) {
    road.q0 = q0;
    for (const double tan_epsilon : {0.0, 1.0, 3.0, 4.5}) {
      const glm::dvec2 point(-10.0 * tan_epsilon * 0.8, 10.0 * tan_epsilon * 0.6);
      EXPECT_NEAR(road_luminance_cd_m2(road, point, {-100, 1.75}).maintained /
                      road_point_illuminance_lx(road, point),
                  q0, 1e-12);
    }
  }
}

// 5 H towards the eye, 12 H beyond the point, 5 H to each side, and tan epsilon of at most 12.
TEST(RoadLight, FarLuminairesDoNotCount) {
  const PhotometricWeb web = uniform_web();
  const RoadLayout road = one_luminaire(web, 10.0, 1.0);
  const auto level = [&](double x, double y) {
    return road_luminance_cd_m2(road, {x, y}, {x - 60.0, y}).maintained;
  };
  EXPECT_GT(level(-120.0, 0.0), 0.0);  // 12 H
  EXPECT_EQ(level(-120.1, 0.0), 0.0);
  EXPECT_GT(level(-119.0, 5.0), 0.0);
  EXPECT_EQ(level(-119.9, 5.0), 0.0);  // tan 12.0004
  EXPECT_GT(level(50.0, 0.0), 0.0);
  EXPECT_EQ(level(50.1, 0.0), 0.0);
  EXPECT_GT(level(0.0, 50.0), 0.0);
  EXPECT_EQ(level(0.0, 50.1), 0.0);
  EXPECT_GT(level(0.0, -50.0), 0.0);
  EXPECT_EQ(level(0.0, -50.1), 0.0);
  // Illuminance: 5 H along and across, or around.
  const auto lit = [&](double x, double y, RoadReach reach) {
    return road_point_illuminance_lx(road, {x, y}, reach) > 0.0;
  };
  for (const RoadReach reach : {RoadReach::square, RoadReach::circle}) {
    EXPECT_TRUE(lit(50.0, 0.0, reach) && lit(0.0, -50.0, reach) && lit(40.0, 30.0, reach));
    EXPECT_FALSE(lit(-50.1, 0.0, reach) || lit(0.0, 50.1, reach));
  }
  EXPECT_TRUE(lit(49.0, -49.0, RoadReach::square));
  EXPECT_FALSE(lit(40.1, 30.0, RoadReach::circle));
}

TEST(RoadLight, TiltRaisesTheSideOfC90) {
  // All light within a degree of the axis: it meets the road at H tan(tilt) towards +y.
  const PhotometricWeb beam =
      PhotometricWeb::make({0.0}, {0.0, kDegree, std::numbers::pi}, {1000.0, 0.0, 0.0}, {}, {});
  RoadLayout road = one_luminaire(beam, 10.0, 1.0);
  road.rows[0].road_from_luminaire = aimed(15.0);
  const double y_m = 10.0 * std::tan(15.0 * kDegree);
  EXPECT_NEAR(road_point_illuminance_lx(road, {0.0, y_m}),
              1000.0 * std::pow(std::cos(15.0 * kDegree), 3) / 100.0, 1e-6);
  EXPECT_EQ(road_point_illuminance_lx(road, {0.0, -y_m}), 0.0);
}

// --- glare --------------------------------------------------------------------------------------

TEST(RoadLight, VeilingAgreesWithHandWork) {
  const PhotometricWeb web = uniform_web();
  const auto plane = [&](double height_m, double ahead_m, double beside_m) {
    // Maintenance has no part in it.
    return road_veiling(one_luminaire(web, height_m, 0.5, beside_m), {-ahead_m, 0.0, 1.5})
        .by_plane_cd_m2;
  };
  EXPECT_NEAR(plane(3.5, 10.0, 0.0), 0.620066291, 1e-7);
  EXPECT_NEAR(plane(9.0, 20.625, 1.75), 0.0417392577, 1e-8);  // just below the 20 degrees
  EXPECT_EQ(plane(9.0, 20.5, 1.75), 0.0);
  EXPECT_NEAR(plane(4.5, 400.0, 0.0), 0.0369412227, 1e-8);  // theta 1.43: the other formula
  EXPECT_GT(plane(4.5, 500.0, 0.0), 0.0);
  EXPECT_EQ(plane(4.5, 500.5, 0.0), 0.0);
  EXPECT_EQ(plane(4.5, -10.0, 0.0), 0.0);  // behind
  EXPECT_EQ(plane(4.5, 10.0, 19.0), 0.0);  // beyond 60 degrees
  EXPECT_GT(plane(4.5, 10.0, 16.0), 0.0);
}

TEST(RoadLight, ScreensDifferBesideTheEye) {
  const PhotometricWeb web = uniform_web();
  // 20 degrees by the plane 20.6 m ahead; by the elevation 10 m beside already 18 m ahead.
  const auto veiling = [&](double ahead_m) {
    return road_veiling(one_luminaire(web, 9.0, 1.0, 10.0), {-ahead_m, 0.0, 1.5});
  };
  EXPECT_EQ(veiling(19.0).by_plane_cd_m2, 0.0);
  EXPECT_GT(veiling(19.0).by_elevation_cd_m2, 0.0);
  EXPECT_EQ(veiling(17.9).by_elevation_cd_m2, 0.0);
  EXPECT_EQ(veiling(21.0).by_plane_cd_m2, veiling(21.0).by_elevation_cd_m2);
}

TEST(RoadLight, ThresholdIncrementHasTwoRanges) {
  EXPECT_DOUBLE_EQ(*threshold_increment_percent(0.05, 1.0), 3.25);
  EXPECT_NEAR(*threshold_increment_percent(1.0, 10.0), 8.46688391, 1e-8);
  EXPECT_NEAR(*threshold_increment_percent(1.0, 5.0), 65.0 / std::pow(5.0, 0.8), 1e-12);
  EXPECT_NEAR(*threshold_increment_percent(1.0, 5.001), 95.0 / std::pow(5.001, 1.05), 1e-12);
  EXPECT_FALSE(threshold_increment_percent(1.0, 0.05));
  EXPECT_TRUE(threshold_increment_percent(1.0, 0.0501));
  EXPECT_FALSE(threshold_increment_percent(0.0, 0.0));
}

// --- whole roads --------------------------------------------------------------------------------

struct ExpectedObserver {
  double average, least, largest, uo, ul, veiling, ti;
};
struct ExpectedRoad {
  std::size_t along, lx_rows;
  double mean_lx, least_lx, largest_lx;
  std::vector<ExpectedObserver> observers;
  double ratio_at_0, ratio_at_width;
  double surround_2003;  // both strips outside by both inside, as wide as min(5 m, width / 2)
  double first_cd_m2, last_cd_m2, first_lx;
};

void expect_relative(double value, double expected, double tolerance, const std::string& what) {
  EXPECT_NEAR(value, expected, tolerance * std::abs(expected)) << what;
}

// Tolerances are those of the vectors: 1e-4, of glare 1e-3.
void expect_road(const RoadLayout& road, const ExpectedRoad& expected, const std::string& name) {
  const RoadLight light = road_light(road);
  EXPECT_EQ(light.grid.along(), expected.along) << name;
  EXPECT_EQ(light.grid.across(), 3U * static_cast<std::size_t>(road.lanes)) << name;
  const RoadIlluminance lit = road_illuminance(road, 0.0, road.width_m);
  EXPECT_EQ(lit.grid.across(), expected.lx_rows) << name;
  EXPECT_EQ(lit.grid.along(), expected.along) << name;
  expect_relative(lit.mean_lx(), expected.mean_lx, 1e-4, name + " mean lx");
  expect_relative(*std::min_element(lit.lx.begin(), lit.lx.end()), expected.least_lx, 1e-4,
                  name + " least lx");
  expect_relative(*std::max_element(lit.lx.begin(), lit.lx.end()), expected.largest_lx, 1e-4,
                  name + " largest lx");
  expect_relative(lit.lx.front(), expected.first_lx, 1e-4, name + " first lx");
  ASSERT_EQ(light.observers.size(), expected.observers.size()) << name;
  for (std::size_t i = 0; i < light.observers.size(); ++i) {
    const RoadObserver& observer = light.observers[i];
    const ExpectedObserver& should = expected.observers[i];
    const std::string lane = name + " lane " + std::to_string(i);
    EXPECT_EQ(observer.lane, static_cast<int>(i));
    ASSERT_TRUE(observer.uo && observer.ul && observer.ti_percent) << lane;
    expect_relative(observer.average_cd_m2.value, should.average, 1e-4, lane + " average");
    expect_relative(*std::min_element(observer.cd_m2.begin(), observer.cd_m2.end()), should.least,
                    1e-4, lane + " least");
    expect_relative(*std::max_element(observer.cd_m2.begin(), observer.cd_m2.end()), should.largest,
                    1e-4, lane + " largest");
    expect_relative(observer.uo->value, should.uo, 1e-4, lane + " Uo");
    expect_relative(observer.ul->value, should.ul, 1e-4, lane + " Ul");
    expect_relative(observer.veiling_cd_m2.value, should.veiling, 1e-3, lane + " Lv");
    expect_relative(observer.ti_percent->value, should.ti, 1e-3, lane + " TI");
  }
  ASSERT_TRUE(light.right_ratio && light.left_ratio) << name;
  expect_relative(light.right_ratio->value, expected.ratio_at_0, 1e-4, name + " REI at 0");
  expect_relative(light.left_ratio->value, expected.ratio_at_width, 1e-4, name + " REI at width");
  const double w = road.width_m, strip = std::min(5.0, 0.5 * w);
  const double outside = road_illuminance(road, -strip, 0.0).mean_lx() +
                         road_illuminance(road, w, w + strip).mean_lx();
  const double inside =
      road_illuminance(road, 0.0, strip).mean_lx() + road_illuminance(road, w - strip, w).mean_lx();
  expect_relative(outside / inside, expected.surround_2003, 1e-4, name + " SR");
  expect_relative(light.observers[0].cd_m2.front(), expected.first_cd_m2, 1e-4, name + " first");
  expect_relative(light.observers[0].cd_m2.back(), expected.last_cd_m2, 1e-4, name + " last");
}

RoadLayout single_sided(double tilt_deg, std::string_view surface) {
  RoadLayout road = empty_road(36.0, 3.5, 2, surface);
  road.rows.push_back(row_of(smooth_web(), 9.0, 0.5, 0.8, 0.0, aimed(tilt_deg)));
  return road;
}

RoadLayout staggered() {
  RoadLayout road = empty_road(40.0, 3.5, 3, "R3");
  road.rows.push_back(row_of(smooth_web(), 9.0, -1.0, 0.8, 0.0, aimed(5.0)));
  road.rows.push_back(row_of(smooth_web(), 9.0, 11.5, 0.8, 20.0, aimed(5.0, 180.0)));
  return road;
}

// Worked out by another program, whose points agree with a published engine to 3e-15.
TEST(RoadLight, SingleRowAgreesWithAnotherProgram) {
  expect_road(
      single_sided(0.0, "R3"),
      {12,
       5,
       12.5996149,
       5.80321715,
       24.9640441,
       {{0.899266824, 0.443955704, 1.45111701, 0.493686293, 0.75254995, 0.27549584, 16.3075806},
        {0.966163475, 0.499381641, 1.44539281, 0.516870751, 0.708866455, 0.221736732, 12.3931726}},
       0.69664111,
       0.819424071,
       0.757880953,
       1.070026,
       0.696405656,
       20.6078241},
      "single");
  expect_road(
      single_sided(10.0, "R3"),
      {12,
       5,
       11.0539053,
       5.53044021,
       22.1094712,
       {{0.835264367, 0.438112262, 1.37886538, 0.524519276, 0.718722228, 0.273588723, 17.1800481},
        {0.902876998, 0.496434221, 1.37632172, 0.549835938, 0.75054454, 0.234688217, 13.8475761}},
       0.771454247,
       0.81254063,
       0.792511609,
       0.860146438,
       0.628660237,
       12.9838491},
      "tilted");
  expect_road(
      single_sided(0.0, "C2"),
      {12,
       5,
       12.5996149,
       5.80321715,
       24.9640441,
       {{0.922888502, 0.424038822, 1.43216303, 0.459469178, 0.750575475, 0.27549584, 15.9727981},
        {0.982861131, 0.472783062, 1.44535038, 0.481027326, 0.626437572, 0.221736732, 12.2244481}},
       0.69664111,
       0.819424071,
       0.757880953,
       1.08032754,
       0.81649027,
       20.6078241},
      "C2");
}

TEST(RoadLight, TwoRowsAgreeWithAnotherProgram) {
  RoadLayout opposite = empty_road(30.0, 3.5, 2, "R3");
  opposite.rows.push_back(row_of(smooth_web(), 9.0, 0.5, 0.8, 0.0, aimed(0.0)));
  opposite.rows.push_back(row_of(smooth_web(), 9.0, 6.5, 0.8, 0.0, aimed(0.0, 180.0)));
  expect_road(
      opposite,
      {10,
       5,
       30.2390757,
       18.3557048,
       49.1723979,
       {{2.23631541, 1.75282593, 2.51630867, 0.783800854, 0.856648408, 0.566033468, 16.1659418},
        {2.23631541, 1.75282593, 2.51630867, 0.783800854, 0.856648408, 0.566033468, 16.1659418}},
       0.757880953,
       0.757880953,
       0.757880953,
       2.10506463,
       1.93991077,
       41.7928156},
      "opposite");
  expect_road(
      staggered(),
      {14,
       7,
       19.3376121,
       15.4049836,
       26.9655771,
       {{1.25470269, 1.01399944, 1.6434686, 0.808159131, 0.744603715, 0.340789782, 15.4539409},
        {1.2668221, 1.04641131, 1.6625291, 0.826012828, 0.952872617, 0.318916122, 14.3512363},
        {1.25085041, 0.94685149, 1.6599121, 0.756966205, 0.744603715, 0.340789782, 15.4920044}},
       0.759216549,
       0.759216549,
       0.701015468,
       1.32342055,
       1.46031706,
       26.9655771},
      "staggered");
}

// --- a second derivation ------------------------------------------------------------------------

// Everything by angles, as the standard draws it: from the functions instead of sampled tables,
// with angles undone one after the other instead of matrices.
struct AngledRow {
  double (*cd_of)(double, double);
  double factor, maintenance, height_m, y_m, shift_m, tilt_deg, turn_deg;

  // New, towards an azimuth (from +x to the left) and an angle from straight down.
  double cd(double azimuth_rad, double down_rad) const {
    const double azimuth = azimuth_rad - turn_deg * kDegree;
    const double x = std::sin(down_rad) * std::cos(azimuth);
    const double y = std::sin(down_rad) * std::sin(azimuth), z = -std::cos(down_rad);
    // In the plane across the luminaire the tilt is an angle to be taken off.
    const double rho = std::hypot(y, z), phi = std::atan2(z, y) - tilt_deg * kDegree;
    const double gamma = std::acos(std::clamp(-rho * std::sin(phi), -1.0, 1.0));
    return factor * std::max(0.0, cd_of(std::atan2(rho * std::cos(phi), x), gamma));
  }
};

struct AngledRoad {
  double spacing_m, width_m, scale;
  int lanes;
  const RTable* table;
  std::vector<AngledRow> rows;

  double luminance(double x, double y, double eye_x, double eye_y, bool is_maintained) const {
    double sum = 0.0;
    for (const AngledRow& row : rows) {
      for (int k = -40; k <= 40; ++k) {
        const double dx = x - (row.shift_m + k * spacing_m), dy = y - row.y_m;  // from luminaire
        const double h = row.height_m, plan = std::hypot(dx, dy);
        if (dx > 5 * h || dx < -12 * h || std::abs(dy) > 5 * h || plan > 12 * h) continue;
        const double epsilon = std::atan(plan / h);
        // Both directions end at the point: they are opposite where the luminaire is beyond it.
        double between = std::abs(std::atan2(y - eye_y, x - eye_x) - std::atan2(dy, dx)) / kDegree;
        if (between > 180.0) between = 360.0 - between;
        const double r = 1e-4 * r_1e4(*table, std::tan(epsilon), 180.0 - between);
        sum += row.cd(std::atan2(dy, dx), epsilon) * r / (h * h) *
               (is_maintained ? row.maintenance : 1.0);
      }
    }
    return sum * scale;
  }

  double veiling(double eye_x, double eye_y) const {
    double sum = 0.0;
    for (const AngledRow& row : rows) {
      for (int k = -40; k <= 40; ++k) {
        const double dx = row.shift_m + k * spacing_m - eye_x, dy = row.y_m - eye_y;
        if (dx <= 0.0 || dx > 500.0) continue;
        const double dz = row.height_m - 1.5, plan = std::hypot(dx, dy);
        if (std::atan(dz / dx) > 20 * kDegree) continue;
        const double elevation = std::atan(dz / plan), azimuth = std::atan2(dy, dx);
        const double theta = std::acos(std::cos(elevation) * std::cos(azimuth) * std::cos(kDegree) -
                                       std::sin(elevation) * std::sin(kDegree));
        if (theta > 60 * kDegree) continue;
        const double distance = plan / std::cos(elevation);
        const double cd = row.cd(std::atan2(-dy, -dx), 0.5 * std::numbers::pi - elevation);
        const double lx = cd * std::cos(theta) / (distance * distance), t = theta / kDegree;
        sum += t > 1.5 ? 9.86 * lx * (1 + std::pow(23 / 66.4, 4)) / (t * t)
                       : lx * (10 / (t * t * t) + 5 / (t * t) * (1 + std::pow(23 / 62.5, 4)));
      }
    }
    return sum;
  }
};

// Three rows of different luminaires and heights on another surface, one lane against the others.
struct MixedRoad {
  RoadLayout layout;
  AngledRoad angled;
};
MixedRoad mixed_road() {
  MixedRoad road{empty_road(34.0, 3.25, 3, "R2"), {}};
  road.layout.q0 = 0.09;
  road.angled = {34.0,
                 9.75,
                 0.09 / 0.07,
                 3,
                 road.layout.table,
                 {{skew_cd, 0.7, 0.8, 8.0, -1.2, 3.0, 10.0, 0.0},
                  {smooth_cd, 1.1, 0.9, 10.0, 10.5, 17.5, -5.0, 170.0},
                  {skew_cd, 0.4, 0.67, 6.0, 4.0, 0.0, 20.0, 75.0}}};
  for (const AngledRow& row : road.angled.rows) {
    road.layout.rows.push_back({row.cd_of == skew_cd ? &skew_web() : &smooth_web(), row.factor,
                                row.maintenance, row.height_m, row.y_m, row.shift_m,
                                aimed(row.tilt_deg, row.turn_deg)});
  }
  return road;
}

TEST(RoadLight, AgreesWithASecondDerivation) {
  const MixedRoad road = mixed_road();
  const RoadLight light = road_light(road.layout);
  ASSERT_EQ(light.grid.along(), 12U);
  const double pace = 34.0 / 12;
  for (int lane = 0; lane < 3; ++lane) {
    const RoadObserver& observer = light.observers[static_cast<std::size_t>(lane)];
    const double eye_y = 3.25 * (lane + 0.5);
    for (const double eye_x : {-60.0, 0.5 * pace - 60.0}) {
      double sum = 0.0, initial = 0.0, least = 1e9, line_least = 1e9, line_largest = 0.0;
      for (int j = 0; j < 9; ++j) {
        for (int i = 0; i < 12; ++i) {
          const double x = (i + 0.5) * pace, y = (j + 0.5) * 3.25 / 3;
          const double l = road.angled.luminance(x, y, eye_x, eye_y, true);
          sum += l, least = std::min(least, l);
          initial += road.angled.luminance(x, y, eye_x, eye_y, false);
          if (j == 3 * lane + 1)
            line_least = std::min(line_least, l), line_largest = std::max(line_largest, l);
          if (eye_x == -60.0)
            expect_relative(observer.cd_m2[static_cast<std::size_t>(j * 12 + i)], l, 5e-5, "point");
        }
      }
      const double average = sum / 108, uo = least / average, ul = line_least / line_largest;
      // The series of the row with the least shift, 6 m high.
      double veiling = 0.0;
      for (int i = 0; i < 12; ++i)
        veiling = std::max(veiling, road.angled.veiling(-2.75 * 4.5 + i * pace, eye_y));
      const double ti = 65 * veiling / std::pow(initial / 108, 0.8);
      if (eye_x == -60.0) {
        expect_relative(observer.average_cd_m2.value, average, 5e-5, "average");
        expect_relative(observer.uo->value, uo, 5e-5, "Uo");
        expect_relative(observer.ul->value, ul, 5e-5, "Ul");
        expect_relative(observer.veiling_cd_m2.value, veiling, 1e-4, "Lv");
        expect_relative(observer.ti_percent->value, ti, 1e-4, "TI");
      }
      // The other reading is the other end of the interval.
      const auto holds = [](const Estimate& e, double x) {
        return e.low <= x * (1 + 5e-5) && e.high >= x * (1 - 5e-5);
      };
      EXPECT_TRUE(holds(observer.average_cd_m2, average));
      EXPECT_TRUE(holds(*observer.uo, uo));
      EXPECT_TRUE(holds(*observer.ul, ul));
      EXPECT_TRUE(holds(*observer.ti_percent, ti));
    }
    EXPECT_LT(observer.average_cd_m2.low, observer.average_cd_m2.high);
    EXPECT_LT(observer.average_cd_m2.high, 1.02 * observer.average_cd_m2.low);
  }
}

// What other series give is inside the interval.
TEST(RoadLight, GlareOfOtherReadingsIsInTheInterval) {
  const MixedRoad road = mixed_road();
  const RoadLight light = road_light(road.layout);
  for (const RoadObserver& observer : light.observers) {
    double least = std::numeric_limits<double>::infinity(), largest = 0.0;
    for (const RoadRow& row : road.layout.rows) {
      double plane = 0.0, elevation = 0.0;
      for (int i = 0; i < 12; ++i) {
        const double x = row.shift_m - 2.75 * (row.height_m - 1.5) + i * 34.0 / 12;
        const RoadVeiling here = road_veiling(road.layout, {x, observer.eye_m.y, 1.5});
        plane = std::max(plane, here.by_plane_cd_m2);
        elevation = std::max(elevation, here.by_elevation_cd_m2);
      }
      least = std::min({least, plane, elevation});
      largest = std::max({largest, plane, elevation});
    }
    EXPECT_DOUBLE_EQ(observer.veiling_cd_m2.low, least);
    EXPECT_DOUBLE_EQ(observer.veiling_cd_m2.high, largest);
    const double per_veiling = observer.ti_percent->value / observer.veiling_cd_m2.value;
    EXPECT_LE(observer.ti_percent->low, per_veiling * least * (1 + 1e-12));
    EXPECT_GE(observer.ti_percent->high, per_veiling * largest * (1 - 1e-12));
  }
}

// An eye that stays 60 m before the field sees far less glare than the one that moves.
TEST(RoadLight, EyeOfGlareMoves) {
  RoadLayout road = single_sided(0.0, "R3");
  road.spacing_m = 40.0;  // at -60 m the nearest luminaire ahead, 20 m away, is screened
  const RoadObserver observer = road_light(road).observers[0];
  const RoadVeiling fixed = road_veiling(road, {-60.0, 1.75, 1.5});
  EXPECT_LT(fixed.by_elevation_cd_m2, 0.6 * observer.veiling_cd_m2.low);
  EXPECT_NEAR(observer.veiling_cd_m2.value, road_veiling(road, {-20.625, 1.75, 1.5}).by_plane_cd_m2,
              1e-12);
}

// --- symmetry and scale -------------------------------------------------------------------------

void expect_same(const Estimate& a, const Estimate& b, const char* what) {
  EXPECT_NEAR(a.value, b.value, 1e-11 * b.value) << what;
  EXPECT_NEAR(a.low, b.low, 1e-11 * b.low) << what;
  EXPECT_NEAR(a.high, b.high, 1e-11 * b.high) << what;
}
void expect_same(const RoadObserver& a, const RoadObserver& b) {
  expect_same(a.average_cd_m2, b.average_cd_m2, "average");
  expect_same(*a.uo, *b.uo, "Uo");
  expect_same(*a.ul, *b.ul, "Ul");
  expect_same(a.veiling_cd_m2, b.veiling_cd_m2, "Lv");
  expect_same(*a.ti_percent, *b.ti_percent, "TI");
}

// The road turned by half a turn, row by row and lane by lane.
RoadLayout turned_road(const RoadLayout& road) {
  RoadLayout turned = road;
  for (RoadRow& row : turned.rows) {
    row.y_m = road.width_m - row.y_m;
    row.shift_m = row.shift_m == 0.0 ? 0.0 : road.spacing_m - row.shift_m;
    row.road_from_luminaire = aimed(0.0, 180.0) * row.road_from_luminaire;
  }
  for (std::size_t i = 0; i < road.is_oncoming.size(); ++i)
    turned.is_oncoming[road.is_oncoming.size() - 1 - i] = !road.is_oncoming[i];
  std::swap(turned.right_strip_m, turned.left_strip_m);
  return turned;
}

TEST(RoadLight, TurnedRoadIsTheSame) {
  RoadLayout road = mixed_road().layout;
  road.left_strip_m = 2.0;
  for (const bool is_mixed : {false, true}) {
    if (is_mixed) road.is_oncoming = {false, true, true};
    const RoadLight light = road_light(road), turned = road_light(turned_road(road));
    ASSERT_EQ(light.observers.size(), 3U);
    ASSERT_EQ(turned.observers.size(), 3U);
    for (std::size_t lane = 0; lane < 3; ++lane) {
      const RoadObserver &a = light.observers[lane], &b = turned.observers[2 - lane];
      EXPECT_EQ(a.lane, static_cast<int>(lane));
      EXPECT_NE(a.is_oncoming, b.is_oncoming);
      EXPECT_EQ(a.is_oncoming, road.is_oncoming[lane]);
      expect_same(a, b);
      EXPECT_NEAR(a.eye_m.x, 34.0 - b.eye_m.x, 1e-12);
      EXPECT_NEAR(a.eye_m.y, 9.75 - b.eye_m.y, 1e-12);
      EXPECT_NEAR(a.eye_m.y, 3.25 * (a.lane + 0.5), 1e-12);
      for (std::size_t i = 0; i < a.cd_m2.size(); ++i)
        EXPECT_NEAR(a.cd_m2[i], b.cd_m2[a.cd_m2.size() - 1 - i], 1e-11);
    }
    expect_same(*light.right_ratio, *turned.left_ratio, "ratio");
    expect_same(*light.left_ratio, *turned.right_ratio, "ratio");
  }
}

// Traffic both ways under light without a side: both directions see the same.
TEST(RoadLight, OncomingTrafficSeesTheSymmetricRoadAlike) {
  RoadLayout road = empty_road(36.0, 3.5, 2, "R3");
  road.is_oncoming = {false, true};
  road.rows.push_back(row_of(smooth_web(), 9.0, 0.5, 0.8, 0.0, aimed(0.0)));
  road.rows.push_back(row_of(smooth_web(), 9.0, 6.5, 0.8, 0.0, aimed(0.0, 180.0)));
  const RoadLight light = road_light(road);
  expect_same(light.observers[0], light.observers[1]);
  EXPECT_EQ(light.observers[0].eye_m, glm::dvec3(-60.0, 1.75, 1.5));
  EXPECT_EQ(light.observers[1].eye_m, glm::dvec3(96.0, 5.25, 1.5));
}

TEST(RoadLight, OrderOfRowsDoesNotMatter) {
  RoadLayout road = mixed_road().layout;
  const RoadLight light = road_light(road);
  std::reverse(road.rows.begin(), road.rows.end());
  const RoadLight other = road_light(road);
  for (std::size_t lane = 0; lane < 3; ++lane)
    expect_same(light.observers[lane], other.observers[lane]);
  expect_same(*light.right_ratio, *other.right_ratio, "ratio");
}

TEST(RoadLight, FollowsTheFlux) {
  RoadLayout road = staggered();
  const RoadLight light = road_light(road);
  for (const double k : {0.5, 2.0}) {
    RoadLayout scaled = road;
    for (RoadRow& row : scaled.rows) row.factor *= k;
    const RoadLight other = road_light(scaled);
    for (std::size_t lane = 0; lane < 3; ++lane) {
      const RoadObserver &a = light.observers[lane], &b = other.observers[lane];
      EXPECT_NEAR(b.average_cd_m2.value, k * a.average_cd_m2.value, 1e-12);
      EXPECT_NEAR(b.uo->value, a.uo->value, 1e-12);
      EXPECT_NEAR(b.ul->value, a.ul->value, 1e-12);
      EXPECT_NEAR(b.ti_percent->value, a.ti_percent->value * std::pow(k, 0.2), 1e-10);
    }
    EXPECT_NEAR(other.left_ratio->value, light.left_ratio->value, 1e-12);
  }
}

// Dirt takes light from the road, but glare is judged with clean luminaires.
TEST(RoadLight, MaintenanceHasNoPartInGlare) {
  RoadLayout road = staggered();
  const RoadLight light = road_light(road);
  for (RoadRow& row : road.rows) row.maintenance = 0.4;
  const RoadLight dirty = road_light(road);
  for (std::size_t lane = 0; lane < 3; ++lane) {
    EXPECT_NEAR(dirty.observers[lane].average_cd_m2.value,
                0.5 * light.observers[lane].average_cd_m2.value, 1e-12);
    EXPECT_DOUBLE_EQ(dirty.observers[lane].ti_percent->value,
                     light.observers[lane].ti_percent->value);
  }
  EXPECT_NEAR(road_illuminance(road, 0, 10.5).mean_lx(), 0.5 * 19.3376121, 1e-3);
}

TEST(RoadLight, SurfaceIsScaledByItsQ0) {
  RoadLayout road = staggered();
  const double average = road_light(road).observers[1].average_cd_m2.value;
  road.q0 = 0.1;
  EXPECT_NEAR(road_light(road).observers[1].average_cd_m2.value, average / 0.07 * 0.1, 1e-12);
}

// --- grids and ends -----------------------------------------------------------------------------

TEST(RoadLight, GridsFollowTheStandard) {
  const auto along = [](double spacing_m) {
    return road_luminance_grid(empty_road(spacing_m, 3.5, 2, "R3")).along();
  };
  EXPECT_EQ(along(12.0), 10U);
  EXPECT_EQ(along(30.0), 10U);
  EXPECT_EQ(along(30.001), 11U);
  EXPECT_EQ(along(33.0), 11U);
  EXPECT_EQ(along(36.0), 12U);
  EXPECT_EQ(along(36.3), 13U);
  EXPECT_EQ(along(37.0), 13U);
  EXPECT_EQ(along(40.0), 14U);
  EXPECT_EQ(along(50.0), 17U);
  EXPECT_EQ(along(60.0), 20U);
  const RoadLayout road = empty_road(36.0, 3.6, 2, "R3");
  const RoadGrid grid = road_luminance_grid(road);
  EXPECT_DOUBLE_EQ(grid.x_m.front(), 1.5);
  EXPECT_DOUBLE_EQ(grid.x_m.back(), 34.5);
  ASSERT_EQ(grid.across(), 6U);
  EXPECT_DOUBLE_EQ(grid.y_m[0], 0.6);
  EXPECT_DOUBLE_EQ(grid.y_m[1], 1.8);
  EXPECT_DOUBLE_EQ(grid.y_m[5], 6.6);
  const auto rows = [&](double width_m) {
    return road_illuminance(road, -width_m, 0.0).grid.across();
  };
  EXPECT_EQ(rows(1.0), 3U);
  EXPECT_EQ(rows(4.5), 3U);
  EXPECT_EQ(rows(4.51), 4U);
  EXPECT_EQ(rows(7.5), 5U);
}

TEST(RoadLight, DarkRoadsHaveNoNumbers) {
  RoadLayout road = staggered();
  for (RoadRow& row : road.rows) row.factor = 0.0;
  for (const bool is_empty : {false, true}) {
    if (is_empty) road.rows.clear();
    const RoadLight light = road_light(road);
    EXPECT_FALSE(light.right_ratio);
    EXPECT_FALSE(light.left_ratio);
    for (const RoadObserver& observer : light.observers) {
      EXPECT_EQ(observer.average_cd_m2.high, 0.0);
      EXPECT_FALSE(observer.uo);
      EXPECT_FALSE(observer.ul);
      EXPECT_FALSE(observer.ti_percent);
      EXPECT_EQ(observer.veiling_cd_m2.high, 0.0);
    }
  }
  // Dim: uniformity has a meaning, glare has none.
  road = staggered();
  for (RoadRow& row : road.rows) row.factor = 0.02;
  const RoadObserver dim = road_light(road).observers[0];
  EXPECT_TRUE(dim.uo);
  EXPECT_FALSE(dim.ti_percent);
}

// Of wide roads the corners of the square count in one reading only.
TEST(RoadLight, RatiosOfBothReachesAreInTheInterval) {
  const RoadLayout road = staggered();
  const RoadLight light = road_light(road);
  const auto ratio = [&](RoadReach reach) {
    return road_illuminance(road, -3.5, 0.0, reach).mean_lx() /
           road_illuminance(road, 0.0, 3.5, reach).mean_lx();
  };
  EXPECT_DOUBLE_EQ(light.right_ratio->value, ratio(RoadReach::square));
  EXPECT_DOUBLE_EQ(light.right_ratio->high, ratio(RoadReach::square));
  EXPECT_DOUBLE_EQ(light.right_ratio->low, ratio(RoadReach::circle));
  EXPECT_LT(light.right_ratio->low, light.right_ratio->high);
}

TEST(RoadLight, StripsAreJudgedWhereAsked) {
  RoadLayout road = single_sided(0.0, "R3");
  road.left_strip_m.reset();
  const RoadLight light = road_light(road);
  EXPECT_FALSE(light.left_ratio);
  EXPECT_NEAR(light.right_ratio->value, 0.69664111, 1e-4);
  road.right_strip_m = 1.5;
  const double narrow =
      road_illuminance(road, -1.5, 0.0).mean_lx() / road_illuminance(road, 0.0, 1.5).mean_lx();
  EXPECT_DOUBLE_EQ(road_light(road).right_ratio->value, narrow);
  EXPECT_GT(narrow, 0.7);
}

TEST(RoadLight, RefusesWhatIsNoRoad) {
  const auto refused = [](const std::function<void(RoadLayout&)>& spoil) {
    RoadLayout road = staggered();
    spoil(road);
    EXPECT_THROW(road_light(road), std::logic_error);
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  refused([](RoadLayout& road) { road.spacing_m = 0.0; });
  refused([=](RoadLayout& road) { road.spacing_m = kNan; });
  refused([](RoadLayout& road) { road.spacing_m = 1.0e10; });
  refused([](RoadLayout& road) { road.width_m = -1.0; });
  refused([](RoadLayout& road) { road.lanes = 0; });
  refused([](RoadLayout& road) { road.is_oncoming.pop_back(); });
  refused([](RoadLayout& road) { road.table = nullptr; });
  refused([](RoadLayout& road) { road.q0 = 0.0; });
  refused([](RoadLayout& road) { road.right_strip_m = 10.6; });
  refused([](RoadLayout& road) { road.left_strip_m = 0.0; });
  refused([](RoadLayout& road) { road.rows[1].web = nullptr; });
  refused([](RoadLayout& road) { road.rows[1].factor = -0.1; });
  refused([=](RoadLayout& road) { road.rows[1].factor = kNan; });
  refused([](RoadLayout& road) { road.rows[1].factor = 1.0e40; });
  refused([](RoadLayout& road) { road.rows[1].maintenance = 1.1; });
  refused([](RoadLayout& road) { road.rows[1].maintenance = 0.0; });
  refused([](RoadLayout& road) { road.rows[1].height_m = 1.5; });
  refused([=](RoadLayout& road) { road.rows[1].y_m = kNan; });
  refused([](RoadLayout& road) { road.rows[1].shift_m = 40.0; });
  refused([](RoadLayout& road) { road.rows[1].shift_m = -1.0; });
  refused([](RoadLayout& road) { road.rows[1].road_from_luminaire *= 1.001; });
  refused([](RoadLayout& road) { road.rows[1].road_from_luminaire[0] *= -1.0; });
  EXPECT_THROW(road_illuminance(staggered(), 1.0, 1.0), std::logic_error);
}

}  // namespace
}  // namespace calc::road_light_test
