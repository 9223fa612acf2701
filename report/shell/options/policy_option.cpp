#include "report/shell/options/policy_option.h"

#include "calc/base/diagnostic_ids.h"
#include "report/formats/format.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/print.h"

#include <string_view>
#include <vector>

namespace cli {

Option policy_option(std::string& target) {
  return {"--policy", "FILE",
          "Apply the policy of the owner of the gate. It says who may waive what, which rows are "
          "required and which factors are believed. What it does not allow counts as an error. See "
          "'luxgate policy'",
          some_text(target)};
}

std::optional<report::Policy> read_policy_or_print(const std::string& file,
                                                   const calc::FileReader& files) {
  calc::Diagnostics diagnostics;
  std::optional<report::Policy> policy;
  std::vector<std::string_view> formats;
  for (const report::Format& format : report::formats()) formats.push_back(format.name);
  if (const calc::FileContent content = files.read(file); content.ok()) {
    policy = report::parse_policy(content.bytes, file, formats, diagnostics);
  } else {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {}, file, content.error);
  }
  print_diagnostics(diagnostics.all(), false);
  return policy;
}

}  // namespace cli
