#include "report/tools/schema/schema.h"

#include "report/result_file/result_schema.h"
#include "report/shell/print.h"
#include "rules/binding/project_schema.h"

#include <memory>

namespace cli {

Command schema_command() {
  const auto of_results = std::make_shared<bool>(false);
  Command command{"schema", "Print the XML schema of project files"};
  command.options = {
      {"--result", "", "Print the JSON schema of 'check --format json' instead", of_results.get()}};
  command.run = [of_results](const RunContext&) {
    return print_outcome(
        {kAllMet, *of_results ? report::result_schema() : rules::project_schema(), {}});
  };
  return command;
}

}  // namespace cli
