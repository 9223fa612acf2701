#pragma once
// A project as every command that calculates it sees it.

#include "calc/diagnostics.h"
#include "calc/file_reader.h"
#include "calc/scene/project.h"
#include "rules/rule_pack.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// Reads a project and makes the planes of its workplaces by the packs. Empty if it cannot be read;
// other errors are in `diagnostics` only.
std::optional<calc::Project> load_judged_project(const std::string& path,
                                                 const calc::FileReader& files,
                                                 const std::vector<rules::RulePack>& packs,
                                                 calc::Diagnostics& diagnostics);

// The same with the delivered packs and those of `rule_files` (files or folders). Empty after any
// error.
std::optional<calc::Project> load_judged_project(const std::string& path,
                                                 const calc::FileReader& files,
                                                 const std::vector<std::string>& rule_files,
                                                 calc::Diagnostics& diagnostics);

}  // namespace cli
