#pragma once
// Options of commands that write a document: formats, files, wording.

#include "calc/base/budget.h"
#include "report/formats/format.h"
#include "report/shell/command/command.h"
#include "report/shell/output/page_options.h"
#include "report/stream/spill.h"
#include "report/text/texts.h"

#include <memory>
#include <string>
#include <vector>

namespace cli {

// Names standard output as a file.
inline constexpr const char* kStandardOutput = "-";
inline constexpr const char* kOnlyOneToStdout =
    "--format: only one kind can go to standard output; give the others as KIND=FILE";

struct OutputFormat {
  const report::Format* format = nullptr;
  std::string file;  // "" = standard output; at most one format goes there
};

struct OutputOptions {
  std::vector<OutputFormat> formats;
  std::string folder;  // "" = none
  bool images = false;
  bool html_split = false;                                // HTML as an index and a page per room
  report::Language language = report::Language::english;  // of what people read
  DecimalSign decimal = DecimalSign::of_language;         // of the same formats
  report::PageStyle page;                                 // of HTML, PDF, XLSX, DXF and images
  bool redact = false;                                    // see report::redact()
  bool lists_passes = false;                              // see report::TextOptions
  bool shows_notes = false;                               // the same
  bool quiet = false;                                     // no text unless asked for
  bool are_messages_printed = false;  // to standard error: not again by text on standard output
  double most_bytes = calc::Budget()[calc::BudgetOf::output];  // of each file
  ColorChoice color = ColorChoice::automatic;
  // The printer for `pdf`, see open_printer_or_print() in pdf_printer.h.
  std::shared_ptr<report::PagePrinter> printer = nullptr;
  // For outputs without a folder, standard output and pipes; none: opened when needed.
  std::shared_ptr<report::SpillFiles> spill_files = nullptr;
};

std::vector<Option> output_options(OutputOptions& options);
// Returns --passes and --notes.
std::vector<Option> text_options(OutputOptions& options);
// Returns --color.
Option color_option(ColorChoice& target);
// Returns a contradiction between the options; "" = none.
std::string output_contradiction(const OutputOptions& options);

// Returns the wording of reports for people.
report::Texts report_texts(const OutputOptions& options);

// Returns --format items and the files of --output, in that order, without standard output, which
// has an empty file name.
std::vector<OutputFormat> planned_files(const OutputOptions& options);

// Returns the requested format for standard output, else text; null with --quiet.
const report::Format* stdout_format(const OutputOptions& options);

}  // namespace cli
