#pragma once
// The results that rules and report receive: illuminance per replicate, channel and point.

#include "calc/base/message.h"
#include "calc/base/names.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace calc {

// A value with its confidence interval at the level of the run (95 % by default); low <= value <=
// high. The unit is that of the field that holds it. low == high: exact (nothing was sampled).
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;

  double half_width() const { return 0.5 * (high - low); }
};

inline bool is_finite(const Estimate& estimate) {
  return std::isfinite(estimate.value) && std::isfinite(estimate.low) &&
         std::isfinite(estimate.high);
}

// Returns whether the estimate is "nothing measurable", which is less than every number. `high` is
// finite where something may be there all the same.
inline bool is_nothing(const Estimate& estimate) {
  return estimate.value == -std::numeric_limits<double>::infinity();
}

// Luminaires that share a dimming group and a maintenance factor: results are linear in both, so
// that every scene and state is a weighted sum over channels.
struct LightChannel {
  std::string group;
  double maintenance_factor = 1.0;
  // Whether some of its luminaires have an opening, so that direct light may be sampled; false: it
  // is exact.
  bool may_sample_direct = true;
};

// Why the work on a plane ended. exact: nothing was sampled; decided: every verdict is certain;
// accurate: every quantity has the required accuracy; endless_path: light is hardly absorbed, so
// that paths would not end; memory_limit: the next round's light vertices would not fit.
enum class StopReason {
  exact,
  decided,
  accurate,
  path_limit,
  time_limit,
  memory_limit,
  endless_path,
  interrupted
};

template <>
struct EnumNames<StopReason> {
  static constexpr EnumName<StopReason> list[] = {{StopReason::exact, "exact"},
                                                  {StopReason::decided, "decided"},
                                                  {StopReason::accurate, "accurate"},
                                                  {StopReason::path_limit, "path-limit"},
                                                  {StopReason::time_limit, "time-limit"},
                                                  {StopReason::memory_limit, "memory-limit"},
                                                  {StopReason::endless_path, "endless-path"},
                                                  {StopReason::interrupted, "interrupted"}};
};

// Counts of what was done for one plane; for reports and benchmarks.
struct SolveCounters {
  std::uint64_t paths = 0;            // light paths of all replicates together
  std::uint64_t direct_rays = 0;      // shadow rays towards luminaires
  std::uint64_t connection_rays = 0;  // shadow rays towards light vertices
  std::uint64_t near_rays = 0;        // rays of the near-field part, continuation included
  // Points that took part in each sampling round; the size is the number of rounds.
  std::vector<std::size_t> active_points;
};

// Why CIE 117 states no formula for a luminaire that an eye sees.
enum class GlareProblem {
  below_sight,  // something of it lies below the line of sight, where there is no position index
  too_large,    // what is seen of it, or may be, > 0.1 sr
  no_area       // no luminous area towards the eye: its luminance is unbounded
};
struct GlareDoubt {
  std::size_t point = 0, channel = 0;
  GlareProblem problem = GlareProblem::below_sight;
  double number = 0.0;                  // solid angle in sr of too_large
  std::array<double, 3> luminaire_m{};  // world
};
inline constexpr std::size_t kGlareProblems = 3;

// Glare from the luminaires at the eyes of a plane of DerivedQuantity::ugr, new and at full output;
// a dimmed channel counts by the square of its level. [channel][point], cd^2 sr / m^4; see
// calc/radiosity/direct/glare.h. low: without sources that have no position index or no area, with
// the milder rule for small sources, and with the least visible part of partly hidden openings;
// high: with all of these. `high` omits what a too large source may add: see `doubts`.
struct GlareField {
  std::vector<double> value, low, high;
  std::vector<GlareDoubt> doubts;  // of every problem one per point and channel at most
};

