// The truth of a scene: a long run with other seeds, or path tracing from the points.
#include "tests/bench/measure.h"
#include "tests/bench/path_tracing.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace bench {
namespace {

constexpr std::uint64_t kSeed = 0x7275746800000000u;  // far from the seeds of runs

// Two truths are one only if scene and effort are; a sum over everything tells scenes apart.
std::string key_of(const BenchScene& scene, const Options& options) {
  double sum = 0.0;
  for (const glm::dvec3& p : scene.grid.position_m) sum = 0.7 * sum + p.x + 2.0 * p.y + 3.0 * p.z;
  for (const double rho : scene.scene.reflectance) sum += rho;
  for (const calc::PlacedLuminaire& l : scene.scene.luminaires) {
    sum += l.web->flux_lm() * l.flux_scale + glm::dot(l.position_m, glm::dvec3(1.0, 2.0, 3.0));
  }
  std::string name = scene.name;
  for (char& c : name) c = c == ' ' ? '_' : c;
  return fmt::format("{} {} {} {} {} {} {:.9g}", name, scene.points(), scene.scene.triangle.size(),
                     options.reference_by, options.reference_paths, options.reference_replicates,
                     sum);
}

std::optional<Truth> read_truth(const std::string& file_name, const std::string& key,
                                std::size_t points) {
  std::ifstream file(file_name);
  for (std::string line; std::getline(file, line);) {
    if (line != "truth " + key) continue;
    Truth truth;
    for (std::size_t i = 0; i < points; ++i) {
      double direct = 0.0, indirect = 0.0, error = 0.0;
      if (!(file >> direct >> indirect >> error)) {
        throw std::runtime_error(fmt::format("'{}' ends within '{}'", file_name, key));
      }
      truth.direct_lx.push_back(direct);
      truth.indirect_lx.push_back(indirect);
      truth.error_lx.push_back(error);
    }
    return truth;
  }
  return std::nullopt;
}

void append_truth(const std::string& file_name, const std::string& key, const Truth& truth) {
  std::ofstream file(file_name, std::ios::app);
  file << "truth " << key << '\n';
  for (std::size_t i = 0; i < truth.direct_lx.size(); ++i) {
    file << fmt::format("{:.12g} {:.12g} {:.6g}\n", truth.direct_lx[i], truth.indirect_lx[i],
                        truth.error_lx[i]);
  }
  file.close();
  if (!file) throw std::runtime_error(fmt::format("cannot write '{}'", file_name));
}

Truth compute_truth(const BenchScene& scene, const Options& options) {
  RunPlan plan;
  plan.paths = options.reference_paths;
  plan.replicates = options.reference_replicates;
  plan.seed = kSeed + options.seed;
  const bool by_paths = options.reference_by == "paths";
  if (by_paths) plan.paths = 256;  // for the direct part only
  const Run run = run_core(scene, plan);
  const std::size_t points = scene.points();
  Truth truth;
  truth.direct_lx.assign(points, 0.0);
  for (std::size_t k = 0; k < run.field.direct_exact_lx.size(); ++k) {
    truth.direct_lx[k % points] += run.field.direct_exact_lx[k];
  }
  const auto replicates = by_paths ? trace_from_points(scene, options.reference_paths,
                                                       options.reference_replicates, plan.seed)
                                   : indirect_replicates(run.field);
  truth.indirect_lx = mean_over_replicates(replicates);
  const auto count = static_cast<double>(replicates.size());
  for (std::size_t i = 0; i < points; ++i) {
    double squares = 0.0;
    for (const auto& replicate : replicates) {
      squares += std::pow(replicate[i] - truth.indirect_lx[i], 2);
    }
    truth.error_lx.push_back(std::sqrt(squares / (count * (count - 1.0))));
  }
  return truth;
}

}  // namespace

Truth find_truth(const BenchScene& scene, const Options& options) {
  const std::string key = key_of(scene, options);
  if (options.reference_file.empty()) return compute_truth(scene, options);
  if (auto truth = read_truth(options.reference_file, key, scene.points())) return *truth;
  const Truth truth = compute_truth(scene, options);
  append_truth(options.reference_file, key, truth);
  return truth;
}

double truth_error(const Truth& truth) {
  const double mean = average(truth.indirect_lx);
  double squares = 0.0, points = 0.0;
  for (std::size_t i = 0; i < truth.indirect_lx.size(); ++i) {
    if (truth.indirect_lx[i] < 1e-6 * mean) continue;
    squares += std::pow(truth.error_lx[i] / truth.indirect_lx[i], 2);
    points += 1.0;
  }
  return std::sqrt(squares / points);
}

}  // namespace bench
