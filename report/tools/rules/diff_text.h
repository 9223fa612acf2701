#pragma once
// The differences of two rule packs, and their effect on a project, for people and programs.

#include "report/tools/rules/project_effect.h"
#include "rules/pack/pack_diff.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

struct ShownDiff {
  const rules::RulePack& before;
  const rules::RulePack& after;
  std::vector<rules::PartDifference> parts;
  std::optional<ProjectEffect> effect;  // of --project
};

std::string diff_text(const ShownDiff& diff);
std::string diff_json(const ShownDiff& diff);

}  // namespace cli
