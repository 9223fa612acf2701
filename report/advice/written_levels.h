#pragma once
// Writes advised levels into the text of a project, and checks that the project has them.

#include "report/advice/find_advice.h"
#include "report/check/scene_levels.h"
#include "report/document/document.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// Returns the levels. part: the current project. Names that the text needs are new in it.
check::SceneLevels levels_of(const SceneAdvice& advice, const report::ProjectPart& part);

// All scenes with levels in one text. Empty: `problem` says why.
struct LevelsText {
  std::optional<std::string> text;
  std::string problem;
};
LevelsText with_levels(const std::string& bytes, const std::string& file,
                       const std::vector<SceneAdvice>& scenes, const report::ProjectPart& part);

// Returns a check of levels in this text, which must outlive it, as must all other arguments.
CheckLevels levels_check(const std::string& bytes, const std::string& file,
                         const report::ProjectPart& part, const CheckText& check);

// Returns "" or why the levels are not those of the luminaires in the changed project: not every
// luminaire can be given a group in the text of the file.
calc::Message not_dimmed(const SceneAdvice& advice, const check::SceneLevels& levels,
                         const report::ProjectPart& changed);

// Returns requirements that pass now, or should pass, and do not in the written project as a whole;
// "" = none. Each scene was checked alone.
std::string lost_by_writing(const std::vector<SceneAdvice>& scenes,
                            const report::ProjectPart& before, const report::ProjectPart& after);

}  // namespace cli
