#pragma once
// Reverses json_writer(): a result file becomes a document again.

#include "report/document/document.h"

#include <optional>
#include <string>
#include <string_view>

namespace report {

// Returns a document that renders like the original. Unknown keys are skipped, because later
// versions may add some. A missing key, another type or a value out of range is a problem, and so
// is a verdict, a count or a mark that does not follow from the rest (contradiction.h,
// written_check.h). Empty: `problem` says what is wrong and where, as a JSON pointer
// ("/projects/0/path: a text is needed"). name: of the file, which may tell its kind if the
// contents do not; "" = not known.
std::optional<Document> read_json(std::string_view bytes, std::string& problem,
                                  std::string_view name = "");

}  // namespace report
