#include "report/cli/run.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/rays/instruction_set.h"
#include "report/check/backend.h"
#include "report/cli/commands.h"
#include "report/shell/command/command_line.h"
#include "report/shell/process/print.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
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

// The first file that is opened would get the number of a standard one that the caller has closed,
// and what is told would be written into it. To a closed output writing fails, as to a full disk.
// False: that cannot be had either, and nothing must be written.
bool open_closed_standard_files() {
  constexpr std::array kInPlaceOf = {"/dev/null", "/dev/full", "/dev/null"};
  for (int file = 0; file < 3; ++file) {
    if (fcntl(file, F_GETFD) != -1 || errno != EBADF) continue;
    // Of the numbers that are free the lowest is given.
    const char* const path = kInPlaceOf[static_cast<std::size_t>(file)];
    if (open(path, file == 0 ? O_RDONLY : O_WRONLY) != file) return false;
  }
  return true;
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  try {
    if (!open_closed_standard_files()) return kNotJudged;
    const Environment environment = read_environment();
    const std::vector<Command> commands = all_commands();
    const ParsedLine parsed = parse_command_line(commands, argc, argv, environment);
    if (parsed.command == nullptr) {
      tell("{}", parsed.err);
      return print_result(parsed.out) ? parsed.exit_code : kNotJudged;
    }
    return run(*parsed.command, environment, commands);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "luxgate: error[not-enough-memory]: this machine has not enough memory\n");
    return kNotJudged;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "luxgate: error[internal-error]: %s\n", error.what());
    return kNotJudged;
  }
}

}  // namespace cli
