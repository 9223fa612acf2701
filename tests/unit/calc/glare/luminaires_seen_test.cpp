// What luminaires send upwards and towards eyes: closed forms, second calculations, and what the
// intervals hold.
#include "calc/glare/luminaires_seen.h"

#include "calc/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace calc::luminaires_seen_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

glm::dmat3 about(const glm::dvec3& axis, double deg) {  // Rodrigues
  const double c = std::cos(radians_from_degrees(deg)), s = std::sin(radians_from_degrees(deg));
  const auto turned = [&](const glm::dvec3& v) {
    return c * v + s * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
  };
  return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
}

// The axis leaves straight down by `tilt`, towards `azimuth`.
glm::dmat3 tilted(double tilt_deg, double azimuth_deg = 0.0, double roll_deg = 0.0) {
  return about({0, 0, 1}, azimuth_deg) * about({0, -1, 0}, tilt_deg) * about({0, 0, 1}, roll_deg);
}

std::vector<double> steps(double first_deg, double last_deg, int count) {
  std::vector<double> rad;
  for (int i = 0; i <= count; ++i) {
    rad.push_back(radians_from_degrees(first_deg + (last_deg - first_deg) * i / count));
  }
  return rad;
}

PhotometricWeb isotropic(double cd = 100.0) {
  return PhotometricWeb::make({0.0}, {0.0, kPi}, {cd, cd}, {}, {});
}

PhotometricWeb cosine_web(int rings = 360) {
  const std::vector<double> gamma = steps(0.0, 90.0, rings);
  std::vector<double> cd;
  for (double g : gamma) cd.push_back(std::max(0.0, 1000.0 * std::cos(g)));
  cd.back() = 0.0;
  return PhotometricWeb::make({0.0}, gamma, cd, {}, {});
}

// 1000 cd up to `edge`, then nothing at once.
PhotometricWeb cone(double edge_deg, TableAxis axis = TableAxis::vertical) {
  return PhotometricWeb::make({0.0}, steps(0.0, edge_deg, 6), std::vector<double>(7, 1000.0), {},
                              {}, axis);
}

// Nothing alike, nothing even; a third is dark. Planes disagree at the poles where it has them.
PhotometricWeb lopsided(unsigned seed, TableAxis axis = TableAxis::vertical, int planes = 7,
                        int rings = 9) {
  std::mt19937 random(seed);
  const auto unit = [&] { return std::generate_canonical<double, 53>(random); };
  const auto angles = [&](double first, double last, int count) {
    std::vector<double> rad;
    for (int i = 0; i <= count; ++i) {
      const double jitter = i == 0 || i == count ? 0.0 : 0.6 * (unit() - 0.5);
      rad.push_back(i == count ? last : first + (last - first) * (i + jitter) / count);
    }
    return rad;
  };
  const std::vector<double> c = angles(0.0, 2.0 * kPi, planes);
  const std::vector<double> gamma =
      angles(seed % 3 == 1 ? 0.2 : 0.0, seed % 3 == 2 ? 2.4 : kPi, rings);
  std::vector<double> cd;
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    for (std::size_t k = 0; k < gamma.size(); ++k)
      cd.push_back(std::max(0.0, 1500.0 * unit() - 500.0));
  }
  cd.insert(cd.end(), cd.begin(), cd.begin() + static_cast<std::ptrdiff_t>(gamma.size()));
  return PhotometricWeb::make(c, gamma, cd, {}, {}, axis);
}

// A floodlight as manufacturers measure them: C every 5, gamma every 2.5 degrees.
PhotometricWeb usual_web() {
  const std::vector<double> c = steps(0.0, 360.0, 72), gamma = steps(0.0, 180.0, 72);
  std::vector<double> cd;
  for (std::size_t i = 0; i < c.size(); ++i) {
    for (double g : gamma) {
      const double x = std::sin(g) * std::cos(c[i % 72]), y = std::sin(g) * std::sin(c[i % 72]);
      const double off = std::pow(x - 0.5, 2) / 0.08 + y * y / 0.3;
      cd.push_back(g > 0.5 * kPi ? 20.0 * std::sin(g) : 20.0 + 50000.0 * std::exp(-off));
    }
  }
  return PhotometricWeb::make(
      [&] {
        auto full = c;
        full.back() = 2.0 * kPi;
        return full;
      }(),
      [&] {
        auto full = gamma;
        full.back() = kPi;
        return full;
      }(),
      cd, {}, {});
}

struct Site {
  Project project;

