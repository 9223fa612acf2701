#include "report/check/plane_jobs.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/scene/grid_aliasing.h"
#include "report/check/between_points_warning.h"
#include "rules/applicability/applicability.h"
#include "rules/applicability/lost_points.h"
#include "rules/binding/bind.h"
#include "rules/verdict/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>

namespace check {
namespace {

// Requirements of one plane and one place that have the same problem.
struct Unjudged {
  const rules::Requirement* first;
  std::vector<std::string> ids;
};

bool is_like(const rules::Requirement& a, const rules::Requirement& b) {
  return a.problem == b.problem && a.where.file == b.where.file && a.where.line == b.where.line &&
         a.where.column == b.where.column;
}

std::vector<Unjudged> unjudged_of(const PlaneJob& job) {
  std::vector<Unjudged> list;
  for (const rules::Requirement& requirement : job.requirements) {
    if (requirement.problem.empty() || requirement.severity == rules::Severity::advice) continue;
    auto same = std::find_if(list.begin(), list.end(), [&](const Unjudged& known) {
      return is_like(*known.first, requirement);
    });
    if (same == list.end()) same = list.insert(list.end(), {&requirement, {}});
    same->ids.push_back(requirement.id);
  }
  return list;
}

// What somebody has left out up to a day that is over is asked for again, and cannot be judged.
void add_no_longer_left_out(const calc::Space& space, const rules::JudgedProject& loaded,
                            const std::vector<rules::RulePack>& packs, std::string_view day,
                            std::vector<PlaneJob>& jobs, calc::Diagnostics& diagnostics) {
  for (const calc::LeftOutPlane& left_out : space.left_out) {
    if (left_out.by.holds_on(day)) continue;
    PlaneJob& job = jobs.emplace_back();
    job.plane = &left_out.plane;
    job.requirements =
        rules::requirements_of_left_out(loaded.project, space, left_out.plane, packs);
    job.reason = rules::ended_words(left_out.by);
    diagnostics.report(calc::DiagnosticId::zone_no_longer_left_out, left_out.plane.where,
                       left_out.plane.id, job.reason);
  }
}

void warn_of_small_task(const calc::CalcPlane& plane, const calc::SensorGrid& grid,
                        const std::vector<rules::Requirement>& asked,
                        calc::Diagnostics& diagnostics) {
  const auto first = std::find_if(asked.begin(), asked.end(), [](const rules::Requirement& one) {
    return !one.origin.pack.empty() && !rules::is_of_space(one.metric);
  });
  const calc::Message words = rules::small_task_words(plane, grid);
  if (first == asked.end() || words.empty()) return;
  diagnostics.report(calc::DiagnosticId::task_is_speck, first->where, plane.id, words);
}

// A rule pack says how many points may be lost; of limits of the project's own nobody does, and a
// verdict on what is left may be about a small part. of_grid: what is lost may be told already.
void warn_of_lost_points(const PlaneJob& job, const calc::Diagnostics& of_grid,
                         calc::Diagnostics& diagnostics) {
  constexpr double kMostLost = 0.25;
  const bool is_told = std::any_of(
      of_grid.all().begin(), of_grid.all().end(), [](const calc::Diagnostic& diagnostic) {
        return diagnostic.id == calc::DiagnosticId::route_points_left_out ||
               diagnostic.id == calc::DiagnosticId::points_left_out ||
               diagnostic.id == calc::DiagnosticId::points_in_surface;
      });
  const bool is_asked = std::any_of(
      job.requirements.begin(), job.requirements.end(), [](const rules::Requirement& requirement) {
        return requirement.origin.pack.empty() && counts(requirement) &&
               requirement.metric != rules::Metric::value_at_point;
      });
  const rules::LostPoints lost = rules::lost_points(*job.grid);
  if (is_told || !is_asked || lost.share() <= kMostLost) return;
  diagnostics.report(calc::DiagnosticId::many_points_left_out, job.plane->where, job.plane->id,
                     lost.words);
}

// Once for a plane, for the first scene in which it is so.
void warn_of_grid_aliasing(const calc::Project& project, const calc::Space& space,
                           const PlaneJob& job, calc::Diagnostics& diagnostics) {
  constexpr double kPointsBetween = 3.0;  // three phases see half of a ripple at least
  if (!is_asked_of_points(job)) return;
  std::set<std::string> scenes;
  for (const rules::Requirement& requirement : job.requirements) {
    if (counts(requirement)) scenes.insert(requirement.scene);
  }
  for (const std::string& id : scenes) {
    const auto scene = std::find_if(project.scenes.begin(), project.scenes.end(),
                                    [&](const calc::LightScene& one) { return one.id == id; });
    const auto trap = calc::grid_aliasing(project, space, *job.grid,
                                          scene == project.scenes.end() ? nullptr : &*scene);
    if (!trap) continue;
    diagnostics.report(calc::DiagnosticId::grid_trap, job.plane->where, job.plane->id,
                       id.empty() ? "" : fmt::format(" in scene '{}'", id), trap->points_m,
                       trap->along.x + 0.0, trap->along.y + 0.0, trap->first_id, trap->last_id,
                       trap->luminaires_m, trap->luminaires_m / kPointsBetween);
    return;
  }
}

}  // namespace

std::vector<PlaneJob> make_plane_jobs(const calc::Space& space, const rules::JudgedProject& loaded,
                                      const std::vector<rules::RulePack>& packs,
                                      std::string_view day, calc::Diagnostics& diagnostics) {
  std::vector<PlaneJob> jobs;
  for (const calc::CalcPlane& plane : space.planes) {
    PlaneJob& job = jobs.emplace_back();
    job.plane = &plane;
    job.requirements = rules::requirements_of_plane(loaded.requirements, plane.id);
    calc::Diagnostics of_grid;  // all of its own: of many planes' messages some may be left out
    job.grid = calc::make_sensor_grid(plane, space, of_grid, &job.reason);
    diagnostics.add(of_grid);
    if (job.grid) {
      rules::check_applicability(
          {loaded.project, space, plane, *job.grid, packs, day, loaded.requirements},
          job.requirements);
      warn_of_small_task(plane, *job.grid, job.requirements, diagnostics);
      warn_of_grid_aliasing(loaded.project, space, job, diagnostics);
      warn_of_lost_points(job, of_grid, diagnostics);
    }
  }
  add_no_longer_left_out(space, loaded, packs, day, jobs, diagnostics);
  return jobs;
}

void warn_of_unjudged(const std::vector<PlaneJob>& jobs, calc::Diagnostics& diagnostics) {
  constexpr std::size_t kMostNamed = 4;
  for (const PlaneJob& job : jobs) {
    if (!job.grid) continue;  // an error already
    for (const Unjudged& unjudged : unjudged_of(job)) {
      diagnostics.report(calc::DiagnosticId::will_not_be_judged, unjudged.first->where,
                         job.plane->id, calc::list_names(unjudged.ids, kMostNamed),
                         unjudged.first->problem);
    }
  }
}

}  // namespace check
