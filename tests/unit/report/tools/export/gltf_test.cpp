// What `luxgate export gltf` writes, read by itself and by the program's own reader of meshes.
#include "calc/base/diagnostic_ids.h"
#include "report/tools/export/gltf_room.h"

#include "calc/meshes/mesh_file.h"
#include "report/tools/export/export.h"
#include "tests/support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gltf_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test_support::bytes_of;
using test_support::put_bytes;
using test_support::ScratchFolder;

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value |= std::uint32_t{static_cast<unsigned char>(bytes.at(at + k))} << (8 * k);
  return value;
}

// A GLB as glTF 2.0 has it, with all its numbers.
struct Model {
  json head;
  std::string binary;
  std::vector<std::vector<double>> accessor;

  explicit Model(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(bytes, 4), 2U);
    EXPECT_EQ(word(bytes, 8), bytes.size());
    const std::size_t text = word(bytes, 12);
    EXPECT_EQ(text % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    head = json::parse(bytes.substr(20, text));
    EXPECT_EQ(word(bytes, 20 + text), bytes.size() - 28 - text);
    EXPECT_EQ(bytes.substr(24 + text, 4), std::string("BIN\0", 4));
    binary = bytes.substr(28 + text);
    EXPECT_EQ(binary.size() % 4, 0U);
    EXPECT_EQ(head["buffers"][0]["byteLength"], binary.size());
    for (const json& one : head["accessors"]) accessor.push_back(numbers(one));
  }

  // The values of a mesh's attribute, or of its "indices".
  const std::vector<double>& of(const std::string& mesh, const std::string& name) const {
    static const std::vector<double> kNone;
    for (const json& one : head["meshes"]) {
      if (one["name"] != mesh) continue;
      const json& primitive = one["primitives"][0];
      return accessor.at(name == "indices" ? primitive["indices"].get<std::size_t>()
                                           : primitive["attributes"].at(name).get<std::size_t>());
    }
    return kNone;
  }

 private:
  std::vector<double> numbers(const json& one) const {
    static const std::map<std::string, std::size_t> kComponents{
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}};
    const json& view = head["bufferViews"].at(one["bufferView"].get<std::size_t>());
    const std::size_t count = one["count"].get<std::size_t>() * kComponents.at(one["type"]);
    const std::size_t begin = view["byteOffset"];
    EXPECT_EQ(begin % 4, 0U);
    EXPECT_EQ(view["byteLength"], 4 * count);
    EXPECT_LE(begin + 4 * count, binary.size());
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t bits = word(binary, begin + 4 * i);
      if (one["componentType"] == 5125) {
        values.push_back(bits);
      } else {
        EXPECT_EQ(one["componentType"], 5126);
        float value = 0.0F;
        std::memcpy(&value, &bits, sizeof value);
        EXPECT_TRUE(std::isfinite(value));
        values.push_back(static_cast<double>(value));
      }
    }
    if (one.contains("min")) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = 1e300, high = -1e300;
        for (std::size_t i = axis; i < values.size(); i += 3) {
          low = std::min(low, values[i]);
          high = std::max(high, values[i]);
        }
        EXPECT_EQ(one["min"][axis], low);
        EXPECT_EQ(one["max"][axis], high);
      }
    }
    return values;
  }
};

// Two rooms of the same size, one lit twice as brightly, and a space of nothing but a luminaire.
const char* const kRooms = R"(<?xml version="1.0"?>
<luxgate version="1">
  <material id="grey" reflectance="0.5"/>
  <luminaire-type id="panel" photometry="panel.ies" maintenance-factor="1"/>
  <room id="first:room" name="First" footprint="0 0  4 0  4 3  0 3" height="2.5" floor="grey" ceiling="grey" walls="grey">
    <luminaire id="a" type="panel" position="2 1.5 2.4"/>
    <plane id="low" height="0.1" count="4 3"/>
  </room>
  <room id="second" footprint="10 0  14 0  14 3  10 3" height="2.5" floor="grey" ceiling="grey" walls="grey">
    <luminaire id="b" type="panel" position="12 1.5 2.4"/>
    <luminaire id="c" type="panel" position="12 1.5 2.4"/>
  </room>
</luxgate>
)";

struct Exported {
  ScratchFolder folder;
  cli::ExportOptions options;

  explicit Exported(const std::string& project) {
    fs::copy_file(std::string(LUXGATE_SOURCE_DIR) +
                      "/examples/06-on-the-edge/photometry/lambert_panel_600.ies",
                  folder.path() / "panel.ies");
    put_bytes(folder.path() / "project.xml", project);
    options.target = cli::kGltf;
    options.project = (folder.path() / "project.xml").string();
    options.output = (folder.path() / "models").string();
  }

