#include "calc/radiosity/gather/settings.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

namespace calc {
namespace {

bool is_path_count(std::uint64_t paths) {
  return std::has_single_bit(paths) && paths >= kFewestPaths && paths <= kMostPaths;
}

}  // namespace

std::string validate(const RadiositySettings& settings) {
  if (settings.replicates < kFewestReplicates || settings.replicates > kMostReplicates) {
    return fmt::format("replicates is {}; allowed: {} to {}", settings.replicates,
                       kFewestReplicates, kMostReplicates);
  }
  if (!is_path_count(settings.first_paths)) {
    return fmt::format("first paths is {}; allowed: a power of two, {} to {}", settings.first_paths,
                       kFewestPaths, kMostPaths);
  }
  if (!is_path_count(settings.max_paths) || settings.max_paths < settings.first_paths) {
    return fmt::format("max paths is {}; allowed: a power of two, {} to {}", settings.max_paths,
                       settings.first_paths, kMostPaths);
  }
  if (!(settings.clamp_per_m2 >= 0.0) || !std::isfinite(settings.clamp_per_m2)) {
    return fmt::format("clamp is {} /m^2; allowed: 0 (none) or more", settings.clamp_per_m2);
  }
  const std::uint32_t texels = settings.shadow_map_texels;
  if (texels != 0 && (!std::has_single_bit(texels) || texels < kFewestShadowMapTexels ||
                      texels > kMostShadowMapTexels)) {
    return fmt::format("shadow map texels is {}; allowed: 0 (rays) or a power of two, {} to {}",
                       texels, kFewestShadowMapTexels, kMostShadowMapTexels);
  }
  if (texels != 0 && settings.method != Method::instant_radiosity) {
    return "shadow maps can replace rays in instant radiosity only";
  }
  if (!(settings.time_limit_s >= 0.0) || !std::isfinite(settings.time_limit_s)) {
    return fmt::format("time limit is {} s; allowed: 0 (none) or more", settings.time_limit_s);
  }
  if (!(settings.opening_error_factor > 0.0) || !std::isfinite(settings.opening_error_factor)) {
    return fmt::format("opening error factor is {}; allowed: more than 0",
                       settings.opening_error_factor);
  }
  if (settings.jobs < 0 || settings.jobs > 4096) {
    return fmt::format("jobs is {}; allowed: 0 (one per core) to 4096", settings.jobs);
  }
  return {};
}

}  // namespace calc
