#pragma once
// Waivers: a requirement whose failure is accepted for a time.

#include "calc/base/message.h"
#include "rules/catalogue/requirement.h"
#include "rules/verdict/judge.h"

#include <string>
#include <string_view>

namespace rules {

// Returns "glass, by A. Meier until 2027-06-30".
calc::Message waiver_words(const Waiver& waiver);

// Returns whether a verdict can be waived.
constexpr bool can_be_waived(Verdict verdict) {
  return verdict == Verdict::fail || verdict == Verdict::undecided;
}

// Waives a finding that fails or is undecided, up to the last day; it then does not count, but its
// verdict stays. The reason says so, or that the waiver has ended. today: YYYY-MM-DD.
void apply_waiver(Finding& finding, std::string_view today);

}  // namespace rules
