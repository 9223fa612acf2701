// How often is a verdict wrong, if a plane is looked at up to six times and stops as soon as it is
// decided? Synthetic replicates with known means, sample sizes that double, points left out as the
// rule says. Generator and seed are fixed, so that a result does not change from run to run.

#include "rules/verdict/stop_rule.h"

#include "calc/base/statistics.h"
#include "calc/radiosity/gather/plane_state.h"
#include "rules/measure/error_spending.h"
#include "rules/verdict/judge.h"
#include "tests/support/normal_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rules::stop_rule_test {
namespace {

constexpr std::size_t kPoints = 12;
constexpr std::size_t kReplicates = 16;
constexpr int kLooks = 6;
constexpr int kPlanes = 1000;
constexpr double kConfidence = 0.95;

// Four points in a near-tie at the minimum.
std::vector<double> true_values_lx() {
  std::vector<double> values(kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double x = static_cast<double>(i);
    values[i] = i < 4 ? 300.0 + 0.2 * x : 320.0 + 10.0 * (x - 4.0);
  }
  return values;
}

double truth_of(Metric metric) {
  return compute_metric(PointValues{kPoints, 1, true_values_lx()}, metric, 0.0, std::nullopt, 0.95)
      ->estimate.value;
}

// Relative errors of the means of every look's new samples alone: at each point its own and one
// that all points of a replicate share.
struct Noise {
  explicit Noise(std::uint64_t seed, double of_points = 0.06, double of_all = 0.02) {
    NormalNumbers normal(seed);
    for (int look = 0; look < kLooks; ++look) {
      const double scale = 1.0 / std::sqrt(static_cast<double>(new_samples(look)));
      for (std::size_t r = 0; r < kReplicates; ++r) {
        const double shared = of_all * normal.next();
        for (std::size_t i = 0; i < kPoints; ++i) {
          error[look].push_back(scale * (shared + of_points * normal.next()));
        }
      }
    }
  }

  static std::uint64_t new_samples(int look) {
    return look == 0 ? 1 : std::uint64_t{1} << (look - 1);
  }

  std::array<std::vector<double>, kLooks> error;
};

std::vector<Noise> make_noise() {
  std::vector<Noise> noise;
  for (int plane = 0; plane < kPlanes; ++plane)
    noise.emplace_back(static_cast<std::uint64_t>(plane));
  return noise;
}

const std::vector<Noise>& noise_of_planes() {
  static const std::vector<Noise> kNoise = make_noise();
  return kNoise;
}

calc::SensorGrid grid_of_points() {
  calc::SensorGrid grid;
  for (std::size_t i = 0; i < kPoints; ++i) {
    grid.position_m.emplace_back(static_cast<double>(i), 0.0, 0.0);
  }
  return grid;
}

// Looks as the calculation adds them up, with samples that are made up.
class GrowingField {
 public:
  explicit GrowingField(int looks_planned, std::vector<double> truth_lx = true_values_lx())
      : looks_planned_(looks_planned),
        truth_lx_(std::move(truth_lx)),
        state_("plane", grid_of_points(), {{"", 1.0}}, kReplicates) {
    calc::PlaneSums& sums = state_.sums();
    sums.may_be_sampled.assign(kPoints, 1);
    sums.indirect_sum_lx.assign(kReplicates * kPoints, 0.0);
    sums.largest_sum_lx.assign(kReplicates * kPoints, 0.0f);
  }

  void add(const std::vector<double>& error, std::uint64_t samples,
           const std::vector<std::uint8_t>& active) {
    state_.narrow(active);
    calc::PlaneSums& sums = state_.sums();
    for (std::size_t i = 0; i < kPoints; ++i) {
      if (state_.active()[i] == 0) continue;
      sums.paths[i] += samples;
      for (std::size_t r = 0; r < kReplicates; ++r) {
        sums.indirect_sum_lx[r * kPoints + i] +=
            static_cast<double>(samples) * truth_lx_[i] * (1.0 + error[r * kPoints + i]);
      }
    }
    state_.publish(looks_planned_);
  }

  const calc::PlaneField& field() const { return state_.field(); }

