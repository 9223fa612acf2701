#pragma once
// What the program's exit status means. Scripts rely on these numbers.

#include "report/document.h"

namespace cli {

enum ExitCode : int {
  kAllMet = 0,        // every requirement is met (or none was stated)
  kNotMet = 1,        // at least one requirement is not met
  kNotJudged = 2,     // usage, input, file or internal error, or a plane that could not be judged
  kUndecided = 3,     // nothing failed, but the interval of at least one result holds its limit
  kInterrupted = 130  // SIGINT or SIGTERM, as shells report it
};

// Worst first: not judged, not met, undecided, all met. "Cannot be judged" never looks like a pass
// or a failure of the design. A plane that was not computed counts even when nothing was required
// of it.
ExitCode exit_code_for(const report::Document& document);

}  // namespace cli
