#include "report/tools/validate/validate.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_reader.h"
#include "calc/base/utf8.h"
#include "report/check/check_project.h"
#include "report/check/settings.h"
#include "report/shell/command/option_values.h"
#include "report/shell/options/open_backend.h"
#include "report/shell/options/project_options.h"
#include "report/shell/options/project_reader.h"
#include "report/shell/options/sandbox.h"
#include "report/shell/output/warning_tally.h"
#include "report/shell/process/print.h"
#include "rules/verdict/outcome.h"

#include <fmt/format.h>

#include <memory>

namespace cli {
namespace {

using rules::Outcome;

struct ValidateOptions {
  ProjectOptions input;
  calc::Budget budget;
  StrictWarnings strict;
  bool quiet = false;
  SandboxMode sandbox = SandboxMode::automatic;
  std::string date;  // a moment by SOURCE_DATE_EPOCH; "" = the clock's
};

ExitCode run_validate(const ValidateOptions& options, const Environment& environment) {
  if (!enter_sandbox_or_print(options.sandbox, {places_of(options.input), {}}, environment)) {
    return kNotJudged;
  }
  const std::string day = check::day_or_today(day_of_moment(options.date));
  const ProjectReader files(options.input);
  const auto packs = load_packs_or_print(options.input.rule_files, files);
  if (!packs) return kNotJudged;
  Outcome outcome = Outcome::nothing_asked;
  WarningTally warnings(options.strict);
  for (const std::string& path : options.input.projects) {
    const report::ProjectPart part =
        check::validate_project(path, files, *packs, day, options.budget,
                                options.strict.names(calc::DiagnosticId::one_source));
    print_diagnostics(part.diagnostics, options.quiet);
    warnings.add(part.diagnostics);
    if (!part.is_judged) outcome = graver(outcome, Outcome::not_judged);
    if (!part.is_judged || options.quiet) continue;
    const int count = count_warnings(part).all;
    print_result(
        fmt::format("{}: no error{}\n", calc::printable_path(path),
                    count == 0 ? "" : fmt::format(", {} warning{}", count, count == 1 ? "" : "s")));
  }
  warnings.print(options.quiet);
  outcome = graver(outcome, warnings.outcome());
  return exit_code_of(outcome);
}

}  // namespace

Command validate_command() {
  const auto options = std::make_shared<ValidateOptions>();
  Command command{"validate", "Check projects for errors without calculating"};
  options->input.takes_standard_input = true;
  command.places = {projects_place(options->input)};
  command.options = project_options(options->input);
  command.config = &options->input.config;
  add(command.options, {limit_option(options->budget), strict_option(options->strict),
                        sandbox_option(options->sandbox), quiet_option_with_count(options->quiet)});
  command.examples = {{"luxgate validate office.xml --strict", "Warnings count, too"}};
  command.exit_codes = {{0, "no error"},
                        {2, "at least one error, or a warning that --strict makes count"}};
  command.complete_projects = [options] { return complete_projects(options->input); };
  command.complete = [options](const Environment& environment) {
    return take_source_date(environment.source_date_epoch, options->date);
  };
  command.run = [options](const RunContext& context) {
    return run_validate(*options, context.environment);
  };
  return command;
}

}  // namespace cli
