#include "report/tools/check/check.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/store/entry_folder.h"
#include "calc/store/memory_store.h"
#include "report/advice/changed_project.h"
#include "report/advice/level_solver.h"
#include "report/check/check_project.h"
#include "report/check/in_order.h"
#include "report/check/set_values.h"
#include "report/check/units.h"
#include "report/policy/judge_policy.h"
#include "report/revision/revise.h"
#include "report/shell/interrupt.h"
#include "report/shell/outputs.h"
#include "report/shell/pdf_printer.h"
#include "report/shell/policy_option.h"
#include "report/shell/print.h"
#include "report/shell/progress.h"
#include "report/shell/project_reader.h"
#include "report/shell/recording_reader.h"
#include "report/shell/result_input.h"
#include "report/shell/selection_option.h"
#include "report/text/words.h"
#include "report/tools/check/advice_checks.h"
#include "report/tools/check/against.h"
#include "report/tools/check/changed_settings.h"
#include "report/tools/check/check_setup.h"
#include "report/tools/check/checked_document.h"
#include "report/tools/check/checked_results.h"
#include "report/tools/check/policy_bounds.h"
#include "report/tools/check/shard.h"
#include "report/tools/check/store_words.h"
#include "report/tools/check/watched_project.h"
#include "report/tools/pictures/room_pictures.h"
#include "report/tools/plan/plan.h"
#include "rules/verdict/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace cli {
namespace {

// Looks are small: some 100 KiB for a plane of 1000 points.
constexpr std::size_t kMostMemoryStoreBytes = std::size_t{1} << 30;
// The day on which a git revision is judged: whatever somebody let go then holds. So a failure
// whose waiver has ended is one that was let go, and is broken now.
constexpr const char* kWaiversHold = "0001-01-01";

void print_timing(const report::ProjectPart& project) {
  std::uint64_t rays = 0;
  for (const report::SpacePart& space : project.spaces) {
    for (const report::PlanePart& plane : space.planes) {
      rays +=
          plane.counters.direct_rays + plane.counters.connection_rays + plane.counters.near_rays;
    }
  }
  const report::PhaseTimes& times = project.times;
  const double rays_s =
      times.direct_s + times.connect_s + times.near_s;  // light paths trace others
  tell(
      "{}: {:.3f} s: load {:.3f}, prepare {:.3f}, direct {:.3f}, light paths {:.3f}, "
      "{}connections {:.3f}, near field {:.3f}, verdicts {:.3f}; {} rays from points, {:.3g} /s\n",
      calc::printable_path(project.path), times.total_s, times.load_s, times.prepare_s,
      times.direct_s, times.pool_s,
      times.maps_s > 0.0 ? fmt::format("shadow maps {:.3f}, ", times.maps_s) : "", times.connect_s,
      times.near_s, times.judge_s, rays, rays_s > 0.0 ? static_cast<double>(rays) / rays_s : 0.0);
}

// Pictures of rooms, which are drawn in the order of the projects: on software only the first are.
// Projects wait for their turn.
class Gallery {
 public:
  // device: null = none are wanted.
  Gallery(const CheckOptions& options, std::optional<check::PictureDevice::Request> device) {
    if (!device) return;
    const calc::RadiositySettings& radiosity = options.settings.radiosity;
    pictures_.emplace(
        PictureSettings{options.output.images, radiosity.seed, radiosity.jobs, *std::move(device)},
        [] { return !interrupted(); });
    is_done_.resize(options.input.projects.size());
  }

  bool draws() const { return pictures_.has_value(); }
  // Of the project of that number, which is not done. Those before it are in work, and wait for
  // none after them.
  void add_pictures(std::size_t project, const std::string& path, const calc::Space& space,
                    const calc::PreparedScene& scene, report::SpacePart& part) {
    {
      std::unique_lock lock(mutex_);
      turn_.wait(lock, [&] { return first_not_done_ >= project; });
    }
    pictures_->add_pictures(path, space, scene, part);
  }
  void done(std::size_t project) {
    if (!draws()) return;
    {
      const std::scoped_lock lock(mutex_);
      is_done_[project] = true;
      while (first_not_done_ < is_done_.size() && is_done_[first_not_done_]) ++first_not_done_;
    }
    turn_.notify_all();
  }

