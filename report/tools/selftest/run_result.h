#pragma once
// All cases of a run, and how it is shown.

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
  // Of sampled numbers, one for each seed, those whose stated 95 % interval holds the exact value;
  // numbers of one case share light paths, so that of a single seed it is no sharp measure.
  int sampled() const;
  int held() const;
  // The sampled number whose intervals hold least often; null: none was sampled, or one seed.
  const JudgedNumber* least_held(std::string* of_case) const;
};

struct TextStyle {
  bool shows_all = false, has_timing = false, is_coloured = false;
};
std::string render_text(const RunResult& result, const TextStyle& style);
std::string render_json(const RunResult& result, bool has_timing);
std::string render_list(const std::vector<SelftestCase>& cases);

// Numbers of one row as words.
std::string value_words(double value);               // six digits
std::string deviation_words(const JudgedNumber& n);  // "+0.12 %", "0", "-1.2e-09"
std::string interval_words(const JudgedNumber& n);   // "99.1 – 101.2", "exact"
std::string seeds_words(const RunResult& result);    // "seed 1", "seeds 1 to 100"
// "Of 278 sampled numbers, 274 lie in their stated 95 % interval", and of several seeds the least.
std::string coverage_words(const RunResult& result);

}  // namespace cli::selftest
