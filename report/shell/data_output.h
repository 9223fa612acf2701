#pragma once
// Outputs of commands that write one document in several formats: `--format KIND[=FILE]`.

#include "calc/base/diagnostics.h"

#include <functional>
#include <string>
#include <vector>

namespace cli {

enum class DataFormat { text, csv, json, html };
struct DataOutput {
  DataFormat kind = DataFormat::text;
  std::string file;  // "" = standard output
};

// Of "KIND" or "KIND=FILE"; adds to `target`. A ValueParser of option_values.h, which cannot be
// included here: it needs Options, and those hold DataOutput.
std::function<std::string(const std::string& text)> data_output(std::vector<DataOutput>& target);

// Writes the files, each whole or not at all; a file that cannot be written is reported, and the
// others are written all the same. What is for standard output comes back: text, unless another
// kind was asked for.
std::string write_data_outputs(const std::vector<DataOutput>& outputs,
                               const std::function<std::string(DataFormat)>& render,
                               calc::Diagnostics& diagnostics);

}  // namespace cli
