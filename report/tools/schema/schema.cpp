#include "report/tools/schema/schema.h"

#include "report/result_file/result_schema.h"
#include "report/shell/process/print.h"
#include "report/tools/advise/advice.h"
#include "report/tools/sweep/sweep_table.h"
#include "rules/binding/project_schema.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

namespace cli {
namespace {

struct OtherSchema {
  const char *option, *help;
  std::string (*text)();
};

constexpr std::array kOtherSchemas{
    OtherSchema{"--markdown", "Print the reference of project files in Markdown, for people",
                rules::project_reference},
    OtherSchema{"--result", "Print the JSON schema of 'check --format json'",
                report::result_schema},
    OtherSchema{"--sweep", "Print the JSON schema of 'sweep --format json'", sweep_schema},
    OtherSchema{"--advice", "Print the JSON schema of 'advise --format json'", advice_schema}};

}  // namespace

Command schema_command() {
  const auto asked = std::make_shared<std::array<bool, kOtherSchemas.size()>>();
  Command command{"schema", "Print the XML schema of project files"};
  for (std::size_t i = 0; i < kOtherSchemas.size(); ++i) {
    command.options.push_back({kOtherSchemas[i].option, "", kOtherSchemas[i].help, &(*asked)[i]});
  }
  command.examples = {{"luxgate schema", "For an editor or a validator"},
                      {"luxgate schema --result", "For who reads results"}};
  command.exit_codes = {{0, "printed"}, {2, "an error"}};
  command.complete = [asked](const Environment&) -> std::string {
    if (std::count(asked->begin(), asked->end(), true) <= 1) return "";
    std::string names;
    for (const OtherSchema& one : kOtherSchemas) {
      names += (names.empty() ? "" : ", ") + std::string(one.option);
    }
    return names + ": one of them at a time";
  };
  command.run = [asked](const RunContext&) {
    const auto one =
        static_cast<std::size_t>(std::find(asked->begin(), asked->end(), true) - asked->begin());
    const bool is_other = one < kOtherSchemas.size();
    return print_outcome(
        {kAllMet, is_other ? kOtherSchemas[one].text() : rules::project_schema(), {}});
  };
  return command;
}

}  // namespace cli
