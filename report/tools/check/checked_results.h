#pragma once
// Handles finished projects of `check`: they are written at once and dropped, unless a baseline
// needs all of them.

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
  // Returns the revision of a whole document against a baseline.
  using Revise = std::function<report::Revision(const report::Document&)>;

  // options, run: must outlive this. provenance: as far as it is known before the first project.
  // revise: may be empty.
  CheckedResults(const CheckOptions& options, const check::Run& run, const Environment& environment,
                 const report::Provenance& provenance, Revise revise);

  // Adds a project, in the order of the options. inputs: at least the files read since the previous
  // call.
  void add(report::ProjectPart project, const std::set<std::string>& inputs);
  // Ends the results once, after the last project. inputs: all files that were read. Returns false
  // if something could not be written, which is printed.
  bool finish(const std::set<std::string>& inputs);
  // Returns the outcome for the exit code; after finish().
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
