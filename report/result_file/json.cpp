#include "report/result_file/json.h"

#include "report/document/one_source.h"
#include "report/result_file/json_writer.h"
#include "report/stream/json_list.h"
#include "report/text/json_layout.h"

#include <string>
#include <vector>

namespace report {
namespace {

class ResultWriter : public FormatWriter {
 public:
  ResultWriter(const DocumentFrame& frame, const SpillPlace& place)
      : frame_(frame), projects_(place, 1) {}

  void add(const ProjectPart& project) override { projects_.add(json_of(project)); }

  // The keys are those of a document; of one without projects, all that is said of projects is
  // filled in.
  void finish(const DocumentEnd& end, Sink& sink) override {
    Document head;
    head.provenance = end.provenance;
    if (frame_.revised != nullptr) head.revision = frame_.revised->revision;
    OrderedJson json = json_of(head);
    json.at("counts") = json_of(end.totals.verdicts);
    json.at("warnings") = json_of(end.totals.warnings);
    json.at("projects") = json_gap();
    if (const auto names = one_source_names(end.totals); !names.empty())
      json["one_source"] = json_of(names);
    if (const auto errors = document_errors(end); !errors.empty()) json["errors"] = json_of(errors);
    const std::vector<std::string> pieces = json_layout_around_gaps(json, 0);
    sink.write(pieces.at(0));
    projects_.copy_to(sink);
    sink.write(pieces.at(1) + "\n");
  }

 private:
  const DocumentFrame& frame_;
  JsonList projects_;
};

}  // namespace

std::unique_ptr<FormatWriter> json_writer(const DocumentFrame& frame, const SpillPlace& place) {
  return std::make_unique<ResultWriter>(frame, place);
}

}  // namespace report
