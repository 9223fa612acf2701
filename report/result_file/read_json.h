#pragma once
// json_writer() backwards: a result file becomes a document again.

#include "report/document/document.h"

#include <optional>
#include <string>
#include <string_view>

namespace report {

// Rendering the document gives what the original would have given. Keys that are unknown are passed
// over, since later versions may add some; whatever is missing, of another type or out of range is
// a problem, and so is a verdict, a count or a mark that does not follow from the rest
// (contradiction.h, written_check.h). Empty: `problem` says what is wrong and where, as a JSON
// pointer ("/projects/0/path: a text is needed"). name: of the file, which tells what it is where
// its contents do not; "" = not known.
std::optional<Document> read_json(std::string_view bytes, std::string& problem,
                                  std::string_view name = "");

}  // namespace report
