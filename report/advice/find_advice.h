#pragma once
// Finds levels for every scene of a checked project, from the light of its planes.

#include "calc/scene/project.h"
#include "report/advice/kept_light.h"
#include "report/advice/scene_advice.h"
#include "report/document/document.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// Returns findings for a plane's requirements that count and are judged only from the light of its
// points, as a check with this light would.
std::vector<rules::Finding> judged_by_light(const report::PlanePart& plane, const PlaneLight& light,
                                            const std::vector<calc::LightScene>& scenes,
                                            double confidence);

struct AdviceSettings {
  int steps = 100;           // levels are multiples of 1 / steps
  double confidence = 0.95;  // of the check
  std::string scene;         // only this one; "" = all
  bool is_one_scene = false;
  std::function<bool()> is_stopped = [] { return false; };  // then what is returned says little
  // The cost to minimize; watts are replaced by lumens if a power is not known. kilowatt_hour:
  // every room that counts states its use.
  CostUnit unit = CostUnit::watt;
  // One trial of many: only whether there surely are no levels matters (`contradiction`), not why.
  bool is_trial = false;
};

// Checks the changed project with other random numbers. Empty: it could not be checked; `reason`
// says why.
using CheckLevels = std::function<std::optional<report::ProjectPart>(const SceneAdvice& advice,
                                                                     calc::Message& reason)>;

// Checks the text of a changed project in the same way.
using CheckText =
    std::function<std::optional<report::ProjectPart>(const std::string& text, std::string& reason)>;

// Returns the advice. part: judged. A scene's requirements that are waived, or only advice, are
// omitted.
std::vector<SceneAdvice> find_advice(const report::ProjectPart& part, const LightOfPlanes& light,
                                     const AdviceSettings& settings, const CheckLevels& check);

}  // namespace cli
