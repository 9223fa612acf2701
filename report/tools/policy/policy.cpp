#include "report/tools/policy/policy.h"

#include "calc/base/file_reader.h"
#include "report/policy/policy.h"
#include "report/shell/options/policy_option.h"
#include "report/shell/process/print.h"

#include <memory>
#include <string>
#include <vector>

namespace cli {

Command policy_command() {
  const auto files = std::make_shared<std::vector<std::string>>();
  const auto file = std::make_shared<std::string>();
  Command check{"check", "Find errors in policies"};
  check.places = {{"files", "FILE", "Policies", files.get()}};
  check.examples = {{"luxgate policy check office-policy.xml", ""}};
  check.exit_codes = {{0, "no error"}, {2, "at least one error"}};
  check.run = [files](const RunContext&) {
    const calc::DiskFileReader disk;
    ExitCode code = kAllMet;
    for (const std::string& one : *files) {
      if (!read_policy_or_print(one, disk)) code = kNotJudged;
    }
    return code;
  };
  Command explain{"explain", "Explain in words what a policy requires"};
  explain.places = {{"file", "FILE", "A policy", file.get()}};
  explain.examples = {{"luxgate policy explain office-policy.xml", ""}};
  explain.exit_codes = {{0, "no error"}, {2, "at least one error"}};
  explain.run = [file](const RunContext&) {
    const auto policy = read_policy_or_print(*file, calc::DiskFileReader());
    if (!policy) return kNotJudged;
    return print_outcome({kAllMet, report::explain_policy(*policy), {}});
  };
  Command schema{"schema", "Print the XML schema of policies"};
  schema.examples = {{"luxgate policy schema", "For an editor or a validator"}};
  schema.exit_codes = {{0, "printed"}, {2, "an error"}};
  schema.run = [](const RunContext&) {
    return print_outcome({kAllMet, report::policy_schema(), {}});
  };
  Command command{"policy", "Check and explain policies, the rules of the owner of a gate"};
  command.actions = {std::move(check), std::move(explain), std::move(schema)};
  return command;
}

}  // namespace cli
