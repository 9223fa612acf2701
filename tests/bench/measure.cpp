#include "tests/bench/measure.h"

#include "calc/base/statistics.h"
#include "calc/radiosity/sampling/phase_timer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bench {
namespace {

// The settings may or may not have the member; templates, so that both compile.
template <typename Settings>
constexpr bool settings_have_clamp() {
  return requires(Settings settings) { settings.clamp_per_m2 = 1.0; };
}

template <typename Settings>
void set_clamp(Settings& settings, double clamp_per_m2) {
  if constexpr (settings_have_clamp<Settings>()) {
    if (clamp_per_m2 > 0.0) settings.clamp_per_m2 = clamp_per_m2;
  }
}

// An interval for every point, as a report would have.
double interval_widths(const calc::PlaneField& field) {
  const auto replicates = indirect_replicates(field);
  std::vector<double> values(replicates.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < field.points; ++i) {
    for (std::size_t r = 0; r < replicates.size(); ++r) values[r] = replicates[r][i];
    sum += calc::t_interval(values, 0.95).half_width();
  }
  return sum;
}

double square(double x) { return x * x; }

constexpr double kFarthest = 3.0;  // extrapolations beyond this factor mean nothing

}  // namespace

bool has_clamp() { return settings_have_clamp<calc::RadiositySettings>(); }

double Run::rays_per_replicate() const {
  return static_cast<double>(pool_rays + field.counters.connection_rays +
                             field.counters.near_rays) /
         static_cast<double>(field.replicates);
}

Run run_core(const BenchScene& scene, const RunPlan& plan) {
  calc::RadiositySettings settings;
  settings.method = plan.method;
  settings.first_paths = settings.max_paths = plan.paths;
  settings.replicates = plan.replicates;
  settings.seed = plan.seed;
  settings.jobs = plan.jobs;
  set_clamp(settings, plan.clamp_per_m2);
  if (const std::string problem = calc::validate(settings); !problem.empty()) {
    throw std::runtime_error(problem);
  }
  const auto gatherer = calc::make_cpu_gatherer();
  const double begin_s = calc::now_s();
  calc::SpaceSolution solution = calc::solve_illuminance(
      scene.scene, {{"plane", &scene.grid}}, settings, 0.95, *gatherer,
      [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; }, {});
  calc::PlaneField& field = solution.fields.front();
  if (!field.problem.empty()) {
    throw std::runtime_error(fmt::format("{}: {}", scene.name, field.problem.english()));
  }
  if (field.is_exact() || !std::isfinite(interval_widths(field))) {
    throw std::runtime_error(fmt::format("{}: no finite indirect light", scene.name));
  }
  Run run;
  run.seconds = calc::now_s() - begin_s;
  run.field = std::move(field);
  run.balance = solution.balance;
  run.times = solution.times;
  run.pool_rays = solution.pool_rays;
  return run;
}

Run best_of(const BenchScene& scene, RunPlan plan, int repeats, std::vector<Run>* all) {
  Run best;
  for (int k = 0; k < std::max(1, repeats); ++k, ++plan.seed) {
    Run run = run_core(scene, plan);
    if (all != nullptr) all->push_back(run);
    if (k == 0 || run.seconds < best.seconds) best = std::move(run);
  }
  return best;
}

std::vector<std::vector<double>> indirect_replicates(const calc::PlaneField& field) {
  const std::size_t channels = field.channels.size();
  std::vector<std::vector<double>> sums(field.replicates, std::vector<double>(field.points, 0.0));
  for (std::size_t r = 0; r < field.replicates; ++r) {
    for (std::size_t c = 0; c < channels; ++c) {
      for (std::size_t i = 0; i < field.points; ++i) {
        sums[r][i] += field.indirect_lx[(r * channels + c) * field.points + i];
      }
    }
  }
  return sums;
}

std::vector<double> mean_over_replicates(const std::vector<std::vector<double>>& replicates) {
  std::vector<double> mean(replicates.front().size(), 0.0);
  for (const auto& replicate : replicates) {
    for (std::size_t i = 0; i < mean.size(); ++i) {
      mean[i] += replicate[i] / static_cast<double>(replicates.size());
    }
  }
  return mean;
}

double average(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

Errors errors_of(const calc::PlaneField& field, const Truth& truth) {
  const auto replicates = indirect_replicates(field);
  const std::vector<double> mean = mean_over_replicates(replicates);
  const double truth_average = average(truth.indirect_lx);
  Errors errors;
  double points = 0.0;
  for (std::size_t i = 0; i < field.points; ++i) {
    const double indirect = truth.indirect_lx[i];
    if (indirect < 1e-6 * truth_average) continue;
    points += 1.0;
    for (const auto& replicate : replicates) {
      errors.replicate +=
          square(replicate[i] / indirect - 1.0) / static_cast<double>(replicates.size());
    }
    errors.mean += square(mean[i] / indirect - 1.0);
    errors.total += square((mean[i] - indirect) / (truth.direct_lx[i] + indirect));
  }
  errors.replicate = std::sqrt(errors.replicate / points);
  errors.mean = std::sqrt(errors.mean / points);
  errors.total = std::sqrt(errors.total / points);
  for (const auto& replicate : replicates) {
    errors.replicate_average +=
        square(average(replicate) / truth_average - 1.0) / static_cast<double>(replicates.size());
  }
  errors.replicate_average = std::sqrt(errors.replicate_average);
  errors.mean_average = std::abs(average(mean) / truth_average - 1.0);
  return errors;
}

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  double mean_x = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / static_cast<double>(x.size());
    mean_y += std::log(y[i]) / static_cast<double>(x.size());
  }
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += square(std::log(x[i]) - mean_x);
    xy += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
  }
  return xy / xx;
}

Looked look_up(const std::vector<double>& x, const std::vector<double>& y, double at) {
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i + 1 < x.size() && (x[i] - at) * (x[i + 1] - at) <= 0.0 && x[i] != x[i + 1]) {
      const double share = std::log(at / x[i]) / std::log(x[i + 1] / x[i]);
      return {y[i] * std::pow(y[i + 1] / y[i], share), false};
    }
    if (std::abs(std::log(x[i] / at)) < std::abs(std::log(x[nearest] / at))) nearest = i;
  }
  if (std::abs(std::log(x[nearest] / at)) > std::log(kFarthest)) {
    return {std::numeric_limits<double>::quiet_NaN(), true};
  }
  return {y[nearest] * std::pow(at / x[nearest], fitted_exponent(x, y)), true};
}

}  // namespace bench
