#pragma once
// Which files a run writes: decided and checked before the calculation, written whole after it.

#include "report/cli/options.h"
#include "report/document/document.h"
#include "report/formats/console.h"

#include <set>
#include <string>
#include <vector>

namespace cli {

// --format items and the files of --output, in that order. Standard output has an empty file name
// and is not here.
std::vector<OutputFormat> planned_files(const Options& options);

// "" if every planned file can be written, else what is wrong: the same file twice, a file that is
// also an input, a folder that cannot be written. Touches nothing.
std::string check_outputs(const Options& options);

// Writes all planned files, and with --images a PNG and an EXR of every computed plane. inputs:
// files that were read and must not be overwritten. Returns one message per file that could not be
// written.
std::vector<std::string> write_outputs(const Options& options, const report::Document& document,
                                       const std::set<std::string>& inputs);

// "" if a file can be written there, else why not. Touches nothing.
std::string writability(const std::string& file);

// Equal for two paths to the same file, whether it exists or not.
std::string path_identity(const std::string& file);

// The document in one format. text: for FormatKind::text only; t: for text, HTML and Markdown.
std::string render(FormatKind kind, const report::Document& document,
                   const report::TextOptions& text = {}, const report::Texts& t = {});

// "<project file's stem>-<plane id>", other characters than letters, digits, '-', '_' and '.'
// (UTF-8) each replaced by one '_'.
std::string image_stem(const report::ProjectPart& project, const report::PlanePart& plane);

}  // namespace cli
