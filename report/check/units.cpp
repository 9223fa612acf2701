#include "report/check/units.h"

#include "calc/forecast/cost_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace check {
namespace {

// Of planes first .. last-1, calculated apart from the others.
double first_look_s(const calc::ScenePlan& plan, std::size_t first, std::size_t last,
                    const calc::RadiositySettings& settings) {
  calc::SpaceWorkload load = plan.workload;
  load.planes.assign(plan.workload.planes.begin() + static_cast<std::ptrdiff_t>(first),
                     plan.workload.planes.begin() + static_cast<std::ptrdiff_t>(last));
  const std::vector<std::uint64_t> paths(load.planes.size(), settings.first_paths);
  return calc::predict(load, paths, settings, 1).seconds.total();
}

void add_units(const std::string& project, const SpacePlan& space,
               const calc::RadiositySettings& settings, double split_above_s,
               std::vector<Unit>& units) {
  const std::vector<calc::PlanePlan>& planes = space.plan.planes;
  for (std::size_t first = 0, last = 0; first < planes.size(); first = last) {
    last = planes.size();
    if (first_look_s(space.plan, first, last, settings) > split_above_s) {
      last = first + 1;
      while (last < planes.size() &&
             first_look_s(space.plan, first, last + 1, settings) <= split_above_s) {
        ++last;
      }
    }
    Unit unit;
    unit.project = project;
    unit.space = space.id;
    unit.is_whole_space = first == 0 && last == planes.size();
    unit.first_look_s = first_look_s(space.plan, first, last, settings);
    for (std::size_t p = first; p < last; ++p) {
      unit.planes.push_back(planes[p].plane_id);
      unit.points += planes[p].points;
    }
    units.push_back(std::move(unit));
  }
}

}  // namespace

std::vector<Unit> units_of(const std::vector<ProjectPlan>& projects,
                           const calc::RadiositySettings& settings, double split_above_s) {
  std::vector<Unit> units;
  for (const ProjectPlan& project : projects) {
    for (const SpacePlan& space : project.spaces) {
      add_units(project.path, space, settings, split_above_s, units);
    }
  }
  return units;
}

std::string unit_name(const Unit& unit) {
  const std::string name = unit.project + ": " + unit.space;
  return unit.is_whole_space ? name : fmt::format("{} ({})", name, fmt::join(unit.planes, ", "));
}

std::vector<std::size_t> shards_of(const std::vector<Unit>& units, std::size_t count) {
  double sum_s = 0.0;
  for (const Unit& unit : units) sum_s += unit.first_look_s;
  const bool is_known = sum_s > 0.0;
  const double all_s = is_known ? sum_s : static_cast<double>(units.size());
  double before_s = 0.0;
  std::vector<std::size_t> shard;
  for (const Unit& unit : units) {
    const double own_s = is_known ? unit.first_look_s : 1.0;
    const double place = (before_s + 0.5 * own_s) / all_s * static_cast<double>(count);
    shard.push_back(std::min(static_cast<std::size_t>(place), count - 1));
    before_s += own_s;
  }
  return shard;
}

}  // namespace check
