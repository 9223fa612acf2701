#pragma once
// Loads the rule packs of a run: those that are part of the program, and those of --rules.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "rules/pack/rule_pack.h"

#include <string>
#include <vector>

namespace check {

// Returns the files, and for a folder the *.xml files in it, in order of their names.
std::vector<std::string> rule_files(const std::vector<std::string>& paths,
                                    calc::Diagnostics& diagnostics);

// Returns the packs without errors; errors are reported.
std::vector<rules::RulePack> load_rule_packs(const std::vector<std::string>& paths,
                                             const calc::FileReader& files,
                                             calc::Diagnostics& diagnostics);

}  // namespace check