  std::size_t add_type(PhotometricWeb web) {
    LuminaireType type;
    type.web = project.webs.size();
    project.webs.push_back(std::move(web));
    project.luminaire_types.push_back(type);
    if (project.spaces.empty()) project.spaces.emplace_back();
    return project.luminaire_types.size() - 1;
  }
  Site& add(std::size_t type, const glm::dvec3& place_m, const glm::dmat3& turn = glm::dmat3(1.0),
            const std::string& group = "g") {
    Luminaire luminaire;
    luminaire.type = type;
    luminaire.position_m = place_m;
    luminaire.world_from_luminaire = turn;
    luminaire.group = group;
    project.spaces[0].luminaires.push_back(luminaire);
    return *this;
  }
  Space& space() { return project.spaces[0]; }
  const Space& space() const { return project.spaces[0]; }

  Estimate upward(const LightScene* scene = nullptr) const {
    return upward_share_percent(project, space(), scene);
  }
  StrongestLight strongest(const std::vector<glm::dvec3>& points_m, const glm::dvec3& facing,
                           const LightScene* scene = nullptr) const {
    return strongest_intensity(project, space(), scene, points_m,
                               std::vector<glm::dvec3>(points_m.size(), facing));
  }
  NearestLuminaire nearest(const std::vector<glm::dvec3>& points_m,
                           const LightScene* scene = nullptr) const {
    return nearest_luminaire(project, space(), scene, points_m);
  }
  std::vector<ZoneIntensity> zone(double from_deg, double to_deg,
                                  const LightScene* scene = nullptr) const {
    return zone_intensities(project, space(), scene, from_deg, to_deg);
  }
};

Site one(PhotometricWeb web, const glm::dmat3& turn = glm::dmat3(1.0)) {
  Site site;
  site.add(site.add_type(std::move(web)), {0, 0, 3}, turn);
  return site;
}

double towards_cd(const PhotometricWeb& web, const glm::dmat3& turn, const glm::dvec3& world) {
  const glm::dvec3 own = glm::transpose(turn) * world;
  return web.intensity_cd(std::array{own.x, own.y, own.z});
}

// From world directions alone, midpoints of cells of equal height and azimuth: the horizon is
// between two rows.
double brute_upward_percent(const PhotometricWeb& web, const glm::dmat3& turn, int rows = 500) {
  double up = 0.0, all = 0.0;
  for (int i = 0; i < 2 * rows; ++i) {
    const double z = (i + 0.5) / rows - 1.0, across = std::sqrt(1.0 - z * z);
    double row = 0.0;
    for (int k = 0; k < 2 * rows; ++k) {
      const double a = kPi * (k + 0.5) / rows;
      row += towards_cd(web, turn, {across * std::cos(a), across * std::sin(a), z});
    }
    all += row;
    if (z > 0.0) up += row;
  }
  return 100.0 * up / all;
}

double brute_zone_cd(const PhotometricWeb& web, const glm::dmat3& turn, double from_deg,
                     double to_deg, int rows = 300) {
  double most = 0.0;
  for (int i = 0; i <= rows; ++i) {
    const double t = radians_from_degrees(from_deg + (to_deg - from_deg) * i / rows);
    for (int k = 0; k < 2 * rows; ++k) {
      const double a = kPi * k / rows;
      most = std::max(
          most, towards_cd(web, turn,
                           {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), -std::cos(t)}));
    }
  }
  return most;
}

void expect_ordered(const Estimate& estimate) {
  EXPECT_LE(estimate.low, estimate.value);
  EXPECT_LE(estimate.value, estimate.high);
}

LightScene levels(std::vector<std::pair<std::string, double>> level_of_group) {
  LightScene scene;
  scene.level_of_group = std::move(level_of_group);
  return scene;
}

// A Lambertian disc tilted by a shows half of its area's projection less to the sky: (1 - cos a) /
// 2. The table's chords are low by at most step^2 / 8, everywhere the same way.
TEST(UpwardShare, OfTiltedCosine) {
  const double step = radians_from_degrees(0.25);
  for (double deg : {0.0, 1.0, 17.0, 30.0, 45.0, 60.0, 89.0, 90.0, 91.0, 135.0, 179.0, 180.0}) {
    const Estimate share = one(cosine_web(), tilted(deg, 33.0)).upward();
    const double exact = 50.0 * (1.0 - std::cos(radians_from_degrees(deg)));
    EXPECT_NEAR(share.value, exact, 100.0 * step * step / 8.0) << deg;
    expect_ordered(share);
    EXPECT_LT(share.high - share.low, 0.002) << deg;
  }
}

TEST(UpwardShare, OfAllDirectionsAlikeIsHalf) {
  for (double deg : {0.0, 10.0, 63.0, 90.0, 117.0, 180.0}) {
    const Estimate share = one(isotropic(), tilted(deg, 12.0, 77.0)).upward();
    EXPECT_NEAR(share.value, 50.0, 1e-9) << deg;
    EXPECT_LE(share.low, 50.0 + 1e-12);
    EXPECT_GE(share.high, 50.0 - 1e-12);
  }
}

