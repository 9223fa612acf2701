#include "report/shell/option_values.h"

#include "calc/base/text.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ctime>
#include <iterator>

namespace cli {
namespace {

const std::vector<std::pair<std::string_view, FormatKind>> kFormats = {
    {"text", FormatKind::text},
    {"csv", FormatKind::csv},
    {"points-csv", FormatKind::points_csv},
    {"json", FormatKind::json},
    {"html", FormatKind::html},
    {"junit", FormatKind::junit},
    {"sarif", FormatKind::sarif},
    {"sarif-all", FormatKind::sarif_all},
    {"github", FormatKind::github},
    {"gitlab", FormatKind::gitlab},
    {"markdown", FormatKind::markdown}};

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

ValueParser share_between(double& target, double low, double high) {
  return [&target, low, high](const std::string& text) -> std::string {
    const bool is_percent = text.ends_with('%');
    const std::string_view digits =
        std::string_view(text).substr(0, text.size() - (is_percent ? 1 : 0));
    const std::optional<double> number = calc::parse_number(digits);
    const double value = number.value_or(0.0) / (is_percent ? 100.0 : 1.0);
    if (!number || !(value > low && value < high)) {
      return fmt::format("a number between {} and {} is needed, or a percentage", low, high);
    }
    target = value;
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
  return [&target](const std::string& text) -> std::string {
    constexpr std::string_view kShadowMap = "shadow-map:";
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
}

ValueParser some_text(std::string& target) {
  return [&target](const std::string& text) -> std::string {
    if (text.empty()) return "a name is needed";
    target = text;
    return "";
  };
}

ValueOption rule_files_option(std::vector<std::string>& target) {
  return {"--rules", "FILE|DIR",
          "Rule pack, or folder of rule packs, to know besides those delivered; may be repeated",
          [&target](const std::string& text) -> std::string {
            if (text.empty()) return "the name of a file or folder is needed";
            target.push_back(text);
            return "";
          },
          true};
}

ValueParser seconds(double& target) {
  return [&target](const std::string& text) -> std::string {
    const std::optional<double> value = calc::parse_number(text);
    if (!value || *value <= 0.0) return "a number of seconds above 0 is needed";
    target = *value;
    return "";
  };
}

ValueParser format_item(std::vector<OutputFormat>& target) {
  return [&target](const std::string& text) -> std::string {
    const std::size_t equals = text.find('=');
    OutputFormat format;
    std::string problem = choice(format.kind, kFormats)(text.substr(0, equals));
    if (!problem.empty()) return problem;
    if (equals != std::string::npos) {
      format.file = text.substr(equals + 1);
      if (format.file.empty()) return "a file name is needed after '='";
    }
    target.push_back(std::move(format));
    return "";
  };
}

ValueParser forbidden_skip(calc::SkipSet& target) {
  return [&target](const std::string& text) -> std::string {
    if (text == "all") {
      target.forbid_all();
      return "";
    }
    if (const std::optional<calc::Skip> skip = calc::find_skip(text)) {
      target.forbid(*skip);
      return "";
    }
    std::vector<std::string_view> names;
    for (std::size_t s = 0; s < calc::kSkips; ++s) {
      names.push_back(calc::skip_name(static_cast<calc::Skip>(s)));
    }
    names.push_back("all");
    return one_of_message(text, names);
  };
}

namespace {

constexpr std::pair<std::string_view, bool GpuStages::*> kGpuStages[] = {
    {"light-paths", &GpuStages::light_paths},
    {"connections", &GpuStages::connections},
    {"near-field", &GpuStages::near_field}};

}  // namespace

std::vector<std::string_view> gpu_stage_names(const GpuStages& stages) {
  std::vector<std::string_view> names;
  for (const auto& [name, member] : kGpuStages) {
    if (stages.*member) names.push_back(name);
  }
  return names;
}

ValueParser gpu_stages(std::optional<GpuStages>& target) {
  return [&target](const std::string& text) -> std::string {
    GpuStages stages{false, false, false};
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      const std::string_view name = std::string_view(text).substr(begin, end - begin);
      const auto found = std::find_if(std::begin(kGpuStages), std::end(kGpuStages),
                                      [&](const auto& stage) { return stage.first == name; });
      if (found == std::end(kGpuStages)) return one_of_message(name, gpu_stage_names(GpuStages()));
      if (stages.*found->second) return std::string(name) + " is named twice";
      stages.*found->second = true;
      begin = end + 1;
    }
    target = stages;
    return "";
  };
}

ValueParser moment(std::string& target) {
  return [&target](const std::string& text) -> std::string {
    const std::optional<std::uint64_t> epoch_s =
        text == "now" ? static_cast<std::uint64_t>(std::time(nullptr)) : parse_count(text);
    std::optional<std::string> formatted = epoch_s ? format_epoch(*epoch_s) : std::nullopt;
    if (!formatted) return "'now' or whole seconds since 1970-01-01 UTC are needed";
    target = std::move(*formatted);
    return "";
  };
}

std::string one_of_message(std::string_view text, const std::vector<std::string_view>& names) {
  return calc::join_choices(names) + " is needed" + calc::suggestion(text, names);
}

}  // namespace cli
