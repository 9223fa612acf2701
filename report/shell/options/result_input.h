#pragma once
// Result files as inputs of commands.

#include "calc/base/file_reader.h"
#include "report/document/document.h"

#include <optional>
#include <string>

namespace cli {

// Empty after an error, which has been printed.
std::optional<report::Document> read_result_or_print(const std::string& path,
                                                     const calc::FileReader& files);

// The same of what a gate compares with, or has compared: also empty, with an error, if only a part
// of what the projects require was judged in it.
std::optional<report::Document> read_whole_result_or_print(const std::string& path,
                                                           const calc::FileReader& files);

}  // namespace cli