// A cone of even light, half angle b, tilted by a: by the cap beyond the horizon, a lens of two
// caps. By hand for 90 degrees (half), and nothing while a + b <= 90.
TEST(UpwardShare, OfACone) {
  for (const TableAxis axis : {TableAxis::vertical, TableAxis::lateral}) {
    // The lateral table's own axis is -y of the luminaire, by its frame (-z, x, -y): gamma 0 is y.
    const glm::dmat3 stand =
        axis == TableAxis::vertical ? glm::dmat3(1.0) : about({1, 0, 0}, -90.0);
    const auto share = [&](double edge_deg, double tilt_deg) {
      return one(cone(edge_deg, axis), tilted(tilt_deg) * stand).upward();
    };
    for (double edge : {10.0, 30.0, 60.0, 75.0}) {
      const Estimate below = share(edge, 90.0 - edge);
      EXPECT_EQ(below.high, 0.0) << edge;
      EXPECT_EQ(below.low, 0.0) << edge;
      EXPECT_GT(share(edge, 90.0 - edge + 0.1).low, 0.0) << edge;
      EXPECT_NEAR(share(edge, 90.0).value, 50.0, 1e-3) << edge;
      EXPECT_NEAR(share(edge, 90.0 + edge).value, 100.0, 1e-6) << edge;
      EXPECT_LE(share(edge, 90.0 + edge).high, 100.0) << edge;
      // Of half the cone's angle beyond: two sectors of the cap less the triangles in them.
      const double b = radians_from_degrees(edge), sink = std::sin(0.5 * b);  // of the axis
      const double cap = 2.0 * kPi * (1.0 - std::cos(b));
      const double lens =
          2.0 * (std::acos(sink / std::sin(b)) -
                 std::cos(b) * std::acos(sink * std::cos(b) / (std::cos(0.5 * b) * std::sin(b))));
      EXPECT_NEAR(share(edge, 90.0 - 0.5 * edge).value, 100.0 * lens / cap, 2e-3) << edge;
    }
  }
}

TEST(UpwardShare, OfUprightTablesIsTheZonalFlux) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const PhotometricWeb web = lopsided(seed);
    const double up = 100.0 * web.zonal_flux_lm(0.5 * kPi, kPi) / web.flux_lm();
    const Estimate down = one(web, tilted(0.0, 0.0, 41.0)).upward();
    EXPECT_EQ(down.low, down.high);
    EXPECT_NEAR(down.value, up, 1e-9);
    EXPECT_NEAR(one(web, tilted(180.0)).upward().value, 100.0 - up, 1e-9);
    // The general way agrees where it begins.
    const Estimate nearly = one(web, tilted(1e-6)).upward();
    EXPECT_NEAR(nearly.value, up, 1e-3);
    EXPECT_NE(nearly.low, nearly.high);
    // A lateral table that stands upright: the luminaire's y is straight down or up.
    const PhotometricWeb lateral = lopsided(seed, TableAxis::lateral);
    for (const double turn : {-90.0, 90.0}) {
      const glm::dmat3 stand = about({1, 0, 0}, turn);
      const Estimate share = one(lateral, stand).upward();
      EXPECT_NEAR(share.high, share.low, 1e-9);
      EXPECT_NEAR(share.value, brute_upward_percent(lateral, stand, 300), 0.03);
    }
  }
}

// A million directions each. The interval must hold the second calculation, but for the error of
// its midpoints.
TEST(UpwardShare, HoldsASecondIntegration) {
  std::mt19937 random(25);
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(random);
  };
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const PhotometricWeb web =
        lopsided(seed, seed % 2 == 0 ? TableAxis::lateral : TableAxis::vertical);
    const glm::dmat3 turn = tilted(between(1.0, 179.0), between(0.0, 360.0), between(0.0, 360.0));
    const Estimate share = one(web, turn).upward();
    const double brute = brute_upward_percent(web, turn);
    // Where light ends at once midpoints are less good.
    const bool ends = web.gamma_rad().front() > 0.0 || web.gamma_rad().back() < kPi;
    const double rounding = ends ? 5e-3 : 5e-4;
    EXPECT_LE(share.low, brute + rounding) << seed;
    EXPECT_GE(share.high, brute - rounding) << seed;
    EXPECT_LT(share.high - share.low, 0.01) << seed;
    expect_ordered(share);
  }
}

// Straight to the side without rounding: the horizon goes through the poles of the table.
TEST(UpwardShare, OfTheSideItself) {
  const glm::dmat3 side(glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0));
  EXPECT_NEAR(one(isotropic(), side).upward().value, 50.0, 1e-9);
  EXPECT_NEAR(one(cone(40.0), side).upward().value, 50.0, 1e-9);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Estimate share = one(lopsided(seed), side).upward();
    EXPECT_NEAR(share.value, one(lopsided(seed), tilted(90.0)).upward().value, 2e-3);
    EXPECT_NEAR(share.value, brute_upward_percent(lopsided(seed), side), 0.02);
    EXPECT_LT(share.high - share.low, 0.01);
  }
}

