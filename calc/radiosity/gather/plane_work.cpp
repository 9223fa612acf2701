#include "calc/radiosity/gather/plane_work.h"

#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/direct/glare.h"
#include "calc/radiosity/direct/opening_light.h"
#include "calc/radiosity/direct/point_problem.h"
#include "calc/radiosity/sampling/grid_receivers.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "calc/radiosity/sampling/random.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <utility>

namespace calc {
namespace {

// Clear distances are found up to so many reaches of short rays: the largest possible sample falls
// with their square.
constexpr double kClearReaches = 4.0;
// Neighbours that share one proof that an opening is seen; where it fails each has its own.
constexpr std::size_t kPointsPerProof = 32;
// Of a DirectTracer: enough for a large device, and little beside what the plane itself takes.
constexpr std::size_t kPointsPerBatch = std::size_t{1} << 14;

// Runs work(i) -> rays for every point on all threads and returns the sum of rays.
template <class Work>
std::uint64_t for_each_point(std::size_t points, const Work& work) {
  std::atomic<std::uint64_t> rays{0};
  tbb::parallel_for(std::size_t{0}, points, [&](std::size_t i) {
    const FlushDenormals flush;
    rays += work(i);
  });
  return rays;
}

}  // namespace

PlaneWork::PlaneWork(const Tracer& tracer, const SensorGrid& grid, const PlaneDecision& decision,
                     const RadiositySettings& settings, PlaneState& state)
    : tracer_(tracer),
      settings_(settings),
      decision_(decision),
      state_(state),
      field_(state.field()),
      sums_(state.sums()),
      opening_key_(stage_key(settings.seed, RandomStage::opening).with(field_.plane_id)),
      near_key_(stage_key(settings.seed, RandomStage::near_field).with(field_.plane_id)),
      draw_key_(stage_key(settings.seed, RandomStage::connections).with(field_.plane_id)) {
  receiver_ = receivers_of(tracer, grid);
  spatial_order_ = spatial_order(receiver_);
  // A point's other receivers see nothing that the first one does not.
  for (std::size_t part = 0; part < receivers_per_point(grid.derived); ++part) {
    has_indirect_.insert(has_indirect_.end(), decision.may_see_reflection.begin(),
                         decision.may_see_reflection.end());
    gathers_reflection_.insert(gathers_reflection_.end(), decision.gathers_reflection.begin(),
                               decision.gathers_reflection.end());
  }
}

void PlaneWork::begin(const SensorGrid& grid) {
  sums_.may_be_sampled = has_indirect_;
  if (Message problem = point_problem(tracer_, grid, receiver_, settings_.refuses_close_points);
      !problem.empty()) {
    state_.refuse(std::move(problem));
  }
}

void PlaneWork::add_exact(DirectTracer* direct, double deadline_s, SolveTimes& times) {
  const PhaseTimer timer(times.direct_s);
  if (!decision_.measures_direct) return add_glare(deadline_s);
  if (channels() == 0) return;  // no luminaires, and so no values either
  if (direct != nullptr) {
    field_.counters.direct_rays += direct->add_point_sources(
        {tracer_, receiver_, {decision_.is_dark, has_shadows()}, deadline_s},
        field_.direct_exact_lx);
    return;
  }
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t i) {
    if (is_past(deadline_s)) return std::uint64_t{0};
    return add_point_sources(tracer_, receiver_[i], {decision_.is_dark, has_shadows()},
                             &field_.direct_exact_lx[i], points())
        .traced;
  });
}

void PlaneWork::add_glare(double deadline_s) {
  std::vector<GlareSum> sums(points() * channels());  // [point][channel]
  const std::vector<JoinedOpening> joined = joined_luminaires(tracer_.scene());
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t i) {
    if (is_past(deadline_s)) return std::uint64_t{0};
    return add_glare_sources(tracer_, receiver_[i], has_shadows(), joined,
                             std::span(sums).subspan(i * channels(), channels()));
  });
  GlareField& glare = field_.glare;
  for (std::size_t c = 0; c < channels(); ++c) {
    for (std::size_t i = 0; i < points(); ++i) {
      const GlareSum& sum = sums[i * channels() + c];
      glare.value.push_back(sum.value);
      glare.low.push_back(sum.low);
      glare.high.push_back(sum.high);
      for (const GlareDoubt& doubt : sum.doubts) {
        glare.doubts.push_back(doubt);
        glare.doubts.back().point = i;
      }
    }
  }
}

void PlaneWork::sample_openings(DirectTracer* direct, double deadline_s, SolveTimes& times) {
  if (!decision_.samples_openings) return;
  if (sums_.most_rounds > 0 && !state_.opening_error_matters()) return;
  const PhaseTimer timer(times.direct_s);
  sums_.direct_sum_lx.resize(state_.values());
  const std::uint32_t last = std::max<std::uint32_t>(1, 2 * sums_.most_rounds);
  if (direct != nullptr && !has_fine_beams()) {
    sample_openings_by(*direct, last, deadline_s);
  } else {
    sample_openings_by_points(last, deadline_s);
  }
  sums_.most_rounds = last;
}

// Devices take openings in the parts that wide beams want.
bool PlaneWork::has_fine_beams() {
  if (!has_fine_beams_) {
    has_fine_beams_ =
        calc::has_fine_beams(tracer_.scene(), {decision_.is_dark, has_shadows()}, receiver_);
  }
  return *has_fine_beams_;
}

