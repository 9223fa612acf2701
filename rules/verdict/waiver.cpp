#include "rules/verdict/waiver.h"

#include "calc/base/text.h"

#include <fmt/format.h>

#include <string>

namespace rules {
std::optional<Waiver> read_waiver(calc::ElementReader& reader) {
  const bool is_whole = reader.require_together("waived-because", "waived-by") &&
                        reader.require_together("waived-by", "waived-until");
  if (!is_whole || !reader.has("waived-until")) return std::nullopt;
  Waiver waiver{reader.text("waived-because"), reader.text("waived-by"),
                read_day(reader, "waived-until")};
  if (waiver.until.empty()) return std::nullopt;
  return waiver;
}

std::string read_day(calc::ElementReader& reader, std::string_view name) {
  std::string day(calc::trim(reader.text(name)));
  if (day.empty() || is_day(day)) return day;
  reader.report(calc::DiagnosticId::waiver_incomplete, reader.where(name), name,
                reader.element().name, fmt::format("'{}' is not a date; expected YYYY-MM-DD", day));
  return {};
}

void apply_waiver(Finding& finding, std::string_view today) {
  const std::optional<Waiver>& waiver = finding.requirement.waiver;
  if (!waiver) return;
  if (!can_be_waived(finding.verdict)) return;
  finding.is_waived = lasts(*waiver, today);
  finding.reason +=
      fmt::format("{}{} by {} {} {}: {}", finding.reason.empty() ? "" : "; ",
                  finding.is_waived ? "waived" : "the waiver", waiver->owner,
                  finding.is_waived ? "until" : "ended on", waiver->until, waiver->reason);
}

}  // namespace rules
