#pragma once
// What a check needs before its first project, whatever it does with them.

#include "calc/base/file_reader.h"
#include "report/check/plan.h"
#include "report/check/run.h"
#include "report/shell/command/command.h"
#include "report/tools/check/check_options.h"
#include "rules/pack/rule_pack.h"

#include <functional>
#include <optional>
#include <vector>

namespace cli {

// First of all, before anything that a stranger may have written is read and a thread started.
// False after an error, which has been printed.
bool enter_sandbox_or_print(CheckOptions& options, const RunContext& context);

// Told the plans of the projects, where `auto` needs them.
using SeePlans = std::function<void(const std::vector<check::ProjectPlan>&)>;

// With delivered rule packs and those of the options. Empty after an error, which has been printed.
// files: outlive it.
std::optional<check::Run> open_run_or_print(const CheckOptions& options, const RunContext& context,
                                            const calc::FileReader& files,
                                            SeePlans planned = nullptr);
// The same with these packs.
std::optional<check::Run> open_run_or_print(const CheckOptions& options, const RunContext& context,
                                            const calc::FileReader& files,
                                            std::vector<rules::RulePack> packs,
                                            SeePlans planned = nullptr);

}  // namespace cli
