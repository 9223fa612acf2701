#include "rules/verdict/waiver.h"

#include "calc/base/text.h"

#include <fmt/format.h>

#include <string>

namespace rules {
namespace {

int number_at(std::string_view text, std::size_t begin, std::size_t count) {
  int number = 0;
  for (const char c : text.substr(begin, count)) {
    if (c < '0' || c > '9') return -1;
    number = 10 * number + (c - '0');
  }
  return number;
}

bool is_date(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  const int year = number_at(text, 0, 4), month = number_at(text, 5, 2),
            day = number_at(text, 8, 2);
  if (year < 1 || month < 1 || month > 12 || day < 1) return false;
  constexpr int kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool is_leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  return day <= kDays[month - 1] + (month == 2 && is_leap ? 1 : 0);
}

}  // namespace

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
  if (day.empty() || is_date(day)) return day;
  reader.report(calc::DiagnosticId::waiver_incomplete, reader.where(name), name,
                reader.element().name, fmt::format("'{}' is not a date; expected YYYY-MM-DD", day));
  return {};
}

void apply_waiver(Finding& finding, std::string_view today) {
  const std::optional<Waiver>& waiver = finding.requirement.waiver;
  if (!waiver) return;
  if (finding.verdict != Verdict::fail && finding.verdict != Verdict::undecided) return;
  finding.is_waived = today <= std::string_view(waiver->until);
  finding.reason +=
      fmt::format("{}{} by {} {} {}: {}", finding.reason.empty() ? "" : "; ",
                  finding.is_waived ? "waived" : "the waiver", waiver->owner,
                  finding.is_waived ? "until" : "ended on", waiver->until, waiver->reason);
}

}  // namespace rules
