#include "report/tools/converge/converge_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cli {
namespace {

constexpr double kConfidence = 0.95;

// Everything at one step: [seed], and per plane [seed].
struct StepRuns {
  std::vector<EstimatorRun> runs;
  std::vector<std::array<std::vector<double>, report::kConvergeMetrics>> errors;  // [plane]
  std::vector<report::ConvergeCoverage> coverage, average_coverage;               // [plane]
};

void add(report::ConvergeCoverage& sum, const report::ConvergeCoverage& more) {
  sum.held += more.held;
  sum.tried += more.tried;
}

// "" or why not.
std::string run_step(const ConvergeOptions& options, const EstimatorContext& context,
                     const Estimator& estimator, std::uint64_t paths,
                     const std::vector<report::ConvergeTruth>& truths, StepRuns& step) {
  step.errors.resize(truths.size());
  step.coverage.resize(truths.size());
  step.average_coverage.resize(truths.size());
  for (int s = 0; s < options.seeds; ++s) {
    EstimatorRun run = estimator(context, paths, options.seed + static_cast<std::uint64_t>(s));
    if (run.is_interrupted || !run.problem.empty()) {
      std::string problem = run.problem;
      step.runs.push_back(std::move(run));
      return problem;
    }
    for (std::size_t p = 0; p < truths.size(); ++p) {
      const auto replicates = replicates_of(run.fields[p], options.is_indirect);
      const auto errors = report::errors_of(report::truth_of(replicates).lx, truths[p]);
      for (std::size_t m = 0; m < errors.size(); ++m) step.errors[p][m].push_back(errors[m]);
      add(step.coverage[p], report::coverage_of(replicates, truths[p], kConfidence));
      add(step.average_coverage[p],
          report::average_coverage_of(replicates, truths[p], kConfidence));
    }
    run.fields.clear();
    step.runs.push_back(std::move(run));
  }
  return "";
}

template <class Get>
double median_of(const std::vector<EstimatorRun>& runs, Get get) {
  std::vector<double> values;
  for (const EstimatorRun& run : runs) values.push_back(static_cast<double>(get(run)));
  return report::median(values);
}

// Times of the fastest run: what else the machine does only ever adds to them.
report::ConvergeStep summarise(const std::vector<EstimatorRun>& runs, std::uint64_t paths,
                               std::size_t points) {
  const EstimatorRun& fastest = *std::min_element(
      runs.begin(), runs.end(),
      [](const EstimatorRun& a, const EstimatorRun& b) { return a.seconds < b.seconds; });
  const calc::SolveTimes& t = fastest.times;
  report::ConvergeStep step;
  step.paths = paths;
  step.seconds = fastest.seconds;
  step.phases = {t.build_s, t.direct_s, t.pool_s, t.maps_s, t.connect_s, t.near_s};
  step.light_rays = median_of(runs, [](const EstimatorRun& r) { return r.light_rays; });
  step.rays_per_point =
      median_of(runs, [](const EstimatorRun& r) { return r.rays; }) / static_cast<double>(points);
  return step;
}

void add_step(const StepRuns& step, const std::vector<report::ConvergeTruth>& truths,
              std::size_t method, std::vector<std::vector<report::ConvergeCurve>>& curves) {
  for (std::size_t p = 0; p < truths.size(); ++p) {
    report::ConvergeCurve& curve = curves[p][method];
    auto& errors = curve.errors.emplace_back();
    for (std::size_t m = 0; m < errors.size(); ++m) {
      errors[m] = report::pool_errors(report::kAllConvergeMetrics[m], step.errors[p][m], truths[p]);
    }
    curve.coverage.push_back(step.coverage[p]);
    curve.average_coverage.push_back(step.average_coverage[p]);
  }
}

// Slopes and times at equal error. Errors that drown in the reference's tell nothing about either.
void fit(const std::vector<report::ConvergeStep>& steps, report::ConvergeCurve& curve) {
  for (std::size_t m = 0; m < report::kConvergeMetrics; ++m) {
    std::vector<double> seconds, rays, errors;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      if (curve.errors[k][m].is_below) continue;
      seconds.push_back(steps[k].seconds);
      rays.push_back(steps[k].rays_per_point);
      errors.push_back(curve.errors[k][m].value);
    }
    curve.slopes[m] = {report::fitted_exponent(seconds, errors),
                       report::fitted_exponent(rays, errors)};
    if (m != 0) continue;
    for (std::size_t t = 0; t < curve.targets.size(); ++t) {
      curve.targets[t] = report::find_crossing(seconds, errors, report::kConvergeTargets[t]);
    }
  }
}

}  // namespace

std::vector<std::vector<double>> replicates_of(const calc::PlaneField& field, bool is_indirect) {
  std::vector<std::vector<double>> lx(field.replicates, std::vector<double>(field.points, 0.0));
  for (std::size_t r = 0; r < field.replicates; ++r) {
    for (std::size_t c = 0; c < field.channels.size(); ++c) {
      for (std::size_t i = 0; i < field.points; ++i) {
        lx[r][i] += field.indirect_at(r, c, i);
        if (is_indirect) continue;
        lx[r][i] += field.direct_exact_at(c, i);
        lx[r][i] += field.direct_sampled_at(r, c, i);
      }
    }
  }
  return lx;
}

Ladder climb(const ConvergeOptions& options, const EstimatorContext& context,
             const std::vector<report::ConvergeTruth>& truths,
             const std::function<void(const std::string&)>& announce) {
  Ladder ladder;
  ladder.curves.assign(truths.size(), std::vector<report::ConvergeCurve>(options.methods.size()));
  std::size_t points = 0;
  for (const report::ConvergeTruth& truth : truths) points += truth.lx.size();
  for (std::size_t m = 0; m < options.methods.size(); ++m) {
    const Estimator estimator = find_estimator(options.methods[m]);
    report::ConvergeMethod& method = ladder.methods.emplace_back();
    method.name = options.methods[m];
    method.title = estimator_title(method.name);
    for (std::uint64_t paths = options.min_paths; paths <= options.max_paths; paths *= 2) {
      announce(fmt::format("{}: {} paths, {} seeds", method.name, paths, options.seeds));
      StepRuns step;
      ladder.problem = run_step(options, context, estimator, paths, truths, step);
      ladder.is_interrupted = step.runs.back().is_interrupted;
      if (ladder.is_interrupted || !ladder.problem.empty()) return ladder;
      method.steps.push_back(summarise(step.runs, paths, points));
      add_step(step, truths, m, ladder.curves);
    }
    for (std::vector<report::ConvergeCurve>& plane : ladder.curves) fit(method.steps, plane[m]);
  }
  return ladder;
}

}  // namespace cli
