#include "report/check/check_project.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "calc/forecast/cost_model.h"
#include "calc/radiosity/looks/look_key.h"
#include "calc/radiosity/looks/solve.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"
#include "calc/scene/separate_luminaires.h"
#include "report/build/build.h"
#include "report/build/build_evidence.h"
#include "report/build/build_luminaire_shares.h"
#include "report/build/build_plan_marks.h"
#include "report/build/build_road.h"
#include "report/check/between_points_warning.h"
#include "report/check/in_order.h"
#include "report/check/load_judged_project.h"
#include "report/check/plane_jobs.h"
#include "report/document/luminaire_labels.h"
#include "report/text/one_source_note.h"
#include "rules/binding/colour_rendering.h"
#include "rules/binding/judged_project.h"
#include "rules/measure/error_spending.h"
#include "rules/verdict/coverage.h"
#include "rules/verdict/judge.h"
#include "rules/verdict/judge_aggregates.h"
#include "rules/verdict/stop_rule.h"
#include "rules/verdict/waiver.h"
#include "rules/verdict/waiver_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace check {
namespace {

// A run and who watches it, for one project.
struct Context {
  Context(const Run& run, Observer& its_observer)
      : settings(run.settings()),
        files(run.files()),
        packs(run.packs()),
        stages(run.stages()),
        observer(its_observer),
        vertices(run.vertices()),
        kept(run.store()),
        most_spaces(run.concurrency().most_begun) {}