// Seen from the other side all is the other way round, and the two intervals hold each other.
TEST(UpwardShare, AndDownwardShareMakeAll) {
  for (unsigned seed = 1; seed <= 9; ++seed) {
    const PhotometricWeb web = lopsided(seed, seed > 5 ? TableAxis::lateral : TableAxis::vertical);
    const glm::dmat3 turn = tilted(17.0 * seed, 50.0 * seed, 5.0);
    const Estimate up = one(web, turn).upward();
    const Estimate down = one(web, about({1, 0, 0}, 180.0) * turn).upward();
    EXPECT_LE(up.low + down.low, 100.0 + 1e-9) << seed;
    EXPECT_GE(up.high + down.high, 100.0 - 1e-9) << seed;
    EXPECT_NEAR(up.value + down.value, 100.0, 0.01) << seed;
  }
}

TEST(UpwardShare, DoesNotChangeAboutTheVertical) {
  const PhotometricWeb web = lopsided(4);
  const Estimate first = one(web, tilted(35.0, 0.0, 20.0)).upward();
  for (double deg : {1.0, 45.0, 90.0, 200.0}) {
    EXPECT_NEAR(one(web, tilted(35.0, deg, 20.0)).upward().value, first.value, 1e-6);
  }
  // But about the luminaire's own axis it does.
  EXPECT_GT(std::abs(one(web, tilted(35.0, 0.0, 120.0)).upward().value - first.value), 0.1);
}

TEST(UpwardShare, IsOfTheFluxOfAllTogether) {
  Site site;
  const std::size_t even = site.add_type(isotropic()), down = site.add_type(cone(60.0));
  site.add(even, {0, 0, 3}, glm::dmat3(1.0), "a");
  site.add(down, {0, 0, 3}, glm::dmat3(1.0), "b");
  const double even_lm = 400.0 * kPi, down_lm = 1000.0 * kPi;
  EXPECT_NEAR(site.upward().value, 50.0 * even_lm / (even_lm + down_lm), 1e-9);
  const LightScene dimmed = levels({{"a", 0.25}});
  EXPECT_NEAR(site.upward(&dimmed).value, 50.0 * 0.25 * even_lm / (0.25 * even_lm + down_lm), 1e-9);
  site.project.luminaire_types[down].flux_scale = 3.0;
  EXPECT_NEAR(site.upward().value, 50.0 * even_lm / (even_lm + 3.0 * down_lm), 1e-9);
  const LightScene off = levels({{"b", 0.0}});
  EXPECT_NEAR(site.upward(&off).value, 50.0, 1e-9);
  // Two of one kind, mounted differently, do not share what was found.
  Site two;
  const std::size_t flood = two.add_type(cone(60.0));
  two.add(flood, {0, 0, 3}, tilted(90.0)).add(flood, {0, 0, 3}, tilted(0.0));
  EXPECT_NEAR(two.upward().value, 25.0, 1e-3);
}

TEST(UpwardShare, OfNoLightIsNothing) {
  Site site = one(isotropic());
  EXPECT_TRUE(has_light(site.project, site.space(), nullptr));
  const LightScene off = levels({{"g", 0.0}});
  EXPECT_FALSE(has_light(site.project, site.space(), &off));
  EXPECT_EQ(site.upward(&off).high, 0.0);
  EXPECT_TRUE(site.zone(60, 90, &off).empty());
  EXPECT_EQ(site.strongest({{0, 5, 0}}, {0, 0, 1}, &off).cd.high, 0.0);
  EXPECT_EQ(site.nearest({{0, 5, 0}}, &off).m.low, kInfinity);
  site.space().luminaires.clear();
  EXPECT_FALSE(has_light(site.project, site.space(), nullptr));
  EXPECT_EQ(site.upward().value, 0.0);
}

