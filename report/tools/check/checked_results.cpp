#include "report/tools/check/checked_results.h"

#include "report/html/chapters/data_sheets.h"
#include "report/revision/gate.h"
#include "report/tools/check/checked_document.h"

#include <utility>

namespace cli {

CheckedResults::CheckedResults(const CheckOptions& options, const check::Run& run,
                               const Environment& environment, const report::Provenance& provenance,
                               Revise revise)
    : options_(options), run_(run), environment_(environment), revise_(std::move(revise)) {
  document_.provenance = provenance;
  if (revise_) return;
  report::DocumentFrame frame{provenance, options.input.projects, nullptr};
  if (options.output.redact) {
    redaction_.emplace(frame.paths);
    redaction_->redact(frame);
    document_.provenance = frame.provenance;
  }
  files_.emplace(options.output, environment, std::move(frame));
}

void CheckedResults::add(report::ProjectPart project, const std::set<std::string>& inputs) {
  if (options_.output.page.sheets) options_.output.page.sheets->see(project, "");
  if (revise_) {
    document_.projects.push_back(std::move(project));
    return;
  }
  totals_.add(project);
  if (redaction_) redaction_->redact(project, projects_);
  ++projects_;
  files_->add(project, inputs);
}

bool CheckedResults::finish(const std::set<std::string>& inputs) {
  return revise_ ? finish_revised(inputs) : finish_streamed(inputs);
}

bool CheckedResults::finish_streamed(const std::set<std::string>& inputs) {
  report::DocumentEnd end{document_.provenance, totals_};
  complete_provenance(end.provenance, totals_, run_);
  outcome_ = totals_.outcome;
  return files_->finish(end, inputs);
}

bool CheckedResults::finish_revised(const std::set<std::string>& inputs) {
  complete_provenance(document_.provenance, report::totals_of(document_), run_);
  document_.revision = revise_(document_);
  if (options_.output.redact) report::redact(document_);
  outcome_ = report::gate_outcome(document_);
  return write_results(options_.output, environment_, document_, inputs);
}

}  // namespace cli