  cli::CommandOutcome run() const { return cli::run_export(options, calc::DiskFileReader()); }
  std::string file(const char* name) const { return bytes_of(fs::path(options.output) / name); }
};

// Area-weighted mean of a value of corners over the triangles that face up.
double mean_of_floor(const Model& model) {
  const auto& place = model.of("surfaces", "POSITION");
  const auto& lx = model.of("surfaces", "_ILLUMINANCE_LX");
  const auto& index = model.of("surfaces", "indices");
  double sum = 0.0, whole = 0.0;
  for (std::size_t t = 0; t + 2 < index.size(); t += 3) {
    std::array<std::size_t, 3> corner{};
    std::array<std::array<double, 3>, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = static_cast<std::size_t>(index[t + k]);
      for (std::size_t axis = 0; axis < 3; ++axis) p[k][axis] = place[3 * corner[k] + axis];
    }
    // y is up: that of the cross product.
    const double up =
        (p[1][2] - p[0][2]) * (p[2][0] - p[0][0]) - (p[1][0] - p[0][0]) * (p[2][2] - p[0][2]);
    const double level = std::abs(p[1][1] - p[0][1]) + std::abs(p[2][1] - p[0][1]);
    if (!(up > 0.0) || level > 1e-6) continue;
    for (const std::size_t c : corner) sum += up * lx[c] / 3.0;
    whole += up;
  }
  return sum / whole;
}

TEST(GltfExport, HasTheLightOfEveryRoomOnOneScale) {
  const Exported rooms(kRooms);
  const cli::CommandOutcome outcome = rooms.run();
  ASSERT_EQ(outcome.code, cli::kAllMet) << outcome.text;
  EXPECT_THAT(outcome.text, testing::StartsWith("Wrote 2 files into "));
  for (const char* room : {"first:room", "second"}) {
    EXPECT_THAT(outcome.text,
                testing::ContainsRegex("Note: the light of space '" + std::string(room) +
                                       "' has a sampling error of [0-9.]+ %"));
  }
  const Model first(rooms.file("first_room.glb")), second(rooms.file("second.glb"));
  EXPECT_EQ(first.head["scenes"][0]["name"], "First");
  EXPECT_EQ(second.head["scenes"][0]["name"], "second");
  const json &one = first.head["scenes"][0]["extras"], &other = second.head["scenes"][0]["extras"];
  EXPECT_EQ(one["scale"], other["scale"]);
  EXPECT_EQ(one["space"], "first:room");
  EXPECT_EQ(one["unit"], "lx");
  EXPECT_GT(other["origin_m"][0].get<double>() - one["origin_m"][0].get<double>(), 9.0);
  const double mean = mean_of_floor(first);
  EXPECT_GT(mean, 100.0);
  EXPECT_NEAR(mean_of_floor(second) / mean, 2.0, 0.1);
  EXPECT_EQ(first.of("low", "POSITION").size(), 4U * 3U);
  // y up, from the middle of the room, and a thousandth of its diagonal above the plane.
  EXPECT_NEAR(first.of("low", "POSITION")[1], 0.1 + 0.00559 - 1.25, 1e-4);
  EXPECT_EQ(first.of("luminaires", "indices").size(), 6U);
  EXPECT_FALSE(first.of("legend", "TEXCOORD_0").empty());
  EXPECT_EQ(first.head["images"][0]["mimeType"], "image/png");
}

// As check does: light that nobody says fades is that of a new installation.
TEST(GltfExport, WarnsOfLightWithoutMaintenance) {
  const auto warnings = [](const std::string& project) {
    std::size_t count = 0;
    for (const calc::Diagnostic& one : Exported(project).run().diagnostics)
      count += one.id == calc::DiagnosticId::maintenance_not_stated ? 1 : 0;
    return count;
  };
  std::string project = kRooms;
  EXPECT_EQ(warnings(project), 0U);
  project.replace(project.find(" maintenance-factor=\"1\""), 23, "");
  EXPECT_EQ(warnings(project), 1U);
  // Its own limit has told of it already.
  const std::string plane = "<plane id=\"low\" height=\"0.1\" count=\"4 3\"/>";
  project.replace(project.find(plane), plane.size(),
                  "<plane id=\"low\" height=\"0.1\" count=\"4 3\"><require quantity=\"average\" "
                  "at-least=\"1\"/></plane>");
  EXPECT_EQ(warnings(project), 1U);
}

