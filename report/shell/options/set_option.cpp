#include "report/shell/options/set_option.h"

#include "calc/base/diagnostics.h"
#include "report/shell/process/print.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>

namespace cli {

Option set_option(std::vector<check::SetValue>& set) {
  const auto parse = [&set](const std::string& text) -> std::string {
    const std::size_t equals = text.find('=');
    if (equals == text.npos || equals == 0) {
      return fmt::format("'{}' is not PATH=VALUE, as linear.flux-lm=4000", text);
    }
    set.push_back({text.substr(0, equals), text.substr(equals + 1)});
    return "";
  };
  return {"--set", "PATH=VALUE",
          "Set an attribute of the project for this run; repeatable. The file stays as it is, and "
          "every result warns of the change. PATH is ID.attribute (linear.flux-lm=4000). Where an "
          "id is not unique, write the ids of the elements around it first "
          "(room.desk.general.at-least=500). luxgate.attribute is an attribute of the root",
          parse, true};
}

bool check_values_or_print(const ProjectOptions& input, const std::vector<check::SetValue>& set,
                           std::string_view option, const calc::FileReader& files) {
  calc::Diagnostics diagnostics;
  if (!set.empty()) check::check_values(input.projects, set, option, files, diagnostics);
  print_diagnostics(diagnostics.all(), true);
  return !diagnostics.has_errors();
}

}  // namespace cli
