// What `luxgate export radiance` writes, read by itself: field by field, and as light. The reader
// and the path tracer here know nothing but the exported files.
#include "report/tools/export/export.h"

#include "calc/base/statistics.h"
#include "calc/base/units.h"
#include "calc/project/project_xml.h"
#include "calc/radiosity/looks/solve.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "report/tools/export/radiance_lights.h"
#include "report/tools/export/radiance_scene.h"
#include "report/tools/export/radiance_sensors.h"
#include "tests/support/command_lines.h"
#include "tests/support/mesh_rooms.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

namespace export_test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

// [name] of a .dat file: angles and values, linear between, one or two dimensions.
struct Data {
  std::vector<std::vector<double>> at;
  std::vector<double> value;

  explicit Data(const fs::path& path) {
    std::istringstream in(text_of(path));
    int dimensions = 0;
    in >> dimensions;
    std::size_t count = 1;
    for (int d = 0; d < dimensions; ++d) {
      double zero = 1, also_zero = 1;
      std::size_t n = 0;
      in >> zero >> also_zero >> n;
      EXPECT_EQ(zero, 0.0);
      EXPECT_EQ(also_zero, 0.0);
      at.emplace_back(n);
      for (double& x : at.back()) in >> x;
      for (std::size_t k = 1; k < n; ++k) {  // Radiance reads float and refuses what stands still
        EXPECT_LT(static_cast<float>(at.back()[k - 1]), static_cast<float>(at.back()[k])) << path;
      }
      count *= n;
    }
    value.resize(count);
    for (double& v : value) in >> v;
    EXPECT_TRUE(in.good() || in.eof());
    std::string rest;
    EXPECT_FALSE(static_cast<bool>(in >> rest));
  }

  double operator()(double c, double gamma) const {
    const auto find = [](const std::vector<double>& nodes, double x) {
      std::size_t k = 0;
      while (k + 2 < nodes.size() && x > nodes[k + 1]) ++k;
      return std::pair(k, std::clamp((x - nodes[k]) / (nodes[k + 1] - nodes[k]), 0.0, 1.0));
    };
    const auto [g, part] = find(at.back(), gamma);
    if (at.size() == 1) return (1 - part) * value[g] + part * value[g + 1];
    const auto [k, side] = find(at[0], c);
    const std::size_t n = at[1].size();
    const auto row = [&](std::size_t r) {
      return (1 - part) * value[r * n + g] + part * value[r * n + g + 1];
    };
    return (1 - side) * row(k) + side * row(k + 1);
  }
};

struct Web {
  std::string function, data;
  std::vector<double> arg;
};

struct Source {
  std::string web;
  std::vector<glm::dvec3> corners;  // empty: a sphere, or a ring where there is a direction
  glm::dvec3 centre{0.0};
  double radius = 0.0;
  glm::dvec3 towards{0.0};

  bool is_sphere() const { return corners.empty() && towards == glm::dvec3(0.0); }
  glm::dvec3 normal() const {
    if (corners.empty()) return towards;
    return glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  }
};

// The exported files, as Radiance's reference manual has them.
struct Exported {
  std::map<std::string, double> rho;
  std::map<std::string, Web> webs;  // by the name of the light
  std::map<std::string, Data> data;
  std::vector<Source> sources;
  calc::PreparedScene scene;
  std::vector<std::pair<glm::dvec3, glm::dvec3>> points;

  explicit Exported(const fs::path& folder) {
    scene.extent_m = 1e-9;
    for (const char* name : {"materials.rad", "surfaces.rad", "luminaires.rad"}) {
      read_primitives(text_of(folder / name), folder);
    }
    double x = 0, y = 0, z = 0, nx = 0, ny = 0, nz = 0;
    std::istringstream in(text_of(folder / "points.txt"));
    while (in >> x >> y >> z >> nx >> ny >> nz) points.push_back({{x, y, z}, {nx, ny, nz}});
    glm::dvec3 low(1e300), high(-1e300);
    for (const glm::vec3& v : scene.vertex_m) {
      low = glm::min(low, glm::dvec3(v));
      high = glm::max(high, glm::dvec3(v));
    }
    scene.extent_m = std::max(1.0, glm::length(high - low));
  }

  void read_primitives(const std::string& text, const fs::path& folder) {
    std::istringstream lines(text), in;
    std::string line, plain;
    while (std::getline(lines, line)) {
      if (!line.starts_with("#")) plain += line + "\n";
    }
    in.str(plain);
    std::string modifier, type, id;
    while (in >> modifier >> type >> id) {
      std::size_t n = 0;
      in >> n;
      std::vector<std::string> words(n);
      for (std::string& word : words) in >> word;
      in >> n;
      ASSERT_EQ(n, 0u);
      in >> n;
      std::vector<double> numbers(n);
      for (double& v : numbers) in >> v;
      ASSERT_FALSE(in.fail()) << id;
      add(modifier, type, id, words, numbers, folder);
    }
  }