  const Settings& settings;
  const calc::FileReader& files;
  const std::vector<rules::RulePack>& packs;
  const calc::Stages stages;
  Observer& observer;
  const VertexSource* vertices;  // null: light paths are traced
  const std::optional<calc::LookStore> kept;
  const std::size_t most_spaces;  // that are calculated at the same time
};

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::optional<ProjectInBudget> load(const std::string& path, const calc::FileReader& files,
                                    const std::vector<rules::RulePack>& packs, int replicates,
                                    const calc::Budget& budget, calc::Diagnostics& diagnostics) {
  std::optional<ProjectInBudget> loaded =
      load_in_budget(path, files, packs, replicates, budget, diagnostics);
  if (!loaded) return std::nullopt;
  const std::vector<rules::Requirement>& requirements = loaded->judged.requirements;
  const std::vector<rules::BuildingQuestion>& buildings = loaded->judged.buildings;
  const auto is_counted = [](const rules::Requirement& requirement) {
    return requirement.severity != rules::Severity::advice;
  };
  const bool counts = std::any_of(requirements.begin(), requirements.end(), is_counted) ||
                      std::any_of(buildings.begin(), buildings.end(), [&](const auto& question) {
                        return is_counted(question.requirement);
                      });
  if (!counts) {
    diagnostics.report(calc::DiagnosticId::nothing_required, {path, 0, 0});
  }
  return loaded;
}

report::ProjectPart unreadable_project(const std::string& path,
                                       const calc::Diagnostics& diagnostics) {
  report::ProjectPart part;
  part.path = path;
  part.diagnostics = diagnostics.all();
  return part;
}

// The planes that have points; tasks keep their order.
struct Tasks {
  std::vector<calc::PlaneTask> list;
  std::vector<const PlaneJob*> job;
  std::vector<std::vector<report::PlaneLook>> looks;  // taken so far
};

// planes: ids of those that are wanted; null: all.
Tasks make_tasks(const std::vector<PlaneJob>& jobs, const std::vector<std::string>* planes) {
  Tasks tasks;
  for (const PlaneJob& job : jobs) {
    if (!job.grid) continue;
    if (planes != nullptr &&
        std::find(planes->begin(), planes->end(), job.plane->id) == planes->end())
      continue;
    tasks.list.push_back({job.plane->id, &*job.grid});
    tasks.job.push_back(&job);
  }
  tasks.looks.resize(tasks.list.size());
  return tasks;
}

// "" where the light of single luminaires can be kept apart, else why not: it takes so many
// numbers.
calc::Message problem_with_separation(const calc::PreparedScene& scene, const Tasks& tasks,
                                      const Settings& settings) {
  constexpr double kMostNumbers = 1 << 24;  // 128 MiB for each of the field's parts
  constexpr std::size_t kMostLuminaires = 4096;
  double receivers = 0.0;
  for (const calc::PlaneTask& task : tasks.list) {
    receivers += static_cast<double>(task.grid->position_m.size() *
                                     calc::receivers_per_point(task.grid->derived));
  }
  const std::size_t luminaires = scene.luminaires.size();
  const double numbers =
      receivers * static_cast<double>(luminaires) * settings.radiosity.replicates;
  if (luminaires <= kMostLuminaires && numbers <= kMostNumbers) return {};
  return calc::say<calc::Sentence::not_by_luminaire>(luminaires, receivers);
}

// The project's settings with what is left of its time; a limit of 0 would mean none.
calc::RadiositySettings remaining_settings(const Settings& settings, const Stopwatch& watch) {
  calc::RadiositySettings remaining = settings.radiosity;
  if (remaining.time_limit_s > 0.0) {
    constexpr double kShortest_s = 1e-3;
    remaining.time_limit_s = std::max(remaining.time_limit_s - watch.seconds(), kShortest_s);
  }
  return remaining;
}

calc::SpaceSolution solve(const calc::Project& project, const calc::PreparedScene& scene,
                          Tasks& tasks, const Context& context, const Stopwatch& watch,
                          const calc::VertexCache* cache, double& judge_s) {
  const Settings& wanted = context.settings;
  const rules::StopRule rule{wanted.goal, wanted.tolerance, wanted.confidence};
  const auto test = [&](std::size_t task, const calc::PlaneField& field, calc::Look) {
    const Stopwatch look_watch;
    const PlaneJob& job = *tasks.job[task];
    rules::LookJudgement look =
        rules::judge_look(rule, job.requirements, *job.grid, field, project.scenes);
    tasks.looks[task].push_back(
        report::build_look(field, job.grid->derived, look.findings, wanted.confidence));
    judge_s += look_watch.seconds();
    return calc::LookAnswer{look.finished, std::move(look.active)};
  };
  const auto progress = [&](const calc::SolveProgress& solve_progress) {
    return context.observer.go_on(solve_progress);
  };
  return calc::solve_illuminance(scene, tasks.list, remaining_settings(wanted, watch),
                                 wanted.confidence, context.stages, test, progress, cache,
                                 context.kept ? &*context.kept : nullptr);
}

// Nothing leaves a closed room, unless a luminaire stands outside it or in a wall.
void warn_about_lost_light(const calc::Space& space, const calc::FluxBalance& balance,
                           calc::Diagnostics& diagnostics) {
  constexpr double kNegligibleShare = 1e-3;
  if (!(balance.escaped_lm.value > kNegligibleShare * balance.emitted_lm)) return;
  if (!space.surfaces_file.empty()) {
    diagnostics.report(space.is_from_mesh ? calc::DiagnosticId::mesh_room_leaks
                                          : calc::DiagnosticId::gbxml_room_leaks,
                       space.where, 100.0 * balance.escaped_lm.value / balance.emitted_lm, space.id,
                       space.surfaces_file);
  }
  if (!space.shell) return;
  diagnostics.report(calc::DiagnosticId::light_leaves_room, space.where,
                     100.0 * balance.escaped_lm.value / balance.emitted_lm, space.id);
}

// Whoever asks for an accuracy must see where it is not there: verdicts do not say it.
void warn_about_accuracy(const calc::Space& space, const std::vector<calc::PlaneField>& fields,
                         const Settings& settings, calc::Diagnostics& diagnostics) {
  if (settings.goal != rules::Goal::accuracy) return;
  const auto is_short = [](const calc::PlaneField& field) {
    return field.problem.empty() && (field.stop == calc::StopReason::path_limit ||
                                     field.stop == calc::StopReason::time_limit);
  };
  const auto count = std::count_if(fields.begin(), fields.end(), is_short);
  if (count == 0) return;
  const calc::PlaneField& first = *std::find_if(fields.begin(), fields.end(), is_short);
  diagnostics.report(calc::DiagnosticId::accuracy_not_reached, space.where, count,
                     count == 1 ? "" : "s", space.id, settings.tolerance, first.plane_id,
                     calc::name_of(first.stop));
}

// What the calculation refused is an error of that plane.
void take_problems(std::vector<PlaneJob>& jobs, const std::vector<calc::PlaneField>& fields,
                   calc::Diagnostics& diagnostics) {
  std::size_t task = 0;
  for (PlaneJob& job : jobs) {
    if (!job.grid) continue;
    job.reason = fields[task++].problem;
    if (job.reason.empty()) continue;
    diagnostics.report(calc::DiagnosticId::plane_not_computed, job.plane->where, job.plane->id,
                       job.reason);
  }
}

report::PlanePart judge(const PlaneJob& job, const calc::PlaneField* field,
                        const std::vector<calc::LightScene>& scenes, const Settings& settings) {
  if (field == nullptr || !job.reason.empty()) {
    return report::build_uncomputed_plane(*job.plane, job.reason,
                                          rules::not_judged_plane(job.requirements, job.reason));
  }
  std::vector<rules::Finding> findings =
      rules::judge_plane(job.requirements, *job.grid, *field, scenes, settings.confidence);
  for (rules::Finding& finding : findings) rules::apply_waiver(finding, settings.today);
  return report::build_plane(*job.plane, *job.grid, *field, std::move(findings),
                             settings.confidence, scenes);
}

// Seconds of spaces that run at the same time add up to more than the clock's.
void add_times(const report::PhaseTimes& space, report::PhaseTimes& times) {
  times.prepare_s += space.prepare_s;
  times.direct_s += space.direct_s;
  times.pool_s += space.pool_s;
  times.maps_s += space.maps_s;
  times.connect_s += space.connect_s;
  times.near_s += space.near_s;
  times.judge_s += space.judge_s;
}

void add_times(const calc::SpaceSolution& solution, report::PhaseTimes& times) {
  times.prepare_s += solution.times.build_s;
  times.direct_s += solution.times.direct_s;
  times.pool_s += solution.times.pool_s;
  times.maps_s += solution.times.maps_s;
  times.connect_s += solution.times.connect_s;
  times.near_s += solution.times.near_s;
}

std::vector<rules::JudgedPlane> judged_planes(const calc::Space& space,
                                              const report::SpacePart& part,
                                              const std::string& day) {
  const std::vector<const calc::CalcPlane*> asked = rules::planes_asked(space, day);
  std::vector<rules::JudgedPlane> planes;
  for (std::size_t k = 0; k < part.planes.size(); ++k) {
    planes.push_back({&space, asked[k], &part.planes[k].findings});
  }
  return planes;
}

// A space, and what only its project can tell or add up.
struct CheckedSpace {
  report::SpacePart part;
  calc::Diagnostics diagnostics;
  report::PhaseTimes times;
  std::optional<calc::PreparedScene> scene;  // for pictures of the room
};

// The light of a space, and what it was calculated of.
struct LitSpace {
  std::vector<PlaneJob> jobs;
  calc::PreparedScene scene;
  std::optional<calc::PreparedScene> apart;  // each luminaire for itself
  calc::Message not_apart;                   // why not, although it was asked for
  Tasks tasks;
  calc::SpaceSolution solution;
};

// planes: as of make_tasks(). Empty: light vertices that were given are not of this space.
std::unique_ptr<LitSpace> light_space(const calc::Space& space, const rules::JudgedProject& loaded,
                                      const Context& context, const Stopwatch& watch,
                                      const std::vector<std::string>* planes,
                                      calc::Diagnostics& diagnostics, report::PhaseTimes& times) {
  const Stopwatch prepare_watch;
  auto lit = std::make_unique<LitSpace>();  // its tasks point at its jobs
  lit->jobs = make_plane_jobs(space, loaded, context.packs, context.settings.today, diagnostics);
  lit->scene = calc::prepare_scene(loaded.project, space);
  lit->tasks = make_tasks(lit->jobs, nullptr);
  if (context.settings.by_luminaire) {
    lit->not_apart = problem_with_separation(lit->scene, lit->tasks, context.settings);
    if (lit->not_apart.empty()) calc::separate_luminaires(lit->apart.emplace(lit->scene));
  }
  if (planes != nullptr) lit->tasks = make_tasks(lit->jobs, planes);
  const calc::PreparedScene& solved = lit->apart ? *lit->apart : lit->scene;
  times.prepare_s += prepare_watch.seconds();

  const bool is_traced =
      context.vertices == nullptr || context.vertices->cache.space_id != space.id;
  if (!is_traced &&
      !fits(*context.vertices, solved, context.settings.radiosity.skips, diagnostics)) {
    return nullptr;
  }
  const calc::VertexCache* cache = is_traced ? nullptr : &context.vertices->cache;
  if (!lit->tasks.list.empty()) {
    lit->solution = solve(loaded.project, solved, lit->tasks, context, watch, cache, times.judge_s);
    context.observer.solved(loaded.project.path, space.id, solved, lit->tasks.list, lit->solution);
  }
  add_times(lit->solution, times);
  return lit;
}

// Looks with few places at all planes, and with more at those that seem to be flattered: that a few
// places miss the mean is no reason for a warning.
void warn_of_light_between_points(const calc::Space& space, const LitSpace& lit,
                                  const rules::JudgedProject& loaded, const Context& context,
                                  calc::Diagnostics& diagnostics) {
  constexpr int kMorePairs = 12;
  const std::vector<calc::LightScene>& scenes = loaded.project.scenes;
  std::vector<calc::PlaneOfPoints> planes;
  std::vector<std::size_t> tasks;
  for (std::size_t t = 0; t < lit.tasks.list.size(); ++t) {
    const PlaneJob& job = *lit.tasks.job[t];
    if (!job.reason.empty() || !is_asked_of_points(job)) continue;
    planes.push_back({job.plane, &*job.grid, telling_points(job, lit.solution.fields[t], scenes)});
    tasks.push_back(t);
  }
  for (const int pairs : {1, kMorePairs}) {
    const std::vector<calc::LightBetweenPoints> light =
        calc::light_between_points(lit.apart ? *lit.apart : lit.scene, space, planes,
                                   {context.settings.radiosity.jobs,
                                    [&context] { return !context.observer.is_stopped(); }, pairs});
    std::vector<calc::PlaneOfPoints> doubtful;
    std::vector<std::size_t> doubtful_tasks;
    for (std::size_t p = 0; p < light.size(); ++p) {
      const PlaneJob& job = *lit.tasks.job[tasks[p]];
      const std::optional<FlatteringPoints> flattering =
          flattering_points(job, lit.solution.fields[tasks[p]], light[p], scenes);
      if (!flattering) continue;
      doubtful.push_back(planes[p]);
      doubtful_tasks.push_back(tasks[p]);
      if (pairs != kMorePairs) continue;
      diagnostics.report(calc::DiagnosticId::light_between_points, job.plane->where, job.plane->id,
                         flattering->at_points_lx, flattering->between_lx, flattering->where,
                         flattering->all_lx);
    }
    planes = std::move(doubtful);
    tasks = std::move(doubtful_tasks);
  }
}

CheckedSpace check_space(const calc::Space& space, const rules::JudgedProject& loaded,
                         const Context& context, const Stopwatch& watch) {
  CheckedSpace checked;
  calc::Diagnostics& diagnostics = checked.diagnostics;
  report::PhaseTimes& times = checked.times;
  const std::unique_ptr<LitSpace> lit =
      light_space(space, loaded, context, watch, nullptr, diagnostics, times);
  if (lit == nullptr) return checked;
  auto& [jobs, scene, apart, not_apart, tasks, solution] = *lit;
  take_problems(jobs, solution.fields, diagnostics);
  warn_about_accuracy(space, solution.fields, context.settings, diagnostics);
  warn_about_lost_light(space, solution.balance, diagnostics);

  const Stopwatch judge_watch;
  warn_of_light_between_points(space, *lit, loaded, context, diagnostics);
  std::vector<report::PlanePart> planes;
  std::size_t task = 0;
  for (const PlaneJob& job : jobs) {
    const calc::PlaneField* field = job.grid ? &solution.fields[task] : nullptr;
    planes.push_back(judge(job, field, loaded.project.scenes, context.settings));
    if (!job.grid) continue;
    if (planes.back().is_computed && !field->is_exact())
      planes.back().looks = std::move(tasks.looks[task]);
    if (planes.back().is_computed && apart) {
      planes.back().by_luminaire = report::build_luminaire_shares(
          *field, space.luminaires, loaded.project.luminaire_types, planes.back(),
          rules::look_confidence(context.settings.confidence, *field));
    }
    ++task;
  }
  times.judge_s += judge_watch.seconds();
  report::SpacePart& part = checked.part;
  part = report::build_space(space, scene, solution.balance, std::move(planes));
  part.scene_sha256 = calc::scene_digest(scene);
  if (!not_apart.empty()) part.notes.push_back(not_apart);
  report::add_plan_marks(loaded.project, space, scene, part);
  part.power = calc::installed_power(loaded.project, space);
  if (space.energy) part.energy = calc::lighting_energy(loaded.project, space, part.power);
  part.price = calc::installed_price(loaded.project, space);
  part.road = report::build_road(loaded.project, space, part.planes);
  const std::string& day = context.settings.today;
  const std::vector<rules::JudgedPlane> judged = judged_planes(space, part, day);
  // Of a part nobody can tell what is asked of a whole row, and met.
  if (context.settings.selection.is_all()) {
    part.coverage = rules::row_coverage(
        space, judged, context.packs, day,
        [&](const std::string& scene_id, rules::Comparison comparison, double limit) {
          return rules::rendering_problem(loaded.project, space, scene_id, comparison, limit);
        });
    rules::warn_about_waivers(space, judged, day, diagnostics);
  }
  if (context.observer.draws_rooms()) checked.scene = std::move(scene);
  return checked;
}

// Half a project must not look like one that passes.
bool is_cut_short(const report::SpacePart& space, const Observer& observer) {
  return observer.is_stopped() ||
         std::any_of(space.planes.begin(), space.planes.end(), [](const report::PlanePart& plane) {
           return plane.stop == calc::StopReason::interrupted;
         });
}

std::size_t spaces_at_once(const ProjectInBudget& project, const Context& context) {
  return calc::spaces_within(project.memory, context.settings.budget, context.most_spaces);
}

// Several at a time. Stops after one that is cut short; false: there was one.
bool check_spaces(const ProjectInBudget& project, const Context& context, const Stopwatch& watch,
                  report::ProjectPart& part, calc::Diagnostics& diagnostics,
                  report::PhaseTimes& times) {
  const rules::JudgedProject& loaded = project.judged;
  const std::vector<calc::Space>& spaces = loaded.project.spaces;
  std::vector<CheckedSpace> checked(spaces.size());
  std::atomic<bool> is_cut{false};
  const auto work = [&](std::size_t s) {
    context.observer.start_space(spaces[s].id);
    checked[s] = check_space(spaces[s], loaded, context, watch);
    if (is_cut_short(checked[s].part, context.observer)) is_cut = true;
  };
  const auto deliver = [&](std::size_t s) {
    CheckedSpace& space = checked[s];
    diagnostics.add(space.diagnostics);
    add_times(space.times, times);
    if (space.scene) {
      context.observer.judged(loaded.project.path, spaces[s], *space.scene, space.part);
    }
    part.spaces.push_back(std::move(space.part));
    space = {};
  };
  in_order(spaces.size(), {context.settings.radiosity.jobs, spaces_at_once(project, context)}, work,
           deliver, [&] { return !is_cut; });
  return !is_cut;
}

std::vector<rules::AggregateFinding> judge_aggregates(const report::ProjectPart& part,
                                                      const rules::JudgedProject& loaded,
                                                      const std::vector<rules::RulePack>& packs,
                                                      const std::string& day) {
  const calc::Project& project = loaded.project;
  std::vector<rules::JudgedPlane> planes;
  for (std::size_t s = 0; s < part.spaces.size(); ++s) {
    const std::vector<rules::JudgedPlane> own =
        judged_planes(project.spaces[s], part.spaces[s], day);
    planes.insert(planes.end(), own.begin(), own.end());
  }
  std::vector<rules::AggregateFinding> findings = rules::judge_aggregates(planes, packs);
  for (auto& of_building : rules::judge_buildings(project, loaded.buildings, day)) {
    findings.push_back(std::move(of_building));
  }
  return findings;
}

}  // namespace

