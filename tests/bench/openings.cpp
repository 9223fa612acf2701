// Points near luminous openings, against closed forms: error and sub-sources by distance.
#include "calc/base/statistics.h"
#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/sampling/low_discrepancy.h"
#include "tests/bench/experiments.h"
#include "tests/bench/table.h"
#include "tests/support/scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace bench {
namespace {

using calc::kPi;
using calc::LuminousOpening;
using calc::OpeningShape;

// A source of unit size below whose middle the receiver faces up, and what it gives there.
struct Source {
  const char* name;
  LuminousOpening opening;
  bool is_sphere;
  std::function<double(double distance_m)> lx;  // luminance or intensity per length of 1
};

double square_lx(double h) {  // four corner rectangles  [Howell, B-3]
  const double x = 0.5 / h, r = std::sqrt(1.0 + x * x);
  return kPi * 4.0 * 2.0 * x / r * std::atan(x / r) / (2.0 * kPi);
}
double disk_lx(double h) { return kPi * 0.25 / (0.25 + h * h); }
double line_lx(double h) {
  const double x = 0.5;
  return 2.0 * (x / (2.0 * (x * x + h * h)) + std::atan(x / h) / (2.0 * h));
}
// Of a sphere the distance counts from its surface; it is a point at its centre.
double sphere_lx(double h) { return kPi * 0.25 / ((h + 0.5) * (h + 0.5)); }

std::vector<Source> sources() {
  return {{"square", {OpeningShape::rectangle, 1.0, 1.0, 0.0}, false, square_lx},
          {"disk", {OpeningShape::disk, 1.0, 1.0, 0.0}, false, disk_lx},
          {"line", {OpeningShape::rectangle, 1.0, 0.0, 0.0}, false, line_lx},
          {"sphere", {OpeningShape::ellipsoid, 1.0, 1.0, 1.0}, true, sphere_lx}};
}

calc::PhotometricWeb web_of(const Source& source) {
  if (source.is_sphere) {
    const double cd = kPi * 0.25;
    return calc::PhotometricWeb::make({0.0}, {0.0, kPi}, {cd, cd}, source.opening, {});
  }
  const bool is_disk = source.opening.shape == OpeningShape::disk;
  return test_support::lambert_web(is_disk ? kPi * 0.25 : 1.0, 3600, source.opening);
}

struct Result {
  double error = 0.0, of_mean = 0.0, undivided = 0.0, sources = 0.0;
};

Result measure(const Source& source, double distance_m, std::uint64_t seed) {
  constexpr int kReplicates = 64;
  const calc::PhotometricWeb web = web_of(source);
  calc::PreparedScene scene;
  const double centre_m = distance_m + (source.is_sphere ? 0.5 : 0.0);
  test_support::add_luminaire(scene, web, {0, 0, centre_m});
  scene.extent_m = 10.0;
  const calc::Tracer tracer(scene);
  const calc::Receiver receiver{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
  Result result;
  for (const calc::OpeningCell& cell : calc::opening_cells(scene.luminaires[0], {0, 0, 0})) {
    result.sources += cell.samples;
  }
  const double truth = source.lx(distance_m);
  std::vector<double> values;
  for (std::uint64_t r = 0; r < kReplicates; ++r) {
    double sum = 0.0;
    const calc::RandomKey key = calc::stage_key(seed, calc::RandomStage::opening).with(r);
    calc::add_extended_sources(tracer, receiver, {}, key, 0, 1, &sum, 1);
    values.push_back(sum);
    result.error += std::pow(sum / truth - 1.0, 2) / kReplicates;
  }
  result.error = std::sqrt(result.error);
  result.of_mean = calc::t_interval(values, 0.95).value / truth - 1.0;
  result.undivided = web.intensity_cd(0.0, 0.0) / (centre_m * centre_m) / truth - 1.0;
  return result;
}

}  // namespace

void run_openings(const Options& options) {
  for (const Source& source : sources()) {
    Table table(
        fmt::format("{} of size 1, receiver parallel below its middle; % of the closed form",
                    source.name),
        {"distance", "sub-sources", "error of a replicate", "mean of 64", "one point instead"});
    for (const double distance : {0.01, 0.05, 0.2, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0}) {
      const Result r = measure(source, distance, options.seed);
      table.add({number(distance), count(r.sources), percent(r.error), percent(r.of_mean),
                 percent(r.undivided)});
    }
    table.print();
  }
}

}  // namespace bench
