#pragma once
// Runs of the calculation core, what is known about their truth, and how far off they are.

#include "calc/radiosity/looks/solve.h"
#include "tests/bench/room_model.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

// What the command line says.
struct Options {
  std::string experiment;
  std::vector<std::string> names;     // words after the experiment
  std::string reference_file;         // "" = compute it every time
  std::string reference_by = "pool";  // or "paths": path tracing from the points, independent
  std::uint64_t reference_paths = 65536;
  int reference_replicates = 64;  // 4 to 64
  std::uint64_t min_paths = 256, max_paths = 32768;
  int replicates = 16;
  std::uint64_t seed = 1;
  std::vector<int> threads{1, 2};
  int repeats = 3;    // the best time of so many
  int most_size = 0;  // scaling: leave out sizes beyond; 0 = none
};

// One look of a fixed number of paths per replicate.
struct RunPlan {
  calc::Method method = calc::Method::light_pool;
  std::uint64_t paths = 1024;
  int replicates = 16;
  std::uint64_t seed = 1;
  int jobs = 0;
  double clamp_per_m2 = 0.0;  // 0 = none; only where has_clamp()
};

// Whether the core's settings offer a clamp of the geometry term.
bool has_clamp();

struct Run {
  calc::PlaneField field;
  calc::FluxBalance balance;
  calc::SolveTimes times;
  double seconds = 0.0;  // of solve_illuminance and all points' intervals
  std::uint64_t pool_rays = 0;

  // Of one replicate, luminaires' own shadow rays left out.
  double rays_per_replicate() const;
  double rays_per_point() const { return rays_per_replicate() / static_cast<double>(field.points); }
};

// Throws std::runtime_error if the core refuses.
Run run_core(const BenchScene& scene, const RunPlan& plan);
// The fastest of `repeats` runs with seeds plan.seed, plan.seed + 1, ...; into `all`, if given,
// goes every one of them.
Run best_of(const BenchScene& scene, RunPlan plan, int repeats, std::vector<Run>* all = nullptr);

// All channels at full output, [point].
struct Truth {
  std::vector<double> direct_lx, indirect_lx;
  std::vector<double> error_lx;  // standard error of the indirect part
};
// Read from options.reference_file if it is there, else computed with other seeds and added to the
// file.
Truth find_truth(const BenchScene& scene, const Options& options);
// Relative, RMS over points: what the truth itself may be off by.
double truth_error(const Truth& truth);

// Sums over channels: [replicate][point].
std::vector<std::vector<double>> indirect_replicates(const calc::PlaneField& field);
std::vector<double> mean_over_replicates(const std::vector<std::vector<double>>& replicates);
double average(const std::vector<double>& values);

// Relative errors. Points that get (next to) nothing are left out.
struct Errors {
  double replicate = 0.0;          // of one replicate's indirect part, RMS over points, replicates
  double mean = 0.0;               // of the mean of all replicates, the same
  double total = 0.0;              // of the mean, relative to the total illuminance
  double replicate_average = 0.0;  // of one replicate's indirect plane average, RMS
  double mean_average = 0.0;       // of the mean's
};
Errors errors_of(const calc::PlaneField& field, const Truth& truth);

// Slope of log y over log x, least squares; NaN below two points.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);
// y at x, log-log: between neighbours where x lies between, else along the fitted slope, up to a
// factor 3; NaN farther off.
struct Looked {
  double y = 0.0;
  bool is_extrapolated = false;
};
Looked look_up(const std::vector<double>& x, const std::vector<double>& y, double at);

}  // namespace bench
