#include "calc/radiosity/looks/look_key.h"

#include "calc/base/file_hash.h"
#include "calc/base/numbers_version.h"
#include "calc/rays/triangle_tree.h"

#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <map>
#include <type_traits>

namespace calc {
namespace {

// Raised when what is kept of a look changes: see stored_look.h.
constexpr int kLookFormat = 1;

// Bytes to be hashed: numbers as they lie, lists with their lengths, so that no two inputs give the
// same bytes.
class KeyBytes {
 public:
  template <class Number>
  void add(Number value) {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void add(const glm::dvec3& v) {
    for (int i = 0; i < 3; ++i) add(v[i]);
  }
  template <class Number>
  void add(const std::vector<Number>& list) {
    add(static_cast<std::uint64_t>(list.size()));
    for (const Number& value : list) add(value);
  }
  std::string digest() const { return sha256_hex(bytes_); }

 private:
  std::string bytes_;
};

void add_opening(KeyBytes& bytes, const LuminousOpening& opening) {
  bytes.add(opening.shape);
  bytes.add(opening.along_c0_m);
  bytes.add(opening.along_c90_m);
  bytes.add(opening.height_m);
}

void add_web(KeyBytes& bytes, const PhotometricWeb& web) {
  bytes.add(web.axis());
  bytes.add(web.c_rad());
  bytes.add(web.gamma_rad());
  for (std::size_t c = 0; c < web.c_rad().size(); ++c) {
    for (std::size_t g = 0; g < web.gamma_rad().size(); ++g) bytes.add(web.table_cd(c, g));
  }
  add_opening(bytes, web.opening());
}

void add_surfaces(KeyBytes& bytes, const PreparedScene& scene) {
  bytes.add(static_cast<std::uint64_t>(scene.vertex_m.size()));
  for (const glm::vec3& v : scene.vertex_m) {
    for (int i = 0; i < 3; ++i) bytes.add(v[i]);
  }
  bytes.add(static_cast<std::uint64_t>(scene.triangle.size()));
  for (const glm::uvec3& corner : scene.triangle) {
    for (int i = 0; i < 3; ++i) bytes.add(corner[i]);
  }
  bytes.add(scene.reflectance);
  bytes.add(scene.body);
}

void add_luminaires(KeyBytes& bytes, const PreparedScene& scene) {
  bytes.add(static_cast<std::uint64_t>(scene.channels.size()));
  bytes.add(static_cast<std::uint64_t>(scene.luminaires.size()));
  // Luminaires of a type share a web, which goes in once; its place tells which one this is.
  std::map<const PhotometricWeb*, std::uint64_t> known;
  for (const PlacedLuminaire& luminaire : scene.luminaires) {
    bytes.add(luminaire.position_m);
    for (int i = 0; i < 3; ++i) bytes.add(luminaire.world_from_luminaire[i]);
    bytes.add(luminaire.flux_scale);
    add_opening(bytes, luminaire.opening);
    bytes.add(luminaire.channel);
    bytes.add(static_cast<std::uint64_t>(luminaire.reach ? 1 : 0));
    if (luminaire.reach) {
      bytes.add(luminaire.reach->along.x);
      bytes.add(luminaire.reach->along.y);
      bytes.add(luminaire.reach->distance_m);
    }
    const auto [web, is_new] =
        known.emplace(luminaire.web, static_cast<std::uint64_t>(known.size()));
    bytes.add(web->second);
    if (is_new) add_web(bytes, *luminaire.web);
  }
}

std::string settings_words(const RadiositySettings& settings) {
  std::string skips;
  for (const auto& [skip, name] : EnumNames<Skip>::list) {
    skips += settings.skips.allows(skip) ? '1' : '0';
  }
  return fmt::format(
      "method {} seed {} replicates {} first-paths {} skips {} clamp {:x} shadow-map {} "
      "refuses-close {} opening-error {:x}",
      static_cast<int>(settings.method), settings.seed, settings.replicates, settings.first_paths,
      skips, std::bit_cast<std::uint64_t>(settings.clamp_per_m2), settings.shadow_map_texels,
      settings.refuses_close_points ? 1 : 0,
      std::bit_cast<std::uint64_t>(settings.opening_error_factor));
}

std::string plane_digest(const SensorGrid& grid) {
  KeyBytes bytes;
  for (const auto* list : {&grid.position_m, &grid.shift_m, &grid.normal}) {
    bytes.add(static_cast<std::uint64_t>(list->size()));
    for (const glm::dvec3& v : *list) bytes.add(v);
  }
  bytes.add(grid.kernel);
  bytes.add(grid.derived);
  return bytes.digest();
}

}  // namespace

std::string scene_digest(const PreparedScene& scene) {
  KeyBytes bytes;
  bytes.add(scene.origin_m);
  bytes.add(scene.extent_m);
  bytes.add(scene.whole_extent_m());
  bytes.add(scene.rounding_m);
  add_surfaces(bytes, scene);
  add_luminaires(bytes, scene);
  return bytes.digest();
}

std::string space_key(const PreparedScene& scene, const RadiositySettings& settings,
                      const std::string& backend) {
  return fmt::format(
      "luxgate look {}\nnumbers {} {}\ncompiler {}\ntrees {}\nbackend {} {}\nspace {}\n"
      "settings {}\n",
      kLookFormat, kNumbersVersion, kNumbersDigest, __VERSION__, tree_builder_version(),
      backend.size(), backend, scene_digest(scene), settings_words(settings));
}

// The id keys the random numbers of a plane. Its length keeps it apart from what follows.
LookKey::LookKey(const std::string& space, const PlaneTask& task)
    : common_(fmt::format("{}plane {} {} {}\n", space, task.plane_id.size(), task.plane_id,
                          plane_digest(*task.grid))) {}

std::string LookKey::next(const std::vector<std::uint8_t>& active) {
  KeyBytes bytes;
  bytes.add(active);
  active_digest_ = sha256_hex(active_digest_ + bytes.digest());
  return fmt::format("{}look {} points {}\n", common_, looks_++, active_digest_);
}

}  // namespace calc
