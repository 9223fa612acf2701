// Rule packs: reading, and the limits of what was read.
#include "rules/pack/limit.h"
#include "rules/pack/rule_lint.h"
#include "rules/pack/rule_pack.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

#include <cmath>

namespace {

void check_limits(const rules::RulePack& pack, const rules::RuleRow* row) {
  for (const rules::RuleCheck& check : pack.checks) {
    for (const auto level : {rules::RowLevel::required, rules::RowLevel::modified}) {
      const rules::Limit limit = rules::evaluate_limit(check, {pack, row, level});
      const bool is_known = limit.status == rules::LimitStatus::known;
      fuzz::require(is_known == limit.reason.empty(), "a limit or the reason why there is none");
      fuzz::require(!is_known || !(limit.value.value < 0.0), "no limit below 0");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  calc::Diagnostics diagnostics;
  const auto pack = rules::parse_rule_pack(fuzz::as_text(data, size), "a.xml", diagnostics);
  fuzz::check_messages(pack.has_value(), diagnostics);
  if (!pack) return 0;
  fuzz::require(!pack->checks.empty(), "a pack has checks");
  constexpr std::size_t kMostRows = 20;  // the rest is no different, and time is short
  check_limits(*pack, nullptr);
  for (std::size_t i = 0; i < pack->rows.size() && i < kMostRows; ++i) {
    fuzz::require(pack->find_row(pack->rows[i].ref) == &pack->rows[i],
                  "a row is found by its reference");
    check_limits(*pack, &pack->rows[i]);
  }
  rules::lint_rule_pack(*pack, diagnostics);
  return 0;
}