 private:
  std::optional<PictureMaker> pictures_;
  std::mutex mutex_;
  std::condition_variable turn_;
  std::vector<bool> is_done_;
  std::size_t first_not_done_ = 0;
};

// Of one project: also its pictures, and what --explain-cost prints.
class CheckObserver : public WatchedProject {
 public:
  // project: its number.
  CheckObserver(const CheckOptions& options, Progress& progress, Gallery& gallery,
                std::size_t project)
      : WatchedProject(progress, options.input.projects[project]),
        options_(options),
        gallery_(gallery),
        project_(project) {}
  CheckObserver(const CheckObserver&) = delete;
  CheckObserver& operator=(const CheckObserver&) = delete;
  ~CheckObserver() override { gallery_.done(project_); }

  // In the order of its spaces.
  std::string cost_log(const report::ProjectPart& part) const {
    std::string log;
    for (const report::SpacePart& space : part.spaces) {
      if (const auto own = cost_log_.find(space.id); own != cost_log_.end()) log += own->second;
    }
    return log;
  }
  void solved(const std::string& project_path, const std::string& space_id,
              const calc::PreparedScene& scene, const std::vector<calc::PlaneTask>& tasks,
              const calc::SpaceSolution& solution) override {
    WatchedProject::solved(project_path, space_id, scene, tasks, solution);
    if (!options_.explain_cost) return;
    const std::scoped_lock lock(mutex_);
    cost_log_[space_id] =
        explain_cost(project_path, space_id, scene, tasks, options_.settings.radiosity, solution);
  }
  bool draws_rooms() const override { return gallery_.draws(); }
  void judged(const std::string& project_path, const calc::Space& space,
              const calc::PreparedScene& scene, report::SpacePart& part) override {
    gallery_.add_pictures(project_, project_path, space, scene, part);
  }

 private:
  const CheckOptions& options_;
  Gallery& gallery_;
  const std::size_t project_;
  std::mutex mutex_;
  std::map<std::string, std::string> cost_log_;  // by space
};

// What became of a project, until its turn comes.
struct CheckedProject {
  report::ProjectPart part;
  std::string cost_log;
  calc::LookCounts looks;
};

std::string looks_line(const calc::LookCounts& looks, const CheckOptions& options) {
  const char* from = options.store.empty() ? "--against" : "store";
  return fmt::format("{}: {} looks of planes taken from it, {} computed\n", from, looks.read,
                     looks.computed);
}

// Spaces whose light, or that of some of their planes, is not in the store.
class MissingUnits {
 public:
  void add(const report::ProjectPart& project) {
    for (const report::SpacePart& space : project.spaces) {
      check::Unit unit{project.path, space.id, {}, true, 0, 0.0};
      for (const report::PlanePart& plane : space.planes) {
        const bool is_missing = lacks_light(plane);
        if (is_missing) unit.planes.push_back(plane.id);
        unit.is_whole_space = unit.is_whole_space && is_missing;
      }
      ++units_;
      if (!unit.planes.empty()) names_.push_back(check::unit_name(unit));
    }
  }
  void print(const std::string& store) const {
    if (names_.empty()) return;
    calc::Diagnostics diagnostics;
    diagnostics.report(calc::DiagnosticId::store_lacks_units, {store, 0, 0}, names_.size(), units_,
                       calc::list_names(names_, kMostLackingNamed));
    print_diagnostics(diagnostics.all(), true);
  }

