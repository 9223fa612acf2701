#pragma once
// All cases of a run, and their output.

#include "report/tools/selftest/judge.h"

#include <string>
#include <vector>

namespace cli::selftest {

struct RunResult {
  std::vector<JudgedCase> cases;
  std::uint64_t seed = 1;
  int seeds = 1;
  std::string program;

  int wrong() const;    // cases
  int numbers() const;  // compared
  // Return how many sampled numbers there are over all seeds, and how many have the exact value in
  // their stated 95 % interval; numbers of a case share light paths, so a single seed is no sharp
  // measure.
  int sampled() const;
  int held() const;
  // Returns the sampled number whose intervals hold least often; null: none was sampled, or one
  // seed.
  const JudgedNumber* least_held(std::string* of_case) const;
};

struct TextStyle {
  bool shows_all = false, has_timing = false, is_coloured = false;
};
std::string render_text(const RunResult& result, const TextStyle& style);
std::string render_json(const RunResult& result, bool has_timing);
std::string render_list(const std::vector<SelftestCase>& cases);

// Return the numbers of a row as words.
std::string value_words(double value);               // six digits
std::string deviation_words(const JudgedNumber& n);  // "+0.12 %", "0", "-1.2e-09"
std::string interval_words(const JudgedNumber& n);   // "99.1 – 101.2", "exact"
std::string seeds_words(const RunResult& result);    // "seed 1", "seeds 1 to 100"
// Returns "Of 278 sampled numbers, 274 lie in their stated 95 % interval", and for several seeds
// the least.
std::string coverage_words(const RunResult& result);

}  // namespace cli::selftest
