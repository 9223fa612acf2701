#include "calc/scene/scene_level.h"

#include <algorithm>

namespace calc {

double level_of(const std::vector<std::pair<std::string, double>>& level_of_group,
                std::string_view group) {
  const auto named = std::find_if(level_of_group.begin(), level_of_group.end(),
                                  [&](const auto& level) { return level.first == group; });
  return named == level_of_group.end() ? 1.0 : named->second;
}

double level_in_scene(const LightScene* scene, std::string_view group) {
  return scene == nullptr ? 1.0 : level_of(scene->level_of_group, group);
}

}  // namespace calc
