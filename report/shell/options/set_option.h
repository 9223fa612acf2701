#pragma once
// --set: values that attributes of projects have instead of those in their files.

#include "calc/base/file_reader.h"
#include "report/check/set_values.h"
#include "report/shell/command/command.h"
#include "report/shell/options/project_options.h"

#include <string_view>
#include <vector>

namespace cli {

Option set_option(std::vector<check::SetValue>& set);
// False after an error, which has been printed: a project cannot have these values. option: whose
// they are, "set".
bool check_values_or_print(const ProjectOptions& input, const std::vector<check::SetValue>& set,
                           std::string_view option, const calc::FileReader& files);

}  // namespace cli
