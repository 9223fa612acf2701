#include "calc/radiosity/plane_work.h"

#include "calc/radiosity/direct.h"
#include "calc/radiosity/glare.h"
#include "calc/radiosity/grid_receivers.h"
#include "calc/radiosity/opening_light.h"
#include "calc/radiosity/phase_timer.h"
#include "calc/radiosity/point_problem.h"
#include "calc/radiosity/random.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace calc {
namespace {

// Clear distances are found up to so many reaches of short rays: the largest possible sample falls
// with their square.
constexpr double kClearReaches = 4.0;
// Neighbours that share one proof that an opening is seen; where it fails each has its own.
constexpr std::size_t kPointsPerProof = 32;

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

PlaneWork::PlaneWork(const Tracer& tracer, const std::string& plane_id, const SensorGrid& grid,
                     const PlaneDecision& decision, const RadiositySettings& settings)
    : tracer_(tracer),
      settings_(settings),
      decision_(decision),
      opening_key_(stage_key(settings.seed, RandomStage::opening).with(plane_id)),
      near_key_(stage_key(settings.seed, RandomStage::near_field).with(plane_id)),
      draw_key_(stage_key(settings.seed, RandomStage::connections).with(plane_id)) {
  receiver_ = receivers_of(tracer, grid);
  spatial_order_ = spatial_order(receiver_);
  const auto replicates = static_cast<std::size_t>(settings.replicates);
  field_.plane_id = plane_id;
  field_.points = points();
  field_.point_weight = point_weights(grid);
  field_.replicates = replicates;
  field_.channels = tracer.scene().channels;
  field_.direct_exact_lx.assign(channels() * points(), 0.0);
  replicate_connection_rays_.assign(replicates, 0);
  replicate_near_rays_.assign(replicates, 0);
  active_.assign(points(), 1);
  rounds_.assign(points(), 0);
  paths_.assign(points(), 0);
  possible_sample_lx_.assign(points(), 0.0);
  largest_opening_lx_.assign(points(), 0.0f);
  has_hidden_opening_.assign(points(), 0);
  has_seen_opening_.assign(points(), 0);
  // A point's other receivers see nothing that the first one does not.
  for (std::size_t part = 0; part < receivers_per_point(grid.derived); ++part) {
    may_be_sampled_.insert(may_be_sampled_.end(), decision.may_see_reflection.begin(),
                           decision.may_see_reflection.end());
    gathers_reflection_.insert(gathers_reflection_.end(), decision.gathers_reflection.begin(),
                               decision.gathers_reflection.end());
  }
  has_indirect_ = may_be_sampled_;
  if (std::string problem = point_problem(tracer, grid, receiver_, settings.refuses_close_points);
      !problem.empty()) {
    refuse(std::move(problem));
  }
}

void PlaneWork::refuse(std::string problem) {
  is_active_ = false;
  field_.problem = std::move(problem);
}

void PlaneWork::finish(StopReason reason) {
  is_active_ = false;
  field_.stop = reason;
}

void PlaneWork::narrow(const std::vector<std::uint8_t>& active) {
  active_ = active;
  active_.resize(points(), 1);
}

void PlaneWork::add_exact(double deadline_s, SolveTimes& times) {
  const PhaseTimer timer(times.direct_s);
  if (!decision_.measures_direct) return add_glare(deadline_s);
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t i) {
    if (is_past(deadline_s)) return std::uint64_t{0};
    return add_point_sources(tracer_, receiver_[i], {decision_.is_dark, has_shadows()},
                             &field_.direct_exact_lx[i], points())
        .traced;
  });
}

void PlaneWork::add_glare(double deadline_s) {
  std::vector<GlareSum> sums(points() * channels());  // [point][channel]
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t i) {
    if (is_past(deadline_s)) return std::uint64_t{0};
    return add_glare_sources(tracer_, receiver_[i], has_shadows(),
                             std::span(sums).subspan(i * channels(), channels()));
  });
  GlareField& glare = field_.glare;
  for (std::size_t c = 0; c < channels(); ++c) {
    for (std::size_t i = 0; i < points(); ++i) {
      const GlareSum& sum = sums[i * channels() + c];
      glare.value.push_back(sum.value);
      glare.low.push_back(sum.low);
      glare.high.push_back(sum.high);
      if (!sum.refusal) continue;
      glare.refusals.push_back(*sum.refusal);
      glare.refusals.back().point = i;
    }
  }
}

void PlaneWork::sample_openings(double deadline_s, SolveTimes& times) {
  if (!decision_.samples_openings) return;
  if (most_rounds_ > 0 && !opening_error_matters()) return;
  const PhaseTimer timer(times.direct_s);
  direct_sum_lx_.resize(values());
  if (free_openings_.empty() && has_shadows()) prove_openings(deadline_s);
  const std::uint32_t last = std::max<std::uint32_t>(1, 2 * most_rounds_);
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t place) {
    const std::size_t i = spatial_order_[place];
    if (active_[i] == 0 || is_past(deadline_s)) return std::uint64_t{0};
    DirectProofs proofs{decision_.is_dark, has_shadows()};
    if (has_shadows()) proofs.is_free = free_openings_[place / kPointsPerProof];
    const DirectRays direct =
        add_openings(tracer_, receiver_[i], proofs, opening_key_.with(i),
                     {rounds_[i], last, field_.replicates, settings_.opening_error_factor},
                     {&field_.direct_exact_lx[i], &direct_sum_lx_[i], points(),
                      channels() * points(), &largest_opening_lx_[i]});
    if (direct.has_hidden) has_hidden_opening_[i] = 1;
    if (direct.may_be_lit) may_be_sampled_[i] = 1;
    if (direct.has_seen) has_seen_opening_[i] = 1;
    rounds_[i] = last;
    return direct.traced;
  });
  most_rounds_ = last;
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
  indirect_sum_lx_.resize(values());
  largest_sum_lx_.resize(field_.replicates * points());
  look_near_lx_.resize(field_.replicates * points());
  look_drawn_lx_.resize(field_.replicates * points());
  short_ray_factor_.resize(points(), 1.0);
  std::vector<std::uint8_t> is_wanted(points());
  for (std::size_t i = 0; i < points(); ++i) {
    is_wanted[i] = static_cast<std::uint8_t>(active_[i] != 0 && gathers_reflection_[i] != 0);
  }
  tiles_ = make_tiles(receiver_, spatial_order_, is_wanted);
  look_points_ = static_cast<std::size_t>(std::count(is_wanted.begin(), is_wanted.end(), 1));
  reach_m_ = near_reach_m;
  if (near_reach_m > 0.0 && clear_m_.empty()) {
    clear_m_.assign(points(), 0.0);
    for_each_point(points(), [&](std::size_t i) {
      const Receiver& r = receiver_[i];
      clear_m_[i] =
          tracer_.clear_distance(r.position_m, has_back(r.kernel) ? r.axis : glm::dvec3(0.0),
                                 kClearReaches * near_reach_m);
      return std::uint64_t{0};
    });
  }
}

}  // namespace calc