  void add(const std::string& modifier, const std::string& type, const std::string& id,
           const std::vector<std::string>& words, const std::vector<double>& numbers,
           const fs::path& folder) {
    if (type == "plastic") {
      ASSERT_EQ(modifier, "void");
      ASSERT_EQ(numbers.size(), 5u);
      EXPECT_EQ(numbers[0], numbers[1]);
      EXPECT_EQ(numbers[0], numbers[2]);
      EXPECT_EQ(numbers[3], 0.0);  // no gloss
      rho[id] = numbers[0];
    } else if (type == "brightdata") {
      ASSERT_EQ(modifier, "void");
      ASSERT_GE(words.size(), 4u);
      ASSERT_EQ(numbers.size(), words[0].starts_with("lg_prism") ? 15u : 13u);
      EXPECT_EQ(words[2], "luxgate.cal");
      EXPECT_EQ(words.back(), "lg_gamma");
      webs[id] = {words[0], words[1], numbers};
      const auto [entry, is_new] = data.try_emplace(words[1], folder / words[1]);
      EXPECT_EQ(entry->second.at.size() + 3, words.size());
    } else if (type == "light") {
      ASSERT_TRUE(webs.contains(modifier));
      EXPECT_EQ(numbers, (std::vector<double>{1, 1, 1}));
      webs[id] = webs[modifier];
    } else if (type == "sphere") {
      ASSERT_EQ(numbers.size(), 4u);
      sources.push_back({modifier, {}, {numbers[0], numbers[1], numbers[2]}, numbers[3], {}});
    } else if (type == "ring") {
      ASSERT_EQ(numbers.size(), 8u);
      EXPECT_EQ(numbers[6], 0.0);
      const glm::dvec3 towards(numbers[3], numbers[4], numbers[5]);
      EXPECT_NEAR(glm::length(towards), 1.0, 1e-12);
      sources.push_back({modifier, {}, {numbers[0], numbers[1], numbers[2]}, numbers[7], towards});
    } else if (type == "polygon") {
      ASSERT_EQ(numbers.size() % 3, 0u);
      std::vector<glm::dvec3> corners;
      for (std::size_t k = 0; k < numbers.size(); k += 3) {
        corners.emplace_back(numbers[k], numbers[k + 1], numbers[k + 2]);
      }
      if (webs.contains(modifier)) {
        sources.push_back({modifier, corners, {}, 0.0, {}});
        return;
      }
      ASSERT_TRUE(rho.contains(modifier)) << modifier;
      ASSERT_EQ(corners.size(), 3u);
      const auto first = static_cast<std::uint32_t>(scene.vertex_m.size());
      for (const glm::dvec3& c : corners) scene.vertex_m.emplace_back(c);
      scene.triangle.emplace_back(first, first + 1, first + 2);
      scene.reflectance.push_back(rho[modifier]);
      scene.body.push_back(0);
    } else {
      FAIL() << type;
    }
  }

  // W/(sr m2) towards -d, d the unit direction of a ray to the source.
  double radiance(const Web& web, const glm::dvec3& d) const {
    const auto along = [&](std::size_t k) {
      return -(web.arg[k] * d.x + web.arg[k + 1] * d.y + web.arg[k + 2] * d.z);
    };
    const double x = along(1), y = along(4), z = along(7), degree = calc::kPi / 180.0;
    double c = std::atan2(y, x) / degree;
    if (c < 0.0) c += 360.0;
    const double cd = data.at(web.data)(c, std::acos(std::clamp(-z, -1.0, 1.0)) / degree);
    if (web.function == "lg_even") return web.arg[0] * cd;
    if (web.function == "lg_flat") return web.arg[0] * cd / std::max(std::abs(z), 1e-5);
    double shown =
        web.arg[10] * std::abs(x) + web.arg[11] * std::abs(y) + web.arg[12] * std::abs(z);
    if (web.function != "lg_box") {
      const std::array<double, 3> d3{x, y, z};
      const std::size_t axis = std::string("xyz").find(web.function.back());
      EXPECT_EQ(web.function.substr(0, 9), "lg_prism_");
      const double p = web.arg[13] * d3[(axis + 1) % 3], q = web.arg[14] * d3[(axis + 2) % 3];
      const double turns = 16.0 * std::atan2(q, p) / (2.0 * calc::kPi);
      shown +=
          std::hypot(p, q) * std::cos((turns - std::floor(turns) - 0.5) * 2.0 * calc::kPi / 16.0);
    }
    return web.arg[0] * cd / shown;
  }

  // Area in m2 of a flat source.
  static double area_m2(const Source& source) {
    if (source.corners.empty()) return calc::kPi * source.radius * source.radius;
    const std::vector<glm::dvec3>& c = source.corners;
    double area = 0.0;
    for (std::size_t k = 1; k + 1 < c.size(); ++k) {
      area += 0.5 * glm::length(glm::cross(c[k] - c[0], c[k + 1] - c[0]));
    }
    return area;
  }

  // cd in the unit direction, as whoever is far away sees all sources.
  double far_intensity_cd(const glm::dvec3& out) const {
    double cd = 0.0;
    for (const Source& source : sources) {
      const double facing = source.is_sphere() ? 1.0 : glm::dot(source.normal(), out);
      if (!(facing > 0.0)) continue;
      cd += cli::radiance::kLumensPerWatt * area_m2(source) * facing *
            radiance(webs.at(source.web), -out);
    }
    return cd;
  }
};

// Lux at a point: one random point of every source, cosine paths beyond.
class Estimator {
 public:
  Estimator(const Exported& exported, const calc::Tracer& tracer)
      : exported_(exported), tracer_(tracer) {}

  double direct_lx(const glm::dvec3& x, const glm::dvec3& n) {
    double sum = 0.0;
    for (const Source& source : exported_.sources) {
      glm::dvec3 y = source.centre;
      double area = calc::kPi * source.radius * source.radius;
      if (!source.corners.empty()) {
        y = on_polygon(source, area);
      } else if (!source.is_sphere()) {
        y = on_ring(source);
      }
      const glm::dvec3 w = y - x;
      const double d = glm::length(w), cosine = glm::dot(n, w) / d;
      double facing = 1.0;
      if (!source.is_sphere()) facing = -glm::dot(source.normal(), w) / d;
      if (cosine <= 0.0 || facing <= 0.0) continue;
      const double lx = cli::radiance::kLumensPerWatt * area * facing * cosine / (d * d) *
                        exported_.radiance(exported_.webs.at(source.web), w / d);
      // Short of the source: a sphere ends at its surface, a panel may lie in a ceiling.
      if (lx > 0.0 && !tracer_.is_blocked(x, y - (2e-3 / d) * w)) sum += lx;
    }
    return sum;
  }

