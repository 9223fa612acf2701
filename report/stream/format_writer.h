#pragma once
// The interface of all formats: they render project by project, so that no project must be kept
// until the last one.

#include "report/document/document.h"
#include "report/stream/sink.h"
#include "report/stream/spill.h"

#include <functional>
#include <memory>
#include <string>

namespace report {

// Writes one document, whose frame must outlive the writer.
class FormatWriter {
 public:
  FormatWriter() = default;
  FormatWriter(const FormatWriter&) = delete;
  FormatWriter& operator=(const FormatWriter&) = delete;
  virtual ~FormatWriter() = default;

  // Adds a project, in the document's order. It may be dropped afterwards, unless the frame has a
  // revised document, to which it then belongs. Throws WriteFailure.
  virtual void add(const ProjectPart& project) = 0;
  // Ends the document, once, after the last project. Throws WriteFailure.
  virtual void finish(const DocumentEnd& end, Sink& sink) = 0;
};

using MakeFormatWriter =
    std::function<std::unique_ptr<FormatWriter>(const DocumentFrame&, const SpillPlace&)>;

// Returns a whole document, rendered in memory.
std::string render_whole(const Document& document, const MakeFormatWriter& make);

}  // namespace report
