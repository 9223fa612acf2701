#pragma once
// Makes the key under which a plane's sampling round is stored: all that it depends on, as text.

#include "calc/proofs/solve_plan.h"
#include "calc/radiosity/gather/settings.h"
#include "calc/scene/prepared_scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace calc {

// Returns SHA-256 of everything in the scene that light depends on: surfaces, reflectances,
// luminaires with their photometry and channels, local origin; not the names of channels and bodies
// or the maintenance factors, because they only name results or weigh them later.
std::string scene_digest(const PreparedScene& scene);

// Returns the part common to a space's keys. backend: the code that computes, with versions.
std::string space_key(const PreparedScene& scene, const RadiositySettings& settings,
                      const std::string& backend);

// The keys of one plane, round after round.
class LookKey {
 public:
  // space: space_key().
  LookKey(const std::string& space, const PlaneTask& task);

  // Returns the next round's key. active: [point], 1: the round adds to it.
  std::string next(const std::vector<std::uint8_t>& active);

 private:
  std::string common_;
  std::string active_digest_;  // of all rounds so far
  int looks_ = 0;
};

}  // namespace calc
