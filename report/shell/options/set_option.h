#pragma once
// The option --set: values of projects' attributes that replace those in their files.

#include "calc/base/file_reader.h"
#include "report/check/set_values.h"
#include "report/shell/command/command.h"
#include "report/shell/options/project_options.h"

#include <string_view>
#include <vector>

namespace cli {

Option set_option(std::vector<check::SetValue>& set);
// Returns false after an error, which is printed: a project cannot have these values. option: name
// of the option, "set".
bool check_values_or_print(const ProjectOptions& input, const std::vector<check::SetValue>& set,
                           std::string_view option, const calc::FileReader& files);

}  // namespace cli
