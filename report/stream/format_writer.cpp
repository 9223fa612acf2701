#include "report/stream/format_writer.h"

#include <utility>

namespace report {

std::string render_whole(const Document& document, const MakeFormatWriter& make) {
  const DocumentFrame frame = frame_of(document);
  const std::unique_ptr<FormatWriter> writer = make(frame, SpillPlace::memory());
  for (const ProjectPart& project : document.projects) writer->add(project);
  TextSink sink;
  writer->finish(end_of(document), sink);
  return std::move(sink.text);
}

}  // namespace report
