#pragma once
// Whether a known number is met.

#include "calc/base/field.h"
#include "report/tools/selftest/case.h"

#include <string>
#include <vector>

namespace cli::selftest {

// All intervals together miss a right number in fewer than one of a thousand runs: each holds at
// the level 1 - 0.001 / kMostNumbers (Bonferroni), so that as many numbers may be compared. The
// level does not depend on which cases are chosen.
inline constexpr int kMostNumbers = 1000;
inline constexpr double kFamilyError = 1e-3;
// Numbers that were not sampled must agree to this share; photometric tables and ray offsets are
// below it.
inline constexpr double kRounding = 1e-6;
// Smaller shares are how a machine rounds: they are told as 0, and say nothing about which number
// is furthest off.
inline constexpr double kNoDeviation = 5e-12;

enum class Verdict { right, wrong, too_vague, refused };
std::string verdict_name(Verdict verdict);  // "in", "OUT", "TOO VAGUE", "refused as documented"

struct JudgedNumber {
  Measured measured;             // of several seeds: with the replicates of all
  calc::Estimate stated;         // the 95 % interval that the program gives, of all seeds together
  int seeds = 1, held = 0;       // how often the interval of one seed alone holds the exact value
  double low = 0.0, high = 0.0;  // the interval judged by, the truth's own error included
  Verdict verdict = Verdict::wrong;

  bool is_sampled() const { return measured.replicates.size() > 1; }
  double deviation() const;  // relative; of a truth of 0: the value itself
};

struct JudgedCase {
  SelftestCase test;
  CaseResult result;
  std::vector<JudgedNumber> numbers;
  Verdict verdict = Verdict::wrong;
  double seconds = 0.0;

  // By deviation, of those that are wrong if there are any; the first of several.
  const JudgedNumber* worst() const;
};

// The same number of every seed. All replicates together must meet it; whether it is too vague is
// asked of the middle one of the seeds' widths. A single width is allowed to be kLuck times as
// wide: of 16 replicates, and of some that are rarely much too large, it hangs on the seed.
inline constexpr double kLuck = 2.0;
JudgedNumber judge(const std::vector<Measured>& of_seeds);
// The results of one case for each seed, at least one.
JudgedCase judge(SelftestCase test, const std::vector<CaseResult>& of_seeds);
// Of one seed.
JudgedNumber judge(const Measured& measured);
JudgedCase judge(SelftestCase test, CaseResult result);

}  // namespace cli::selftest