// A road's luminaire that ends at 90 degrees sends nothing up, exactly: zones of 0 % exist.
TEST(UpwardShare, IsExactlyNothingWhereThereIsNone) {
  EXPECT_EQ(one(cone(90.0)).upward().high, 0.0);
  EXPECT_EQ(one(cosine_web(), tilted(0.0, 77.0)).upward().high, 0.0);
  // Nor does what is beyond the horizon by rounding count.
  const double beyond = std::nextafter(0.5 * kPi, kPi);
  EXPECT_EQ(one(PhotometricWeb::make({0.0}, {0.0, beyond}, {1000.0, 1000.0}, {}, {})).upward().high,
            0.0);
  for (int edge = 5; edge < 90; edge += 5) {
    for (int turn = 0; turn < 360; turn += 7) {
      EXPECT_EQ(one(cone(edge), tilted(90.0 - edge, turn, 3.0 * turn)).upward().high, 0.0);
    }
  }
  // Dark planes beside lit ones: only C 90 to 270, tilted so that C 180 looks down.
  std::vector<double> cd;
  for (int plane = 0; plane <= 8; ++plane) {
    for (int ring = 0; ring <= 9; ++ring) {
      cd.push_back(plane >= 3 && plane <= 5 && ring > 0 && ring < 9 ? 100.0 : 0.0);
    }
  }
  std::vector<double> c = steps(0.0, 360.0, 8);
  c.back() = 2.0 * kPi;
  const PhotometricWeb half = PhotometricWeb::make(c, steps(0.0, 90.0, 9), cd, {}, {});
  const Estimate share = one(half, tilted(40.0)).upward();  // C 0 rises
  EXPECT_EQ(share.low, 0.0);
  EXPECT_EQ(share.high, 0.0);
  EXPECT_GT(one(half, tilted(40.0, 0.0, 180.0)).upward().low, 1.0);
}

// 60 to 90 degrees of a cosine, upright: at 60 exactly half of the peak.
TEST(ZoneIntensity, IsExactForUprightTables) {
  const auto at = [](const Site& site, double from, double to) {
    return site.zone(from, to).at(0).cd;
  };
  const Site lambert = one(cosine_web());
  EXPECT_NEAR(at(lambert, 60, 90).value, 500.0, 1e-9);
  EXPECT_NEAR(at(lambert, 60.1, 90).value, 1000.0 * std::cos(radians_from_degrees(60.1)), 1e-2);
  EXPECT_EQ(at(lambert, 0, 180).value, 1000.0);
  EXPECT_EQ(at(lambert, 0, 90).value, 1000.0);
  EXPECT_EQ(at(lambert, 91, 180).high, 0.0);
  const Site up = one(cosine_web(), tilted(180.0));
  EXPECT_EQ(at(up, 60, 90).value, 0.0);
  EXPECT_NEAR(at(up, 60, 120).value, 500.0, 1e-9);
  EXPECT_EQ(at(up, 90, 180).value, 1000.0);
  for (unsigned seed = 1; seed <= 6; ++seed) {
    for (const double tilt : {0.0, 180.0}) {
      const Site site = one(lopsided(seed), tilted(tilt));
      const Estimate cd = at(site, 55.5, 97.25);
      EXPECT_EQ(cd.low, cd.high);
      const double brute = brute_zone_cd(site.project.webs[0], tilted(tilt), 55.5, 97.25);
      EXPECT_GE(cd.value, brute - 1e-9);
      EXPECT_NEAR(cd.value, brute, 0.02 * brute);
    }
    // A lateral table that stands upright.
    const glm::dmat3 stand = about({1, 0, 0}, 90.0);
    const Site site = one(lopsided(seed, TableAxis::lateral), stand);
    const Estimate cd = at(site, 60, 90);
    EXPECT_EQ(cd.low, cd.high);
    const double brute = brute_zone_cd(site.project.webs[0], stand, 60, 90);
    EXPECT_GE(cd.value, brute - 1e-9);
    EXPECT_NEAR(cd.value, brute, 0.02 * brute);
  }
}

TEST(ZoneIntensity, HoldsASecondSearch) {
  std::mt19937 random(1838);
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(random);
  };
  for (unsigned seed = 1; seed <= 24; ++seed) {
    const PhotometricWeb web =
        lopsided(seed, seed % 2 == 0 ? TableAxis::lateral : TableAxis::vertical);
    const glm::dmat3 turn = tilted(between(0.5, 179.5), between(0.0, 360.0), between(0.0, 360.0));
    const double from = seed % 4 == 3 ? 0.0 : between(1.0, 80.0), to = from + between(2.0, 90.0);
    const Estimate cd = one(web, turn).zone(from, to).at(0).cd;
    const double brute = brute_zone_cd(web, turn, from, to);
    EXPECT_GE(cd.high, brute * (1.0 - 1e-12)) << seed;
    EXPECT_GE(cd.low, brute * (1.0 - 2e-4)) << seed;
    EXPECT_NEAR(cd.low, brute, 0.03 * brute) << seed;  // of the other's steps
    EXPECT_LE(cd.high, cd.low * 1.005) << seed;
    EXPECT_EQ(cd.value, cd.low);
    // No more than that of all directions, which is the table's.
    EXPECT_LE(cd.high, web.max_intensity_cd());
    EXPECT_EQ(one(web, turn).zone(0, 180).at(0).cd.low, web.max_intensity_cd());
  }
}

