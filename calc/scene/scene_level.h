#pragma once
// Levels of dimming groups in scenes.

#include "calc/scene/project.h"

#include <string_view>
#include <utility>
#include <vector>

namespace calc {

// Returns the level of a group; 1 if it is not named. level_of_group: of LightScene.
double level_of(const std::vector<std::pair<std::string, double>>& level_of_group,
                std::string_view group);
// Returns the level in a scene; null: everything is at full output.
double level_in_scene(const LightScene* scene, std::string_view group);

}  // namespace calc
