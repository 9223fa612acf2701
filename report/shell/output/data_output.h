#pragma once
// Outputs of commands that write a document in several formats: `--format KIND[=FILE]`.

#include "calc/base/diagnostics.h"
#include "report/shell/command/command.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace cli {

enum class DataFormat { text, csv, json, html, markdown };
struct DataOutput {
  DataFormat kind = DataFormat::text;
  std::string file;  // "" = standard output
};

// Returns --format and --json. help: its text about the kinds. has_markdown: true for the few
// commands with a summary for pull requests.
std::vector<Option> data_format_options(std::vector<DataOutput>& target, const std::string& help,
                                        bool has_markdown = false);
// Returns "" unless several kinds would go to standard output.
std::string data_output_problem(const std::vector<DataOutput>& outputs);

// Reports every file that cannot be written, or is an input or another output. inputs: files.
void check_data_outputs(const std::vector<DataOutput>& outputs, const std::set<std::string>& inputs,
                        calc::Diagnostics& diagnostics);

// Writes the files, each whole or not at all; a file that cannot be written is reported, the others
// are written nevertheless, and named on standard error unless `quiet`. Returns the text for
// standard output: text, unless another kind was requested.
std::string write_data_outputs(const std::vector<DataOutput>& outputs,
                               const std::function<std::string(DataFormat)>& render, bool quiet,
                               calc::Diagnostics& diagnostics);

}  // namespace cli
