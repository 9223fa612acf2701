#include "report/cli/load_judged_project.h"

#include "calc/scene/project_xml.h"
#include "report/cli/load_rules.h"
#include "rules/workplace.h"

namespace cli {

std::optional<calc::Project> load_judged_project(const std::string& path,
                                                 const calc::FileReader& files,
                                                 const std::vector<rules::RulePack>& packs,
                                                 calc::Diagnostics& diagnostics) {
  std::optional<calc::Project> project = calc::load_project(files, path, diagnostics);
  if (project) rules::make_workplace_planes(*project, packs, diagnostics);
  return project;
}

std::optional<calc::Project> load_judged_project(const std::string& path,
                                                 const calc::FileReader& files,
                                                 const std::vector<std::string>& rule_files,
                                                 calc::Diagnostics& diagnostics) {
  const std::vector<rules::RulePack> packs = load_rule_packs(rule_files, files, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  std::optional<calc::Project> project = load_judged_project(path, files, packs, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return project;
}

}  // namespace cli
