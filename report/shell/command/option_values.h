#pragma once
// Turns the texts after options into values, without locale, silent rounding, clamping or octal
// numbers.

#include "calc/base/budget.h"
#include "report/shell/command/command.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cli {

// Returns the number; digits only.
std::optional<std::uint64_t> parse_count(std::string_view text);

// Returns the share for "0.02" or "2%".
std::optional<double> parse_share(std::string_view text);
// Accepts a share strictly between low and high.
ValueParser share_between(double& target, double low, double high);
// Accepts low to high inclusive; high must fit into the target.
ValueParser whole_number(std::uint64_t& target, std::uint64_t low, std::uint64_t high);
ValueParser whole_number(int& target, int low, int high);
ValueParser power_of_two(std::uint64_t& target, std::uint64_t low, std::uint64_t high);
// Accepts numbers > 0 and finite.
ValueParser positive_number(double& target);
// Accepts "rays" (0) or "shadow-map:N", as calc::RadiositySettings::shadow_map_texels.
ValueParser visibility(std::uint32_t& target);
// Accepts any text that is not empty.
ValueParser some_text(std::string& target);
// Appends a text that is not empty.
ValueParser one_more(std::vector<std::string>& target);
// Accepts anything, also the empty text.
ValueParser any_text(std::string& target);
// Accepts seconds > 0.
ValueParser seconds(double& target);
// Accepts "now" or seconds since 1970; the target becomes "2024-05-01T12:00:00Z".
ValueParser moment(std::string& target);
// Sets `target` to SOURCE_DATE_EPOCH as a moment, if it is set. Returns what is wrong with it, "" =
// nothing.
std::string take_source_date(const std::string& epoch, std::string& target);
// Returns the day of a moment; "" for "".
std::string day_of_moment(const std::string& moment);

// Options that several commands share, with the same words. --rules: packs besides those delivered,
// or folders of them.
Option rules_option(std::vector<std::string>& target);
// Returns --allow: folders to which symbolic links in a project's folder may lead.
Option allow_option(std::vector<std::string>& target);
// Returns --limit: the most that one project may take.
Option limit_option(calc::Budget& target);
Option seed_option(std::uint64_t& target);
// Returns --jobs. never_changes: "a result", "the file".
Option jobs_option(int& target, const std::string& never_changes = "a result");
Option space_option(std::string& target);
Option quiet_option(bool& target);
// Returns --quiet for commands with a WarningTally.
Option quiet_option_with_count(bool& target);
// Returns --format KIND and --json, for commands that only write to standard output.
std::vector<Option> text_or_json_options(bool& as_json);
Place project_place(std::string& target);

// Returns "unknown value; did you mean 'json'?", or all names if none is near.
std::string one_of_message(std::string_view text, const std::vector<std::string_view>& names);

template <class Enum>
ValueParser choice(Enum& target, std::vector<std::pair<std::string_view, Enum>> table) {
  std::vector<std::string> words;
  for (const auto& [name, value] : table) words.emplace_back(name);
  const auto parse = [&target, table = std::move(table)](const std::string& text) -> std::string {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : table) {
      names.push_back(name);
      if (name != text) continue;
      target = value;
      return "";
    }
    return one_of_message(text, names);
  };
  return {parse, std::move(words)};
}

}  // namespace cli
