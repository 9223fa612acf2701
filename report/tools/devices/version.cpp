#include "report/tools/devices/version.h"

#include "calc/base/numbers_version.h"
#include "calc/rays/instruction_set.h"
#include "calc/rays/triangle_tree.h"
#include "gpu/device/egl_context.h"
#include "report/document/program_version.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/print.h"
#include "report/text/json_layout.h"
#include "report/tools/devices/devices.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace cli {

// LUXGATE_COMPILER and LUXGATE_BUILD_TYPE come from CMake.
std::string version_text(bool as_json) {
  const std::string builder = calc::tree_builder_version();
  if (as_json) {
    return report::json_layout(
        nlohmann::ordered_json{{"luxgate", report::program_version()},
                               {"compiler", LUXGATE_COMPILER},
                               {"build_type", LUXGATE_BUILD_TYPE},
                               {"numbers_version", calc::kNumbersVersion},
                               {"trees", builder},
                               {"instruction_set", calc::instruction_set()},
                               {"instruction_sets", calc::instruction_sets()},
                               {"opengl_devices", devices_json(gpu::list_devices())}});
  }
  return fmt::format(
      "luxgate {}\nnumbers    version {}\ncompiler   {}\nbuild type {}\ntrees      {}\nvectors    "
      "{}\n",
      report::program_version(), calc::kNumbersVersion, LUXGATE_COMPILER, LUXGATE_BUILD_TYPE,
      builder, calc::instruction_set());
}

Command version_command() {
  const auto as_json = std::make_shared<bool>(false);
  Command command{"version", "Print versions of the program and libraries"};
  command.options = text_or_json_options(*as_json);
  command.examples = {{"luxgate version --json", "The same, with OpenGL devices"}};
  command.exit_codes = {{0, "printed"}, {2, "an error"}};
  command.run = [as_json](const RunContext&) {
    return print_outcome({kAllMet, version_text(*as_json), {}});
  };
  return command;
}

}  // namespace cli
