#include "report/check/load_judged_project.h"

#include "report/check/load_rules.h"

#include <utility>

namespace check {

std::optional<calc::Project> load_judged_project(const std::string& path,
                                                 const calc::FileReader& files,
                                                 const std::vector<std::string>& rule_files,
                                                 calc::Diagnostics& diagnostics) {
  const std::vector<rules::RulePack> packs = load_rule_packs(rule_files, files, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  std::optional<rules::JudgedProject> judged =
      rules::load_judged_project(files, path, packs, diagnostics);
  if (!judged) return std::nullopt;
  return std::move(judged->project);
}

}  // namespace check
