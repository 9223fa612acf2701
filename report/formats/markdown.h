#pragma once
// Writes a summary for a pull request.

#include "report/document/document.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <memory>
#include <string>

namespace report {

// Writes the verdict, a table of requirements that did not pass, and a folded table of the others.
// Hosts cut long comments, so each table has at most 100 rows and says how many it omits.
std::unique_ptr<FormatWriter> markdown_writer(const DocumentFrame& frame, const SpillPlace& place,
                                              const Texts& t);

// Returns the changes of the document's revision, for the head of the document; "" without one.
std::string render_revision_markdown(const Texts& t, const Document& document);

}  // namespace report
