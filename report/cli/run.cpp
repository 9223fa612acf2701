#include "report/cli/run.h"

#include "calc/rays/instruction_set.h"
#include "report/check/backend.h"
#include "report/cli/commands.h"
#include "report/shell/command_line.h"
#include "report/shell/print.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {
namespace {

ExitCode run(const Command& command, const Environment& environment,
             const std::vector<Command>& commands) {
  const std::optional<gpu::Fault> fault = check::find_gl_fault(environment.gl_fault);
  if (!fault) {
    print_error(calc::DiagnosticId::backend_not_available, "gpu",
                fmt::format("LUXGATE_GL_FAULT, which is for tests, is '{}'", environment.gl_fault));
    return kNotJudged;
  }
  const std::vector<std::string_view> here = calc::instruction_sets();
  const std::string_view wanted = calc::wanted_instruction_set();
  if (!wanted.empty() && std::find(here.begin(), here.end(), wanted) == here.end()) {
    print_error(calc::DiagnosticId::instruction_set_not_available, std::string(wanted),
                fmt::format("{}", fmt::join(here, ", ")));
    return kNotJudged;
  }
  return command.run({environment, *fault, &commands});
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  try {
    const Environment environment = read_environment();
    const std::vector<Command> commands = all_commands();
    const ParsedLine parsed = parse_command_line(commands, argc, argv, environment);
    if (parsed.command == nullptr) {
      tell("{}", parsed.err);
      return print_result(parsed.out) ? parsed.exit_code : kNotJudged;
    }
    return run(*parsed.command, environment, commands);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "luxgate: error[internal-error]: %s\n", error.what());
    return kNotJudged;
  }
}

}  // namespace cli
