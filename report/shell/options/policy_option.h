#pragma once
// --policy: what the owner of the gate wants of every project.

#include "calc/base/file_reader.h"
#include "report/policy/policy.h"
#include "report/shell/command/command.h"

#include <optional>
#include <string>

namespace cli {

Option policy_option(std::string& target);
// Empty after an error, which has been printed.
std::optional<report::Policy> read_policy_or_print(const std::string& file,
                                                   const calc::FileReader& files);

}  // namespace cli
