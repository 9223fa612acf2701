#pragma once
// One calculation by two gatherers, value by value.

#include "calc/radiosity/looks/solve.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test_support {

// Of the calling thread.
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct TimedGatherer : calc::Gatherer {
  explicit TimedGatherer(calc::Gatherer& inner) : inner_(inner) {}
  std::uint64_t gather(const calc::GatherBatch& batch, const calc::GatherSums& sums) override {
    const double processor_begin = processor_seconds();
    const auto begin = std::chrono::steady_clock::now();
    const std::uint64_t rays = inner_.gather(batch, sums);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    processor_s += processor_seconds() - processor_begin;
    connections += batch.connections.size();
    return rays;
  }
  std::uint64_t draw_and_gather(const calc::DrawBatch& batch) override {
    const double processor_begin = processor_seconds();
    const auto begin = std::chrono::steady_clock::now();
    const std::uint64_t rays = inner_.draw_and_gather(batch);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    processor_s += processor_seconds() - processor_begin;
    for (std::size_t t = 0; t < batch.sums.size(); ++t) {
      connections += batch.draws * batch.group(t).receiver.size();
    }
    return rays;
  }
  std::size_t tiles_per_batch(const calc::TileWork& work) const override {
    return inner_.tiles_per_batch(work);
  }
  std::string description() const override { return inner_.description(); }

  calc::Gatherer& inner_;
  double seconds = 0.0, processor_s = 0.0;  // valid with one thread
  std::size_t connections = 0;
};

inline std::vector<calc::PlaneField> solve_with(const calc::PreparedScene& scene,
                                                const std::vector<calc::PlaneTask>& tasks,
                                                calc::RadiositySettings settings,
                                                const calc::Stages& stages) {
  return calc::solve_illuminance(
             scene, tasks, settings, 0.95, stages,
             [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; },
             {})
      .fields;
}

// Of all values of all planes: indirect light of a replicate and channel at a point. A value whose
// difference is more than rounding can explain has a ray that one of the two let pass: a grazing
// ray.
struct SameSum {
  static constexpr double kRounding = 1e-5;

  std::size_t values = 0, grazed = 0;
  double largest = 0.0, largest_grazed = 0.0;  // relative difference without and with them
  double sum_a_lx = 0.0, sum_b_lx = 0.0;

  double mean_difference() const {
    return sum_a_lx > 0.0 ? std::abs(sum_b_lx - sum_a_lx) / sum_a_lx : 0.0;
  }
};

inline SameSum compare_sums(const std::vector<calc::PlaneField>& a,
                            const std::vector<calc::PlaneField>& b) {
  SameSum result;
  for (std::size_t p = 0; p < a.size(); ++p) {
    for (std::size_t k = 0; k < a[p].indirect_lx.size(); ++k) {
      const double x = a[p].indirect_lx[k], y = b[p].indirect_lx.at(k);
      ++result.values;
      result.sum_a_lx += x;
      result.sum_b_lx += y;
      const double difference = x == y ? 0.0 : std::abs(x - y) / std::max(x, y);
      result.largest_grazed = std::max(result.largest_grazed, difference);
      if (difference > SameSum::kRounding) {
        ++result.grazed;
      } else {
        result.largest = std::max(result.largest, difference);
      }
    }
  }
  return result;
}

}  // namespace test_support
