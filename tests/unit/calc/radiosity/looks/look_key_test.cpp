#include "calc/radiosity/looks/look_key.h"

#include "calc/base/file_hash.h"
#include "calc/base/file_reader.h"
#include "calc/base/numbers_version.h"
#include "tests/support/scenes.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace look_key_test {
namespace {

using namespace test_support;

// All that a key may be made of.
struct Inputs {
  calc::PreparedScene scene;
  calc::RadiositySettings settings;
  std::string backend = "cpu (trees 1)";
  std::string plane_id = "desk";
  calc::SensorGrid grid;
  std::vector<std::vector<std::uint8_t>> active = {{1, 1}, {1, 0}};

  std::string key() const {
    calc::LookKey key(calc::space_key(scene, settings, backend), {plane_id, &grid});
    std::string last;
    for (const auto& look : active) last = key.next(look);
    return last;
  }
};

class LookKeyInputs : public testing::Test {
 protected:
  LookKeyInputs() {
    add_box(start.scene, {-2, -1.5, 0}, {4, 3, 2.5}, 0.6);
    start.scene.body_id = {"walls"};
    add_luminaire(start.scene, web, {-1, 0, 2});
    add_luminaire(start.scene, weak, {1, 0.5, 1.5});
    start.scene.channels.push_back({"spots", 0.7});
    set_extent(start.scene);
    start.grid.position_m = {{0, 0, 0.8}, {1, 0, 0.8}};
    start.grid.normal = {{0, 0, 1}, {0, 0, 1}};
    start.grid.column = {0, 1};
    start.grid.row = {0, 0};
  }

  std::string after(const std::function<void(Inputs&)>& change) const {
    Inputs inputs = start;
    change(inputs);
    return inputs.key();
  }

  calc::PhotometricWeb web = isotropic_web(100.0), weak = isotropic_web(15.0);
  calc::PhotometricWeb brighter = isotropic_web(100.0000001);
  calc::PhotometricWeb finer = lambert_web(100.0, 10), coarser = lambert_web(100.0, 9);
  Inputs start;
};

TEST_F(LookKeyInputs, EveryInputCounts) {
  using calc::LuminousOpening;
  using Change = std::function<void(Inputs&)>;
  const calc::PhotometricWeb lateral =
      calc::PhotometricWeb::make({0.0}, {0.0, calc::kPi / 2, calc::kPi}, {100.0, 100.0, 100.0}, {},
                                 {}, calc::TableAxis::lateral);
  std::vector<Change> changes = {
      [](Inputs& i) { i.scene.origin_m.y += 1e-9; },
      [](Inputs& i) { i.scene.extent_m += 1e-9; },
      [](Inputs& i) { i.scene.vertex_m[3].z += 1e-6f; },
      [](Inputs& i) { std::swap(i.scene.triangle[3].x, i.scene.triangle[3].y); },
      [](Inputs& i) { std::swap(i.scene.triangle[3], i.scene.triangle[4]); },
      [](Inputs& i) { i.scene.triangle.pop_back(); },
      [](Inputs& i) { i.scene.reflectance[5] += 1e-9; },
      [](Inputs& i) { i.scene.body[2] = 1; },
      [](Inputs& i) { i.scene.luminaires.pop_back(); },
      [](Inputs& i) { std::swap(i.scene.luminaires[0], i.scene.luminaires[1]); },
      [](Inputs& i) { i.scene.luminaires[0].position_m.x += 1e-9; },
      [](Inputs& i) { i.scene.luminaires[1].world_from_luminaire[2].x += 1e-9; },
      [](Inputs& i) { i.scene.luminaires[0].flux_scale += 1e-9; },
      [](Inputs& i) { i.scene.luminaires[0].channel = 1; },
      [](Inputs& i) { i.scene.channels.push_back({}); },
      [](Inputs& i) { i.scene.luminaires[0].opening.shape = calc::OpeningShape::disk; },
      [](Inputs& i) { i.scene.luminaires[0].opening.along_c0_m = 0.1; },
      [](Inputs& i) { i.scene.luminaires[0].opening.along_c90_m = 0.1; },
      [](Inputs& i) { i.scene.luminaires[0].opening.height_m = 0.1; },
      [this](Inputs& i) { i.scene.luminaires[0].web = &brighter; },
      [this](Inputs& i) { i.scene.luminaires[0].web = &finer; },
      [this](Inputs& i) { i.scene.luminaires[0].web = &coarser; },
      [&](Inputs& i) { i.scene.luminaires[0].web = &lateral; },
      [this](Inputs& i) { i.scene.luminaires[1].web = &web; },
      [](Inputs& i) { i.settings.method = calc::Method::instant_radiosity; },
      [](Inputs& i) { i.settings.seed = 2; },
      [](Inputs& i) { i.settings.replicates = 8; },
      [](Inputs& i) { i.settings.first_paths = 128; },
      [](Inputs& i) { i.settings.clamp_per_m2 = 1e-9; },
      [](Inputs& i) { i.settings.shadow_map_texels = 16; },
      [](Inputs& i) { i.settings.refuses_close_points = false; },
      [](Inputs& i) { i.settings.opening_error_factor = 4.0; },
      [](Inputs& i) { i.backend = "cpu (trees 2)"; },
      [](Inputs& i) { i.plane_id = "desk2"; },
      [](Inputs& i) { i.grid.position_m[1].x += 1e-9; },
      [](Inputs& i) {
        i.grid.shift_m = {glm::dvec3(0.0), glm::dvec3(0.0)};
      },
      [](Inputs& i) {
        i.grid.shift_m = {glm::dvec3(0.0), glm::dvec3(1e-9)};
      },
      [](Inputs& i) {
        i.grid.normal[0] = {0, 1, 0};
      },
      [](Inputs& i) { i.grid.kernel = calc::ReceiverKernel::cylindrical; },
      [](Inputs& i) { i.grid.derived = calc::DerivedQuantity::ugr; },
      [](Inputs& i) {
        i.active = {{1, 1}};
      },
      [](Inputs& i) {
        i.active = {{1, 0}, {1, 1}};
      },
      [](Inputs& i) {
        i.active = {{1, 1}, {0, 1}};
      },
      [](Inputs& i) {
        i.active = {{1, 1}, {1, 1}, {1, 0}};
      },
  };
  for (const auto& [skip, name] : calc::EnumNames<calc::Skip>::list) {
    changes.emplace_back([skip = skip](Inputs& i) { i.settings.skips.forbid(skip); });
  }
  std::set<std::string> keys{start.key()};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    EXPECT_TRUE(keys.insert(after(changes[k])).second) << "change " << k << " is not in the key";
  }
}

