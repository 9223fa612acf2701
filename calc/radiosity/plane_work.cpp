#include "calc/radiosity/plane_work.h"

#include "calc/radiosity/direct.h"
#include "calc/radiosity/emission.h"
#include "calc/radiosity/phase_timer.h"
#include "calc/radiosity/random.h"
#include "calc/statistics.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>

namespace calc {
namespace {

constexpr std::uint64_t kPathsPerNearRay = 4;
constexpr std::uint64_t kFewestNearRays = 4;

// Share of the indirect part's variance below which openings need no more samples.
constexpr double kNegligibleVariance = 0.1;

std::uint32_t near_rays_for(std::uint64_t batch_paths) {
  return static_cast<std::uint32_t>(std::max(kFewestNearRays, batch_paths / kPathsPerNearRay));
}

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

std::vector<double> divided(const std::vector<double>& sums, double divisor) {
  std::vector<double> result(sums.size());
  std::transform(sums.begin(), sums.end(), result.begin(),
                 [divisor](double s) { return s / divisor; });
  return result;
}

// [point]: 1 if some reflecting surface reaches in front of the point's tangent plane; else
// indirect light is exactly 0.
std::vector<std::uint8_t> see_reflecting_surface(const Tracer& tracer,
                                                 const std::vector<glm::dvec3>& position_m,
                                                 const std::vector<glm::dvec3>& normal) {
  const PreparedScene& scene = tracer.scene();
  std::vector<std::uint8_t> sees(position_m.size(), 0);
  glm::dvec3 direction(0.0);
  double farthest_m =
      0.0;  // of all corners along `direction`; neighbours mostly share their normal
  for (std::size_t i = 0; i < position_m.size(); ++i) {
    if (i == 0 || normal[i] != direction) {
      direction = normal[i];
      farthest_m = -std::numeric_limits<double>::max();
      for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
        if (scene.reflectance[t] <= 0.0) continue;
        for (int k = 0; k < 3; ++k) {
          const glm::dvec3 corner(scene.vertex_m[scene.triangle[t][k]]);
          farthest_m = std::max(farthest_m, glm::dot(direction, corner));
        }
      }
    }
    sees[i] = farthest_m > glm::dot(direction, position_m[i]) + tracer.offset_m() ? 1 : 0;
  }
  return sees;
}

}  // namespace

PlaneWork::PlaneWork(const Tracer& tracer, const std::string& plane_id, const SensorGrid& grid,
                     std::uint64_t seed, std::size_t replicates)
    : tracer_(tracer),
      opening_key_(stage_key(seed, RandomStage::opening).with(plane_id)),
      near_key_(stage_key(seed, RandomStage::near_field).with(plane_id)),
      normal_(grid.normal) {
  for (const glm::dvec3& p : grid.position_m) position_m_.push_back(p - tracer.scene().origin_m);
  field_.plane_id = plane_id;
  field_.points = points();
  field_.replicates = replicates;
  field_.channels = tracer.scene().channels;
  field_.direct_exact_lx.assign(channels() * points(), 0.0);
  may_be_sampled_ = see_reflecting_surface(tracer, position_m_, normal_);
  for (std::size_t i = 0; i < points(); ++i) {
    if (find_touching_luminaire(tracer.scene(), position_m_[i], tracer.offset_m()) < 0) continue;
    const glm::dvec3& p = grid.position_m[i];
    refuse(fmt::format(
        "the point ({:.6g} {:.6g} {:.6g}) lies at a luminaire without size: illuminance is "
        "unbounded there",
        p.x, p.y, p.z));
    return;
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

void PlaneWork::add_exact(SolveTimes& times) {
  const PhaseTimer timer(times.direct_s);
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t i) {
    return add_point_sources(tracer_, position_m_[i], normal_[i], &field_.direct_exact_lx[i],
                             points());
  });
}

