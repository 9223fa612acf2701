#pragma once
// What a check needs before its first project, whatever it does with them.

#include "calc/base/file_reader.h"
#include "report/check/backend.h"
#include "report/check/drawing_device.h"
#include "report/check/in_order.h"
#include "report/shell/command.h"
#include "report/tools/check/check_options.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <vector>

namespace cli {

struct CheckSetup {
  std::vector<rules::RulePack> packs;
  check::BackendChoice backend;
  check::OpenBackend opened;
  check::Crew crew;  // projects at once; of each project so many spaces, too
  check::Hardware hardware;
  std::optional<calc::DrawingWork> pictures;  // of all projects, if they were planned
};

// First of all, before anything that a stranger may have written is read and a thread started.
// False after an error, which has been printed.
bool enter_sandbox_or_print(CheckOptions& options, const RunContext& context);

// options: with the day by which waivers end. Empty after an error, which has been printed.
std::optional<CheckSetup> set_up_or_print(const CheckOptions& options, const RunContext& context,
                                          const calc::FileReader& files);

// On which device pictures of rooms are drawn; setup: of the same options.
check::DrawingChoice choose_for_pictures(const CheckOptions& options, const calc::FileReader& files,
                                         CheckSetup& setup);

}  // namespace cli
