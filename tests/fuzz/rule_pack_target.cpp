// Rule packs.
#include "rules/rule_pack.h"

#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"

#include <cmath>

namespace {

void check_row(const rules::RulePack& pack, const rules::RuleRow& row) {
  fuzz::require(pack.find_row(row.ref) == &row, "a row is found by its reference");
  fuzz::require(!row.limits.empty(), "a row has limits");
  for (const rules::RowLimit& limit : row.limits) {
    for (const auto level : {rules::RowLevel::required, rules::RowLevel::modified}) {
      const double value = limit.at_level(level);
      fuzz::require(std::isfinite(value) && value >= 0.0, "a limit >= 0");
      fuzz::require(!pack.clause_text(limit, level).empty(), "a limit has a clause");
    }
    fuzz::require(
        limit.metric != rules::Metric::percentile && limit.metric != rules::Metric::value_at_point,
        "rows have neither percentiles nor values at points");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  calc::Diagnostics diagnostics;
  const auto pack = rules::parse_rule_pack(fuzz::as_text(data, size), "a.xml", diagnostics);
  fuzz::check_messages(pack.has_value(), diagnostics);
  if (!pack) return 0;
  fuzz::require(!pack->rows.empty(), "a pack has rows");
  for (const rules::RuleRow& row : pack->rows) check_row(*pack, row);
  return 0;
}