// They only decide which points go on, name something, or weigh results later.
TEST_F(LookKeyInputs, WhatDoesNotMatterIsNotInIt) {
  const std::string key = start.key();
  EXPECT_EQ(after([](Inputs& i) { i.scene.channels[1].group = "renamed"; }), key);
  EXPECT_EQ(after([](Inputs& i) { i.scene.channels[1].maintenance_factor = 0.5; }), key);
  EXPECT_EQ(after([](Inputs& i) { i.scene.body_id = {"renamed"}; }), key);
  EXPECT_EQ(after([](Inputs& i) { i.settings.max_paths *= 2; }), key);
  EXPECT_EQ(after([](Inputs& i) { i.settings.time_limit_s = 10.0; }), key);
  EXPECT_EQ(after([](Inputs& i) { i.settings.jobs = 7; }), key);
  EXPECT_EQ(after([](Inputs& i) { i.grid.rule = calc::Message::words("another"); }), key);
  EXPECT_EQ(after([](Inputs& i) { i.grid.column = {5, 6}; }), key);
  // The same web from another file.
  const calc::PhotometricWeb same = isotropic_web(100.0);
  EXPECT_EQ(after([&](Inputs& i) { i.scene.luminaires[0].web = &same; }), key);
}

TEST_F(LookKeyInputs, NamesTheNumbersOfTheProgram) {
  EXPECT_NE(start.key().find(calc::kNumbersDigest), std::string::npos);
}

// Whoever moves numbers writes kept.txt anew (numbers.*), and with it this.
TEST(NumbersVersion, NamesTheKeptNumbers) {
  const calc::FileContent kept =
      calc::DiskFileReader().read(LUXGATE_SOURCE_DIR "/tests/numbers/kept.txt");
  ASSERT_TRUE(kept.ok());
  EXPECT_EQ(calc::sha256_hex(kept.bytes), calc::kNumbersDigest)
      << "kNumbersDigest in calc/base/numbers_version.h must be the SHA-256 of "
         "tests/numbers/kept.txt; tests/numbers/write does both";
}

}  // namespace
}  // namespace look_key_test
