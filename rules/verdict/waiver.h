#pragma once
// A requirement that somebody has decided to live without, for a time.

#include "calc/base/message.h"
#include "rules/catalogue/requirement.h"
#include "rules/verdict/judge.h"

#include <string>
#include <string_view>

namespace rules {

// "glass, by A. Meier until 2027-06-30"
calc::Message waiver_words(const Waiver& waiver);

// A verdict that somebody may live without.
constexpr bool can_be_waived(Verdict verdict) {
  return verdict == Verdict::fail || verdict == Verdict::undecided;
}

// A finding that fails or is undecided is waived up to the last day, and then does not count; its
// verdict stays. The reason says so, or that the waiver has ended. today: YYYY-MM-DD.
void apply_waiver(Finding& finding, std::string_view today);

}  // namespace rules