report::ProjectPart check_project(const std::string& path, const Run& run, Observer& observer) {
  const Context context(run, observer);
  const Settings& settings = context.settings;
  const Stopwatch watch;
  calc::Diagnostics diagnostics;
  std::optional<ProjectInBudget> in_budget =
      load(path, context.files, context.packs, settings.radiosity.replicates, settings.budget,
           diagnostics);
  if (!in_budget) return unreadable_project(path, diagnostics);
  select(settings.selection, in_budget->judged, diagnostics);
  const rules::JudgedProject* loaded = &in_budget->judged;

  report::ProjectPart part = report::build_project(loaded->project);
  report::PhaseTimes times;
  times.load_s = watch.seconds();
  if (context.vertices != nullptr &&
      !has_space_of(*context.vertices, loaded->project, diagnostics)) {
    return unreadable_project(path, diagnostics);
  }
  context.observer.start_project(loaded->project.spaces.size());
  if (!check_spaces(*in_budget, context, watch, part, diagnostics, times)) {
    return unreadable_project(path, diagnostics);
  }
  const bool is_refused =
      std::any_of(diagnostics.all().begin(), diagnostics.all().end(), [](const auto& diagnostic) {
        return diagnostic.id == calc::DiagnosticId::vertex_cache_unfit;
      });
  if (is_refused) return unreadable_project(path, diagnostics);
  if (settings.selection.is_all()) {
    part.aggregates = judge_aggregates(part, *loaded, context.packs, settings.today);
    rules::warn_about_waivers(part.aggregates, settings.today, diagnostics);
  }
  report::label_luminaires(part);
  part.is_judged = true;
  part.diagnostics = diagnostics.all();
  times.total_s = watch.seconds();
  if (context.settings.has_times) part.times = times;
  return part;
}

