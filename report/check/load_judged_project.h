#pragma once
// Loads a project for a command: with its requirements, and within its budget.

#include "calc/base/budget.h"
#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/base/message.h"
#include "calc/forecast/memory_need.h"
#include "calc/scene/project.h"
#include "rules/binding/judged_project.h"

#include <optional>
#include <string>
#include <vector>

namespace check {

struct ProjectInBudget {
  rules::JudgedProject judged;
  calc::MemoryNeed memory;
};

// Loads a project as rules::load_judged_project() does. Also empty if it needs more points or
// memory than the budget has; none is then allocated. replicates: as in calc::RadiositySettings.
std::optional<ProjectInBudget> load_in_budget(const std::string& path,
                                              const calc::FileReader& files,
                                              const std::vector<rules::RulePack>& packs,
                                              int replicates, const calc::Budget& budget,
                                              calc::Diagnostics& diagnostics);

// Loads a project for commands that calculate planes without judging them, with the delivered
// packs, those of `rule_files` (files or folders) and the default budget. Empty after any error,
// also in requirements, which are not returned.
std::optional<calc::Project> load_judged_project(const std::string& path,
                                                 const calc::FileReader& files,
                                                 const std::vector<std::string>& rule_files,
                                                 calc::Diagnostics& diagnostics);

// Clauses of the requirements whose numbers rest on one public source, see
// report/document/one_source.h.
std::vector<calc::Message> one_source_rows(const rules::JudgedProject& judged);

}  // namespace check