void PlaneWork::sample_openings_by_points(std::uint32_t last_round, double deadline_s) {
  if (free_openings_.empty() && has_shadows()) prove_openings(deadline_s);
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t place) {
    const std::size_t i = spatial_order_[place];
    if (state_.active()[i] == 0 || is_past(deadline_s)) return std::uint64_t{0};
    DirectProofs proofs{decision_.is_dark, has_shadows()};
    if (has_shadows()) proofs.is_free = free_openings_[place / kPointsPerProof];
    const DirectRays direct = add_openings(
        tracer_, receiver_[i], proofs, opening_key_.with(i),
        {sums_.rounds[i], last_round, field_.replicates, settings_.opening_error_factor},
        {&field_.direct_exact_lx[i], &sums_.direct_sum_lx[i], points(), channels() * points(),
         &sums_.largest_opening_lx[i]});
    take_opening_rays(i, direct, last_round);
    return direct.traced;
  });
}

void PlaneWork::take_opening_rays(std::size_t point, const DirectRays& rays,
                                  std::uint32_t last_round) {
  if (rays.has_hidden) sums_.has_hidden_opening[point] = 1;
  if (rays.may_be_lit) sums_.may_be_sampled[point] = 1;
  if (rays.has_seen) sums_.has_seen_opening[point] = 1;
  sums_.rounds[point] = last_round;
}

void PlaneWork::sample_openings_by(DirectTracer& direct, std::uint32_t last_round,
                                   double deadline_s) {
  // Those at work are alike, but for what a store may hold.
  std::map<std::uint32_t, std::vector<std::size_t>> points_of_rounds;
  for (const std::uint32_t i : spatial_order_) {
    if (state_.active()[i] != 0) points_of_rounds[sums_.rounds[i]].push_back(i);
  }
  for (const auto& [first_round, chosen] : points_of_rounds) {
    const OpeningRounds rounds{first_round, last_round, field_.replicates,
                               settings_.opening_error_factor};
    const std::span<const std::size_t> all(chosen);
    for (std::size_t first = 0; first < all.size(); first += kPointsPerBatch) {
      if (is_past(deadline_s)) return;
      sample_batch(direct, all.subspan(first, std::min(kPointsPerBatch, all.size() - first)),
                   rounds, deadline_s);
    }
  }
}

void PlaneWork::sample_batch(DirectTracer& direct, std::span<const std::size_t> chosen,
                             const OpeningRounds& rounds, double deadline_s) {
  std::vector<Receiver> receivers;
  std::vector<RandomKey> keys;
  for (const std::size_t i : chosen) {
    receivers.push_back(receiver_[i]);
    keys.push_back(opening_key_.with(i));
  }
  const std::size_t n = chosen.size(), sums = field_.replicates * channels();
  std::vector<double> known(channels() * n), sampled(sums * n);
  std::vector<float> largest(n);
  std::vector<DirectRays> rays(n);
  direct.add_openings({tracer_, receivers, {decision_.is_dark, has_shadows()}, deadline_s}, keys,
                      rounds, {known, sampled, largest, rays});
  if (is_past(deadline_s)) return;  // some of it may be missing
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = chosen[k];
    for (std::size_t c = 0; c < channels(); ++c) {
      field_.direct_exact_lx[c * points() + i] += known[c * n + k];
    }
    for (std::size_t sum = 0; sum < sums; ++sum) {
      sums_.direct_sum_lx[sum * points() + i] += sampled[sum * n + k];
    }
    sums_.largest_opening_lx[i] = std::max(sums_.largest_opening_lx[i], largest[k]);
    take_opening_rays(i, rays[k], rounds.last);
    field_.counters.direct_rays += rays[k].traced;
  }
}

void PlaneWork::prove_openings(double deadline_s) {
  free_openings_.resize((points() + kPointsPerProof - 1) / kPointsPerProof);
  for_each_point(free_openings_.size(), [&](std::size_t group) {
    if (is_past(deadline_s)) return std::uint64_t{0};
    std::vector<Receiver> receivers;
    const std::size_t first = group * kPointsPerProof;
    for (std::size_t k = first; k < std::min(points(), first + kPointsPerProof); ++k) {
      receivers.push_back(receiver_[spatial_order_[k]]);
    }
    free_openings_[group] =
        find_free_openings(tracer_, receivers, {decision_.is_dark, has_shadows()});
    return std::uint64_t{0};
  });
}

void PlaneWork::start_look(double near_reach_m, const PossibleVertex& possible) {
  possible_vertex_ = possible;
  sums_.indirect_sum_lx.resize(state_.values());
  sums_.largest_sum_lx.resize(field_.replicates * points());
  look_near_lx_.resize(field_.replicates * points());
  look_drawn_lx_.resize(field_.replicates * points());
  sums_.short_ray_factor.resize(points(), 1.0);
  std::vector<std::uint8_t> is_wanted(points());
  for (std::size_t i = 0; i < points(); ++i) {
    is_wanted[i] =
        static_cast<std::uint8_t>(state_.active()[i] != 0 && gathers_reflection_[i] != 0);
  }
  tiles_ = make_tiles(receiver_, spatial_order_, is_wanted);
  look_points_ = static_cast<std::size_t>(std::count(is_wanted.begin(), is_wanted.end(), 1));
  reach_m_ = near_reach_m;
  if (near_reach_m > 0.0 && sums_.clear_m.empty()) {
    sums_.clear_m.assign(points(), 0.0);
    for_each_point(points(), [&](std::size_t i) {
      const Receiver& r = receiver_[i];
      sums_.clear_m[i] =
          tracer_.clear_distance(r.position_m, has_back(r.kernel) ? r.axis : glm::dvec3(0.0),
                                 kClearReaches * near_reach_m);
      return std::uint64_t{0};
    });
  }
}

}  // namespace calc
