#include "report/cli/commands.h"

#include "report/tools/advise/advise.h"
#include "report/tools/check/check.h"
#include "report/tools/compare/compare.h"
#include "report/tools/config/config.h"
#include "report/tools/converge/converge.h"
#include "report/tools/devices/devices.h"
#include "report/tools/devices/version.h"
#include "report/tools/export/export.h"
#include "report/tools/geometry/geometry.h"
#include "report/tools/help/help.h"
#include "report/tools/import/import.h"
#include "report/tools/init/init.h"
#include "report/tools/photometry/photometry.h"
#include "report/tools/plan/plan.h"
#include "report/tools/policy/policy.h"
#include "report/tools/report/report.h"
#include "report/tools/rules/rules.h"
#include "report/tools/schema/schema.h"
#include "report/tools/selftest/selftest.h"
#include "report/tools/store/store.h"
#include "report/tools/submit/submit.h"
#include "report/tools/sweep/sweep.h"
#include "report/tools/validate/validate.h"
#include "report/tools/vpl/vpl.h"
#include "report/tools/watch/watch.h"

#include <string>

namespace cli {

std::vector<Command> all_commands() {
  std::vector<Command> commands = {
      check_command(),  watch_command(),      sweep_command(),    advise_command(),
      report_command(), plan_command(),       submit_command(),   validate_command(),
      vpl_command(),    converge_command(),   selftest_command(), compare_command(),
      export_command(), photometry_command(), geometry_command(), rules_command(),
      policy_command(), explain_command(),    config_command(),   store_command(),
      schema_command(), import_command(),     init_command(),     devices_command(),
      version_command()};
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  for (const char* name : {"help", "completions", "man"}) names.emplace_back(name);
  commands.push_back(help_command(names));
  commands.push_back(completions_command());
  commands.push_back(man_command(names));
  return commands;
}

}  // namespace cli