// Initial illuminance (new lamps, full output) at the points of one plane, on the side of their
// normals. E[replicate][channel][point] = direct_exact + direct_sampled + indirect; replicates are
// independent and identically distributed, each an unbiased estimate, but for is_cut_off.
struct PlaneField {
  std::string plane_id;
  Message problem;             // why the plane could not be computed; "" = it was
  std::size_t points = 0;      // of a derived quantity: receivers, [receiver of the point][point]
  std::size_t replicates = 0;  // >= 2; the sampled parts are empty when nothing was sampled
  std::vector<LightChannel> channels;
  // Only for DerivedQuantity::ugr, where all illuminance is of reflected light; else empty.
  GlareField glare;
  std::vector<double> direct_exact_lx;  // [channel][point]
  std::vector<double>
      direct_sampled_lx;  // [replicate][channel][point]; empty without extended luminaires
  std::vector<double> indirect_lx;  // [replicate][channel][point]; empty without reflection
  // The same two parts from only those rounds in which all points took part. Quantities over
  // several points, such as averages, use these: a mean of dark points that went on and bright
  // points that stopped early would be too large. Empty: every point took part in every round, and
  // both are equal.
  std::vector<double> even_direct_sampled_lx, even_indirect_lx;
  // [point]: 1 if sampled light may reach the point but no sample has: its 0 lx is then not a
  // measurement, and its interval of width 0 means nothing. Empty when nothing was sampled.
  std::vector<std::uint8_t> unseen;
  // [point]: the largest share that a single sample, drawn or possible, has in the point's
  // illuminance (all channels at full output), >= 0. Near 1 or above the value rests on one sample
  // and its t-interval is not to be trusted. Empty when nothing was sampled.
  std::vector<float> largest_share;
  // [point]: the mean over the replicates of what the largest single sample of reflected light,
  // drawn or possible, adds, lx (all channels at full output). If few or no such samples were
  // drawn, neither the mean nor the replicates' spread shows them. Empty without reflection.
  std::vector<double> largest_sample_lx;
  // [point]: its weight in averages, in any unit; empty: all alike. See point_weights().
  std::vector<double> point_weight;
  // Rounds that the plane might have taken, fixed before the first: its intervals hold over all of
  // them together. 1: only one was planned, or nothing was sampled.
  int looks_planned = 1;
  // Geometry terms were clamped (RadiositySettings::clamp_per_m2): reflected light is too low by an
  // unknown amount.
  bool is_cut_off = false;
  StopReason stop = StopReason::exact;
  SolveCounters counters;

  // Returns the number of the last round; 0 if it is the first, or none was taken.
  int last_look() const {
    return counters.active_points.empty() ? 0 : static_cast<int>(counters.active_points.size()) - 1;
  }
  bool is_exact() const { return direct_sampled_lx.empty() && indirect_lx.empty(); }

  // Return the parts at one point; 0 where a part is empty. Require replicate < replicates, channel
  // < channels.size(), point < points; not checked.
  double direct_exact_at(std::size_t channel, std::size_t point) const {
    return direct_exact_lx[channel * points + point];
  }
  double direct_sampled_at(std::size_t replicate, std::size_t channel, std::size_t point) const {
    return direct_sampled_lx.empty() ? 0.0 : direct_sampled_lx[index(replicate, channel, point)];
  }
  double indirect_at(std::size_t replicate, std::size_t channel, std::size_t point) const {
    return indirect_lx.empty() ? 0.0 : indirect_lx[index(replicate, channel, point)];
  }
  // Returns the sum of all parts and channels: new, at full output.
  double total_lx(std::size_t replicate, std::size_t point) const {
    double sum = 0.0;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      sum += direct_exact_at(c, point);
      sum += direct_sampled_at(replicate, c, point);
      sum += indirect_at(replicate, c, point);
    }
    return sum;
  }
  // Returns the estimate itself: the mean over all replicates.
  double mean_lx(std::size_t point) const {
    double sum = 0.0;
    for (std::size_t r = 0; r < replicates; ++r) sum += total_lx(r, point);
    return sum / static_cast<double>(replicates);
  }

 private:
  std::size_t index(std::size_t replicate, std::size_t channel, std::size_t point) const {
    return (replicate * channels.size() + channel) * points + point;
  }
};

// Light budget of one space, all luminaires at full output, new: emitted = untraced + absorbed +
// escaped up to sampling noise.
struct FluxBalance {
  double emitted_lm = 0.0;   // exact: integrals of the photometry
  double untraced_lm = 0.0;  // of it, from luminaires that light no reflecting surface
  Estimate absorbed_lm;      // by surfaces
  Estimate escaped_lm;       // left an open model; 0 in a closed room
};

}  // namespace calc
