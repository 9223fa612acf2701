#pragma once
// How bright a dimming group is in a scene.

#include "calc/scene/project.h"

#include <string_view>
#include <utility>
#include <vector>

namespace calc {

// level_of_group: of LightScene. A group that is not named is at 1.
double level_of(const std::vector<std::pair<std::string, double>>& level_of_group,
                std::string_view group);
// scene: null, and everything is at full output.
double level_in_scene(const LightScene* scene, std::string_view group);

}  // namespace calc
