#pragma once
// Distinguishes scenes by everything that light paths depend on.

#include "calc/radiosity/sampling/random.h"
#include "calc/scene/prepared_scene.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace calc {

// A running 64-bit hash. It detects mistakes, not manipulation.
class Fingerprint {
 public:
  void add(std::uint64_t word) { bits_ = mix_bits(bits_ ^ mix_bits(word)); }
  void add(double value);
  void add(std::string_view bytes);  // with its length
  std::uint64_t bits() const { return bits_; }

 private:
  std::uint64_t bits_ = 0;
};

// Returns the fingerprint of surfaces, reflectances, luminaires with their photometry, dimming
// groups and local origin; not of the planes, which may change. is_unlit: as given to the Emitter.
std::uint64_t scene_fingerprint(const PreparedScene& scene, std::span<const std::uint8_t> is_unlit);

}  // namespace calc
