#include "report/shell/options/chosen_space.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

namespace cli {

const calc::Space* find_chosen_space(const calc::Project& project, const std::string& id,
                                     calc::Diagnostics& diagnostics) {
  std::vector<std::string_view> ids;
  for (const calc::Space& space : project.spaces) {
    if (space.id == id || (id.empty() && project.spaces.size() == 1)) return &space;
    ids.push_back(space.id);
  }
  diagnostics.report(calc::DiagnosticId::choose_space, {project.path, 0, 0},
                     id.empty() ? fmt::format("the project has {} spaces", ids.size())
                                : fmt::format("the project has no space '{}'", id),
                     calc::join_choices(ids));
  return nullptr;
}

}  // namespace cli
