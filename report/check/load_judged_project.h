#pragma once
// A project as every command takes it: read, with what is required, and within its budget.

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

// See rules::load_judged_project(). Empty, too, after an error about more points or memory than the
// budget has, of which none has been taken then. replicates: as of calc::RadiositySettings.
std::optional<ProjectInBudget> load_in_budget(const std::string& path,
                                              const calc::FileReader& files,
                                              const std::vector<rules::RulePack>& packs,
                                              int replicates, const calc::Budget& budget,
                                              calc::Diagnostics& diagnostics);

// The same for commands that calculate planes without judging them, with the delivered packs and
// those of `rule_files` (files or folders), and the budget by default. Empty after any error, also
// of the requirements, which are not handed on.
std::optional<calc::Project> load_judged_project(const std::string& path,
                                                 const calc::FileReader& files,
                                                 const std::vector<std::string>& rule_files,
                                                 calc::Diagnostics& diagnostics);

// Clauses of the requirements whose numbers rest on one public source, see
// report/document/one_source.h.
std::vector<calc::Message> one_source_rows(const rules::JudgedProject& judged);

}  // namespace check
