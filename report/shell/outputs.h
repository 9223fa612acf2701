#pragma once
// Which files a run writes: decided and checked before the calculation, written whole after it.

#include "report/document/document.h"
#include "report/shell/output_options.h"

#include <set>
#include <string>
#include <vector>

namespace cli {

// "" if every planned file can be written, else what is wrong: the same file twice, a file that is
// also an input, a folder that cannot be written. Touches nothing.
// inputs: files that will be read.
std::string check_outputs(const OutputOptions& options, const std::vector<std::string>& inputs);

// Writes all planned files, and with --images a PNG and an EXR of every computed plane. inputs:
// files that were read and must not be overwritten. Returns one message per file that could not be
// written.
std::vector<std::string> write_outputs(const OutputOptions& options,
                                       const report::Document& document,
                                       const std::set<std::string>& inputs);

// "" if a file can be written there, else why not. Touches nothing.
std::string writability(const std::string& file);

// Equal for two paths to the same file, whether it exists or not.
std::string path_identity(const std::string& file);

// All planned files and what goes to standard output. inputs: as above. False after an error, which
// has been printed; the other formats are written all the same.
bool write_results(const OutputOptions& options, const Environment& environment,
                   const report::Document& document, const std::set<std::string>& inputs);

// "<project file's stem>-<plane id>", other characters than letters, digits, '-', '_' and '.'
// (UTF-8) each replaced by one '_'.
std::string image_stem(const report::ProjectPart& project, const report::PlanePart& plane);

}  // namespace cli