 private:
  int looks_planned_;
  std::vector<double> truth_lx_;
  calc::PlaneState state_;
};

struct Outcome {
  std::vector<Finding> findings;  // one per requirement
  int looks = 0;
};

Outcome run_plane(const std::vector<Requirement>& requirements, const Noise& noise,
                  int looks_planned) {
  static const calc::SensorGrid kGrid = grid_of_points();
  const StopRule rule{Goal::verdict, 0.02, kConfidence};
  GrowingField growing(looks_planned);
  LookJudgement answer;
  Outcome outcome;
  while (outcome.looks < kLooks && !answer.finished) {
    growing.add(noise.error[outcome.looks], Noise::new_samples(outcome.looks), answer.active);
    ++outcome.looks;
    answer = judge_look(rule, requirements, kGrid, growing.field(), {});
  }
  outcome.findings = judge_plane(requirements, kGrid, growing.field(), {}, kConfidence);
  return outcome;
}

// The limit lies `offset` (relative) above the truth: > 0 fails in truth.
Requirement off_by(Metric metric, double offset) {
  Requirement requirement;
  requirement.metric = metric;
  requirement.limit = truth_of(metric) * (1.0 + offset);
  return requirement;
}

struct Counts {
  int wrong = 0;
  int undecided = 0;
  std::array<int, kLooks> open_after{};  // planes not finished after each look
};

Counts count(const std::vector<Requirement>& requirements, double offset,
             int looks_planned = kLooks) {
  Counts counts;
  const Verdict wrong = offset > 0.0 ? Verdict::pass : Verdict::fail;
  for (const Noise& noise : noise_of_planes()) {
    const Outcome outcome = run_plane(requirements, noise, looks_planned);
    bool is_wrong = false, is_undecided = false;
    for (const Finding& finding : outcome.findings) {
      is_wrong = is_wrong || finding.verdict == wrong;
      is_undecided = is_undecided || finding.verdict == Verdict::undecided;
    }
    counts.wrong += is_wrong ? 1 : 0;
    counts.undecided += is_undecided ? 1 : 0;
    const int open = is_undecided ? kLooks : outcome.looks - 1;
    for (int look = 0; look < open; ++look) ++counts.open_after[look];
  }
  return counts;
}

constexpr double kMostWrong = (1.0 - kConfidence) * kPlanes;

class WrongVerdicts : public ::testing::TestWithParam<Metric> {};

// Measured, wrong of 1000 where 50 are allowed, limits just above and below the truth: average 20
// and 16, minimum 0 and 8, Uo 0 and 9; none at 1 % and more. Undecided after six looks: at 1 %
// average 0, minimum 336 and 562, Uo 446 and 725; at 2 % 0, 0, Uo 37 and 82; none at 5 %.
TEST_P(WrongVerdicts, AreRarerThanTheRiskAtAnyDistanceFromTheLimit) {
  for (const double offset : {0.0001, 0.01, 0.02, 0.05, -0.0001, -0.01, -0.02, -0.05}) {
    const Counts counts = count({off_by(GetParam(), offset)}, offset);
    EXPECT_LE(counts.wrong, kMostWrong) << offset;
    if (std::abs(offset) >= 0.01) {
      EXPECT_EQ(counts.wrong, 0) << offset;
    }
    const std::string name = std::string(calc::name_of(GetParam())) + std::to_string(offset);
    RecordProperty(name, std::to_string(counts.wrong) + " wrong, " +
                             std::to_string(counts.undecided) + " undecided");
  }
}

INSTANTIATE_TEST_SUITE_P(Quantities, WrongVerdicts,
                         ::testing::Values(Metric::average, Metric::minimum,
                                           Metric::uniformity_min_avg),
                         [](const auto& tested) {
                           return std::string(calc::name_of(tested.param));
                         });

// What the share of the risk per look is for: the limit is next to the truth, and a look that
// spends the whole risk comes six times. Measured: 22 wrong of 1000, and 106.
TEST(WrongVerdictsOfTheAverage, ExceedTheRiskOfOneSideIfEveryLookSpendsItWhole) {
  const double kMostWrongOfOneSide = kMostWrong / 2.0;
  const int spent = count({off_by(Metric::average, 1e-6)}, 1e-6).wrong;
  const int not_spent = count({off_by(Metric::average, 1e-6)}, 1e-6, 1).wrong;
  EXPECT_LE(spent, kMostWrongOfOneSide);
  EXPECT_GT(not_spent, kMostWrong);
}

// Points are left out for the minimum and Uo while the average is judged, too.
TEST(WrongVerdictsOfAPlane, AreRareWhereSeveralQuantitiesShareTheSamples) {
  for (const double offset : {0.005, -0.005}) {
    const Counts counts = count({off_by(Metric::average, offset), off_by(Metric::minimum, offset),
                                 off_by(Metric::uniformity_min_avg, offset)},
                                offset);
    EXPECT_LE(counts.wrong, kMostWrong) << offset;
  }
}

// Where all points are alike and their noise is their own, those that go on for the uniformity are
// those that were dark by chance. They get brighter; those that were bright by chance stay so. The
// average may not be of both. Measured: 0.3 % below, and 10 of
// 1000 intervals miss; of all looks 1.7 % above, and 154 miss.
TEST(TheAverageBesideAnOpenUniformity, IsOfTheLooksInWhichAllPointsTookPart) {
  const std::vector<double> truth_lx(kPoints, 300.0);
  Requirement average, uniformity;
  average.metric = Metric::average;
  average.limit = 150.0;
  uniformity.metric = Metric::uniformity_min_avg;
  uniformity.limit = 0.9;
  const calc::SensorGrid grid = grid_of_points();
  std::vector<double> averages;
  int missed = 0, failed = 0, narrowed = 0;
  for (int plane = 0; plane < kPlanes; ++plane) {
    const Noise noise(static_cast<std::uint64_t>(plane), 0.3, 0.0);
    GrowingField growing(kLooks, truth_lx);
    LookJudgement answer;
    for (int look = 0; look < kLooks && !answer.finished; ++look) {
      growing.add(noise.error[look], Noise::new_samples(look), answer.active);
      answer = judge_look({Goal::verdict, 0.02, kConfidence}, {average, uniformity}, grid,
                          growing.field(), {});
    }
    narrowed += growing.field().even_indirect_lx.empty() ? 0 : 1;
    const std::vector<Finding> found =
        judge_plane({average, uniformity}, grid, growing.field(), {}, kConfidence);
    averages.push_back(found[0].measured.value);
    missed += found[0].measured.low > 300.0 || found[0].measured.high < 300.0 ? 1 : 0;
    failed += found[1].verdict == Verdict::fail ? 1 : 0;
  }
  const calc::ReplicateMean mean = calc::replicate_mean(averages);
  RecordProperty("average", std::to_string(mean.mean));
  RecordProperty("missed", missed);
  EXPECT_GT(narrowed, kPlanes / 2);
  EXPECT_NEAR(mean.mean, 300.0, 0.005 * 300.0);  // it ends sooner where the average is low
  EXPECT_LE(missed, kMostWrong);
  EXPECT_EQ(failed, 0);
}

// With the limit 2 % off. Planes not finished after each look: average 421, 127, 2, 0; minimum
// 999, 997, 962, 647, 78, 0; Uo 1000, 999, 970, 812, 364, 82.
TEST(Undecided, ShrinksWithTheLooks) {
  for (const Metric metric : {Metric::average, Metric::minimum, Metric::uniformity_min_avg}) {
    const Counts counts = count({off_by(metric, -0.02)}, -0.02);
    EXPECT_GT(counts.open_after.front(), kPlanes / 4) << calc::name_of(metric);
    EXPECT_LT(counts.open_after[4], counts.open_after[1]) << calc::name_of(metric);
    EXPECT_LT(counts.open_after.back(), kPlanes / 10) << calc::name_of(metric);
  }
}

// The smallest of noisy means is low; the interval that is judged covers the truth nevertheless.
// Measured bias and half-width: -1.4 % and 5.3 % after one look, -0.7 % and 2.8 % after three, -0.2
// % and 1.0 % after six.
TEST(PlugInMinimum, IsBiasedLowByLessThanItsInterval) {
  const double truth_lx = truth_of(Metric::minimum);
  double previous_bias = 1.0;
  for (const int looks : {1, 3, 6}) {
    double bias = 0.0, half_width = 0.0;
    int missed = 0;
    for (const Noise& noise : noise_of_planes()) {
      GrowingField growing(kLooks);
      for (int look = 0; look < looks; ++look) {
        growing.add(noise.error[look], Noise::new_samples(look), {});
      }
      const calc::Estimate minimum =
          compute_metric(combine_channels(growing.field(), LightState::initial, {}),
                         Metric::minimum, 0.0, std::nullopt,
                         look_confidence(kConfidence, growing.field()))
              ->estimate;
      bias += (minimum.value / truth_lx - 1.0) / kPlanes;
      half_width += minimum.half_width() / truth_lx / kPlanes;
      if (minimum.low > truth_lx || minimum.high < truth_lx) ++missed;
    }
    const std::string after = "_after_" + std::to_string(looks);
    RecordProperty("bias" + after, std::to_string(bias));
    RecordProperty("half_width" + after, std::to_string(half_width));
    EXPECT_LT(bias, 0.0);
    EXPECT_LT(-bias, half_width / 2.0);
    EXPECT_LT(-bias, previous_bias);
    EXPECT_LE(missed, kMostWrong / kLooks + 10);
    previous_bias = -bias;
  }
}

}  // namespace
}  // namespace rules::stop_rule_test
