#include "report/tools/selftest/judge.h"

#include "calc/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cli::selftest {

std::string verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::right:
      return "in";
    case Verdict::too_vague:
      return "TOO VAGUE";
    case Verdict::refused:
      return "refused as documented";
    case Verdict::wrong:
      break;
  }
  return "OUT";
}

double JudgedNumber::deviation() const {
  if (measured.exact == 0.0) return stated.value;
  const double share = stated.value / measured.exact - 1.0;
  return std::abs(share) < kNoDeviation ? 0.0 : share;
}

const JudgedNumber* JudgedCase::worst() const {
  const JudgedNumber* found = nullptr;
  for (const JudgedNumber& number : numbers) {
    const auto key = [](const JudgedNumber& n) {
      return std::pair(n.verdict != Verdict::right, std::abs(n.deviation()));
    };
    if (found == nullptr || key(number) > key(*found)) found = &number;
  }
  return found;
}

namespace {

// Its own interval where the program has one; of several seeds the replicates make one sample.
calc::Estimate interval_of(const Measured& measured, double confidence) {
  return measured.interval ? measured.interval(confidence)
                           : calc::t_interval(measured.replicates, confidence);
}

double allowed_off(const Measured& measured) {
  return measured.known_to + kRounding * std::abs(measured.exact);
}

Measured pooled(const std::vector<Measured>& of_seeds) {
  Measured all = of_seeds.front();
  // The program's own intervals are of one run: the first one stands for all.
  for (std::size_t s = 1; s < of_seeds.size() && !all.interval; ++s) {
    all.replicates.insert(all.replicates.end(), of_seeds[s].replicates.begin(),
                          of_seeds[s].replicates.end());
  }
  return all;
}

double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

CaseResult joined(const std::vector<CaseResult>& of_seeds, std::vector<JudgedNumber>& numbers) {
  CaseResult all = of_seeds.front();
  for (std::size_t s = 1; s < of_seeds.size(); ++s) {
    all.rays += of_seeds[s].rays;
    if (all.problem.empty()) all.problem = of_seeds[s].problem;
    if (all.problem.empty() && of_seeds[s].measured.size() != all.measured.size()) {
      all.problem = "another seed gives a different count of numbers";
    }
  }
  for (std::size_t i = 0; i < all.measured.size() && all.problem.empty(); ++i) {
    std::vector<Measured> number;
    for (const CaseResult& one : of_seeds) number.push_back(one.measured[i]);
    numbers.push_back(judge(number));
  }
  return all;
}

}  // namespace

JudgedNumber judge(const std::vector<Measured>& of_seeds) {
  JudgedNumber number;
  number.measured = pooled(of_seeds);
  const double exact = number.measured.exact;
  number.seeds = static_cast<int>(of_seeds.size());
  std::vector<double> half_widths;
  for (const Measured& one : of_seeds) {
    const calc::Estimate stated = interval_of(one, 0.95);
    const double allowed = allowed_off(one);
    if (stated.low - allowed <= exact && exact <= stated.high + allowed) ++number.held;
    half_widths.push_back(stated.half_width());
  }
  number.stated = interval_of(number.measured, 0.95);
  const double allowed = allowed_off(number.measured);
  const calc::Estimate family = interval_of(number.measured, 1.0 - kFamilyError / kMostNumbers);
  number.low = family.low - allowed;
  number.high = family.high + allowed;
  const bool is_in = number.low <= exact && exact <= number.high;
  const double luck = of_seeds.size() == 1 ? kLuck : 1.0;
  const bool is_vague =
      number.is_sampled() &&
      !(middle_of(half_widths) <=
        luck * number.measured.widest * std::max(std::abs(exact), number.measured.scale));
  number.verdict = !is_in ? Verdict::wrong : is_vague ? Verdict::too_vague : Verdict::right;
  return number;
}

JudgedNumber judge(const Measured& measured) { return judge(std::vector<Measured>{measured}); }

JudgedCase judge(SelftestCase test, CaseResult result) {
  return judge(std::move(test), std::vector<CaseResult>{std::move(result)});
}

JudgedCase judge(SelftestCase test, const std::vector<CaseResult>& of_seeds) {
  JudgedCase judged;
  CaseResult result = joined(of_seeds, judged.numbers);
  judged.verdict =
      result.measured.empty() && !result.refused.empty() ? Verdict::refused : Verdict::right;
  for (const JudgedNumber& number : judged.numbers) {
    if (number.verdict == Verdict::wrong) judged.verdict = Verdict::wrong;
    if (number.verdict == Verdict::too_vague && judged.verdict != Verdict::wrong) {
      judged.verdict = Verdict::too_vague;
    }
  }
  for (const Refused& refused : result.refused) {
    if (refused.said.find(refused.expected) == std::string::npos || refused.said.empty()) {
      judged.verdict = Verdict::wrong;
    }
  }
  if (!result.problem.empty() || (result.measured.empty() && result.refused.empty())) {
    judged.verdict = Verdict::wrong;
  }
  judged.test = std::move(test);
  judged.result = std::move(result);
  return judged;
}

}  // namespace cli::selftest
