#pragma once
// How every format is rendered: project by project, so that none must be kept until the last one
// is there.

#include "report/document/document.h"
#include "report/stream/sink.h"
#include "report/stream/spill.h"

#include <functional>
#include <memory>
#include <string>

namespace report {

// Made for one document; its frame outlives the writer.
class FormatWriter {
 public:
  FormatWriter() = default;
  FormatWriter(const FormatWriter&) = delete;
  FormatWriter& operator=(const FormatWriter&) = delete;
  virtual ~FormatWriter() = default;

  // In the document's order. The project may be forgotten afterwards, unless the frame has a
  // revised document: then it is one of that. Throws WriteFailure.
  virtual void add(const ProjectPart& project) = 0;
  // Once, after the last project. Throws WriteFailure.
  virtual void finish(const DocumentEnd& end, Sink& sink) = 0;
};

using MakeFormatWriter =
    std::function<std::unique_ptr<FormatWriter>(const DocumentFrame&, const SpillPlace&)>;

// Of a document that is there as a whole, in memory.
std::string render_whole(const Document& document, const MakeFormatWriter& make);

}  // namespace report