// Linear light of the map's colours: two ends and one between, by hand from #00204d and so on.
TEST(GltfExport, HasTheColoursOfTheScale) {
  calc::PreparedScene scene;
  cli::gltf::Room room{"a", "", &scene, {}, {}};
  room.light.position_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  room.light.lx = {0.0F, 1000.0F, 5000.0F};
  room.light.triangle = {{0, 1, 2}};
  const Model model(cli::gltf::write_glb(room, {0.0, 100.0, 10}));
  const std::vector<double>& colour = model.of("surfaces", "COLOR_0");
  ASSERT_EQ(colour.size(), 9U);
  const auto linear = [](int value) { return std::pow((value / 255.0 + 0.055) / 1.055, 2.4); };
  const report::Rgb low = report::cividis(0.0), high = report::cividis(1.0);
  EXPECT_NEAR(colour[1], linear(low.g), 1e-6);
  EXPECT_NEAR(colour[2], linear(low.b), 1e-6);
  EXPECT_EQ(low.r, 0);
  EXPECT_EQ(colour[0], 0.0);
  for (const std::size_t corner : {std::size_t{1}, std::size_t{2}}) {
    EXPECT_NEAR(colour[3 * corner], linear(high.r), 1e-6);
    EXPECT_NEAR(colour[3 * corner + 1], linear(high.g), 1e-6);
  }
  EXPECT_EQ(model.of("surfaces", "_ILLUMINANCE_LX"), (std::vector<double>{0.0, 1000.0, 5000.0}));
  // x to the right, z up, y to the north: away from who looks along -z of the model.
  EXPECT_EQ(model.of("surfaces", "POSITION"), (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 0, -1}));
}

// A spot beside a luminaire takes nothing from the colours of a room.
TEST(GltfExport, HasTheScaleOfMostOfTheArea) {
  cli::gltf::Room room;
  room.light.position_m = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 1}, {0.1, 0, 1}, {0, 0.1, 1}};
  room.light.lx = {400.0F, 500.0F, 480.0F, 90000.0F, 80000.0F, 90000.0F};
  room.light.triangle = {{0, 1, 2}, {3, 4, 5}};
  const report::ColourScale scale = cli::gltf::common_scale({room});
  EXPECT_EQ(scale.low, 0.0);
  EXPECT_GE(scale.high(), 500.0);
  EXPECT_LE(scale.high(), 600.0);
}

TEST(GltfExport, IsReadByTheProgramItself) {
  const Exported rooms(kRooms);
  ASSERT_EQ(rooms.run().code, cli::kAllMet);
  calc::Diagnostics diagnostics;
  const auto mesh = calc::parse_mesh_file(
      rooms.file("second.glb"), "second.glb",
      [](const std::string&) { return std::optional<std::string>(); }, diagnostics);
  ASSERT_TRUE(mesh) << (diagnostics.all().empty() ? "" : diagnostics.all()[0].message);
  EXPECT_GT(mesh->triangle.size(), 1000U);
}

TEST(GltfExport, GivesTheSameBytesOnAnyNumberOfThreads) {
  Exported rooms(kRooms);
  rooms.options.space = "second";
  rooms.options.jobs = 1;
  ASSERT_EQ(rooms.run().code, cli::kAllMet);
  const std::string bytes = rooms.file("second.glb");
  EXPECT_FALSE(fs::exists(fs::path(rooms.options.output) / "first_room.glb"));
  rooms.options.jobs = 3;
  EXPECT_EQ(rooms.run().code, cli::kNotJudged);  // it is there already
  rooms.options.overwrites = true;
  ASSERT_EQ(rooms.run().code, cli::kAllMet);
  EXPECT_TRUE(rooms.file("second.glb") == bytes);
  rooms.options.seed = 2;
  ASSERT_EQ(rooms.run().code, cli::kAllMet);
  EXPECT_FALSE(rooms.file("second.glb") == bytes);
}

TEST(GltfExport, SaysWhatIsMissing) {
  const std::string lamp = R"(<luxgate version="1">
  <luminaire-type id="panel" photometry="panel.ies" maintenance-factor="1"/>
  <luminaire id="a" type="panel" position="2 1.5 2.4"/>
)";
  const Exported nothing(lamp + "</luxgate>");
  const cli::CommandOutcome outcome = nothing.run();
  EXPECT_EQ(outcome.code, cli::kNotJudged);
  ASSERT_FALSE(outcome.diagnostics.empty());
  EXPECT_THAT(outcome.diagnostics.back().message, testing::HasSubstr("the room has no surfaces"));
  EXPECT_FALSE(fs::exists(nothing.options.output));
}

}  // namespace
}  // namespace gltf_test
