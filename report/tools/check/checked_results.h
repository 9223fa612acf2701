#pragma once
// What `check` does with projects that are done: they are written at once and forgotten, unless a
// baseline is to be compared with, which needs them all.

#include "report/check/run.h"
#include "report/document/document.h"
#include "report/result_file/redact.h"
#include "report/shell/output/outputs.h"
#include "report/tools/check/check_options.h"
#include "rules/verdict/outcome.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>

namespace cli {

class CheckedResults {
 public:
  // Against a baseline, of a document that is there as a whole.
  using Revise = std::function<report::Revision(const report::Document&)>;

  // options, run: they outlive this. provenance: as far as it is known before the first project.
  // revise: may be empty.
  CheckedResults(const CheckOptions& options, const check::Run& run, const Environment& environment,
                 const report::Provenance& provenance, Revise revise);

  // In the order of the options. inputs: files that were read since the call before, at least.
  void add(report::ProjectPart project, const std::set<std::string>& inputs);
  // Once, after the last project. inputs: all that were read. False: something could not be
  // written, which has been printed.
  bool finish(const std::set<std::string>& inputs);
  // After finish(): what the exit code tells.
  rules::Outcome outcome() const { return outcome_; }

 private:
  bool finish_streamed(const std::set<std::string>& inputs);
  bool finish_revised(const std::set<std::string>& inputs);

  const CheckOptions& options_;
  const check::Run& run_;
  const Environment& environment_;
  Revise revise_;
  rules::Outcome outcome_ = rules::Outcome::nothing_asked;
  report::Document document_;  // its projects only if it is revised
  std::optional<report::Redaction> redaction_;
  report::Totals totals_;
  std::size_t projects_ = 0;  // so far
  std::optional<ResultFiles> files_;
};

}  // namespace cli
