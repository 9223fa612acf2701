#pragma once
// The meaning of the program's exit status. Scripts rely on these numbers.

#include "rules/verdict/outcome.h"

namespace cli {

enum ExitCode : int {
  kAllMet = 0,  // every requirement is met or waived, or nothing is required
  kNotMet = 1,  // at least one requirement is not met
  // usage, input, file or internal error, a plane that could not be judged, or a warning that
  // counts
  kNotJudged = 2,
  kUndecided = 3,     // nothing failed, but the interval of at least one result holds its limit
  kInterrupted = 130  // SIGINT or SIGTERM, as shells report it
};

// Returns the code of the gravest outcome of several projects or files, see rules::graver().
ExitCode exit_code_of(rules::Outcome outcome);

}  // namespace cli
