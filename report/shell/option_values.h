#pragma once
// The texts after options, turned into values. No locale, no silent rounding, clamping or octal
// numbers.

#include "report/cli/options.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cli {

// Sets its target and returns "", or returns what is allowed and leaves the target alone.
using ValueParser = std::function<std::string(const std::string& text)>;

// An option with a value, for commands that list theirs in a file of their own.
struct ValueOption {
  std::string name, value_name, help;
  ValueParser parser;
  bool repeats = false;
};

// What a command has that lists its options in a file of its own.
struct ListedCommand {
  struct Place {
    std::string name, value_name, help;
    std::string* target;
    bool is_required = true;
  };
  struct Flag {
    std::string name, help;
    bool* target;
  };
  std::vector<Place> places = {};
  std::vector<Flag> flags = {};
  std::vector<ValueOption> values = {};
  std::string footer = {};
};

// Digits only.
std::optional<std::uint64_t> parse_count(std::string_view text);

// "0.02" or "2%", strictly between low and high.
ValueParser share_between(double& target, double low, double high);
// low to high inclusive; high must fit into the target.
ValueParser whole_number(std::uint64_t& target, std::uint64_t low, std::uint64_t high);
ValueParser whole_number(int& target, int low, int high);
ValueParser power_of_two(std::uint64_t& target, std::uint64_t low, std::uint64_t high);
// > 0 and finite
ValueParser positive_number(double& target);
// "rays" (0) or "shadow-map:N", as calc::RadiositySettings::shadow_map_texels.
ValueParser visibility(std::uint32_t& target);
// Not empty.
ValueParser some_text(std::string& target);
// --rules, as of 'check', for commands that list their options.
ValueOption rule_files_option(std::vector<std::string>& target);
// > 0
ValueParser seconds(double& target);
// "csv" or "csv=FILE", appended.
ValueParser format_item(std::vector<OutputFormat>& target);
// A name of calc::skip_name(), or "all"; forbidden besides those that are already.
ValueParser forbidden_skip(calc::SkipSet& target);
// "light-paths,near-field": names of GpuStages with dashes, each once, at least one.
ValueParser gpu_stages(std::optional<GpuStages>& target);
std::vector<std::string_view> gpu_stage_names(const GpuStages& stages);
// "now" or seconds since 1970; the target becomes "2024-05-01T12:00:00Z".
ValueParser moment(std::string& target);

std::string one_of_message(std::string_view text, const std::vector<std::string_view>& names);

template <class Enum>
ValueParser choice(Enum& target, std::vector<std::pair<std::string_view, Enum>> table) {
  return [&target, table = std::move(table)](const std::string& text) -> std::string {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : table) {
      names.push_back(name);
      if (name != text) continue;
      target = value;
      return "";
    }
    return one_of_message(text, names);
  };
}

}  // namespace cli
