#pragma once
// What a look of a plane depends on, as text: the key under which it is stored.

#include "calc/proofs/solve_plan.h"
#include "calc/radiosity/gather/settings.h"
#include "calc/scene/prepared_scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace calc {

// SHA-256 of everything in the scene that light depends on: surfaces, reflectances, luminaires with
// their photometry and channels, local origin. Not what channels are called, nor their maintenance
// factors, nor what bodies are called: they only name results or weigh them later.
std::string scene_digest(const PreparedScene& scene);

// What all looks of a space have in common. backend: who computes, with versions.
std::string space_key(const PreparedScene& scene, const RadiositySettings& settings,
                      const std::string& backend);

// Of one plane, look after look.
class LookKey {
 public:
  // space: space_key().
  LookKey(const std::string& space, const PlaneTask& task);

  // Of the next look, the first when called first; active: [point], 1: the look adds to it.
  std::string next(const std::vector<std::uint8_t>& active);

 private:
  std::string common_;
  std::string active_digest_;  // of all looks so far
  int looks_ = 0;
};

}  // namespace calc
