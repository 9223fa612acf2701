#include "report/shell/process/exit_code.h"

namespace cli {

ExitCode exit_code_of(rules::Outcome outcome) {
  switch (outcome) {
    case rules::Outcome::not_judged:
    case rules::Outcome::warned:
      break;
    case rules::Outcome::fail:
      return kNotMet;
    case rules::Outcome::undecided:
      return kUndecided;
    case rules::Outcome::pass:
    case rules::Outcome::waived:
    case rules::Outcome::nothing_asked:
      return kAllMet;
  }
  return kNotJudged;
}

}  // namespace cli
