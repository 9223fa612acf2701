#pragma once
// The setup of a check before its first project.

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

// Enters the sandbox, before any untrusted file is read and any thread started. Returns false after
// an error, which is printed.
bool enter_sandbox_or_print(CheckOptions& options, const RunContext& context);

// Receives the plans of the projects, if `auto` needs them.
using SeePlans = std::function<void(const std::vector<check::ProjectPlan>&)>;

// Opens a run with delivered rule packs and those of the options. Empty after an error, which is
// printed. files: must outlive it.
std::optional<check::Run> open_run_or_print(const CheckOptions& options, const RunContext& context,
                                            const calc::FileReader& files,
                                            SeePlans planned = nullptr);
// Opens a run with these packs.
std::optional<check::Run> open_run_or_print(const CheckOptions& options, const RunContext& context,
                                            const calc::FileReader& files,
                                            std::vector<rules::RulePack> packs,
                                            SeePlans planned = nullptr);

}  // namespace cli
