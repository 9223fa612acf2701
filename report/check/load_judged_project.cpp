#include "report/check/load_judged_project.h"

#include "calc/radiosity/gather/settings.h"
#include "report/check/load_rules.h"
#include "report/document/one_source.h"

#include <utility>

namespace check {

std::optional<ProjectInBudget> load_in_budget(const std::string& path,
                                              const calc::FileReader& files,
                                              const std::vector<rules::RulePack>& packs,
                                              int replicates, const calc::Budget& budget,
                                              calc::Diagnostics& diagnostics) {
  std::optional<rules::JudgedProject> judged =
      rules::load_judged_project(files, path, packs, diagnostics, budget);
  if (!judged) return std::nullopt;
  std::optional<calc::ProjectNeed> need =
      calc::need_within(judged->project, replicates, budget, diagnostics);
  if (!need) return std::nullopt;
  return ProjectInBudget{std::move(*judged), std::move(need->memory)};
}

std::optional<calc::Project> load_judged_project(const std::string& path,
                                                 const calc::FileReader& files,
                                                 const std::vector<std::string>& rule_files,
                                                 calc::Diagnostics& diagnostics) {
  const std::vector<rules::RulePack> packs = load_rule_packs(rule_files, files, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  std::optional<ProjectInBudget> loaded = load_in_budget(
      path, files, packs, calc::RadiositySettings().replicates, calc::Budget(), diagnostics);
  if (!loaded) return std::nullopt;
  return std::move(loaded->judged.project);
}

std::vector<calc::Message> one_source_rows(const rules::JudgedProject& judged) {
  std::vector<calc::Message> rows;
  for (const rules::Requirement& requirement : judged.requirements)
    report::add_one_source_row(requirement, rows);
  for (const rules::BuildingQuestion& question : judged.buildings)
    report::add_one_source_row(question.requirement, rows);
  return rows;
}

}  // namespace check
