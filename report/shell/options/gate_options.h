#pragma once
// A result beside an earlier one: the options of all commands that compare them.

#include "report/document/revision.h"
#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

// --baseline.
Option baseline_option(std::string& target);
// --gate, --allow-worse and --accept-weaker.
std::vector<Option> gate_options(report::Gate& gate);

// What is wrong with them together, "" = nothing. is_compared: there is something to compare with;
// with: the options that would give it, for the message.
std::string gate_contradiction(const report::Gate& gate, bool is_compared, const std::string& with);

}  // namespace cli
