#pragma once
// Judges whether known numbers are met.

#include "calc/base/field.h"
#include "report/tools/selftest/case.h"

#include <string>
#include <vector>

namespace cli::selftest {

// Most numbers of a run. Each interval holds at the level 1 - 0.001 / kMostNumbers (Bonferroni), so
// that all together miss a right number in fewer than one of a thousand runs. The level does not
// depend on the chosen cases.
inline constexpr int kMostNumbers = 1000;
inline constexpr double kFamilyError = 1e-3;
// Numbers that were not sampled must agree to this share; photometric tables and ray offsets are
// below it.
inline constexpr double kRounding = 1e-6;
// Smaller shares are rounding of the machine: they are shown as 0, and do not decide which number
// has the largest deviation.
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

  // Returns the number with the largest deviation, among wrong ones if there are any; the first of
  // equal ones.
  const JudgedNumber* worst() const;
};

// The number of all seeds is judged: all replicates together must meet it, and the median of the
// seeds' widths must not be too vague. A single width may be kLuck times as wide: with 16
// replicates, some of them rarely much too large, it depends on the seed.
inline constexpr double kLuck = 2.0;
JudgedNumber judge(const std::vector<Measured>& of_seeds);
// Judges the results of a case for each seed, at least one.
JudgedCase judge(SelftestCase test, const std::vector<CaseResult>& of_seeds);
// Judges the number of one seed.
JudgedNumber judge(const Measured& measured);
JudgedCase judge(SelftestCase test, CaseResult result);

}  // namespace cli::selftest
