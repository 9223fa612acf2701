#include "rules/binding/judged_project.h"

#include "calc/project/project_xml.h"
#include "rules/binding/bind.h"
#include "rules/binding/bind_buildings.h"
#include "rules/binding/workplace.h"

#include <cstddef>
#include <utility>

namespace rules {

std::optional<JudgedProject> load_judged_project(const calc::FileReader& files,
                                                 const std::string& path,
                                                 const std::vector<RulePack>& packs,
                                                 calc::Diagnostics& diagnostics,
                                                 const calc::Budget& budget) {
  const std::size_t errors = diagnostics.error_count();
  const std::size_t first = diagnostics.all().size();
  std::optional<calc::ReadProject> read = calc::read_project(files, path, diagnostics, budget);
  if (!read) return std::nullopt;
  JudgedProject judged{std::move(read->project), {}, {}};
  make_workplace_planes(judged.project, packs, diagnostics, read->is_good);
  if (read->is_good) {
    judged.requirements = bind_requirements(judged.project, packs, diagnostics);
  } else {
    check_requirements(judged.project, packs, diagnostics);
  }
  judged.buildings = bind_buildings(judged.project, packs, diagnostics);
  if (diagnostics.error_count() == errors) return judged;
  diagnostics.sort_by_line(path, first);
  return std::nullopt;
}

}  // namespace rules
