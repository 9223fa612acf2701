#include "calc/radiosity/paths/near_field.h"

#include "calc/base/units.h"
#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/paths/cut.h"
#include "calc/radiosity/paths/draws.h"
#include "calc/radiosity/paths/light_paths.h"
#include "calc/radiosity/paths/vertex_bounds.h"
#include "calc/radiosity/sampling/low_discrepancy.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "calc/radiosity/sampling/shadow_batch.h"
#include "calc/scene/surface_summary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

namespace calc {
namespace {

// Share of the local vertex density at which short rays take over: a vertex then adds at most kappa
// / pi of the illuminance it stands for.  [measured: 0.01 keeps points beside luminaire hot spots
// within 2 %]
constexpr double kKappa = 0.01;
constexpr double kHighestMeanReflectance = 0.999;  // only shapes the bound; never a result

// Chains of short rays are short, but between surfaces that reflect everything.
constexpr std::uint64_t kHitsPerLookAtTheClock = 1024;

// Illuminance if the luminaire sent its largest intensity here and nothing stood between.
double most_of(const PlacedLuminaire& luminaire, const glm::dvec3& position_m,
               const glm::dvec3& normal) {
  const glm::dvec3 w = luminaire.position_m - position_m;
  const double cosine_times_d = glm::dot(normal, w);
  if (!(cosine_times_d > 0.0)) return 0.0;
  const double d2 = glm::dot(w, w);
  return luminaire.web->max_intensity_cd() * luminaire.flux_scale * cosine_times_d /
         (d2 * std::sqrt(d2));
}

// Illuminance at a short ray's hit from `kFarDraws` vertices.
std::uint64_t add_far_draws(const NearField& field, const SurfaceHit& at, double u, double weight,
                            double* sums, std::size_t stride) {
  thread_local std::vector<float> scratch;
  thread_local std::vector<Connection> connections;
  connections.clear();
  draw_connections(field.tree, field.cut, {at.position_m, at.normal}, 0, kFarDraws, u, scratch,
                   connections);
  ShadowBatch batch(field.tracer, field.tracer.has_shadows(), kHitToVertex);
  const glm::vec3 from(field.tracer.lift(at.position_m, at.normal));
  for (const Connection& connection : connections) {
    const LightVertex& v = field.tree.vertices()[connection.vertex];
    const double g =
        lifted_connection_geometry(ReceiverKernel::planar, at.normal, glm::dvec3(v.normal),
                                   glm::dvec3(v.position_m) - at.position_m,
                                   lift_at(glm::dvec3(v.position_m), field.tracer.offset_m()));
    if (g <= 0.0) continue;
    const float bounded = field.vertex_bounds.limited(connection.vertex, static_cast<float>(g));
    const auto flux = static_cast<double>(connection.weight * v.flux_lm * bounded);
    batch.add(from, v.position_m, weight * flux / kPi, &sums[v.channel * stride]);
  }
  batch.flush();
  return batch.rays();
}

// Direct light at a short ray's hit, from one luminaire.
std::uint64_t add_direct_draw(const NearField& field, const SurfaceHit& at, RandomKey key,
                              double weight, double* sums, std::size_t stride) {
  const auto choice = field.luminaires.choose(at.position_m, at.normal, key.with(2).uniform());
  if (!choice) return 0;
  return add_direct_sample_of(field.tracer, choice->luminaire, {at.position_m, at.normal}, key,
                              weight / choice->probability, sums, stride);
}

// A short ray's direction, and its weight k(w) / (density pi).
struct FirstRay {
  glm::dvec3 origin_m, direction;
  double weight;
};

FirstRay first_ray(const Tracer& tracer, const Receiver& receiver, std::array<double, 2> u) {
  if (has_back(receiver.kernel)) {
    return {tracer.lift(receiver), cosine_direction(receiver.axis, u[0], u[1]), 1.0};
  }
  const glm::dvec3 direction = sphere_direction(u[0], u[1]);
  return {receiver.position_m, direction,
          4.0 * response_times_distance(receiver.kernel, receiver.axis, direction)};
}

double receiver_geometry(const Receiver& receiver, const SurfaceHit& hit) {
  return connection_geometry(receiver.kernel, receiver.axis, hit.normal,
                             hit.position_m - receiver.position_m);
}

// A chain of short rays at one of the places that it meets.
struct Chain {
  SurfaceHit at;
  double g;       // geometry term between it and the place before
  double weight;  // of its light
};

// Light at a chain's place, and one more ray from there to the next; false: the chain ends.
// gpu/shaders/hits/hit_bounds.glsl and those after it do the same.
bool add_step(const NearField& field, RandomKey ray_key, std::uint64_t depth, Chain& chain,
              double* sums, std::size_t stride, std::uint64_t& rays) {
  const Tracer& tracer = field.tracer;
  const SurfaceHit at = chain.at;
  const double rho = tracer.scene().reflectance[at.triangle];
  if (rho <= 0.0 || chain.g <= field.bound.smallest()) return false;
  const RandomKey key = ray_key.with(depth);
  // Roulette with survival probability `factor`, so that the weight stays; the first step is always
  // taken, and weighs less.
  const double roulette = depth == 0 ? 0.0 : key.with(0).uniform();
  // To find the bound takes rays, and it is no smaller than the smallest.
  if (roulette >= (1.0 - field.bound.smallest() / chain.g) * rho) return false;
  const double missing = 1.0 - field.bound.at(at.position_m, at.normal) / chain.g;
  if (missing <= 0.0) return false;
  const double factor = missing * rho;
  if (roulette >= factor) return false;
  if (depth == 0) chain.weight *= factor;
  rays += add_direct_draw(field, at, key.with(1), chain.weight, sums, stride);
  rays += add_far_draws(field, at, key.with(2).uniform(), chain.weight, sums, stride);
  ++rays;
  if (!tracer.closest_hit(tracer.lift(at.position_m, at.normal),
                          cosine_direction(at.normal, key.with(3).uniform(), key.with(4).uniform()),
                          field.bound.reach_m(), chain.at)) {
    return false;
  }
  chain.g = geometry_term(at.position_m, at.normal, chain.at.position_m, chain.at.normal);
  return true;
}

// Light of a chain from one of its places on.
std::uint64_t add_chain(const NearField& field, Chain chain, std::uint64_t first_depth,
                        RandomKey ray_key, double* sums, std::size_t stride) {
  std::uint64_t rays = 0;
  for (std::uint64_t depth = first_depth;; ++depth) {
    if (depth >= kMostReflections) {
      if (field.has_endless_chain != nullptr) *field.has_endless_chain = true;
      break;
    }
    if (depth % kHitsPerLookAtTheClock == kHitsPerLookAtTheClock - 1 && is_past(field.deadline_s)) {
      break;
    }
    if (!add_step(field, ray_key, depth, chain, sums, stride, rays)) break;
  }
  return rays;
}

// What a device found of light from afar; returns the rays it traced.
std::uint64_t add_found_draws(const NearField& field, const HitLight& light, double* sums,
                              std::size_t stride) {
  std::uint64_t rays = 0;
  for (const HitLight::Draw& draw : light.draws) {
    if (draw.channel == HitLight::kNothing) continue;
    ++rays;
    if (draw.channel == HitLight::kHidden) continue;
    sums[draw.channel * stride] += light.weight * static_cast<double>(draw.lm_per_m2) / kPi;
  }
  return field.tracer.has_shadows() ? rays : 0;
}

// A chain whose first step a device did.
std::uint64_t add_found(const NearField& field, const HitLight& light, RandomKey ray_key,
                        double* sums, std::size_t stride) {
  if (!(light.weight > 0.0)) return 0;
  std::uint64_t rays = 1;  // the further one
  const Tracer& tracer = field.tracer;
  const auto hit = [&] {
    return tracer.surface_hit(light.triangle_and_side, light.place.u, light.place.v);
  };
  if (light.luminaire == HitLight::kLeft) {
    rays += add_direct_draw(field, hit(), ray_key.with(0).with(1), light.weight, sums, stride);
  } else if (light.luminaire != HitLight::kNothing) {
    rays += tracer.has_shadows() ? 1 : 0;
    if (light.luminaire != HitLight::kHidden) {
      sums[tracer.scene().luminaires[light.luminaire].channel * stride] += light.direct_lx;
    }
  }
  rays += add_found_draws(field, light, sums, stride);
  if (light.next_triangle_and_side == HitLight::kNothing) return rays;
  const SurfaceHit at = hit(), next = tracer.surface_hit(light.next_triangle_and_side,
                                                         light.next_place.u, light.next_place.v);
  const double g = geometry_term(at.position_m, at.normal, next.position_m, next.normal);
  return rays + add_chain(field, {next, g, light.weight}, 1, ray_key, sums, stride);
}

double sum_of_channels(const double* sums, std::size_t stride, std::size_t channels) {
  double sum = 0.0;
  for (std::size_t c = 0; c < channels; ++c) sum += sums[c * stride];
  return sum;
}

}  // namespace

GeometryBound::GeometryBound(const Tracer& tracer, const Emitter& emitter, std::uint64_t paths)
    : tracer_(tracer) {
  const SurfaceSummary summary = summarise_surfaces(tracer.scene());
  reach_m_ = near_reach_m(summary);
  smallest_ = 1.0 / (reach_m_ * reach_m_);
  const double paths_number = static_cast<double>(paths);
  vertices_per_lumen_ = kKappa * paths_number / emitter.traced_flux_lm();
  const double rho = std::min(summary.mean_reflectance, kHighestMeanReflectance);
  // Sumpner: E_amb = rho Phi / (A (1 - rho)), so that Phi cancels.
  if (summary.area_m2 > 0.0) {
    ambient_per_m2_ = kKappa * paths_number * rho / (summary.area_m2 * (1.0 - rho));
    smallest_ = std::max(smallest_, ambient_per_m2_);
    reach_m_ = 1.0 / std::sqrt(smallest_);
  }
}

GeometryBound::Terms GeometryBound::terms() const {
  const auto luminaires = static_cast<double>(tracer_.scene().luminaires.size());
  return {smallest_, vertices_per_lumen_, ambient_per_m2_,
          (smallest_ - ambient_per_m2_) / vertices_per_lumen_,
          smallest_ / (vertices_per_lumen_ * luminaires)};
}

// gpu/shaders/hits/hit_bounds.glsl does the same.
double GeometryBound::at_lifted(const glm::dvec3& position_m, const glm::dvec3& normal) const {
  const auto& luminaires = tracer_.scene().luminaires;
  const auto [smallest, vertices_per_lumen, ambient_per_m2, needed_lx, least_lx] = terms();
  // Without a single ray.
  double most_lx = 0.0;
  for (const PlacedLuminaire& luminaire : luminaires)
    most_lx += most_of(luminaire, position_m, normal);
  if (most_lx <= needed_lx) return smallest;
  double direct_lx = 0.0;
  for (const PlacedLuminaire& luminaire : luminaires) {
    if (most_of(luminaire, position_m, normal) < least_lx) continue;
    const double lx = point_illuminance_lx(luminaire, luminaire.position_m, {position_m, normal});
    if (lx < least_lx) continue;
    const glm::dvec3 source =
        lifted_source_m(luminaire, luminaire.position_m, position_m, tracer_.offset_m());
    if (!tracer_.is_blocked(position_m, source, kHitToSource)) direct_lx += lx;
  }
  return std::max(smallest, vertices_per_lumen * direct_lx + ambient_per_m2);
}

double near_reach_m(const SurfaceSummary& surfaces) {
  constexpr double kMeanFreePathsPerReach = 1.0 / 3.0;
  return kMeanFreePathsPerReach * surfaces.mean_free_path_m;
}

PointLight ShortRayLight::of(std::size_t point) const {
  const auto request = static_cast<std::uint32_t>(point);
  const auto begin =
      std::lower_bound(left.begin(), left.end(), request,
                       [](const HitLight& light, std::uint32_t r) { return light.request < r; });
  auto end = begin;
  while (end != left.end() && end->request == request) ++end;
  return {{lx.data() + point * channels, channels}, largest_lx[point], rays[point], {begin, end}};
}

std::uint64_t add_near_field(const NearField& field, const NearFieldRequest& request,
                             const std::optional<PointLight>& found, double* sums,
                             std::size_t stride, float& largest) {
  std::uint64_t rays = request.rays;
  const auto add = [&](const auto& add_ray) {  // which adds one ray's light
    const double before = sum_of_channels(sums, stride, field.channels);
    rays += add_ray();
    const double added = sum_of_channels(sums, stride, field.channels) - before;
    largest = std::max(largest, static_cast<float>(added));
  };
  if (found) {
    rays += found->rays;
    for (std::size_t c = 0; c < field.channels; ++c) sums[c * stride] += found->lx[c];
    largest = std::max(largest, found->largest_lx);
    for (const HitLight& light : found->left) {
      add([&] { return add_found(field, light, request.key.with(light.ray), sums, stride); });
    }
    return rays;
  }
  const ScrambledSobol sobol(request.key);
  const double ray_weight = 1.0 / request.rays;
  // A point may lie in a surface that it does not look out of: that surface is not in its way.
  const auto least_m = static_cast<float>(field.tracer.offset_m());
  const auto most_m = static_cast<float>(field.bound.reach_m());
  RayPacket packet;
  std::array<double, RayPacket::kSize> weight;
  std::array<SurfaceHit, RayPacket::kSize> hit;
  for (std::uint32_t first = 0; first < request.rays; first += RayPacket::kSize) {
    packet.count = 0;
    for (std::uint32_t k = first; k < request.rays && !packet.is_full(); ++k) {
      const FirstRay ray = first_ray(field.tracer, request.receiver, sobol.sample_pair(k, 0));
      weight[k - first] = ray_weight * ray.weight;
      packet.add(ray.origin_m, ray.direction);
    }
    std::uint32_t hits = field.tracer.closest_hits(packet, least_m, most_m, hit);
    for (; hits != 0; hits &= hits - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(hits));
      add([&] {
        return add_chain(field, {hit[k], receiver_geometry(request.receiver, hit[k]), weight[k]}, 0,
                         request.key.with(first + k), sums, stride);
      });
    }
  }
  return rays;
}

}  // namespace calc
