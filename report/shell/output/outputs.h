#pragma once
// Which files a run writes: decided and checked before the calculation, written while its projects
// come, each whole or not at all.

#include "report/document/document.h"
#include "report/shell/output/output_options.h"
#include "report/stream/format_writer.h"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace cli {

// "" if every planned file can be written, else what is wrong: the same file twice, a file that is
// also an input, a folder that cannot be written. Touches nothing.
// inputs: files that will be read.
std::string check_outputs(const OutputOptions& options, const std::vector<std::string>& inputs);

// Files and folders in which those that are planned, and what is needed meanwhile, are made.
std::vector<std::string> written_rooms(const OutputOptions& options);
// For who cannot open temporary files later.
void open_spill_files(OutputOptions& options);

// "" if a file can be written there, else why not. Touches nothing.
std::string writability(const std::string& file);

// Equal for two paths to the same file, whether it exists or not.
std::string path_identity(const std::string& file);

// A project's errors and warnings, to standard error. Where that is a terminal, and text of several
// rooms goes to standard output, warnings of a kind share a line: see folded_warnings.h. A log
// keeps them all.
void print_messages(const report::ProjectPart& project, const OutputOptions& options,
                    const Environment& environment);

class OutputFiles;

// All planned files, with --images a PNG and an EXR of every computed plane, and what goes to
// standard output. Every project is rendered into all formats at once and may then be forgotten.
// The files of formats appear at the end; images, and pages of --html-split, when their project
// comes: they stay if the run ends before its time.
class ResultFiles {
 public:
  ResultFiles(const OutputOptions& options, const Environment& environment,
              report::DocumentFrame frame);
  ResultFiles(const ResultFiles&) = delete;
  ResultFiles& operator=(const ResultFiles&) = delete;
  ~ResultFiles();

  // In the frame's order. inputs: files that were read since the call before, at least; they are
  // not overwritten. Those that the command line names are known to check_outputs(); what a later
  // project will read is not, and may be overwritten by an image or a page of this one: that is an
  // error at the end.
  void add(const report::ProjectPart& project, const std::set<std::string>& inputs);
  // Once. False after an error, which has been printed; the other formats are written all the same.
  bool finish(const report::DocumentEnd& end, const std::set<std::string>& inputs);

 private:
  bool print(const report::DocumentEnd& end);

  const report::DocumentFrame frame_;
  const double most_bytes_;
  const bool is_quiet_;
  std::unique_ptr<OutputFiles> files_;
  std::unique_ptr<report::FormatWriter> for_stdout_;  // null: nothing goes there
  std::string stdout_failure_;                        // of rendering
};

// The same of a document that is there as a whole.
bool write_results(const OutputOptions& options, const Environment& environment,
                   const report::Document& document, const std::set<std::string>& inputs);

// Other characters than letters, digits, '-', '_' and '.' (UTF-8) each replaced by one '_'.
std::string safe_name(const std::string& wanted);

// "<project file's stem>-<plane id>" as a safe_name().
std::string image_stem(const report::ProjectPart& project, const report::PlanePart& plane);

}  // namespace cli
