#pragma once
// A project ready to be judged: with the planes of its workplaces and all requirements.

#include "calc/base/budget.h"
#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/scene/project.h"
#include "rules/catalogue/requirement.h"
#include "rules/pack/rule_pack.h"
#include "rules/verdict/judge_buildings.h"

#include <optional>
#include <string>
#include <vector>

namespace rules {

struct JudgedProject {
  calc::Project project;
  std::vector<Requirement> requirements;    // see bind_requirements()
  std::vector<BuildingQuestion> buildings;  // see bind_buildings()
};

// Returns the project; empty exactly if there is an error. All errors of the file, in shapes and in
// requirements, are reported in the order of its lines.
std::optional<JudgedProject> load_judged_project(const calc::FileReader& files,
                                                 const std::string& path,
                                                 const std::vector<RulePack>& packs,
                                                 calc::Diagnostics& diagnostics,
                                                 const calc::Budget& budget = {});

}  // namespace rules
