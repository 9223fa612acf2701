#include "rules/verdict/waiver.h"

#include <fmt/format.h>

#include <string>

namespace rules {
std::string waiver_words(const Waiver& waiver) {
  return fmt::format("{}, by {} until {}", waiver.reason, waiver.owner, waiver.until);
}

void apply_waiver(Finding& finding, std::string_view today) {
  const std::optional<Waiver>& waiver = finding.requirement.waiver;
  if (!waiver) return;
  if (!can_be_waived(finding.verdict)) return;
  finding.is_waived = waiver->holds_on(today);
  finding.reason +=
      fmt::format("{}{} by {} {} {}: {}", finding.reason.empty() ? "" : "; ",
                  finding.is_waived ? "waived" : "the waiver", waiver->owner,
                  finding.is_waived ? "until" : "ended on", waiver->until, waiver->reason);
}

}  // namespace rules
