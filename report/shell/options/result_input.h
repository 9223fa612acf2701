#pragma once
// Result files as inputs of commands.

#include "calc/base/file_reader.h"
#include "report/document/document.h"

#include <optional>
#include <string>

namespace cli {

// Returns the result; empty after an error, which is printed.
std::optional<report::Document> read_result_or_print(const std::string& path,
                                                     const calc::FileReader& files);

// Returns a result for a gate: also empty, with an error, if only a part of the projects'
// requirements was judged in it.
std::optional<report::Document> read_whole_result_or_print(const std::string& path,
                                                           const calc::FileReader& files);

}  // namespace cli
