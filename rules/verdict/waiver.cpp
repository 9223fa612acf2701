#include "rules/verdict/waiver.h"

#include "calc/base/sentences.h"

#include <fmt/format.h>

#include <string>

namespace rules {
calc::Message waiver_words(const Waiver& waiver) {
  return calc::Message::words(waiver.reason) + ", " +
         calc::say<calc::Sentence::by_until>(waiver.owner, waiver.until);
}

void apply_waiver(Finding& finding, std::string_view today) {
  const std::optional<Waiver>& waiver = finding.requirement.waiver;
  if (!waiver) return;
  if (!can_be_waived(finding.verdict)) return;
  finding.is_waived = waiver->holds_on(today);
  append(finding.reason, finding.is_waived
                             ? calc::say<calc::Sentence::waived_on>(waiver->owner, waiver->until,
                                                                    today, waiver->reason)
                             : calc::say<calc::Sentence::waiver_ended>(waiver->owner, waiver->until,
                                                                       waiver->reason));
}

}  // namespace rules