 private:
  std::size_t units_ = 0;
  std::vector<std::string> names_;
};

// Images and pages are written while projects come.
ExitCode told_of_interrupt(const CheckOptions& options) {
  const OutputOptions& output = options.output;
  tell("luxgate: interrupted; {}{}\n",
       output.images || output.html_split ? "no report was written" : "nothing was written",
       options.store.empty() ? "" : "; finished light is kept, and the same command goes on there");
  return kInterrupted;
}

// Nothing but a store of luxgate has been made there. False: it stays, which has been printed. Its
// mark goes last: a run that is ended meanwhile leaves a store, with which the next one goes on.
bool remove_resume_store(const std::string& folder) {
  std::error_code failure;
  for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (entry->path().filename() != calc::kStoreMark) {
      std::filesystem::remove_all(entry->path(), failure);
    }
  }
  if (!failure) std::filesystem::remove_all(folder, failure);
  if (!failure) return true;
  print_error(calc::DiagnosticId::output_not_possible,
              fmt::format("cannot remove '{}', which is not needed any more: {}", folder,
                          failure.message()));
  return false;
}

// Whether every project was there then, and all that was read for it has the same bytes.
bool have_same_inputs(const report::Document& before, const report::Document& after) {
  const auto is_same = [](const report::ProjectPart& a, const report::ProjectPart& b) {
    return a.path == b.path &&
           std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(),
                      [](const calc::InputFile& one, const calc::InputFile& other) {
                        return one.sha256 == other.sha256;
                      });
  };
  return std::equal(before.projects.begin(), before.projects.end(), after.projects.begin(),
                    after.projects.end(), is_same);
}

// What is wrong with the projects may be for a setting that does not hold yet.
void warn_of_changed_settings(const CheckOptions& options) {
  const std::vector<SettingChange>& changed = options.input.config.changed;
  if (changed.empty()) return;
  std::vector<std::string> names;
  for (const SettingChange& change : changed) names.push_back(change.name);
  calc::Diagnostics diagnostics;
  diagnostics.report(calc::DiagnosticId::config_of_revision, {}, options.against,
                     calc::list_names(names, names.size()));
  print_diagnostics(diagnostics.all(), options.output.quiet);
}

}  // namespace

