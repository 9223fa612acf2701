#pragma once
// A project for commands that calculate its planes without judging them.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/scene/project.h"
#include "rules/binding/judged_project.h"

#include <optional>
#include <string>
#include <vector>

namespace check {

// See rules::load_judged_project(), with the delivered packs and those of `rule_files` (files or
// folders). Empty after any error, also of the requirements, which are not handed on.
std::optional<calc::Project> load_judged_project(const std::string& path,
                                                 const calc::FileReader& files,
                                                 const std::vector<std::string>& rule_files,
                                                 calc::Diagnostics& diagnostics);

}  // namespace check