  double path_lx(glm::dvec3 x, glm::dvec3 n) {
    double lx = direct_lx(x, n), weight = 1.0;
    for (int bounce = 0; bounce < 1000; ++bounce) {
      const double z = 2.0 * uniform() - 1.0, angle = 2.0 * calc::kPi * uniform();
      const double r = std::sqrt(1.0 - z * z);
      const glm::dvec3 out =
          glm::normalize(n + 0.999999 * glm::dvec3(r * std::cos(angle), r * std::sin(angle), z));
      calc::SurfaceHit hit{};
      if (!tracer_.closest_hit(x, out, 1e9, hit)) break;
      const double rho = exported_.scene.reflectance[hit.triangle];
      if (bounce == 0) {
        weight = rho;
      } else if (uniform() >= rho) {
        break;
      }
      if (weight == 0.0) break;
      n = hit.normal;
      x = tracer_.lift(hit.position_m, n);
      lx += weight * direct_lx(x, n);
    }
    return lx;
  }

 private:
  double uniform() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

  glm::dvec3 on_ring(const Source& source) {
    const glm::dvec3 aside =
        std::abs(source.towards.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(source.towards, aside));
    const double r = source.radius * std::sqrt(uniform()), angle = 2.0 * calc::kPi * uniform();
    return source.centre +
           r * (std::cos(angle) * u + std::sin(angle) * glm::cross(source.towards, u));
  }

  // Even over the polygon, cut into triangles about its first corner.
  glm::dvec3 on_polygon(const Source& source, double& area) {
    const std::vector<glm::dvec3>& c = source.corners;
    std::vector<double> upto;
    area = 0.0;
    for (std::size_t k = 1; k + 1 < c.size(); ++k) {
      area += 0.5 * glm::length(glm::cross(c[k] - c[0], c[k + 1] - c[0]));
      upto.push_back(area);
    }
    const double pick = uniform() * area;
    const auto k = static_cast<std::size_t>(std::upper_bound(upto.begin(), upto.end() - 1, pick) -
                                            upto.begin());
    const double s = std::sqrt(uniform()), t = uniform();
    return c[0] + s * ((1 - t) * (c[k + 1] - c[0]) + t * (c[k + 2] - c[0]));
  }

  const Exported& exported_;
  const calc::Tracer& tracer_;
  std::mt19937_64 random_{7};
};

fs::path scratch(const std::string& name) {
  static const test_support::ScratchFolder folder;
  return folder.path() / name;
}

cli::ExportOptions options_for(const std::string& project, const fs::path& folder) {
  cli::ExportOptions options;
  options.target = "radiance";
  options.project = project;
  options.output = folder.string();
  return options;
}

class ExportedExample : public testing::TestWithParam<const char*> {};

TEST_P(ExportedExample, HasTheSameLight) {
  const std::string project_file =
      std::string(LUXGATE_SOURCE_DIR) + "/examples/" + GetParam() + "/project.xml";
  const fs::path folder = scratch(GetParam());
  const calc::DiskFileReader disk;
  const cli::CommandOutcome outcome = cli::run_export(options_for(project_file, folder), disk);
  ASSERT_EQ(outcome.code, cli::kAllMet)
      << (outcome.diagnostics.empty() ? "" : outcome.diagnostics[0].message);

  // The program's own answer.
  calc::Diagnostics diagnostics;
  const auto project = calc::load_project(disk, project_file, diagnostics);
  ASSERT_TRUE(project);
  const calc::Space& space = project->spaces[0];
  const calc::PreparedScene scene = calc::prepare_scene(*project, space);
  std::vector<calc::SensorGrid> grids;
  std::vector<calc::PlaneTask> tasks;
  for (const calc::CalcPlane& plane : space.planes) {
    grids.push_back(*calc::make_sensor_grid(plane, space, diagnostics));
  }
  for (std::size_t p = 0; p < grids.size(); ++p) tasks.push_back({space.planes[p].id, &grids[p]});
  calc::RadiositySettings settings;
  settings.first_paths = settings.max_paths = 1024;
  const auto gatherer = calc::make_cpu_gatherer();
  const calc::SpaceSolution solution = calc::solve_illuminance(
      scene, tasks, settings, 0.95, *gatherer,
      [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; }, {});

  const Exported exported(folder);
  EXPECT_EQ(exported.scene.triangle.size(), scene.triangle.size());
  std::size_t all = 0;
  for (const calc::SensorGrid& grid : grids) all += grid.position_m.size();
  ASSERT_EQ(exported.points.size(), all);
  const calc::Tracer tracer(exported.scene);
  Estimator estimator(exported, tracer);
  std::size_t at = 0, compared = 0;
  for (const calc::PlaneField& field : solution.fields) {
    const std::size_t step = std::max<std::size_t>(1, field.points / 4);
    for (std::size_t i = 0; i < field.points; ++i, ++at) {
      if (i % step != step / 2) continue;
      std::vector<double> ours;
      for (std::size_t r = 0; r < field.replicates; ++r) {
        double lx = 0.0;
        for (std::size_t c = 0; c < field.channels.size(); ++c) {
          const std::size_t exact = c * field.points + i;
          const std::size_t k = r * field.channels.size() * field.points + exact;
          lx += field.channels[c].maintenance_factor *
                (field.direct_exact_lx[exact] +
                 (field.direct_sampled_lx.empty() ? 0.0 : field.direct_sampled_lx[k]) +
                 (field.indirect_lx.empty() ? 0.0 : field.indirect_lx[k]));
        }
        ours.push_back(lx);
      }
      constexpr int kPaths = 1500;
      double sum = 0.0, squares = 0.0;
      for (int p = 0; p < kPaths; ++p) {
        const double lx = estimator.path_lx(exported.points[at].first, exported.points[at].second);
        sum += lx / kPaths;
        squares += lx * lx / kPaths;
      }
      const calc::ReplicateMean mean = calc::replicate_mean(ours);
      const double error =
          std::hypot(mean.standard_error, std::sqrt(std::max(0.0, squares - sum * sum) / kPaths));
      EXPECT_NEAR(sum, mean.mean, 4.5 * error + 2e-3 * mean.mean) << field.plane_id << " " << i;
      ++compared;
    }
  }
  EXPECT_GE(compared, 4u);
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Examples, ExportedExample,
                         testing::Values("01-one-luminaire", "02-direct-and-indirect",
                                         "03-cornell-box", "04-office", "05-failing-corridor",
                                         "07-spot-and-wall-washer"),
                         [](const auto& parameter) {
                           std::string name = parameter.param;
                           std::replace(name.begin(), name.end(), '-', 'x');
                           return "E" + name;
                         });