namespace {

// "" if every look that a check needs of it has been taken, and a store can keep it. A space whose
// first look takes too much memory has no light at all, which only calculating it again can tell.
calc::Message why_not_kept(const LitSpace& lit) {
  if (lit.solution.looks.too_large > 0) {
    return calc::say<calc::Sentence::too_large_for_store>();
  }
  for (const calc::PlaneField& field : lit.solution.fields) {
    if (!field.problem.empty()) continue;  // a check comes to it by itself
    switch (field.stop) {
      case calc::StopReason::exact:
      case calc::StopReason::decided:
      case calc::StopReason::accurate:
      case calc::StopReason::path_limit:
        break;
      default:
        return calc::say<calc::Sentence::plane_stopped>(field.plane_id, calc::name_of(field.stop));
    }
  }
  return {};
}

}  // namespace

calc::Diagnostics light_units(const std::string& path, const std::vector<Unit>& units,
                              const Run& run, Observer& observer) {
  const Context context(run, observer);
  const Settings& settings = context.settings;
  const Stopwatch watch;
  calc::Diagnostics diagnostics;
  const std::optional<ProjectInBudget> in_budget =
      load_in_budget(path, context.files, context.packs, settings.radiosity.replicates,
                     settings.budget, diagnostics);
  if (!in_budget) return diagnostics;
  const rules::JudgedProject* loaded = &in_budget->judged;
  context.observer.start_project(units.size());
  std::vector<calc::Diagnostics> of_unit(units.size());
  const auto work = [&](std::size_t u) {
    const std::vector<calc::Space>& spaces = loaded->project.spaces;
    const auto space = std::find_if(spaces.begin(), spaces.end(), [&](const calc::Space& one) {
      return one.id == units[u].space;
    });
    if (space == spaces.end()) {
      of_unit[u].report(calc::DiagnosticId::unit_not_kept, {path, 0, 0}, unit_name(units[u]),
                        "the project has no such space");
      return;
    }
    context.observer.start_space(space->id);
    calc::Diagnostics told;  // of the project: the check that comes after tells it
    report::PhaseTimes times;
    const std::unique_ptr<LitSpace> lit =
        light_space(*space, *loaded, context, watch, &units[u].planes, told, times);
    if (context.observer.is_stopped()) return;
    calc::Message why = why_not_kept(*lit);
    if (lit->tasks.list.size() != units[u].planes.size()) {
      why = calc::say<calc::Sentence::other_planes>();
    }
    if (why.empty()) return;
    of_unit[u].report(calc::DiagnosticId::unit_not_kept, space->where, unit_name(units[u]), why);
  };
  in_order(
      units.size(), {settings.radiosity.jobs, spaces_at_once(*in_budget, context)}, work,
      [&](std::size_t u) { diagnostics.add(of_unit[u]); },
      [&] { return !context.observer.is_stopped(); });
  return diagnostics;
}

