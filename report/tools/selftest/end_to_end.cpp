#include "report/tools/selftest/end_to_end.h"

#include "calc/project/project_xml.h"
#include "calc/scene/sensor_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace cli::selftest {

calc::FileContent TextFiles::read_within(const std::string&, const std::string& path) const {
  const auto found = files_.find(path);
  if (found == files_.end()) return {{}, "No such file or directory"};
  return {found->second, {}};
}

std::string errors_in(const calc::Diagnostics& diagnostics) {
  std::string text;
  for (const calc::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity() != calc::Severity::error) continue;
    text += fmt::format("{}error[{}]: {}", text.empty() ? "" : "; ",
                        calc::diagnostic_name(diagnostic.id), diagnostic.message);
  }
  return text;
}

void add_from_files(CaseResult& result, const std::map<std::string, std::string>& files,
                    const std::vector<KnownPoint>& known, const std::string& label,
                    const Effort& effort, double known_to, double widest) {
  constexpr double kSamePlace_m = 1e-9;
  calc::Diagnostics diagnostics;
  const auto project = calc::load_project(TextFiles(files), "project.xml", diagnostics);
  std::optional<calc::SensorGrid> grid;
  const calc::Space* space = nullptr;
  if (project) {
    const auto found = std::find_if(project->spaces.begin(), project->spaces.end(),
                                    [](const calc::Space& one) { return !one.planes.empty(); });
    if (found != project->spaces.end()) space = &*found;
    if (space != nullptr) grid = calc::make_sensor_grid(space->planes[0], *space, diagnostics);
  }
  if (!grid) {
    result.problem = label + errors_in(diagnostics);
    return;
  }
  std::vector<Point> points;
  std::vector<double> exact_lx;
  for (std::size_t i = 0; i < known.size(); ++i) {
    points.push_back(known[i].point);
    exact_lx.push_back(known[i].exact_lx);
    if (i < grid->position_m.size() &&
        glm::distance(grid->position_m[i], points[i].position_m) < kSamePlace_m) {
      continue;
    }
    result.problem = fmt::format("{}point {} is not at its expected place", label, i + 1);
    return;
  }
  if (grid->position_m.size() != known.size()) {
    result.problem = label + "the plane has more points than the reference";
    return;
  }
  const std::size_t before = result.measured.size();
  result.add_points(solve(*project, *space, *grid, effort), points, exact_lx, known_to, widest);
  for (std::size_t i = before; i < result.measured.size(); ++i) {
    result.measured[i].what = label + result.measured[i].what;
  }
}

void add_points_from_files(CaseResult& result, const std::string& project,
                           std::map<std::string, std::string> files,
                           const std::vector<KnownPoint>& known, const std::string& label,
                           const Effort& effort, double known_to, double widest) {
  std::string list = "x,y,z,nx,ny,nz\n";
  for (const KnownPoint& one : known) {
    const glm::dvec3 &p = one.point.position_m, &n = one.point.normal;
    list += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", p.x, p.y, p.z, n.x,
                        n.y, n.z);
  }
  files["points.csv"] = list;
  files["project.xml"] =
      fmt::format(fmt::runtime(project), "<plane id=\"p\" file=\"points.csv\"/>");
  add_from_files(result, files, known, label, effort, known_to, widest);
}

}  // namespace cli::selftest