TEST(RadianceExport, NeverReplacesFilesUnasked) {
  const std::string project =
      std::string(LUXGATE_SOURCE_DIR) + "/examples/01-one-luminaire/project.xml";
  const fs::path folder = scratch("twice");
  cli::ExportOptions options = options_for(project, folder);
  const calc::DiskFileReader disk;
  ASSERT_EQ(cli::run_export(options, disk).code, cli::kAllMet);
  const cli::CommandOutcome again = cli::run_export(options, disk);
  EXPECT_EQ(again.code, cli::kNotJudged);
  ASSERT_FALSE(again.diagnostics.empty());
  EXPECT_NE(again.diagnostics[0].message.find("--force"), std::string::npos);
  options.overwrites = true;
  EXPECT_EQ(cli::run_export(options, disk).code, cli::kAllMet);
  EXPECT_NE(fs::status(folder / "run.sh").permissions() & fs::perms::owner_exec, fs::perms::none);
  for (const char* name : {"README.md", "luxgate.cal", "points.csv", "light-1.dat"}) {
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
  fs::remove_all(folder);
}

// An asymmetric table that ends in the light: degrees, darkness beyond, one value at the pole.
TEST(RadianceExport, TablesAreInDegreesAndDarkOutside) {
  const double right = 0.5 * calc::kPi;
  const auto web =
      calc::PhotometricWeb::make({0.0, right, 2 * right, 3 * right, 4 * right}, {0.0, right},
                                 {10, 1, 20, 2, 10, 3, 20, 4, 10, 1}, {}, {});
  std::string text;
  bool is_axial = true;
  ASSERT_TRUE(cli::radiance::web_data(web, text, is_axial));
  EXPECT_FALSE(is_axial);
  EXPECT_TRUE(text.starts_with("2\n0 0 5\n 0 90 180 270 360\n0 0 4\n 0 90 90.0001 180\n")) << text;
  EXPECT_NE(text.find("\n 15 1 0 0\n 15 2 0 0\n"), std::string::npos) << text;
}

TEST(RadianceExport, AnglesThatFloatCannotTellApartAreNotWritten) {
  const double degree = calc::kPi / 180.0;
  const auto writes = [&](double step_deg) {
    const auto web = calc::PhotometricWeb::make(
        {0.0}, {0.0, 90 * degree, (90 + step_deg) * degree, 180 * degree}, {4, 3, 2, 1}, {}, {});
    std::string text;
    bool is_axial = false;
    return cli::radiance::web_data(web, text, is_axial);
  };
  EXPECT_TRUE(writes(1e-4));
  EXPECT_FALSE(writes(1e-6));
}

TEST(RadianceExport, LeavesOutRatingsAndRatiosAndSaysSo) {
  const fs::path folder = scratch("quantities");
  cli::ExportOptions options = options_for(
      std::string(LUXGATE_SOURCE_DIR) + "/tests/golden/ratings-and-power/project.xml", folder);
  options.space = "lit";
  const cli::CommandOutcome outcome = cli::run_export(options, calc::DiskFileReader());
  ASSERT_EQ(outcome.code, cli::kAllMet);
  for (const char* words :
       {"plane 'towards' has the quantity 'ugr', which is not a sum",
        "'away' has the quantity 'ugr'", "plane 'modelling' has the quantity 'modelling'"}) {
    EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text;
  }
  const std::string points = text_of(folder / "points.csv");
  EXPECT_NE(points.find("\nplanar,"), std::string::npos) << points;
  EXPECT_NE(points.find(",cylindrical-4\n"), std::string::npos) << points;
  EXPECT_EQ(std::count(points.begin(), points.end(), '\n'), 3) << points;
  EXPECT_EQ(text_of(folder / "weights.txt"), "1 1\n2 0.25\n2 0.25\n2 0.25\n2 0.25\n");
  // The result has more: compare needs to be told.
  EXPECT_NE(text_of(folder / "run.sh").find("--tolerance 2% --partial\""), std::string::npos);
  EXPECT_NE(text_of(folder / "README.md").find("radiance.csv --partial`"), std::string::npos);
  fs::remove_all(folder);
}

// A room with one luminaire of the shape in each of two dimming groups, and planes of all
// quantities that are sums. Sizes in m along H 0, across and up, as LM-63 has them.
fs::path shaped_project(const std::string& name, const std::string& sizes) {
  const fs::path folder = scratch(name);
  fs::create_directories(folder);
  std::ofstream(folder / "lamp.ies")
      << "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n"
         "TILT=NONE\n1 -1 1 7 5 1 2 "
      << sizes
      << "\n1 1 12\n0 30 60 90 120 150 180\n0 90 180 270 360\n"
         "100 90 60 50 40 20 10\n100 80 70 60 50 20 10\n100 70 90 40 40 20 10\n"
         "100 60 80 70 60 20 10\n100 90 60 50 40 20 10\n";
  std::ofstream(folder / "project.xml")
      << "<luxgate version='1'><material id='m' reflectance='0.5'/>"
         "<luminaire-type id='t' photometry='lamp.ies'/>"
         "<scene id='night'><dim group='a' level='0.25'/><dim group='b' level='0'/></scene>"
         "<scene id='off'><dim group='a' level='0'/><dim group='b' level='0'/></scene>"
         "<room id='r' size='8 6 3' floor='m' walls='m' ceiling='m'>"
         "<luminaire id='l' type='t' position='2 3 2' axis='0 0.6 -0.8' rotation='20' group='a'/>"
         "<luminaire id='k' type='t' position='6 3 2' group='b'/>"
         "<plane id='p' origin='3 3 1' u='2 0 0' v='0 2 0' count='1 1'/>"
         "<plane id='c' origin='3 3 1' u='2 0 0' v='0 2 0' count='1 1' quantity='cylindrical'/>"
         "<plane id='s' origin='3 3 1' u='2 0 0' v='0 2 0' count='1 1' quantity='semicylindrical'"
         " direction='1 0 0'/>"
         "<plane id='h' origin='3 3 1' u='2 0 0' v='0 2 0' count='1 1' quantity='hemispherical'/>"
         "</room></luxgate>";
  return folder;
}

struct Shape {
  const char *name, *sizes;
  calc::OpeningShape shape;
  glm::dvec3 size_m;  // along the luminaire's axes
};

class ExportedShape : public testing::TestWithParam<Shape> {};

// In every direction the intensity of the file, and sources as large as the opening.
TEST_P(ExportedShape, ShinesAsThePhotometrySays) {
  const Shape& shape = GetParam();
  const fs::path folder = shaped_project(shape.name, shape.sizes);
  const std::string project_file = (folder / "project.xml").string();
  const calc::DiskFileReader disk;
  const cli::CommandOutcome outcome =
      cli::run_export(options_for(project_file, folder / "out"), disk);
  ASSERT_EQ(outcome.code, cli::kAllMet)
      << (outcome.diagnostics.empty() ? "" : outcome.diagnostics[0].message);
  calc::Diagnostics diagnostics;
  const auto project = calc::load_project(disk, project_file, diagnostics);
  ASSERT_TRUE(project);
  const calc::PreparedScene scene = calc::prepare_scene(*project, project->spaces[0]);
  ASSERT_EQ(scene.luminaires.size(), 2u);
  ASSERT_EQ(scene.luminaires[0].opening.shape, shape.shape);

  Exported exported(folder / "out");
  std::erase_if(exported.sources,
                [](const Source& source) { return !source.web.starts_with("light_1_"); });
  const calc::PlacedLuminaire& luminaire = scene.luminaires[0];
  const glm::dmat3 to_luminaire = glm::transpose(luminaire.world_from_luminaire);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  double flux_lm = 0.0, expected_lm = 0.0;
  for (int k = 0; k < 2000; ++k) {
    const glm::dvec3 out =
        glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    const glm::dvec3 local = to_luminaire * out;
    double c = std::atan2(local.y, local.x);
    if (c < 0.0) c += 2.0 * calc::kPi;
    const double cd = luminaire.flux_scale * scene.channels[luminaire.channel].maintenance_factor *
                      luminaire.web->intensity_cd(c, std::acos(std::clamp(-local.z, -1.0, 1.0)));
    // Flat openings have no light for those who see them edge-on.
    if (shape.size_m.z == 0.0 && std::abs(local.z) < 1e-3) continue;
    flux_lm += exported.far_intensity_cd(out);
    expected_lm += cd;
    ASSERT_NEAR(exported.far_intensity_cd(out), cd, 1e-9 * cd) << local.x << " " << local.y;
  }
  EXPECT_NEAR(flux_lm, expected_lm, 1e-9 * expected_lm);

  glm::dvec3 low(1e300), high(-1e300);
  const auto reach = [&](const glm::dvec3& world) {
    const glm::dvec3 p = to_luminaire * (world - scene.origin_m - luminaire.position_m);
    low = glm::min(low, p);
    high = glm::max(high, p);
  };
  for (const Source& source : exported.sources) {
    for (const glm::dvec3& corner : source.corners) reach(corner);
    if (!source.corners.empty()) continue;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step = glm::dvec3(luminaire.world_from_luminaire[axis]);
      step -= glm::dot(step, source.towards) * source.towards;
      reach(source.centre + source.radius * step);
      reach(source.centre - source.radius * step);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(high[axis], -low[axis], 1e-9) << axis;
    // A prism's corners may stand out; faces of flat openings stand off their plane by 0.1 mm.
    EXPECT_NEAR(high[axis] - low[axis], shape.size_m[axis], 0.02 * shape.size_m[axis] + 3e-4)
        << axis;
  }
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, ExportedShape,
    testing::Values(
        Shape{"point", "0 0 0", calc::OpeningShape::point, {0.01, 0.01, 0.01}},
        Shape{"rectangle", "0.3 0.9 0", calc::OpeningShape::rectangle, {0.9, 0.3, 0.0}},
        Shape{"disk", "-0.6 -0.6 0", calc::OpeningShape::disk, {0.6, 0.6, 0.0}},
        Shape{"ellipse", "-0.3 -0.9 0", calc::OpeningShape::disk, {0.9, 0.3, 0.0}},
        Shape{"box", "0.3 0.9 0.1", calc::OpeningShape::box, {0.9, 0.3, 0.1}},
        Shape{"upright", "-0.2 -0.2 0.5", calc::OpeningShape::cylinder, {0.2, 0.2, 0.5}},
        Shape{"elliptical", "-0.2 -0.4 0.5", calc::OpeningShape::cylinder, {0.4, 0.2, 0.5}},
        Shape{"along", "-0.1 0.9 -0.1", calc::OpeningShape::cylinder_c0, {0.9, 0.1, 0.1}},
        Shape{"across", "0.9 -0.1 -0.1", calc::OpeningShape::cylinder_c90, {0.1, 0.9, 0.1}},
        Shape{"sphere", "-0.3 -0.3 -0.3", calc::OpeningShape::ellipsoid, {0.3, 0.3, 0.3}}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

// Polygons of many corners lose 6 % of it in Radiance, which samples a square of their area.
TEST(RadianceExport, DisksAreRings) {
  const fs::path folder = shaped_project("rings", "-0.6 -0.6 0");
  const cli::CommandOutcome outcome = cli::run_export(
      options_for((folder / "project.xml").string(), folder / "out"), calc::DiskFileReader());
  ASSERT_EQ(outcome.code, cli::kAllMet);
  EXPECT_NE(text_of(folder / "out/luminaires.rad")
                .find("light_2_shine ring light_2_below\n0\n0\n8\n 6 3 1.9999\n 0 0 -1\n 0 0.3\n"),
            std::string::npos)
      << text_of(folder / "out/luminaires.rad");
  const Exported exported(folder / "out");
  ASSERT_EQ(exported.sources.size(), 4u);  // both sides of two
  for (const Source& source : exported.sources) {
    EXPECT_NEAR(Exported::area_m2(source), calc::kPi * 0.09, 1e-9);
  }
  fs::remove_all(folder);
}

// What shades in luxgate shades there, behind the source: the mesh and the face of the opening.
TEST(RadianceExport, AHousingOfAMeshIsASurface) {
  const fs::path folder = shaped_project("housing", "0.3 0.9 0");
  std::ofstream(folder / "down.ies")
      << "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n"
         "TILT=NONE\n1 -1 1 2 1 1 2 0.3 0.9 0\n1 1 12\n0 90\n0\n100 0\n";
  std::ofstream(folder / "body.obj")
      << test_support::ObjText().box("body", {-0.45, -0.15, 0}, {0.45, 0.15, 0.1}, false).text();
  const std::string project_file = (folder / "project.xml").string();
  std::ofstream(project_file)
      << "<luxgate version='1'><material id='m' reflectance='0.5'/>"
         "<material id='grey' reflectance='0.25'/><luminaire-type id='t' photometry='down.ies'>"
         "<housing material='grey' file='body.obj' units='m' up='z'/></luminaire-type>"
         "<room id='r' size='8 6 3' floor='m' walls='m' ceiling='m'>"
         "<luminaire id='l' type='t' position='2 3 2'/>"
         "<plane id='p' origin='3 3 1' u='2 0 0' v='0 2 0' count='1 1'/></room></luxgate>";
  const cli::CommandOutcome outcome =
      cli::run_export(options_for(project_file, folder / "out"), calc::DiskFileReader());
  ASSERT_EQ(outcome.code, cli::kAllMet)
      << (outcome.diagnostics.empty() ? "" : outcome.diagnostics[0].message);
  const Exported exported(folder / "out");
  double area_m2 = 0.0, lowest_m = 9.0, highest_m = 0.0;
  for (std::size_t t = 0; t < exported.scene.triangle.size(); ++t) {
    if (exported.scene.reflectance[t] != 0.25) continue;
    const glm::uvec3& v = exported.scene.triangle[t];
    const glm::dvec3 a(exported.scene.vertex_m[v.x]), b(exported.scene.vertex_m[v.y]),
        c(exported.scene.vertex_m[v.z]);
    area_m2 += 0.5 * glm::length(glm::cross(b - a, c - a));
    for (const glm::dvec3& p : {a, b, c}) {
      lowest_m = std::min(lowest_m, p.z);
      highest_m = std::max(highest_m, p.z);
    }
  }
  EXPECT_NEAR(area_m2, 3 * 0.27 + 0.24, 1e-5);
  EXPECT_NEAR(lowest_m, 2.0, 1e-6);
  EXPECT_NEAR(highest_m, 2.1, 1e-6);
  fs::remove_all(folder);
}

TEST(RadianceExport, AModelHasNoScene) {
  const cli::TestLine line =
      cli::parse_words({"export", "gltf", "a.xml", "-o", "folder", "--scene", "night"});
  EXPECT_FALSE(line.is_good);
  EXPECT_NE(line.err.find("--scene is for radiance"), std::string::npos) << line.err;
}

TEST(RadianceExport, ASceneDimsItsGroups) {
  const fs::path folder = shaped_project("scenes", "0.3 0.9 0");
  cli::ExportOptions options = options_for((folder / "project.xml").string(), folder / "full");
  const calc::DiskFileReader disk;
  ASSERT_EQ(cli::run_export(options, disk).code, cli::kAllMet);
  EXPECT_NE(text_of(folder / "full/README.md")
                .find("All luminaires are at full output; `--scene` takes the levels of a scene "
                      "(night, off)."),
            std::string::npos);
  options.output = (folder / "night").string();
  options.scene = "night";
  ASSERT_EQ(cli::run_export(options, disk).code, cli::kAllMet);
  const Exported full(folder / "full"), night(folder / "night");
  ASSERT_EQ(full.webs.count("light_2_web"), 1u);
  EXPECT_EQ(night.webs.count("light_2_web"), 0u);
  EXPECT_DOUBLE_EQ(night.webs.at("light_1_web").arg[0], 0.25 * full.webs.at("light_1_web").arg[0]);
  EXPECT_NE(text_of(folder / "night/luminaires.rad").find("# light_2: its group is at level 0."),
            std::string::npos);
  EXPECT_NE(text_of(folder / "night/README.md")
                .find("Levels are those of scene `night`: group `a` at 0.25, group `b` at 0, all "
                      "else at 1."),
            std::string::npos);
  EXPECT_EQ(text_of(folder / "night/run.sh").find("Next: luxgate compare"), std::string::npos);

  const auto problem = [&](const char* scene) {
    options.output = (folder / "none").string();
    options.scene = scene;
    const cli::CommandOutcome outcome = cli::run_export(options, disk);
    EXPECT_EQ(outcome.code, cli::kNotJudged);
    EXPECT_FALSE(fs::exists(folder / "none"));
    return outcome.diagnostics.empty() ? "" : outcome.diagnostics[0].message;
  };
  EXPECT_NE(problem("nght").find("no scene 'nght'; known: night or off; did you mean 'night'?"),
            std::string::npos)
      << problem("nght");
  EXPECT_NE(problem("off").find("no luminaire with light to export in scene 'off'"),
            std::string::npos)
      << problem("off");
  fs::remove_all(folder);
}

// Light from one direction after the other: what the sum of planes makes of it, and the kernel.
TEST(RadianceExport, SumsOverDirectionsAreTheQuantities) {
  const glm::dvec3 up(0, 0, 1), aside(0.6, 0.8, 0);
  struct Case {
    calc::ReceiverKernel kernel;
    glm::dvec3 axis;
    double allowed;  // in units of what the kernel's sphere or cylinder sees at most
  };
  for (const Case& one : {Case{calc::ReceiverKernel::planar, aside, 1e-12},
                          Case{calc::ReceiverKernel::cylindrical, up, 0.0019 / calc::kPi},
                          Case{calc::ReceiverKernel::cylindrical, aside, 0.0019 / calc::kPi},
                          Case{calc::ReceiverKernel::semicylindrical, aside, 0.0019 / calc::kPi},
                          Case{calc::ReceiverKernel::hemispherical, up, 0.005 / 4.0},
                          Case{calc::ReceiverKernel::hemispherical, aside, 0.005 / 4.0},
                          Case{calc::ReceiverKernel::scalar, up, 0.005 / 4.0}}) {
    calc::SensorGrid grid;
    grid.kernel = one.kernel;
    grid.position_m = {{1, 2, 3}};
    grid.normal = {one.axis};
    const auto sensors = cli::radiance::sensors_of(grid, 0);
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    double worst = 0.0;
    for (int k = 0; k < 5000; ++k) {
      const glm::dvec3 w =
          glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
      double sum = 0.0;
      for (const auto& sensor : sensors) {
        EXPECT_NEAR(glm::length(sensor.direction), 1.0, 1e-12);
        EXPECT_LE(glm::distance(sensor.position_m, grid.position_m[0]), 1.1e-4);
        sum += sensor.weight * std::max(0.0, glm::dot(sensor.direction, w));
      }
      worst =
          std::max(worst, std::abs(sum - calc::response_times_distance(one.kernel, one.axis, w)));
    }
    EXPECT_LE(worst, one.allowed) << calc::quantity_name(one.kernel, calc::DerivedQuantity::none);
  }
}

TEST(RadianceExport, TheMeanOfFourPlanesIsThat) {
  calc::SensorGrid grid;
  grid.kernel = calc::ReceiverKernel::cylindrical;
  grid.derived = calc::DerivedQuantity::four_planes;
  grid.position_m = {{1, 2, 3}};
  grid.normal = {{0, 0, 1}};
  const auto sensors = cli::radiance::sensors_of(grid, 0);
  ASSERT_EQ(sensors.size(), 4u);
  const glm::dvec3 expected[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LE(glm::distance(sensors[k].direction, expected[k]), 1e-12);
    EXPECT_EQ(sensors[k].weight, 0.25);
  }
}

TEST(RadianceExport, BouncesGoByTheReflectances) {
  calc::PreparedScene scene;
  scene.vertex_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene.triangle = {{0, 1, 2}, {0, 1, 3}};
  const auto bounces = [&](double one, double other) {
    scene.reflectance = {one, other};
    return cli::radiance::ambient_bounces(scene);
  };
  EXPECT_EQ(bounces(0.0, 0.0), 1);
  EXPECT_EQ(bounces(0.5, 0.5), 9);   // 0.5^9 = 0.00195
  EXPECT_EQ(bounces(0.8, 0.2), 9);   // by area
  EXPECT_EQ(bounces(0.7, 0.7), 18);  // 0.7^18 = 0.0016
  EXPECT_EQ(bounces(1.0, 1.0), 100);
}

TEST(RadianceExport, HasThePlanesOfWorkplaces) {
  const fs::path folder = scratch("workplace");
  const cli::CommandOutcome outcome = cli::run_export(
      options_for(std::string(LUXGATE_SOURCE_DIR) + "/examples/09-office-by-row/project.xml",
                  folder),
      calc::DiskFileReader());
  ASSERT_EQ(outcome.code, cli::kAllMet);
  const std::string points = text_of(folder / "points.csv");
  EXPECT_NE(points.find("\ndesk.task,"), std::string::npos);
  EXPECT_NE(points.find("\ndesk.ceiling,"), std::string::npos);
  EXPECT_EQ(points.find("\ndesk.observer"), std::string::npos);
  fs::remove_all(folder);
}

TEST(RadianceExport, KnowsTheUsersRulePacks) {
  const fs::path folder = scratch("rules");
  fs::create_directories(folder);
  std::ofstream(folder / "lamp.ies")
      << "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\n"
         "TILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 12\n0 90\n0\n100 0\n";
  std::ofstream(folder / "project.xml")
      << "<luxgate version='1'><material id='m' reflectance='0.5'/>"
         "<luminaire-type id='t' photometry='lamp.ies'/>"
         "<room id='r' size='8 6 3' floor='m' walls='m' ceiling='m'>"
         "<luminaire id='l' type='t' position='4 3 2.9'/>"
         "<workplace id='w' pack='own' row='1' origin='3 2' size='1.6 0.8' height='0.75'/>"
         "</room></luxgate>";
  std::ofstream(folder / "pack.xml")
      << "<rule-pack id='own' edition='2024' title='Own rules' version='1' kind='contract' "
         "status='draft' jurisdiction='EU' licence='internal' role='task'>"
         "<source id='s' note='n'/><parameter id='E' unit='lx' meaning='m'/>"
         "<grid id='g' method='formula-power' count='nearest'/>"
         "<plane role='task' orientation='horizontal-up' heights='0.7 0.8' grid='g' "
         "area='task' height='0.75'/>"
         "<row ref='1' name='desk' trust='confirmed' sources='s'><value of='E' required='300'/>"
         "</row><check id='a' role='task' quantity='planar' statistic='average' "
         "at-least='row(E)'/></rule-pack>";
  cli::ExportOptions options = options_for((folder / "project.xml").string(), folder / "out");
  EXPECT_EQ(cli::run_export(options, calc::DiskFileReader()).code, cli::kNotJudged);
  options.rule_files = {(folder / "pack.xml").string()};
  const cli::CommandOutcome outcome = cli::run_export(options, calc::DiskFileReader());
  ASSERT_EQ(outcome.code, cli::kAllMet)
      << (outcome.diagnostics.empty() ? "" : calc::format_diagnostic(outcome.diagnostics[0]));
  EXPECT_NE(text_of(folder / "out/points.csv").find("\nw.task,"), std::string::npos);
  // All that a result has is exported.
  EXPECT_EQ(text_of(folder / "out/run.sh").find("--partial"), std::string::npos);
  fs::remove_all(folder);
}

// Several directions for a point: as many numbers as there are points, each the weighted sum.
TEST(RadianceExport, TheScriptAddsUpDirections) {
  const fs::path folder = shaped_project("sums", "0 0 0");
  ASSERT_EQ(cli::run_export(options_for((folder / "project.xml").string(), folder / "out"),
                            calc::DiskFileReader())
                .code,
            cli::kAllMet);
  const fs::path bin = folder / "bin";
  fs::create_directories(bin);
  std::ofstream(bin / "oconv") << "#!/bin/sh\n";
  // Light from straight above: what a plane has of it is its normal's z.
  std::ofstream(bin / "rtrace")
      << "#!/bin/sh\nawk '{ e = $6 > 0 ? $6 / 1.79 : 0; print e, e, e }'\n";
  for (const char* program : {"oconv", "rtrace"}) {
    fs::permissions(bin / program, fs::perms::owner_all, fs::perm_options::add);
  }
  const std::string quoted = "'" + folder.string();
  ASSERT_EQ(
      std::system(
          ("PATH=" + quoted + "/bin':\"$PATH\" " + quoted + "/out/run.sh' > /dev/null").c_str()),
      0);
  std::istringstream csv(text_of(folder / "out/radiance.csv"));
  std::string line;
  ASSERT_TRUE(std::getline(csv, line));
  EXPECT_EQ(line, "plane,column,row,x,y,z,quantity,lx");
  const std::map<std::string, double> expected{
      {"planar", 100.0}, {"cylindrical", 0.0}, {"semicylindrical", 0.0}, {"hemispherical", 50.0}};
  std::size_t rows = 0;
  for (; std::getline(csv, line); ++rows) {
    const std::size_t comma = line.rfind(','), before = line.rfind(',', comma - 1);
    const std::string quantity = line.substr(before + 1, comma - before - 1);
    ASSERT_TRUE(expected.contains(quantity)) << line;
    EXPECT_NEAR(std::stod(line.substr(comma + 1)), expected.at(quantity), 0.15) << line;
  }
  EXPECT_EQ(rows, 4u);
  fs::remove_all(folder);
}

// By the shell itself; and by Radiance where it is installed.
TEST(RadianceExport, TheScriptRuns) {
  const auto shell = [](const std::string& command) { return std::system(command.c_str()); };
  const fs::path folder = scratch("script it's");
  const std::string name = "'" + (folder.parent_path() / "script it'\\''s").string() + "'";
  ASSERT_EQ(cli::run_export(options_for(std::string(LUXGATE_SOURCE_DIR) +
                                            "/examples/01-one-luminaire/project.xml",
                                        folder),
                            calc::DiskFileReader())
                .code,
            cli::kAllMet);
  EXPECT_EQ(shell("sh -n " + name + "/run.sh"), 0);
  // With programs in Radiance's place: where it looks, and what becomes of the numbers.
  const fs::path bin = folder / "bin";
  fs::create_directories(bin);
  std::ofstream(bin / "oconv") << "#!/bin/sh\necho \"path=${RAYPATH-unset}\"\n";
  std::ofstream(bin / "rtrace") << "#!/bin/sh\nfor last; do :; done\ncp \"$last\" seen.txt\n"
                                   "while read -r line; do echo '1.5 1.5 1.5'; done\n";
  for (const char* program : {"oconv", "rtrace"}) {
    fs::permissions(bin / program, fs::perms::owner_all, fs::perm_options::add);
  }
  const std::string with_them = "PATH=" + name + "/bin:\"$PATH\"; export PATH; cd /; ";
  ASSERT_EQ(shell(with_them + "unset RAYPATH; CDPATH=/tmp LC_ALL=de_DE.UTF-8 " + name +
                  "/run.sh > " + name + "/said.txt"),
            0);
  EXPECT_EQ(text_of(folder / "seen.txt"), "path=unset\n");
  const std::string csv = text_of(folder / "radiance.csv"), points = text_of(folder / "points.txt");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'),
            std::count(points.begin(), points.end(), '\n') + 1);
  EXPECT_NE(csv.find(",268.5\n"), std::string::npos) << csv;
  EXPECT_NE(text_of(folder / "said.txt").find("Next: luxgate compare"), std::string::npos);
  ASSERT_EQ(shell(with_them + "RAYPATH=/usr/lib/ray " + name + "/run.sh > " + name + "/said.txt"),
            0);
  EXPECT_EQ(text_of(folder / "seen.txt"), "path=.:/usr/lib/ray\n");
  // A line that rtrace leaves out is no darkness.
  fs::remove(folder / "radiance.csv");
  std::ofstream(bin / "rtrace") << "#!/bin/sh\necho '1.5 1.5 1.5'\n";
  EXPECT_NE(shell(with_them + name + "/run.sh > /dev/null 2> " + name + "/said.txt"), 0);
  EXPECT_NE(text_of(folder / "said.txt").find("did not answer for all points"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "radiance.csv"));
  fs::remove_all(bin);
  if (shell("command -v oconv > /dev/null && command -v rtrace > /dev/null") != 0) {
    fs::remove_all(folder);
    GTEST_SKIP() << "oconv and rtrace are not installed: run.sh ran with programs in their place";
  }
  EXPECT_EQ(shell(name + "/run.sh -ab 1 -ad 16 > /dev/null"), 0);
  EXPECT_EQ(text_of(folder / "radiance.csv").find(",268.5\n"), std::string::npos);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace export_test
