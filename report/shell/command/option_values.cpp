#include "report/shell/command/option_values.h"

#include "calc/base/text.h"
#include "calc/radiosity/gather/settings.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ctime>

namespace cli {
namespace {

constexpr std::string_view kShadowMap = "shadow-map:";

std::optional<std::string> format_epoch(std::uint64_t epoch_s) {
  constexpr std::uint64_t kEndOfYear9999 = 253402300799;
  if (epoch_s > kEndOfYear9999) return std::nullopt;
  const auto time = static_cast<std::time_t>(epoch_s);
  std::tm utc{};
  if (gmtime_r(&time, &utc) == nullptr) return std::nullopt;
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", utc);
}

}  // namespace

std::optional<std::uint64_t> parse_count(std::string_view text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<double> parse_share(std::string_view text) {
  const bool is_percent = text.ends_with('%');
  if (is_percent) text.remove_suffix(1);
  const std::optional<double> number = calc::parse_number(text);
  if (!number) return std::nullopt;
  return *number / (is_percent ? 100.0 : 1.0);
}

ValueParser share_between(double& target, double low, double high) {
  return [&target, low, high](const std::string& text) -> std::string {
    const std::optional<double> value = parse_share(text);
    if (!value || !(*value > low && *value < high)) {
      return fmt::format("a number between {} and {} is needed, or a percentage", low, high);
    }
    target = *value;
    return "";
  };
}

ValueParser whole_number(std::uint64_t& target, std::uint64_t low, std::uint64_t high) {
  return [&target, low, high](const std::string& text) -> std::string {
    const std::optional<std::uint64_t> value = parse_count(text);
    if (!value || *value < low || *value > high) {
      return fmt::format("a whole number from {} to {} is needed", low, high);
    }
    target = *value;
    return "";
  };
}

ValueParser whole_number(int& target, int low, int high) {
  return [&target, low, high](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    std::string problem = whole_number(value, static_cast<std::uint64_t>(low),
                                       static_cast<std::uint64_t>(high))(text);
    if (problem.empty()) target = static_cast<int>(value);
    return problem;
  };
}

ValueParser power_of_two(std::uint64_t& target, std::uint64_t low, std::uint64_t high) {
  return [&target, low, high](const std::string& text) -> std::string {
    const std::optional<std::uint64_t> value = parse_count(text);
    if (!value || *value < low || *value > high || (*value & (*value - 1)) != 0) {
      return fmt::format("a power of two from {} to {} is needed", low, high);
    }
    target = *value;
    return "";
  };
}

ValueParser positive_number(double& target) {
  return [&target](const std::string& text) -> std::string {
    const std::optional<double> value = calc::parse_number(text);
    if (!value || !(*value > 0.0) || !std::isfinite(*value)) return "a number above 0 is needed";
    target = *value;
    return "";
  };
}

ValueParser visibility(std::uint32_t& target) {
  const auto parse = [&target](const std::string& text) -> std::string {
    std::uint64_t texels = 0;
    if (text != "rays") {
      const std::string size = text.starts_with(kShadowMap) ? text.substr(kShadowMap.size()) : "";
      if (!power_of_two(texels, calc::kFewestShadowMapTexels, calc::kMostShadowMapTexels)(size)
               .empty()) {
        return fmt::format("rays or shadow-map:N is needed, N a power of two from {} to {}",
                           calc::kFewestShadowMapTexels, calc::kMostShadowMapTexels);
      }
    }
    target = static_cast<std::uint32_t>(texels);
    return "";
  };
  return {parse, {"rays", std::string(kShadowMap)}};
}

ValueParser some_text(std::string& target) {
  return [&target](const std::string& text) -> std::string {
    if (text.empty()) return "a name is needed";
    target = text;
    return "";
  };
}

ValueParser one_more(std::vector<std::string>& target) {
  return [&target](const std::string& text) -> std::string {
    if (text.empty()) return "a name is needed";
    target.push_back(text);
    return "";
  };
}

ValueParser any_text(std::string& target) {
  return [&target](const std::string& text) -> std::string {
    target = text;
    return "";
  };
}

ValueParser seconds(double& target) {
  return [&target](const std::string& text) -> std::string {
    const std::optional<double> value = calc::parse_number(text);
    if (!value || !(*value > 0.0) || !std::isfinite(*value)) {
      return "a number of seconds above 0 is needed";
    }
    target = *value;
    return "";
  };
}

ValueParser moment(std::string& target) {
  const auto parse = [&target](const std::string& text) -> std::string {
    const std::optional<std::uint64_t> epoch_s =
        text == "now" ? static_cast<std::uint64_t>(std::time(nullptr)) : parse_count(text);
    std::optional<std::string> formatted = epoch_s ? format_epoch(*epoch_s) : std::nullopt;
    if (!formatted) return "'now' or whole seconds since 1970-01-01 UTC are needed";
    target = std::move(*formatted);
    return "";
  };
  return {parse, {"now"}};
}

std::string take_source_date(const std::string& epoch, std::string& target) {
  if (epoch.empty()) return "";
  if (epoch != "now" && moment(target)(epoch).empty()) return "";
  return fmt::format("SOURCE_DATE_EPOCH is '{}': whole seconds since 1970 are needed", epoch);
}

std::string day_of_moment(const std::string& moment) {
  constexpr std::size_t kDateLength = 10;
  return moment.substr(0, kDateLength);
}

Option rules_option(std::vector<std::string>& target) {
  return {"--rules", "FILE|DIR",
          "Add rule packs to those delivered: a file, or a folder of them; repeatable",
          one_more(target), true};
}

Option allow_option(std::vector<std::string>& target) {
  return {"--allow", "DIR",
          "Allow symbolic links of projects to lead into this folder, such as a photometry "
          "library. Links that lead elsewhere are errors; repeatable",
          one_more(target), true};
}

namespace {

// "4G", of bytes in steps of 1024; "2.5e6", "10M" of counts in steps of 1000. Empty: no number
// above 0.
std::optional<double> parse_amount(std::string_view text, bool is_of_bytes) {
  const double step = is_of_bytes ? 1024.0 : 1000.0;
  double factor = 1.0;
  if (text.size() > 1) {
    constexpr std::string_view kSuffixes = "kMGT";
    if (const std::size_t at = kSuffixes.find(text.back()); at != std::string_view::npos) {
      for (std::size_t i = 0; i <= at; ++i) factor *= step;
      text.remove_suffix(1);
    }
  }
  const std::optional<double> number = calc::parse_number(text);
  if (!number || !(*number > 0.0)) return std::nullopt;
  return *number * factor;
}

}  // namespace

Option limit_option(calc::Budget& target) {
  using calc::BudgetOf;
  std::string defaults;
  std::vector<std::string> words;
  for (const std::string_view name : calc::names_of<BudgetOf>()) {
    const BudgetOf of = *calc::find_value<BudgetOf>(name);
    const bool is_second_line = of == BudgetOf::points;
    defaults += fmt::format("{}{} {}",
                            defaults.empty() ? ""
                            : is_second_line ? ",\n"
                                             : ", ",
                            name, calc::budget_text(of, calc::Budget()[of]));
    words.push_back(std::string(name) + "=");
  }
  const auto parse = [&target](const std::string& text) -> std::string {
    const std::size_t equals = text.find('=');
    const auto of = calc::find_value<BudgetOf>(text.substr(0, equals));
    const std::string allowed = calc::join_choices(calc::names_of<BudgetOf>());
    if (!of || equals == std::string::npos) {
      return fmt::format("NAME=N is needed; names: {}", allowed);
    }
    const bool is_of_bytes = *of == BudgetOf::memory || *of == BudgetOf::output;
    const auto amount = parse_amount(std::string_view(text).substr(equals + 1), is_of_bytes);
    if (!amount) return "a number above 0 is needed; it may end with k, M, G or T, as 4G";
    target[*of] = *amount;
    return "";
  };
  return {"--limit", "NAME=N",
          "Limit what one project and one output file may take; repeatable. A project beyond the "
          "limit is an error, and the others go on. N may end with k, M, G or T. By default " +
              defaults,
          ValueParser(parse, std::move(words)), true};
}

Option seed_option(std::uint64_t& target) {
  return {"--seed", "N", "Set the seed of the random numbers; default 1",
          whole_number(target, 0, UINT64_MAX)};
}

Option jobs_option(int& target, const std::string& never_changes) {
  return {"-j,--jobs", "N",
          "Use N threads, 1 to 1024; default one per core. Never changes " + never_changes,
          whole_number(target, 1, 1024)};
}

Option space_option(std::string& target) {
  return {"--space", "ID", "Choose the space by its id; needed if there are several",
          some_text(target)};
}

Option quiet_option(bool& target) {
  return {"-q,--quiet", "", "Print only errors, and what other options request", &target};
}

Option quiet_option_with_count(bool& target) {
  return {"-q,--quiet", "",
          "Print only errors, and what other options request. Warnings share one line: how many, "
          "and their ids",
          &target};
}

std::vector<Option> text_or_json_options(bool& as_json) {
  return {{"--format", "KIND", "Choose the output: text or json; default text",
           choice<bool>(as_json, {{"text", false}, {"json", true}})},
          {"--json", "", "Print JSON: the same as --format json", &as_json}};
}

Place project_place(std::string& target) {
  return {"project", "PROJECT.xml", "Project file", &target};
}

std::string one_of_message(std::string_view text, const std::vector<std::string_view>& names) {
  const std::string near = calc::suggestion(text, names);
  return near.empty() ? calc::join_choices(names) + " is needed" : "unknown value" + near;
}

}  // namespace cli
