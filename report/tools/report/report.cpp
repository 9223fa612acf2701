#include "report/tools/report/report.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_reader.h"
#include "report/html/chapters/data_sheets.h"
#include "report/result_file/redact.h"
#include "report/revision/gate.h"
#include "report/revision/revise.h"
#include "report/shell/command/option_values.h"
#include "report/shell/options/gate_options.h"
#include "report/shell/options/result_input.h"
#include "report/shell/output/outputs.h"
#include "report/shell/output/pdf_printer.h"
#include "report/shell/process/print.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cli {
namespace {

ExitCode run_report(const ReportOptions& asked, const Environment& environment) {
  ReportOptions options = asked;
  std::vector<std::string> inputs{options.result_file};
  if (!options.baseline.empty()) inputs.push_back(options.baseline);
  if (!open_printer_or_print(options.output, environment)) return kNotJudged;
  if (options.sandbox != SandboxMode::off) open_spill_files(options.output);
  std::vector<std::string> read = inputs;
  if (options.output.page.sheets) {  // photometry files, which the result names
    const std::filesystem::path beside = std::filesystem::path(options.result_file).parent_path();
    read.push_back(beside.empty() ? "." : beside.string());
    read.emplace_back(".");
  }
  if (!enter_sandbox_or_print(options.sandbox, {read, written_rooms(options.output)},
                              environment)) {
    return kNotJudged;
  }
  const std::string output_problem = check_outputs(options.output, inputs);
  if (!output_problem.empty()) {
    print_error(calc::DiagnosticId::output_not_possible, output_problem);
    return kNotJudged;
  }
  const calc::DiskFileReader files;
  const bool is_compared = !options.baseline.empty();
  std::optional<report::Document> document =
      is_compared ? read_whole_result_or_print(options.result_file, files)
                  : read_result_or_print(options.result_file, files);
  if (!document) return kNotJudged;
  if (is_compared) {
    const auto baseline = read_whole_result_or_print(options.baseline, files);
    if (!baseline) return kNotJudged;
    document->revision = report::revise(*baseline, *document, options.baseline, options.gate);
  }
  if (options.output.page.sheets) {
    for (const report::ProjectPart& project : document->projects)
      options.output.page.sheets->see(project, options.result_file);
  }
  if (options.output.redact) report::redact(*document);
  for (const report::ProjectPart& project : document->projects) {
    print_messages(project, options.output, environment);
  }
  options.output.are_messages_printed = !options.output.quiet;
  std::set<std::string> identities;
  for (const std::string& input : inputs) identities.insert(path_identity(input));
  if (!write_results(options.output, environment, *document, identities)) return kNotJudged;
  const bool is_gate = options.gate.mode == report::GateMode::regression;
  return is_gate ? exit_code_of(report::gate_outcome(*document)) : kAllMet;
}

}  // namespace

Command report_syntax(ReportOptions& options) {
  Command command{"report", "Render a result again in other formats, without calculating"};
  command.places = {
      {"result", "RESULT.json", "A file that 'check --format json' wrote", &options.result_file}};
  command.options = output_options(options.output);
  add(command.options, {baseline_option(options.baseline)});
  add(command.options, gate_options(options.gate));
  add(command.options, text_options(options.output));
  add(command.options, {color_option(options.output.color), sandbox_option(options.sandbox),
                        quiet_option(options.output.quiet)});
  command.examples = {
      {"luxgate report result.json --language de --format html=bericht.html", "In German"},
      {"luxgate report result.json --baseline main.json --gate regression --format markdown",
       "What became worse since an earlier result, for a pull request"}};
  command.exit_codes = {
      {kAllMet, "written, whatever the verdicts are; with --gate regression it is as of 'check'"},
      {kNotMet, "with --gate regression: something became worse"},
      {kNotJudged,
       "an error, also a result whose verdicts or counts do not follow from its numbers"},
      {kUndecided, "with --gate regression: nothing failed, but a result is undecided"}};
  command.most_used = {"--format",   "--output", "--json",   "--language", "--paper",
                       "--baseline", "--gate",   "--redact", "--color",    "--quiet"};
  command.complete = [&options](const Environment&) {
    const std::string problem =
        gate_contradiction(options.gate, !options.baseline.empty(), "a --baseline");
    return problem.empty() ? output_contradiction(options.output) : problem;
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
