#pragma once
// The outcome of a requirement, a room, a project or a batch. Their one order of gravity is here:
// exit codes, banners, headlines and summaries read it.

#include "calc/base/names.h"
#include "rules/catalogue/aggregate.h"
#include "rules/catalogue/compare.h"
#include "rules/verdict/judge.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace rules {

// Gravest first. "Cannot be judged" never looks like a pass or a failure of the design.
enum class Outcome : std::uint8_t {
  not_judged,    // something could not be
  warned,        // a warning that was asked to count: whatever was judged is not accepted
  fail,          // at least one requirement is not met
  undecided,     // nothing failed, but the interval of at least one result holds its limit
  pass,          // every requirement is met or waived, and one is met
  waived,        // every requirement is waived: accepted, but nothing is called a pass
  nothing_asked  // no requirement counts: nothing to be met, and so nothing that is
};

constexpr Outcome outcome_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return Outcome::pass;
    case Verdict::fail:
      return Outcome::fail;
    case Verdict::undecided:
      return Outcome::undecided;
    case Verdict::not_judged:
      break;
  }
  return Outcome::not_judged;
}

// Returns the outcome of a finding; nothing_asked if it does not count by itself (advice, or only a
// member of aggregates).
Outcome outcome_of(const Finding& finding);
Outcome outcome_of(const AggregateFinding& finding);

// Returns whether the outcome counts for the exit code: it is required and not waived.
constexpr bool counts(Outcome outcome) {
  return outcome != Outcome::waived && outcome != Outcome::nothing_asked;
}

// Returns the graver of two outcomes; Outcome::nothing_asked changes nothing.
constexpr Outcome graver(Outcome a, Outcome b) { return std::min(a, b); }
constexpr Verdict graver(Verdict a, Verdict b) { return outcome_of(b) < outcome_of(a) ? b : a; }

inline constexpr std::array kGravestFirst{Verdict::not_judged, Verdict::fail, Verdict::undecided,
                                          Verdict::pass};
// Returns the place of the verdict in the order of gravity: 0, 1, 2, 3.
constexpr int gravity_rank(Verdict verdict) {
  return static_cast<int>(std::find(kGravestFirst.begin(), kGravestFirst.end(), verdict) -
                          kGravestFirst.begin());
}

}  // namespace rules

namespace calc {

template <>
struct EnumNames<rules::Outcome> {
  static constexpr EnumName<rules::Outcome> list[] = {
      {rules::Outcome::not_judged, "not-judged"},
      {rules::Outcome::warned, "warned"},
      {rules::Outcome::fail, "fail"},
      {rules::Outcome::undecided, "undecided"},
      {rules::Outcome::pass, "pass"},
      {rules::Outcome::waived, "waived"},
      {rules::Outcome::nothing_asked, "nothing-asked"}};
};

}  // namespace calc
