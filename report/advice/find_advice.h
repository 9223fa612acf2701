#pragma once
// Levels for every scene of a project that has been checked, from the light of its planes.

#include "calc/scene/project.h"
#include "report/advice/kept_light.h"
#include "report/advice/scene_advice.h"
#include "report/document/document.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// Of a plane's requirements that count and are judged from the light of its points alone, as a
// check with this light would.
std::vector<rules::Finding> judged_by_light(const report::PlanePart& plane, const PlaneLight& light,
                                            const std::vector<calc::LightScene>& scenes,
                                            double confidence);

struct AdviceSettings {
  int steps = 100;           // levels are multiples of 1 / steps
  double confidence = 0.95;  // of the check
  std::string scene;         // only this one; "" = all
  bool is_one_scene = false;
  std::function<bool()> is_stopped = [] { return false; };  // then what is returned says little
  // What is to be least; watts give way to lumens where a power is not known. kilowatt_hour: every
  // room that counts states its use.
  CostUnit unit = CostUnit::watt;
  // One of many: nobody asks why there are no levels, only whether there surely are none
  // (`contradiction`).
  bool is_trial = false;
};

// The changed project, checked with other random numbers. Empty: it could not be; `reason` says
// why.
using CheckLevels = std::function<std::optional<report::ProjectPart>(const SceneAdvice& advice,
                                                                     calc::Message& reason)>;

// Likewise of the changed project's text.
using CheckText =
    std::function<std::optional<report::ProjectPart>(const std::string& text, std::string& reason)>;

// part: judged. A scene's requirements that are waived, or only advice, are left out.
std::vector<SceneAdvice> find_advice(const report::ProjectPart& part, const LightOfPlanes& light,
                                     const AdviceSettings& settings, const CheckLevels& check);

}  // namespace cli