void PlaneWork::sample_openings(SolveTimes& times) {
  if (rounds_ > 0 && !opening_error_matters()) return;
  const PhaseTimer timer(times.direct_s);
  direct_sum_lx_.resize(values());
  const std::uint32_t first = rounds_;
  rounds_ = std::max<std::uint32_t>(1, 2 * first);
  field_.counters.direct_rays += for_each_point(points(), [&](std::size_t i) {
    std::uint64_t rays = 0;
    for (std::size_t r = 0; r < field_.replicates; ++r) {
      rays += add_extended_sources(tracer_, position_m_[i], normal_[i],
                                   opening_key_.with(i).with(r), first, rounds_,
                                   &direct_sum_lx_[r * channels() * points() + i], points());
    }
    if (rays > 0) may_be_sampled_[i] = 1;  // no ray is traced where the unoccluded light is 0
    return rays;
  });
}

bool PlaneWork::opening_error_matters() const {
  if (std::find(field_.unseen.begin(), field_.unseen.end(), 1) != field_.unseen.end()) return true;
  if (field_.indirect_lx.empty()) return true;
  return squared_error(field_.direct_sampled_lx) >
         kNegligibleVariance * squared_error(field_.indirect_lx);
}

// Sum over points of the squared standard error, all channels at full output.
double PlaneWork::squared_error(const std::vector<double>& values_lx) const {
  double sum = 0.0;
  std::vector<double> at_point(field_.replicates);
  for (std::size_t i = 0; i < points(); ++i) {
    for (std::size_t r = 0; r < field_.replicates; ++r) {
      at_point[r] = 0.0;
      for (std::size_t c = 0; c < channels(); ++c) {
        at_point[r] += values_lx[(r * channels() + c) * points() + i];
      }
    }
    const double error = replicate_mean(at_point).standard_error;
    sum += error * error;
  }
  return sum;
}

void PlaneWork::connect(const VertexBatch& batch, Gatherer& gatherer, SolveTimes& times) {
  std::vector<double> batch_lx(channels() * points(), 0.0);
  {
    const PhaseTimer timer(times.connect_s);
    field_.counters.connection_rays +=
        gatherer.gather(tracer_, {position_m_, normal_}, batch.vertices, batch_lx);
  }
  {
    const PhaseTimer timer(times.near_s);
    const std::uint32_t last_ray = near_rays_ + near_rays_for(batch.paths);
    field_.counters.near_rays += for_each_point(points(), [&](std::size_t i) {
      const NearFieldRequest request{position_m_[i], normal_[i],
                                     near_key_.with(i).with(batch.replicate), near_rays_, last_ray};
      return add_near_field(tracer_, batch.bound, batch.vertices, request, &batch_lx[i], points());
    });
  }
  indirect_sum_lx_.resize(values());
  double* sum = &indirect_sum_lx_[batch.replicate * channels() * points()];
  for (std::size_t k = 0; k < batch_lx.size(); ++k) {
    sum[k] += static_cast<double>(batch.paths) * batch_lx[k];
  }
}

void PlaneWork::finish_look(std::uint64_t paths, std::uint64_t batch_paths) {
  paths_ = paths;
  near_rays_ += near_rays_for(batch_paths);
  field_.counters.paths = paths * field_.replicates;
}

void PlaneWork::publish() {
  if (rounds_ > 0) field_.direct_sampled_lx = divided(direct_sum_lx_, rounds_);
  if (paths_ > 0) field_.indirect_lx = divided(indirect_sum_lx_, static_cast<double>(paths_));
  if (!field_.is_exact()) find_unseen();
}

void PlaneWork::find_unseen() {
  field_.unseen = may_be_sampled_;
  for (const std::vector<double>* sums : {&direct_sum_lx_, &indirect_sum_lx_}) {
    for (std::size_t k = 0; k < sums->size(); ++k) {
      if ((*sums)[k] > 0.0) field_.unseen[k % points()] = 0;
    }
  }
}

}  // namespace calc
