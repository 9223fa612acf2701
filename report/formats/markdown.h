#pragma once
// A summary for a pull request.

#include "report/document/document.h"
#include "report/stream/format_writer.h"
#include "report/text/texts.h"

#include <memory>
#include <string>

namespace report {

// The verdict, a table of what did not pass, and a folded table of what did. Hosts cut long
// comments off, so each table has at most 100 rows and says what it leaves out.
std::unique_ptr<FormatWriter> markdown_writer(const DocumentFrame& frame, const SpillPlace& place,
                                              const Texts& t);

// What the document's revision did, as it stands at the head of that; "" without one.
std::string render_revision_markdown(const Texts& t, const Document& document);

}  // namespace report
