#pragma once
// Options of all commands that compare a result with an earlier one.

#include "report/document/revision.h"
#include "report/shell/command/command.h"

#include <string>
#include <vector>

namespace cli {

// Returns --baseline.
Option baseline_option(std::string& target);
// Returns --gate, --allow-worse and --accept-weaker.
std::vector<Option> gate_options(report::Gate& gate);

// Returns what is wrong with them together, "" = nothing. is_compared: there is a result to compare
// with; with: options that would give it, for the message.
std::string gate_contradiction(const report::Gate& gate, bool is_compared, const std::string& with);

}  // namespace cli
