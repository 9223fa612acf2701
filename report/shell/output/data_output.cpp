#include "report/shell/output/data_output.h"

#include "calc/base/diagnostic_ids.h"
#include "report/formats/write.h"
#include "report/shell/command/option_values.h"
#include "report/shell/output/output_options.h"
#include "report/shell/output/outputs.h"
#include "report/shell/process/print.h"

#include <fmt/format.h>

#include <algorithm>

namespace cli {
namespace {

ValueParser data_output(std::vector<DataOutput>& target, bool has_markdown) {
  std::vector<std::pair<std::string_view, DataFormat>> kinds = {{"text", DataFormat::text},
                                                                {"csv", DataFormat::csv},
                                                                {"json", DataFormat::json},
                                                                {"html", DataFormat::html}};
  if (has_markdown) kinds.emplace_back("markdown", DataFormat::markdown);
  std::vector<std::string> words;
  for (const auto& [name, kind] : kinds) words.emplace_back(name);
  const auto parse = [&target, kinds = std::move(kinds)](const std::string& text) -> std::string {
    const std::size_t equals = text.find('=');
    DataOutput output;
    const std::string problem = choice<DataFormat>(output.kind, kinds)(text.substr(0, equals));
    if (!problem.empty()) return problem;
    if (equals != std::string::npos) output.file = text.substr(equals + 1);
    if (equals != std::string::npos && output.file.empty())
      return "a file name is missing after '='";
    if (output.file == kStandardOutput) output.file.clear();
    target.push_back(output);
    return "";
  };
  return {parse, std::move(words)};
}

}  // namespace

std::vector<Option> data_format_options(std::vector<DataOutput>& target, const std::string& help,
                                        bool has_markdown) {
  const ValueParser parse = data_output(target, has_markdown);
  return {{"--format", "KIND[=FILE]", "Choose the output and its file: " + help, parse, true},
          {"--json", "", "Print JSON: the same as --format json",
           [parse](const std::string&) { return parse("json"); }}};
}

std::string data_output_problem(const std::vector<DataOutput>& outputs) {
  const auto to_stdout = std::count_if(
      outputs.begin(), outputs.end(), [](const DataOutput& output) { return output.file.empty(); });
  return to_stdout > 1 ? kOnlyOneToStdout : "";
}

void check_data_outputs(const std::vector<DataOutput>& outputs, const std::set<std::string>& inputs,
                        calc::Diagnostics& diagnostics) {
  std::set<std::string> taken;
  for (const std::string& input : inputs) taken.insert(path_identity(input));
  for (const DataOutput& output : outputs) {
    if (output.file.empty()) continue;
    std::string problem = writability(output.file);
    if (!taken.insert(path_identity(output.file)).second) {
      problem =
          fmt::format("'{}' is an input or another output and is not overwritten", output.file);
    }
    if (!problem.empty()) {
      diagnostics.report(calc::DiagnosticId::output_not_possible, {}, problem);
    }
  }
}

std::string write_data_outputs(const std::vector<DataOutput>& outputs,
                               const std::function<std::string(DataFormat)>& render, bool quiet,
                               calc::Diagnostics& diagnostics) {
  std::vector<std::string> written;
  DataFormat to_stdout = DataFormat::text;
  for (const DataOutput& output : outputs) {
    if (output.file.empty()) {
      to_stdout = output.kind;
      continue;
    }
    const std::string problem = report::write_file_atomically(output.file, render(output.kind));
    if (problem.empty()) {
      written.push_back(output.file);
      continue;
    }
    diagnostics.report(calc::DiagnosticId::output_not_possible, {},
                       fmt::format("cannot write '{}': {}", output.file, problem));
  }
  if (!quiet) tell_written(written);
  return render(to_stdout);
}

}  // namespace cli