// Caps about nadir and zenith, and rings about them, that lie within a cell of the table.
TEST(ZoneIntensity, FindsZonesWithinACell) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const PhotometricWeb web =
        lopsided(3 * seed, seed % 2 == 0 ? TableAxis::lateral : TableAxis::vertical, 5, 6);
    const glm::dmat3 turn = tilted(30.0 + 10.0 * seed, 40.0 * seed, 75.0 * seed);
    const Site site = one(web, turn);
    for (const auto& [from, to] : {std::pair(0.0, 2.0), std::pair(178.0, 180.0),
                                   std::pair(1.0, 1.5), std::pair(178.0, 179.0)}) {
      const Estimate cd = site.zone(from, to).at(0).cd;
      const double brute = brute_zone_cd(web, turn, from, to, 100);
      EXPECT_GE(cd.high, brute * (1.0 - 1e-9)) << seed << ", " << from;
      EXPECT_GE(cd.low, brute * (1.0 - 2e-4) - 1e-6 * web.max_intensity_cd())
          << seed << ", " << from;
      EXPECT_LE(cd.low, brute * 1.01 + 1e-2) << seed << ", " << from;
    }
  }
}

// The pole of the table lies on the border, and only its planes beyond have light there: what is
// found is the mean that the pole itself has.
TEST(ZoneIntensity, KnowsThePole) {
  std::vector<double> c = steps(0.0, 360.0, 4);
  c.back() = 2.0 * kPi;
  const PhotometricWeb web = PhotometricWeb::make(
      c, {0.0, 0.5 * kPi}, {0.0, 0.0, 0.0, 0.0, 1000.0, 0.0, 0.0, 0.0, 0.0, 0.0}, {}, {});
  const Estimate cd = one(web, tilted(60.0)).zone(60, 90).at(0).cd;  // C 0 rises
  EXPECT_NEAR(cd.low, 250.0, 1e-9);
  EXPECT_GE(cd.high, 250.0);
}

// A cosine tilted by a: towards the zone's nearer border, cos(60 - a), and its peak beyond that.
TEST(ZoneIntensity, OfTiltedCosine) {
  for (double deg : {5.0, 30.0, 59.0, 60.0, 75.0, 90.0, 100.0, 140.0}) {
    const Estimate cd = one(cosine_web(), tilted(deg, 25.0)).zone(60, 90).at(0).cd;
    const double off = deg < 60.0 ? 60.0 - deg : std::max(0.0, deg - 90.0);
    const double exact = 1000.0 * std::cos(radians_from_degrees(off));
    EXPECT_NEAR(cd.low, exact, 0.12) << deg;  // 1e-4 of the search, 2.4e-6 of the table
    EXPECT_LE(cd.low, exact * (1.0 + 1e-12)) << deg;
    EXPECT_GE(cd.high, exact * (1.0 - 3e-6)) << deg;
    EXPECT_LE(cd.high, cd.low * 1.005) << deg;
  }
}

// Light that ends within the zone, or touches it in a point alone.
TEST(ZoneIntensity, KnowsWhereTablesEnd) {
  EXPECT_EQ(one(cone(30.0), tilted(29.9)).zone(60, 90).at(0).cd.high, 0.0);
  EXPECT_EQ(one(cone(30.0), tilted(30.1)).zone(60, 90).at(0).cd.low, 1000.0);
  EXPECT_EQ(one(cone(30.0), tilted(30.0)).zone(60, 90).at(0).cd.high, 1000.0);
  EXPECT_EQ(one(cone(59.9)).zone(60, 90).at(0).cd.high, 0.0);
  // However many cells there are beside it.
  std::vector<double> c = steps(0.0, 360.0, 720);
  c.back() = 2.0 * kPi;
  const std::vector<double> cd(721 * 91, 1000.0);
  const auto fine = PhotometricWeb::make(c, steps(0.0, 30.0, 90), cd, {}, {});
  EXPECT_EQ(one(fine, tilted(20.0)).zone(60, 90).at(0).cd.high, 0.0);
  EXPECT_EQ(one(fine, tilted(40.0)).zone(60, 90).at(0).cd.low, 1000.0);
  EXPECT_EQ(one(cone(60.0)).zone(60, 90).at(0).cd.low, 1000.0);
}

TEST(ZoneIntensity, IsOfEveryLuminaireThatCounts) {
  Site site;
  const std::size_t type = site.add_type(lopsided(3));
  site.add(type, {0, 0, 3}, tilted(20.0), "a").add(type, {1, 0, 3}, tilted(20.0), "b");
  site.add(type, {2, 0, 3}, tilted(20.0), "off").add(type, {3, 0, 3}, tilted(100.0), "a");
  site.project.luminaire_types[type].flux_scale = 2.0;
  const LightScene scene = levels({{"b", 0.5}, {"off", 0.0}});
  const std::vector<ZoneIntensity> found = site.zone(60, 90, &scene);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].luminaire, 0u);
  EXPECT_EQ(found[1].luminaire, 1u);
  EXPECT_EQ(found[2].luminaire, 3u);
  EXPECT_EQ(found[1].cd.value, 0.5 * found[0].cd.value);
  EXPECT_EQ(found[1].cd.high, 0.5 * found[0].cd.high);
  EXPECT_NEAR(found[0].cd.value, 2.0 * one(lopsided(3), tilted(20.0)).zone(60, 90)[0].cd.value,
              1e-9);
  EXPECT_NEAR(found[2].cd.value, 2.0 * one(lopsided(3), tilted(100.0)).zone(60, 90)[0].cd.value,
              1e-9);
  EXPECT_NE(found[0].cd.value, found[2].cd.value);
}

