#include "report/cli/exit_code.h"

namespace cli {

ExitCode exit_code_for(const report::Document& document) {
  const report::VerdictCounts counts = report::count_verdicts(document);
  if (counts.not_judged > 0 || report::has_uncomputed_plane(document)) return kNotJudged;
  if (counts.fail > 0) return kNotMet;
  if (counts.undecided > 0) return kUndecided;
  return kAllMet;
}

}  // namespace cli
