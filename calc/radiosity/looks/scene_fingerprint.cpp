#include "calc/radiosity/looks/scene_fingerprint.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <map>

namespace calc {
namespace {

void add_vector(Fingerprint& print, const glm::dvec3& v) {
  for (int i = 0; i < 3; ++i) print.add(v[i]);
}

void add_web(Fingerprint& print, const PhotometricWeb& web) {
  print.add(static_cast<std::uint64_t>(web.axis()));
  for (const auto* angles : {&web.c_rad(), &web.gamma_rad()}) {
    print.add(static_cast<std::uint64_t>(angles->size()));
    for (const double angle : *angles) print.add(angle);
  }
  for (std::size_t c = 0; c < web.c_rad().size(); ++c) {
    for (std::size_t g = 0; g < web.gamma_rad().size(); ++g) print.add(web.table_cd(c, g));
  }
}

void add_luminaire(Fingerprint& print, const PlacedLuminaire& luminaire,
                   std::map<const PhotometricWeb*, std::size_t>& known) {
  add_vector(print, luminaire.position_m);
  for (int i = 0; i < 3; ++i) add_vector(print, luminaire.world_from_luminaire[i]);
  print.add(luminaire.flux_scale);
  print.add(static_cast<std::uint64_t>(luminaire.opening.shape));
  add_vector(print, luminaire.opening.size_m());
  print.add(static_cast<std::uint64_t>(luminaire.channel));
  if (luminaire.reach) {
    print.add(luminaire.reach->along.x);
    print.add(luminaire.reach->along.y);
    print.add(luminaire.reach->distance_m);
  }
  // Luminaires of a type share a web, which goes in once; its place tells which one this is.
  const auto [web, is_new] = known.emplace(luminaire.web, known.size());
  print.add(static_cast<std::uint64_t>(web->second));
  if (is_new) add_web(print, *luminaire.web);
}

}  // namespace

void Fingerprint::add(double value) { add(std::bit_cast<std::uint64_t>(value)); }

void Fingerprint::add(std::string_view bytes) {
  add(static_cast<std::uint64_t>(bytes.size()));
  for (; !bytes.empty(); bytes.remove_prefix(std::min<std::size_t>(8, bytes.size()))) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), std::min<std::size_t>(8, bytes.size()));
    add(word);
  }
}

std::uint64_t scene_fingerprint(const PreparedScene& scene,
                                std::span<const std::uint8_t> is_unlit) {
  Fingerprint print;
  add_vector(print, scene.origin_m);
  print.add(scene.extent_m);
  print.add(scene.whole_extent_m());
  print.add(scene.rounding_m);
  print.add(static_cast<std::uint64_t>(scene.vertex_m.size()));
  for (const glm::vec3& v : scene.vertex_m) add_vector(print, glm::dvec3(v));
  print.add(static_cast<std::uint64_t>(scene.triangle.size()));
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    const glm::uvec3& corner = scene.triangle[t];
    print.add((static_cast<std::uint64_t>(corner.x) << 32) | corner.y);
    print.add(static_cast<std::uint64_t>(corner.z));
    print.add(scene.reflectance[t]);
  }
  print.add(static_cast<std::uint64_t>(scene.luminaires.size()));
  std::map<const PhotometricWeb*, std::size_t> known;
  for (const PlacedLuminaire& luminaire : scene.luminaires) add_luminaire(print, luminaire, known);
  for (const LightChannel& channel : scene.channels) {
    print.add(std::string_view(channel.group));
    print.add(channel.maintenance_factor);
  }
  print.add(static_cast<std::uint64_t>(is_unlit.size()));
  for (const std::uint8_t unlit : is_unlit) print.add(static_cast<std::uint64_t>(unlit));
  return print.bits();
}

}  // namespace calc
