#pragma once
// Changes dimming levels in the text of a project file; everything else stays unchanged.

#include "calc/base/diagnostics.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace check {

struct SceneLevels {
  std::string scene;               // id; a scene that the file does not have is made
  bool takes_full_output = false;  // it becomes the scene of all that is asked of full output
  std::vector<std::pair<std::string, double>> level_of_group;  // (0..1]; "": of luminaires without
  std::string group_of_others;                                 // what these are called from then on
};

struct TextWithLevels {
  std::string text;         // of a project file, in UTF-8
  std::size_t grouped = 0;  // luminaires, or rows of them, that were given `group_of_others`
};

// Returns the text with these levels; existing levels of a scene are replaced, further ones added.
// Empty after an error: parse_xml() refuses the text.
std::optional<TextWithLevels> with_scene_levels(const std::string& bytes, const std::string& file,
                                                const SceneLevels& levels,
                                                calc::Diagnostics& diagnostics);

}  // namespace check
