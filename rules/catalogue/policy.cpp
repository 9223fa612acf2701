#include "rules/catalogue/policy.h"

#include <fmt/format.h>

namespace rules {

bool DecisionPolicy::is_default() const {
  return !compares_rounded && tolerance == 0.0 && guard == 0.0;
}

std::string policy_text(const DecisionPolicy& policy) {
  std::string text =
      policy.compares_rounded
          ? fmt::format("values rounded ({}; {} digits of lx, {} of ratios, {} of others)",
                        calc::name_of(policy.rounding), policy.illuminance_digits,
                        policy.ratio_digits, policy.other_digits)
          : "unrounded values";
  if (policy.tolerance == 0.0) {
    text += ", no tolerance";
  } else {
    text += fmt::format(", tolerance {:g} % of the limit ({})", 100.0 * policy.tolerance,
                        policy.tolerance_reason);
  }
  if (policy.guard > 0.0) {
    text += fmt::format(", intervals widened by {:g} %", 100.0 * policy.guard);
  }
  return text;
}

}  // namespace rules