// Widths that are promised, of tables as they are.
TEST(LuminairesSeen, AreNarrowForUsualTables) {
  const PhotometricWeb web = usual_web();
  for (double deg : {0.001, 3.0, 15.0, 30.0, 60.0, 90.0, 123.0}) {
    const Site site = one(web, tilted(deg, 10.0, 35.0));
    const Estimate share = site.upward();
    EXPECT_LT(share.high - share.low, 0.01) << deg;
    const Estimate cd = site.zone(60, 90).at(0).cd;
    EXPECT_LE(cd.high, 1.005 * cd.low) << deg;
  }
}

// Two lamps over two points before a facade that looks along +x.
TEST(StrongestIntensity, IsTheGreatestTowardsAPoint) {
  Site site;
  const std::size_t type = site.add_type(cosine_web());
  site.add(type, {10, 0, 6}).add(type, {4, 0, 6}, glm::dmat3(1.0), "b");
  const std::vector<glm::dvec3> points{{0, 0, 1}, {0, 3, 2}};
  const StrongestLight seen = site.strongest(points, {1, 0, 0});
  const double best = 1000.0 * 5.0 / std::sqrt(16.0 + 25.0);
  EXPECT_NEAR(seen.cd.value, best, 0.01);
  EXPECT_EQ(seen.cd.low, seen.cd.value);
  EXPECT_EQ(seen.cd.high, seen.cd.value);
  EXPECT_EQ(seen.luminaire, 1u);
  EXPECT_EQ(seen.point, 0u);
  // The other lamp where the first is dimmed, at the point that it looks down on most.
  const LightScene dimmed = levels({{"b", 0.1}});
  const StrongestLight other = site.strongest(points, {1, 0, 0}, &dimmed);
  EXPECT_EQ(other.luminaire, 0u);
  EXPECT_NEAR(other.cd.value, 1000.0 * 5.0 / std::sqrt(125.0), 0.01);
  site.project.luminaire_types[type].flux_scale = 2.0;
  EXPECT_NEAR(site.strongest(points, {1, 0, 0}).cd.value, 2.0 * best, 0.02);
}

// Directions are from the luminaire, by its own turn: one beam among C.
TEST(StrongestIntensity, FollowsTheTurn) {
  const PhotometricWeb web = lopsided(7);
  const glm::dmat3 turn = tilted(50.0, 130.0, 70.0);
  Site site = one(web, turn);
  for (const glm::dvec3& point :
       {glm::dvec3(4, 1, 0), glm::dvec3(-3, 2, 1), glm::dvec3(0.5, -6, 9)}) {
    const double expected = towards_cd(web, turn, glm::normalize(point - glm::dvec3(0, 0, 3)));
    EXPECT_NEAR(site.strongest({point}, {0, 0, 1}).cd.value, expected, 1e-9);
  }
}

TEST(StrongestIntensity, KnowsWhatMayHideLuminaires) {
  Site site = one(isotropic(), glm::dmat3(1.0));
  const std::vector<glm::dvec3> point{{5, 0, 1}};
  // Behind the plane of the points, and in it.
  EXPECT_EQ(site.strongest(point, {-1, 0, 0}).cd.low, 100.0);
  EXPECT_EQ(site.strongest(point, {1, 0, 0}).cd.low, 0.0);
  EXPECT_EQ(site.strongest(point, {0, 1, 0}).cd.low, 0.0);
  EXPECT_EQ(site.strongest(point, {1, 0, 0}).cd.value, 100.0);
  EXPECT_EQ(site.strongest(point, {1, 0, 0}).cd.high, 100.0);
  // What is lower than both hides nothing.
  Body body;
  body.vertex_m = {{1, 0, 0}, {2, 0, 0}, {1, 0, 1.0}};
  site.space().bodies.push_back(body);
  EXPECT_EQ(site.strongest(point, {-1, 0, 0}).cd.low, 100.0);
  EXPECT_FALSE(may_hide_luminaires(site.space(), 1.0));
  site.space().bodies[0].vertex_m[2].z = 1.01;
  EXPECT_EQ(site.strongest(point, {-1, 0, 0}).cd.low, 0.0);
  EXPECT_EQ(site.strongest(point, {-1, 0, 0}).cd.value, 100.0);
  EXPECT_TRUE(may_hide_luminaires(site.space(), 1.0));
  // The lower one is the luminaire.
  site.space().luminaires[0].position_m.z = 0.5;
  site.space().bodies[0].vertex_m[2].z = 0.9;
  EXPECT_EQ(site.strongest(point, {-1, 0, 0}).cd.low, 0.0);
  site.space().bodies.clear();
  EXPECT_EQ(site.strongest(point, {-1, 0, 0}).cd.low, 100.0);
  site.space().surfaces_file = "room.gbxml";
  EXPECT_TRUE(may_hide_luminaires(site.space(), 1e9));
  site.space().surfaces_file.clear();
  site.space().shell.emplace();
  EXPECT_TRUE(may_hide_luminaires(site.space(), 1e9));
}

