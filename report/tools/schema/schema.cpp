#include "report/tools/schema/schema.h"

#include "report/result_file/result_schema.h"
#include "report/shell/print.h"
#include "report/tools/sweep/sweep_table.h"
#include "rules/binding/project_schema.h"

#include <memory>

namespace cli {

Command schema_command() {
  struct Asked {
    bool results = false, sweeps = false, reference = false;
  };
  const auto asked = std::make_shared<Asked>();
  Command command{"schema", "Print the XML schema of project files"};
  command.options = {
      {"--markdown", "", "Print the reference of project files for people instead, in Markdown",
       &asked->reference},
      {"--result", "", "Print the JSON schema of 'check --format json' instead", &asked->results},
      {"--sweep", "", "Print the JSON schema of 'sweep --format json' instead", &asked->sweeps}};
  command.examples = {{"luxgate schema", "For an editor or a validator"},
                      {"luxgate schema --result", "For who reads results"}};
  command.exit_codes = {{0, "printed"}, {2, "an error"}};
  command.complete = [asked](const Environment&) -> std::string {
    return int{asked->results} + int{asked->sweeps} + int{asked->reference} > 1
               ? "--markdown, --result and --sweep exclude each other"
               : "";
  };
  command.run = [asked](const RunContext&) {
    return print_outcome({kAllMet,
                          asked->results     ? report::result_schema()
                          : asked->sweeps    ? sweep_schema()
                          : asked->reference ? rules::project_reference()
                                             : rules::project_schema(),
                          {}});
  };
  return command;
}

}  // namespace cli
