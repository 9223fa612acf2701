#pragma once
// Finds levels that would make a project pass, for reports: see check --advice.

#include "report/advice/find_advice.h"
#include "report/advice/kept_light.h"
#include "report/document/document.h"
#include "report/document/level_advice.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cli {

// A checked project with its text.
struct CheckedText {
  const std::string& file;   // its path
  const std::string& bytes;  // of it
  const report::ProjectPart& part;
};

// Returns the same project with its light known to the tolerance everywhere, not only as far as
// verdicts needed it, and that light. Empty: it could not be calculated.
using CheckLight = std::function<std::optional<report::ProjectPart>(KeptLight& light)>;

// Returns advice for each scene in which a requirement that depends on levels fails or is
// undecided, in the order of the project; calculates nothing if there is none. check: with other
// random numbers.
std::vector<report::LevelAdvice> advised_levels(const CheckedText& project,
                                                const AdviceSettings& settings,
                                                const CheckLight& check_light,
                                                const CheckText& check);

}  // namespace cli