// In the point itself every direction may be it; of equal ones the first point and luminaire.
TEST(StrongestIntensity, KnowsPlacesThatAreTheSame) {
  Site site = one(cosine_web(), tilted(180.0));
  const StrongestLight same = site.strongest({{0, 9, 0}, {0, 0, 3}}, {0, 1, 0});
  EXPECT_EQ(same.cd.value, 1000.0);
  EXPECT_EQ(same.cd.low, 0.0);
  EXPECT_EQ(same.point, 1u);
  Site equal = one(isotropic());
  equal.add(0, {0, 0, 4}).add(0, {0, 0, 5});
  const StrongestLight first = equal.strongest({{1, 0, 0}, {2, 0, 0}}, {0, 0, 1});
  EXPECT_EQ(first.luminaire, 0u);
  EXPECT_EQ(first.point, 0u);
  // Nobody looks: nothing.
  EXPECT_EQ(equal.strongest({}, {0, 0, 1}).cd.high, 0.0);
}

// Height does not count; the point where the nearest is farthest does.
TEST(NearestLuminaire, IsInPlan) {
  Site site;
  const std::size_t type = site.add_type(isotropic());
  site.add(type, {0, 0, 3}, glm::dmat3(1.0), "a").add(type, {10, 0, 30}, glm::dmat3(1.0), "b");
  const std::vector<glm::dvec3> points{{1, 0, 0}, {7, 4, 0}, {10, 1, 0}};
  const NearestLuminaire nearest = site.nearest(points);
  EXPECT_EQ(nearest.m.value, 5.0);
  EXPECT_EQ(nearest.m.low, 5.0);
  EXPECT_EQ(nearest.m.high, 5.0);
  EXPECT_EQ(nearest.luminaire, 1u);
  EXPECT_EQ(nearest.point, 1u);
  const LightScene off = levels({{"b", 0.0}});
  EXPECT_NEAR(site.nearest(points, &off).m.value, std::sqrt(101.0), 1e-12);
  EXPECT_EQ(site.nearest(points, &off).point, 2u);
  EXPECT_EQ(site.nearest({{0, 0, 0}}).m.value, 0.0);
  // Ties: the first of both.
  const NearestLuminaire tie = site.nearest({{5, 2, 0}, {5, -2, 0}});
  EXPECT_EQ(tie.luminaire, 0u);
  EXPECT_EQ(tie.point, 0u);
  EXPECT_EQ(site.nearest({}).m.value, 0.0);
  site.space().luminaires.clear();
  EXPECT_EQ(site.nearest(points).m.value, kInfinity);
  EXPECT_EQ(site.nearest(points).m.low, kInfinity);
}

// What is one luminaire sends the light of all its emitters.
TEST(LuminairesSeen, EmittersOfOneLuminaireAreOne) {
  Site site;
  const std::size_t first = site.add_type(isotropic(100.0));
  const std::size_t second = site.add_type(isotropic(30.0));
  site.project.luminaire_types[second].is_further_emitter = true;
  site.add(first, {0, 0, 3}).add(second, {0, 1, 3}).add(first, {9, 0, 3});
  const StrongestLight seen = site.strongest({{4, 0, 0}}, {0, 0, 1});
  EXPECT_NEAR(seen.cd.value, 130.0, 1e-9);
  EXPECT_NEAR(seen.cd.low, 130.0, 1e-9);
  EXPECT_EQ(seen.luminaire, 0u);
  // The second emitter alone is behind the point.
  EXPECT_NEAR(site.strongest({{0, 0.5, 0}}, {0, -1, 0}).cd.low, 100.0, 1e-9);
  const std::vector<ZoneIntensity> zone = site.zone(60.0, 90.0);
  ASSERT_EQ(zone.size(), 2u);
  EXPECT_EQ(zone[1].luminaire, 2u);
  EXPECT_NEAR(zone[0].cd.low, 100.0, 1e-9);
  EXPECT_NEAR(zone[0].cd.value, 130.0, 1e-9);
  EXPECT_NEAR(zone[0].cd.high, 130.0, 1e-9);
}

}  // namespace
}  // namespace calc::luminaires_seen_test
