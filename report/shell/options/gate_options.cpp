#include "report/shell/options/gate_options.h"

#include "calc/base/names.h"
#include "calc/base/text.h"
#include "report/shell/command/option_values.h"
#include "rules/catalogue/metric.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace cli {
namespace {

// "1%", or "Uo=2%" of one quantity; the last word on each counts.
std::string take_allowed_loss(const std::string& text, report::Gate& gate) {
  const std::size_t sign = text.find('=');
  const std::string name = sign == std::string::npos ? "" : text.substr(0, sign);
  const std::optional<double> share =
      parse_share(sign == std::string::npos ? text : text.substr(sign + 1));
  if (!share || !(*share >= 0.0 && *share < 1.0)) {
    return "a share from 0 to below 1 is needed, such as 0.01 or 1%, or with a quantity, such as "
           "Uo=2%";
  }
  if (sign == std::string::npos) {
    gate.allowed_worse = *share;
    return "";
  }
  const std::optional<rules::Metric> metric = calc::find_value<rules::Metric>(name);
  if (!metric) {
    return fmt::format("quantity '{}': {}", name,
                       one_of_message(name, calc::names_of<rules::Metric>()));
  }
  auto& losses = gate.allowed_worse_of;
  std::erase_if(losses, [&](const report::AllowedLoss& loss) { return loss.metric == *metric; });
  losses.push_back({*metric, *share});
  return "";
}

ValueParser reason(std::string& target) {
  return [&target](const std::string& text) -> std::string {
    if (calc::trim(text).empty()) return "a reason is needed; reports show it";
    target = text;
    return "";
  };
}

}  // namespace

Option baseline_option(std::string& target) {
  return {"--baseline", "FILE",
          "Compare with an earlier result that '--format json' wrote. Reports say what became "
          "better or worse, what is required less, and what changed in the input",
          some_text(target)};
}

std::vector<Option> gate_options(report::Gate& gate) {
  return {{"--gate", "NAME",
           "Choose what ends with exit code 1: all or regression; default all. all: everything "
           "that is not met. regression: only what was met or not required before, values that "
           "fell by more than --allow-worse, and weaker requirements that are not accepted",
           choice<report::GateMode>(gate.mode, {{"all", report::GateMode::all},
                                                {"regression", report::GateMode::regression}})},
          {"--allow-worse", "SHARE",
           "Let values fall by this share with --gate regression, as 0.01 or 1%; default 0.01. It "
           "counts while the verdict stays the same. For one quantity: Uo=2%; repeatable",
           [&gate](const std::string& text) { return take_allowed_loss(text, gate); }, true},
          {"--accept-weaker", "REASON",
           "Accept weaker and other requirements with --gate regression. The reason is printed in "
           "reports",
           reason(gate.weaker_accepted_by)}};
}

std::string gate_contradiction(const report::Gate& gate, bool is_compared,
                               const std::string& with) {
  if (!is_compared && gate.mode == report::GateMode::regression) {
    return fmt::format("--gate regression needs {} to compare with", with);
  }
  if (gate.mode == report::GateMode::all && !gate.weaker_accepted_by.empty()) {
    return "--accept-weaker is for --gate regression";
  }
  return "";
}

}  // namespace cli
