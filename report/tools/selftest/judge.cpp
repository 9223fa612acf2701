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

JudgedNumber judge(const Measured& measured) {
  JudgedNumber number;
  number.measured = measured;
  const auto interval = [&](double confidence) {
    return measured.interval ? measured.interval(confidence)
                             : calc::t_interval(measured.replicates, confidence);
  };
  number.stated = interval(0.95);
  const double allowed = measured.known_to + kRounding * std::abs(measured.exact);
  const calc::Estimate family = interval(1.0 - kFamilyError / kMostNumbers);
  number.low = family.low - allowed;
  number.high = family.high + allowed;
  const bool is_in = number.low <= measured.exact && measured.exact <= number.high;
  const bool is_vague = number.is_sampled() &&
                        !(number.stated.half_width() <= measured.widest * std::abs(measured.exact));
  number.verdict = !is_in ? Verdict::wrong : is_vague ? Verdict::too_vague : Verdict::right;
  return number;
}

JudgedCase judge(SelftestCase test, CaseResult result) {
  JudgedCase judged;
  judged.verdict =
      result.measured.empty() && !result.refused.empty() ? Verdict::refused : Verdict::right;
  for (const Measured& measured : result.measured) {
    judged.numbers.push_back(judge(measured));
    const Verdict verdict = judged.numbers.back().verdict;
    if (verdict == Verdict::wrong) judged.verdict = Verdict::wrong;
    if (verdict == Verdict::too_vague && judged.verdict != Verdict::wrong) {
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