report::ProjectPart validate_project(const std::string& path, const calc::FileReader& files,
                                     const std::vector<rules::RulePack>& packs,
                                     std::string_view day, const calc::Budget& budget,
                                     bool warns_of_one_source) {
  calc::Diagnostics diagnostics;
  const std::optional<ProjectInBudget> in_budget =
      load(path, files, packs, calc::RadiositySettings().replicates, budget, diagnostics);
  if (!in_budget) return unreadable_project(path, diagnostics);
  const rules::JudgedProject* loaded = &in_budget->judged;

  report::ProjectPart part = report::build_project(loaded->project);
  for (const calc::Space& space : loaded->project.spaces) {
    warn_of_unjudged(make_plane_jobs(space, *loaded, packs, day, diagnostics), diagnostics);
  }
  for (const rules::AggregateFinding& finding :
       rules::judge_buildings(loaded->project, loaded->buildings, day)) {
    if (finding.verdict != rules::Verdict::not_judged) continue;
    diagnostics.report(calc::DiagnosticId::building_not_judged, finding.where, finding.building_id,
                       finding.sum->requirement.id, finding.reason);
  }
  part.is_judged = !diagnostics.has_errors();
  part.diagnostics = diagnostics.all();
  if (warns_of_one_source)
    report::warn_of_one_source(one_source_rows(*loaded), path, part.diagnostics);
  return part;
}

}  // namespace check
