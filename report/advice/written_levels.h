#pragma once
// Advised levels in the text of a project, and whether the project then is what was meant.

#include "report/advice/find_advice.h"
#include "report/check/scene_levels.h"
#include "report/document/document.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// part: of the project as it is. Names that the text needs are none that it has.
check::SceneLevels levels_of(const SceneAdvice& advice, const report::ProjectPart& part);

// All scenes that have levels, in one text. Empty: `problem` says why.
struct LevelsText {
  std::optional<std::string> text;
  std::string problem;
};
LevelsText with_levels(const std::string& bytes, const std::string& file,
                       const std::vector<SceneAdvice>& scenes, const report::ProjectPart& part);

// Levels of this text, which outlives it, as is all else here.
CheckLevels levels_check(const std::string& bytes, const std::string& file,
                         const report::ProjectPart& part, const CheckText& check);

// "" or why the levels are not those of the luminaires in the changed project: not every luminaire
// can be given a group in the text of the file.
calc::Message not_dimmed(const SceneAdvice& advice, const check::SceneLevels& levels,
                         const report::ProjectPart& changed);

// What passes now, or was said to pass, and does not in the written project as a whole; "" = all
// does. Each scene was checked alone.
std::string lost_by_writing(const std::vector<SceneAdvice>& scenes,
                            const report::ProjectPart& before, const report::ProjectPart& after);

}  // namespace cli
