#include "calc/radiosity/direct/emission.h"

#include "calc/base/units.h"
#include "calc/scene/opening.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace calc {
namespace {

glm::dvec3 axis(const PlacedLuminaire& luminaire) { return -luminaire.world_from_luminaire[2]; }

glm::dvec3 lift_along_axis(const PlacedLuminaire& luminaire, const glm::dvec3& source_m,
                           const glm::dvec3& towards, double offset_m) {
  const double side = glm::dot(axis(luminaire), towards) >= 0.0 ? 1.0 : -1.0;
  return source_m + side * offset_m * axis(luminaire);
}

}  // namespace

double point_illuminance_lx(const PlacedLuminaire& luminaire, const glm::dvec3& source_m,
                            const Receiver& receiver) {
  const glm::dvec3 to_source = source_m - receiver.position_m;
  const double response_times_d =
      response_times_distance(receiver.kernel, receiver.axis, to_source);
  if (!(response_times_d > 0.0)) return 0.0;
  const double distance2 = glm::dot(to_source, to_source);
  const double distance = std::sqrt(distance2);
  const glm::dvec3 out = glm::transpose(luminaire.world_from_luminaire) * (to_source / -distance);
  const double intensity =
      luminaire.web->intensity_cd({out.x, out.y, out.z}) * luminaire.flux_scale;
  return intensity * response_times_d / (distance2 * distance);
}

glm::dvec3 lifted_source_m(const PlacedLuminaire& luminaire, const glm::dvec3& source_m,
                           const glm::dvec3& receiver_m, double offset_m) {
  return lift_along_axis(luminaire, source_m, receiver_m - source_m, offset_m);
}

Emitter::Emitter(const PreparedScene& scene, std::span<const std::uint8_t> is_unlit)
    : scene_(scene), cumulative_{0.0} {
  std::map<const PhotometricWeb*, std::size_t> sampler_of_web;
  std::vector<double> traced_lm;
  std::vector<double> channel_lm(scene.channels.size(), 0.0);
  for (const PlacedLuminaire& luminaire : scene.luminaires) {
    const auto [entry, is_new] = sampler_of_web.try_emplace(luminaire.web, samplers_.size());
    if (is_new) samplers_.emplace_back(*luminaire.web);
    sampler_of_.push_back(entry->second);
    const double flux_lm = luminaire.web->flux_lm() * luminaire.flux_scale;
    const bool is_traced = is_unlit.empty() || is_unlit[luminaire_flux_lm_.size()] == 0;
    luminaire_flux_lm_.push_back(flux_lm);
    flux_lm_ += flux_lm;
    traced_lm.push_back(is_traced ? flux_lm : 0.0);
    channel_lm[luminaire.channel] += traced_lm.back();
    traced_flux_lm_ += traced_lm.back();
  }
  const auto lit_channels = static_cast<double>(
      std::count_if(channel_lm.begin(), channel_lm.end(), [](double lm) { return lm > 0.0; }));
  for (std::size_t l = 0; l < traced_lm.size(); ++l) {
    const double flux_lm = traced_lm[l];
    const double own_lm = channel_lm[scene.luminaires[l].channel];
    const double probability =
        flux_lm > 0.0 ? 0.5 * flux_lm / traced_flux_lm_ + 0.5 * flux_lm / own_lm / lit_channels
                      : 0.0;
    path_flux_lm_.push_back(flux_lm > 0.0 ? flux_lm / probability : 0.0);
    cumulative_.push_back(cumulative_.back() + probability);
  }
}

std::size_t Emitter::choose_luminaire(double u) const {
  const auto next =
      std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, u * cumulative_.back());
  return static_cast<std::size_t>(next - cumulative_.begin()) - 1;
}

EmittedRay Emitter::emit(std::size_t luminaire, std::array<double, 2> direction_u,
                         std::array<double, 2> opening_u, double offset_m) const {
  const PlacedLuminaire& placed = scene_.luminaires[luminaire];
  const auto local = samplers_[sampler_of_[luminaire]].sample(direction_u[0], direction_u[1]);
  const glm::dvec3 direction =
      placed.world_from_luminaire * glm::dvec3(local[0], local[1], local[2]);
  const OpeningView view(placed, direction);
  const OpeningView::Point source = view.point(opening_u[0], opening_u[1]);
  if (!placed.opening.is_body()) {
    return {lift_along_axis(placed, source.position_m, direction, offset_m), direction};
  }
  return {source.position_m + offset_m * source.normal, direction};
}

int find_touching_luminaire(const PreparedScene& scene, const glm::dvec3& point_m,
                            double distance_m) {
  for (std::size_t l = 0; l < scene.luminaires.size(); ++l) {
    const PlacedLuminaire& luminaire = scene.luminaires[l];
    if (is_inside_opening(luminaire, point_m, distance_m)) return static_cast<int>(l);
    if (luminaire.opening.shape != OpeningShape::point) continue;
    if (glm::length(luminaire.position_m - point_m) < distance_m) return static_cast<int>(l);
  }
  return -1;
}

}  // namespace calc
