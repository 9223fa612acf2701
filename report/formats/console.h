#pragma once
// The document as a table for terminals and logs: verdicts first, one line per requirement; those
// of workplaces that pass share lines, see folded_passes.h.

#include "report/document/document.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <memory>
#include <string>

namespace report {

struct TextOptions {
  bool colour = false;  // ANSI colours, beside words and symbols, never instead of them
  int width = 0;  // columns of the terminal; 0: as wide as needed. Names are shortened, numbers
                  // never, and notes take more lines
  bool lists_passes = false;  // each by itself; else those of a workplace share a line
  bool has_messages = true;   // warnings and errors below each table; else they are said elsewhere
};

// UTF-8, every line ends in '\n'. Holds the table of each project and one summary line, which
// counts the warnings.
std::unique_ptr<FormatWriter> text_writer(const DocumentFrame& frame, const SpillPlace& place,
                                          const TextOptions& options, const Texts& t);

// What the document's revision did, as it stands at the head of that; "" without one.
std::string render_revision_text(const Texts& t, const Document& document, bool colour);

}  // namespace report
