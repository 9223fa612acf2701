#include "report/tools/report/report.h"

#include "calc/base/file_reader.h"
#include "report/result_file/redact.h"
#include "report/shell/option_values.h"
#include "report/shell/outputs.h"
#include "report/shell/print.h"
#include "report/shell/result_input.h"

#include <memory>
#include <optional>

namespace cli {
namespace {

ExitCode run_report(const ReportOptions& asked, const Environment& environment) {
  ReportOptions options = asked;
  const std::string output_problem = check_outputs(options.output, {options.result_file});
  if (!output_problem.empty()) {
    print_error(calc::DiagnosticId::output_not_possible, output_problem);
    return kNotJudged;
  }
  std::optional<report::Document> document =
      read_result_or_print(options.result_file, calc::DiskFileReader());
  if (!document) return kNotJudged;
  if (options.output.redact) report::redact(*document);
  for (const report::ProjectPart& project : document->projects) {
    print_diagnostics(project.diagnostics, options.output.quiet);
  }
  options.output.are_messages_printed = !options.output.quiet;
  const bool is_written =
      write_results(options.output, environment, *document, {path_identity(options.result_file)});
  return is_written ? kAllMet : kNotJudged;
}

}  // namespace

Command report_syntax(ReportOptions& options) {
  Command command{"report", "Render a result again in other formats, without calculating"};
  command.places = {
      {"result", "RESULT.json", "A file that 'check --format json' wrote", &options.result_file}};
  command.options = output_options(options.output);
  add(command.options, {passes_option(options.output.lists_passes),
                        color_option(options.output.color), quiet_option(options.output.quiet)});
  command.footer =
      "Exit codes: 0 written, whatever the verdicts are; 2 an error, also a result whose verdicts\n"
      "or counts do not follow from its numbers.";
  command.complete = [&options](const Environment&) {
    return output_contradiction(options.output);
  };
  return command;
}

Command report_command() {
  const auto options = std::make_shared<ReportOptions>();
  Command command = report_syntax(*options);
  command.run = [options](const RunContext& context) {
    return run_report(*options, context.environment);
  };
  return command;
}

}  // namespace cli
