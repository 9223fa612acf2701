#pragma once
// The option --policy: conditions that the owner of the gate sets for every project.

#include "calc/base/file_reader.h"
#include "report/policy/policy.h"
#include "report/shell/command/command.h"

#include <optional>
#include <string>

namespace cli {

Option policy_option(std::string& target);
// Returns the policy; empty after an error, which is printed.
std::optional<report::Policy> read_policy_or_print(const std::string& file,
                                                   const calc::FileReader& files);

}  // namespace cli
