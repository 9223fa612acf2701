#pragma once
// The document as a table for terminals and logs: verdicts first, one line per requirement; passing
// requirements of workplaces share lines, see folded_passes.h.

#include "report/document/document.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <memory>
#include <string>

namespace report {

struct TextOptions {
  bool colour = false;  // ANSI colours, beside words and symbols, never instead of them
  int width = 0;  // columns of the terminal; 0: as wide as needed. Names are shortened, numbers
                  // never, notes take more lines, and of rooms less is shown: no line is wider
                  // than a terminal of 40 columns or more
  bool lists_passes = false;  // each by itself; else those of a workplace share a line
  bool shows_notes = false;   // of several rooms: also notes on method, and every doubt by itself
  bool has_messages = true;   // warnings and errors below each table; else they are said elsewhere
};

// Writes UTF-8 in which every line ends in '\n': the table of each project and one summary line,
// which counts the warnings.
std::unique_ptr<FormatWriter> text_writer(const DocumentFrame& frame, const SpillPlace& place,
                                          const TextOptions& options, const Texts& t);

// Returns the changes of the document's revision, for the head of the document; "" without one.
// terminal_width: as TextOptions::width.
std::string render_revision_text(const Texts& t, const Document& document, bool colour,
                                 int terminal_width = 0);

}  // namespace report
