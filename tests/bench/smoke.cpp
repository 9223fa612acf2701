// Every generator and experiment at the smallest size, so that ctest sees them run.
#include "tests/bench/experiments.h"
#include "tests/bench/ray_limit.h"
#include "tests/bench/scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace bench {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("smoke: " + what);
}

void check_scenes() {
  for (const std::string& name : room_names()) {
    const BenchScene scene = make_scene(find_room(name));
    const std::size_t triangles = scene.scene.triangle.size();
    fmt::print("{}: {} triangles, {} points, {} luminaires\n", name, triangles, scene.points(),
               scene.scene.luminaires.size());
    require(scene.points() > 0 && scene.label.size() == scene.points(), name + " has no points");
    if (name == "office") {
      require(triangles == 840 && scene.points() == 1000, "the office is not the office");
      require(scene.scene.channels.size() == 2, "the office has no 2 light groups");
    }
    if (name == "office126") require(scene.points() == 126, "a point stands in furniture");
    if (name == "hall") require(triangles > 1000000, "the hall is too small");
  }
}

}  // namespace

void run_smoke(const Options& given) {
  check_scenes();
  Options options = given;
  options.min_paths = 64;
  options.max_paths = 128;
  options.replicates = 4;
  options.repeats = 1;
  options.threads = {1};
  options.reference_paths = 64;
  options.reference_replicates = 4;
  options.most_size = 100;
  options.names = {"room"};
  run_converge(options);
  run_accuracy(options);
  run_ratios(options);
  options.names = {"washers"};
  run_near(options);
  options.names = {"2"};
  run_coverage(options);
  run_sparse(options);
  options.names = {"luminaires"};
  run_scaling(options);
  run_files(options);
}

}  // namespace bench
