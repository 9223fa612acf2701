#pragma once
// The files that a run writes: planned and checked before the calculation, written while its
// projects come, each whole or not at all.

#include "report/document/document.h"
#include "report/shell/output/output_options.h"
#include "report/stream/format_writer.h"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace cli {

// Returns "" if every planned file can be written, else what is wrong: the same file twice, a file
// that is also an input, a folder that cannot be written. Touches nothing. inputs: files that will
// be read.
std::string check_outputs(const OutputOptions& options, const std::vector<std::string>& inputs);

// Returns the files and folders that the planned files, and temporary ones, need.
std::vector<std::string> written_rooms(const OutputOptions& options);
// Opens temporary files for a process that cannot open them later.
void open_spill_files(OutputOptions& options);

// Returns "" if a file can be written there, else the reason. Touches nothing.
std::string writability(const std::string& file);

// Returns equal texts for two paths to the same file, whether it exists or not.
std::string path_identity(const std::string& file);

// Prints a project's errors and warnings to standard error. If that is a terminal, and text of
// several rooms goes to standard output, warnings of a kind share a line: see folded_warnings.h. A
// log has them all.
void print_messages(const report::ProjectPart& project, const OutputOptions& options,
                    const Environment& environment);

class OutputFiles;

// All planned files, with --images a PNG and an EXR of every computed plane, and the text for
// standard output. Every project is rendered into all formats at once and may then be dropped. The
// files of formats appear at the end; images, and pages of --html-split, with their project: they
// stay if the run ends early.
class ResultFiles {
 public:
  ResultFiles(const OutputOptions& options, const Environment& environment,
              report::DocumentFrame frame);
  ResultFiles(const ResultFiles&) = delete;
  ResultFiles& operator=(const ResultFiles&) = delete;
  ~ResultFiles();

  // Adds a project, in the frame's order. inputs: at least the files read since the previous call;
  // they are not overwritten. check_outputs() knows the files on the command line; files that a
  // later project reads are not known and may be overwritten by an image or a page of this one:
  // that is an error at the end.
  void add(const report::ProjectPart& project, const std::set<std::string>& inputs);
  // Ends the files, once. Returns false after an error, which is printed; the other formats are
  // written nevertheless.
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

// Writes a whole document in the same way.
bool write_results(const OutputOptions& options, const Environment& environment,
                   const report::Document& document, const std::set<std::string>& inputs);

// Returns the text with each character other than letters, digits, '-', '_' and '.' (UTF-8)
// replaced by one '_'.
std::string safe_name(const std::string& wanted);

// Returns "<project file's stem>-<plane id>" as a safe_name().
std::string image_stem(const report::ProjectPart& project, const report::PlanePart& plane);

}  // namespace cli