ExitCode run_check(const CheckOptions& asked, const RunContext& context) {
  CheckOptions options = asked;
  if (!open_printer_or_print(options.output, context.environment)) return kNotJudged;
  if (const std::string problem = options.advice ? solver_problem() : ""; !problem.empty()) {
    print_error(calc::DiagnosticId::output_not_possible, "--advice: " + problem);
    return kNotJudged;
  }
  if (!enter_sandbox_or_print(options, context)) return kNotJudged;
  watch_for_interrupt();
  const ProjectReader disk(asked.input);
  const RecordingReader recorded(disk);
  const check::SetReader files(recorded, asked.input.projects, asked.set);
  options.settings.today = day_of(options.settings);  // one for all, also over midnight
  std::optional<check::VertexSource> vertices;
  if (!options.vpl_file.empty()) {
    calc::Diagnostics diagnostics;
    vertices = check::read_vertex_source(options.vpl_file, files, diagnostics);
    print_diagnostics(diagnostics.all(), true);
    if (!vertices) return kNotJudged;
    check::use_settings_of(vertices->cache, options.settings.radiosity);
  }
  std::vector<std::string> inputs = options.input.projects;
  inputs.insert(inputs.end(), options.input.rule_files.begin(), options.input.rule_files.end());
  if (!options.baseline.empty()) inputs.push_back(options.baseline);
  if (!options.policy.empty()) inputs.push_back(options.policy);
  if (const std::string& file = options.input.standard_input_file; !file.empty()) {
    inputs.push_back(file);
  }
  if (const std::string problem = check_outputs(options.output, inputs); !problem.empty()) {
    print_error(calc::DiagnosticId::output_not_possible, problem);
    return kNotJudged;
  }
  if (!check_values_or_print(options.input, options.set, "set", recorded)) return kNotJudged;
  std::optional<report::Policy> policy;
  if (!options.policy.empty()) {
    policy = read_policy_or_print(options.policy, files);
    if (!policy || !is_allowed_or_print(*policy, options)) return kNotJudged;
    // Whoever changes designs may set SOURCE_DATE_EPOCH, and must not revive a waiver by it.
    options.settings.today = check::day_or_today("");
    const std::vector<calc::DiagnosticId>& fatal = policy->fatal_warnings;
    options.strict.ids.insert(options.strict.ids.end(), fatal.begin(), fatal.end());
    options.strict.all = options.strict.all || policy->are_all_warnings_fatal;
  }
  std::optional<report::Document> baseline;
  if (!options.baseline.empty()) {
    baseline = read_whole_result_or_print(options.baseline, files);
    if (!baseline) return kNotJudged;
  }
  std::optional<OldState> old_state;
  if (!options.against.empty()) {
    warn_of_changed_settings(options);
    const Environment& environment = context.environment;
    old_state = OldState::open_or_print(
        options.input, options.against,
        {environment.git_dir, environment.git_work_tree, environment.git_index_file}, files);
    if (!old_state) return kNotJudged;
  }
  std::optional<CheckSetup> setup = set_up_or_print(options, context, files);
  if (!setup) return kNotJudged;
  const check::Backend backend = setup->backend.backend;
  const std::string& identity = setup->opened.identity;
  const std::size_t at_once = setup->crew.most_begun;

  const calc::Stages stages = setup->opened.stages();
  std::optional<calc::EntryFolder> folder;
  std::optional<calc::MemoryStore> memory;
  std::optional<calc::LookStore> store;
  if (!options.store.empty()) {
    folder.emplace(options.store);
    store.emplace(calc::LookStore{*folder, identity, options.batch.is_stored_only});
  } else if (old_state || options.advice) {  // what did not change is calculated once
    memory.emplace(kMostMemoryStoreBytes);
    store.emplace(calc::LookStore{*memory, identity});
  }
  Progress progress(progress_style(options.output, context.environment),
                    context.environment.stderr_columns);
  progress.expect(options.input.projects.size());
  const auto go_on = [] { return !interrupted(); };
  options.output.are_messages_printed = !options.output.quiet;
  WarningTally warnings(options.strict);
  report::Provenance provenance = provenance_of(options, backend, setup->opened.description);
  if (policy) {
    provenance.policy = policy->name;
    provenance.policy_sha256 = policy->sha256;
  }
  if (old_state) {
    progress.expect(old_state->project_count());
    check::Settings old_settings = options.settings;
    old_settings.today = kWaiversHold;
    const auto check_one = [&](const std::string& path, const calc::FileReader& old_files,
                               const std::vector<rules::RulePack>& old_packs,
                               const std::string& shown_path) {
      WatchedProject observer(progress, shown_path);
      report::ProjectPart part =
          check_safely(path, {old_settings, old_files, old_packs, stages, observer, nullptr,
                              store ? &*store : nullptr, at_once});
      progress.done(shown_path, report::outcome_words(report::outcome_of(part)));
      return part;
    };
    auto parts = old_state->check(check_one, setup->crew, go_on);
    progress.clear();
    if (interrupted()) return told_of_interrupt(options);
    if (!parts) return kNotJudged;
    baseline.emplace(report::Document{provenance, std::move(*parts), {}});
  }
  const auto revise = [&](const report::Document& document) {
    report::Revision revision = report::revise(
        *baseline, document, old_state ? options.against : options.baseline, options.gate);
    if (old_state) {
      add_changed_settings(options.input.config.changed, revision);
      revision.commits = old_state->commits();
      const std::vector<calc::Message>& notes = old_state->notes();
      revision.notes.insert(revision.notes.begin(), notes.begin(), notes.end());
      revision.is_of_itself = options.input.config.changed.empty() &&
                              have_same_inputs(*baseline, document) &&
                              old_state->is_unchanged_head(files);
      const bool is_gate = options.gate.mode == report::GateMode::regression;
      if (revision.is_of_itself && is_gate) {  // an error of every report
        print_error(calc::DiagnosticId::revision_is_head, options.against);
      } else if (revision.is_of_itself) {
        revision.notes.push_back(calc::say<calc::Sentence::revision_of_itself>(options.against));
      }
    }
    return revision;
  };
  CheckedResults results(options, context.environment, provenance,
                         baseline ? CheckedResults::Revise(revise) : nullptr);
  std::optional<check::PictureDevice::Request> picture_device;
  if (options.pictures && wants_pictures(options.output)) {
    picture_device = {
        choose_for_pictures(options, files, *setup), context.gl_fault,
        context.environment.program_folder, setup->opened.device, [&](const std::string& failure) {
          calc::Diagnostics diagnostics;
          diagnostics.report(calc::DiagnosticId::picture_device_failed, {}, failure);
          progress.aside([&] { print_diagnostics(diagnostics.all(), options.output.quiet); });
        }};
  }
  const std::string pictures_line =
      picture_device ? check::pictures_line(picture_device->choice) : "";
  Gallery gallery(options, std::move(picture_device));
  MissingUnits missing;
  std::vector<std::optional<CheckedProject>> checked(options.input.projects.size());
  std::string cost_log;
  calc::LookCounts looks;
  bool has_chosen = options.settings.selection.is_all();
  const auto work = [&](std::size_t p) {
    const std::string& path = options.input.projects[p];
    CheckObserver observer(options, progress, gallery, p);
    // Whatever happens to the file from now on, advice is about what was checked.
    const calc::FileContent as_read = options.advice ? files.read(path) : calc::FileContent{};
    std::optional<ChangedProject> kept;
    if (options.advice && as_read.ok()) kept.emplace(files, path, as_read.bytes);
    const check::Context check{options.settings,
                               kept ? static_cast<const calc::FileReader&>(*kept) : files,
                               setup->packs,
                               stages,
                               observer,
                               vertices ? &*vertices : nullptr,
                               store ? &*store : nullptr,
                               at_once};
    CheckedProject project;
    project.part = check_safely(path, check);
    if (kept && project.part.is_judged) {
      project.part.advice = advice_on(project.part, as_read.bytes, check, progress);
    }
    tell_set_values(options.set, project.part);
    if (policy) report::judge_policy(*policy, options.settings.today, project.part);
    project.cost_log = observer.cost_log(project.part);
    project.looks = observer.looks();
    checked[p] = std::move(project);
  };
  const auto deliver = [&](std::size_t p) {
    if (interrupted()) return;
    report::ProjectPart& project = checked[p]->part;
    project.strict_warnings = warnings.add(project.diagnostics);
    progress.aside([&] {
      print_diagnostics(project.diagnostics, options.output.quiet);
      if (options.settings.has_times && project.is_judged) print_timing(project);
    });
    progress.done(project.path, report::outcome_words(report::outcome_of(project)));
    missing.add(project);
    has_chosen = has_chosen || !report::is_nothing_chosen(project);
    cost_log += checked[p]->cost_log;
    looks.read += checked[p]->looks.read;
    looks.computed += checked[p]->looks.computed;
    results.add(std::move(project), recorded.new_paths());
    checked[p].reset();
  };
  check::in_order(checked.size(), setup->crew, work, deliver, go_on);
  progress.clear();
  if (!begin_to_write()) return told_of_interrupt(options);
  if (options.explain_cost) {
    tell("{}{}{}{}", check::backend_line(setup->backend), pictures_line, cost_log,
         folder || old_state ? looks_line(looks, options) : "");
  }
  bool is_written = results.finish(backend, recorded.paths());
  warnings.print(options.output.quiet);
  if (options.batch.is_stored_only) missing.print(options.store);
  if (folder && !options.output.quiet) print_troubles(options.store, folder->troubles());
  if (is_written && options.batch.resumes) is_written = remove_resume_store(options.store);
  if (!has_chosen) print_nothing_chosen(options.settings.selection);
  return is_written ? exit_code_of(results.outcome()) : kNotJudged;
}

Command check_command() {
  const auto options = std::make_shared<CheckOptions>();
  Command command = check_syntax(*options);
  command.run = [options](const RunContext& context) {
    return options->batch.share.count > 0 ? run_shard(*options, context)
                                          : run_check(*options, context);
  };
  return command;
}

}  // namespace cli
