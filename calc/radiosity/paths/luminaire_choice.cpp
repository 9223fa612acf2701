#include "calc/radiosity/paths/luminaire_choice.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/radiosity/paths/draws.h"

#include <algorithm>
#include <map>
#include <utility>

namespace calc {
namespace {

// Of the largest intensity: where an opening has a size, its parts shine in other directions than
// its centre.
constexpr float kLeastOfExtended = 0.05f;

}  // namespace

LuminaireChoice::LuminaireChoice(const PreparedScene& scene) : channels_(scene.channels.size()) {
  std::map<std::pair<const PhotometricWeb*, bool>, std::uint32_t> lobe_of_web;
  for (const PlacedLuminaire& luminaire : scene.luminaires) {
    const bool is_extended = luminaire.opening.shape != OpeningShape::point;
    const auto [entry, is_new] = lobe_of_web.try_emplace({luminaire.web, is_extended},
                                                         static_cast<std::uint32_t>(lobes_.size()));
    if (is_new) lobes_.push_back(lobe_of(*luminaire.web, is_extended));
    const glm::dvec3 half_m = is_extended ? 0.5 * luminaire.opening.size_m() : glm::dvec3(0.0);
    const glm::dmat3& axes = luminaire.world_from_luminaire;
    sources_.push_back(
        {glm::vec3(luminaire.position_m), glm::vec3(axes[0]), glm::vec3(axes[1]),
         glm::vec3(axes[2]), glm::vec3(half_m), static_cast<float>(glm::length(half_m)),
         static_cast<float>(luminaire.flux_scale), entry->second, luminaire.channel});
  }
}

LuminaireChoice::Lobe LuminaireChoice::lobe_of(const PhotometricWeb& web, bool is_extended) {
  Lobe lobe;
  const auto largest_cd = static_cast<float>(web.max_intensity_cd());
  lobe.most_cd.fill(largest_cd);
  lobe.largest_cd = largest_cd;
  if (web.axis() != TableAxis::vertical) return lobe;
  const std::vector<double>& gamma = web.gamma_rad();
  const std::size_t planes = web.c_rad().size();
  for (std::size_t band = 0; band < choice_terms::kChoiceBands; ++band) {
    const auto edge = [](std::size_t k) {
      return calc::acos(
          std::clamp(1.0 - 2.0 * static_cast<double>(k) / choice_terms::kChoiceBands, -1.0, 1.0));
    };
    const double from = edge(band > 0 ? band - 1 : 0),
                 to = edge(std::min(band + 2, choice_terms::kChoiceBands));
    // Interpolated between the entries before and behind.
    const auto behind = std::lower_bound(gamma.begin(), gamma.end(), to);
    const auto before = std::upper_bound(gamma.begin(), gamma.end(), from);
    const auto first =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(before - gamma.begin() - 1, 0));
    const auto last = static_cast<std::size_t>(
        std::min<std::ptrdiff_t>(behind - gamma.begin(), std::ssize(gamma) - 1));
    double most_cd = 0.0;
    for (std::size_t plane = 0; plane < planes; ++plane) {
      for (std::size_t g = first; g <= last; ++g) {
        most_cd = std::max(most_cd, web.table_cd(plane, g));
      }
    }
    lobe.most_cd[band] = static_cast<float>(most_cd);
    if (is_extended) {
      lobe.most_cd[band] = std::max(lobe.most_cd[band], kLeastOfExtended * largest_cd);
    }
  }
  return lobe;
}

std::optional<LuminaireChoice::Choice> LuminaireChoice::choose(const glm::dvec3& position_m,
                                                               const glm::dvec3& normal,
                                                               double u) const {
  if (sources_.empty()) return std::nullopt;
  if (sources_.size() == 1) return Choice{0, 1.0};
  thread_local std::vector<float> weight;
  thread_local std::vector<double> channel_weight;
  weight.resize(sources_.size());
  channel_weight.assign(channels_, 0.0);
  const glm::vec3 at(position_m), facing(normal);
  for (std::size_t l = 0; l < sources_.size(); ++l) {
    weight[l] = choice_terms::choice_most_lx(sources_[l], lobes_[sources_[l].lobe], at, facing);
    channel_weight[sources_[l].channel] += static_cast<double>(weight[l]);
  }
  double all = 0.0;
  for (const double w : channel_weight) all += w;
  if (!(all > 0.0)) return std::nullopt;
  const double least = kLeastShare * all;
  const auto lit_channels = std::count_if(channel_weight.begin(), channel_weight.end(),
                                          [&](double w) { return w > least; });
  // Of luminaire l: weight[l] * share[channel].
  for (double& w : channel_weight) {
    w = 0.5 / all + (w > least ? 0.5 / (static_cast<double>(lit_channels) * w) : 0.0);
  }
  double left = u;
  std::size_t chosen = sources_.size();
  for (std::size_t l = 0; l < sources_.size(); ++l) {
    const double p = static_cast<double>(weight[l]) * channel_weight[sources_[l].channel];
    if (!(p > 0.0)) continue;
    chosen = l;
    if (left < p) break;
    left -= p;
  }
  return Choice{chosen,
                static_cast<double>(weight[chosen]) * channel_weight[sources_[chosen].channel]};
}

}  // namespace calc
