#include "report/shell/output/warning_tally.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "report/shell/process/print.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string_view>

namespace cli {
namespace {

constexpr calc::DiagnosticId kAllIds[] = {
#define LUXGATE_DIAGNOSTIC(id, severity, text) calc::DiagnosticId::id,
#include "calc/base/diagnostics.def"
#undef LUXGATE_DIAGNOSTIC
};

using Counts = std::map<calc::DiagnosticId, std::size_t>;

std::size_t sum(const Counts& counts) {
  std::size_t total = 0;
  for (const auto& [id, count] : counts) total += count;
  return total;
}

// "light-leaves-room, luminaire-outside-room (2)"
std::string names(const Counts& counts) {
  std::string text;
  for (const auto& [id, count] : counts) {
    text += (text.empty() ? "" : ", ") + calc::diagnostic_name(id);
    if (count > 1) text += fmt::format(" ({})", count);
  }
  return text;
}

std::vector<std::string> warning_names() {
  std::vector<std::string> all;
  for (const calc::DiagnosticId id : kAllIds) {
    if (calc::diagnostic_severity(id) == calc::Severity::warning) {
      all.push_back(calc::diagnostic_name(id));
    }
  }
  return all;
}

// "" or what is wrong with it.
std::string add_id(const std::string& name, StrictWarnings& target) {
  const std::optional<calc::DiagnosticId> id = calc::diagnostic_from_name(name);
  if (id && calc::diagnostic_severity(*id) == calc::Severity::warning) {
    target.ids.push_back(*id);
    return "";
  }
  if (id)
    return fmt::format("'{}' is an error, which always counts; ids of warnings are needed", name);
  const std::vector<std::string> all = warning_names();
  const std::vector<std::string_view> choices(all.begin(), all.end());
  const std::string close = calc::suggestion(name, choices);
  return fmt::format("no warning has the id '{}'{}", name,
                     close.empty() ? "; there are " + calc::join_choices(choices) : close);
}

}  // namespace

bool StrictWarnings::has(calc::DiagnosticId id) const {
  return all || id == calc::DiagnosticId::policy_not_met || names(id);
}

bool StrictWarnings::names(calc::DiagnosticId id) const {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

Option strict_option(StrictWarnings& target) {
  const auto parse = [&target](const std::string& text) -> std::string {
    if (text.empty()) {
      target.all = true;
      return "";
    }
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      if (std::string problem = add_id(text.substr(begin, end - begin), target); !problem.empty()) {
        return problem;
      }
      begin = end + 1;
    }
    return "";
  };
  Option option{
      "--strict", "",
      "Count warnings as errors: exit code 2. --strict=ID,ID counts only warnings with "
      "these ids, as light-leaves-room in warning[light-leaves-room]. Numbers of standards that "
      "rest on one public source count only by their id, one-source",
      ValueParser(parse, warning_names()), true};
  option.may_have_value = true;
  return option;
}

std::vector<calc::DiagnosticId> WarningTally::add(
    const std::vector<calc::Diagnostic>& diagnostics) {
  std::vector<calc::DiagnosticId> counting;
  for (const calc::Diagnostic& diagnostic : diagnostics) {
    const calc::DiagnosticId id = diagnostic.id;
    if (diagnostic.severity() != calc::Severity::warning) continue;
    if (!strict_.has(id)) {
      ++others_[id];
      continue;
    }
    ++counting_[id];
    if (std::find(counting.begin(), counting.end(), id) == counting.end()) counting.push_back(id);
  }
  return counting;
}

rules::Outcome WarningTally::outcome() const {
  return counting_.empty() ? rules::Outcome::nothing_asked : rules::Outcome::warned;
}

std::string WarningTally::words(bool quiet) const {
  std::string text;
  if (const std::size_t count = sum(others_); quiet && count > 0) {
    text +=
        fmt::format("luxgate: {} warning{} ({}); exit code unaffected, --strict makes {} count\n",
                    count, count == 1 ? "" : "s", names(others_), count == 1 ? "it" : "them");
  }
  if (const std::size_t count = sum(counting_); count > 0) {
    text += fmt::format("luxgate: exit code {}: {} because of {}: {}\n",
                        static_cast<int>(exit_code_of(outcome())),
                        count == 1 ? "1 warning counts" : fmt::format("{} warnings count", count),
                        strict_.has_policy || counting_.contains(calc::DiagnosticId::policy_not_met)
                            ? "the policy or --strict"
                            : "--strict",
                        names(counting_));
  }
  return text;
}

void WarningTally::print(bool quiet) const { tell("{}", words(quiet)); }

}  // namespace cli
