#include "report/tools/check/check.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/store/entry_folder.h"
#include "calc/store/memory_store.h"
#include "report/advice/level_solver.h"
#include "report/check/drawing_device.h"
#include "report/check/in_order.h"
#include "report/check/run.h"
#include "report/check/set_values.h"
#include "report/check/units.h"
#include "report/check/vertex_source.h"
#include "report/policy/judge_policy.h"
#include "report/revision/revise.h"
#include "report/shell/options/policy_option.h"
#include "report/shell/options/project_reader.h"
#include "report/shell/options/recording_reader.h"
#include "report/shell/options/result_input.h"
#include "report/shell/options/selection_option.h"
#include "report/shell/output/outputs.h"
#include "report/shell/output/pdf_printer.h"
#include "report/shell/output/progress.h"
#include "report/shell/process/interrupt.h"
#include "report/shell/process/print.h"
#include "report/text/one_source_note.h"
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
class PictureQueue {
 public:
  // device: null = none are wanted.
  PictureQueue(const CheckOptions& options, std::optional<check::PictureDevice::Request> device) {
    if (!device) return;
    const calc::RadiositySettings& radiosity = options.settings.radiosity;
    pictures_.emplace(
        PictureSettings{options.output.images, radiosity.seed, radiosity.jobs, *std::move(device),
                        options.output.page.palette, report_texts(options.output)},
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
  CheckObserver(const CheckOptions& options, Progress& progress, PictureQueue& pictures,
                std::size_t project)
      : WatchedProject(progress, options.input.projects[project]),
        options_(options),
        pictures_(pictures),
        project_(project) {}
  CheckObserver(const CheckObserver&) = delete;
  CheckObserver& operator=(const CheckObserver&) = delete;
  ~CheckObserver() override { pictures_.done(project_); }

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
  bool draws_rooms() const override { return pictures_.draws(); }
  void judged(const std::string& project_path, const calc::Space& space,
              const calc::PreparedScene& scene, report::SpacePart& part) override {
    pictures_.add_pictures(project_, project_path, space, scene, part);
  }

 private:
  const CheckOptions& options_;
  PictureQueue& pictures_;
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
  return fmt::format("{}: {} sampling rounds of planes read from it, {} computed\n", from,
                     looks.read, looks.computed);
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
       options.store.empty() ? "" : "; finished light is kept, and the same command continues");
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
  print_error(
      calc::DiagnosticId::output_not_possible,
      fmt::format("cannot remove '{}', which is no longer needed: {}", folder, failure.message()));
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

// First of all: before anything is read. False after an error, which has been printed.
bool can_begin(CheckOptions& options, const RunContext& context) {
  if (!open_printer_or_print(options.output, context.environment)) return false;
  if (const std::string problem = options.advice ? solver_problem() : ""; !problem.empty()) {
    print_error(calc::DiagnosticId::output_not_possible, "--advice: " + problem);
    return false;
  }
  return enter_sandbox_or_print(options, context);
}

// One run of the command. Members stand in the order in which they come to be.
class CheckCommand {
 public:
  CheckCommand(CheckOptions options, const RunContext& context)
      : options_(std::move(options)),
        context_(context),
        progress_(progress_style(options_.output, context.environment),
                  context.environment.stderr_columns) {}

  ExitCode run() {
    if (!read_inputs() || !open()) return kNotJudged;
    if (old_state_) {
      if (const std::optional<ExitCode> end = check_old_state()) return *end;
    }
    return check_projects();
  }

 private:
  // What the run needs beside its projects. False after an error, which has been printed.
  bool read_inputs() {
    options_.settings.today = day_of(options_.settings);  // one for all, also over midnight
    return read_vertices() && can_write() &&
           check_values_or_print(options_.input, options_.set, "set", recorded_) && read_policy() &&
           read_baseline();
  }

  bool read_vertices() {
    if (options_.vpl_file.empty()) return true;
    calc::Diagnostics diagnostics;
    vertices_ = check::read_vertex_source(options_.vpl_file, files_, diagnostics);
    print_diagnostics(diagnostics.all(), true);
    if (vertices_) check::use_settings_of(vertices_->cache, options_.settings.radiosity);
    return vertices_.has_value();
  }

  bool can_write() const {
    std::vector<std::string> inputs = options_.input.projects;
    inputs.insert(inputs.end(), options_.input.rule_files.begin(), options_.input.rule_files.end());
    for (const std::string* file :
         {&options_.baseline, &options_.policy, &options_.input.standard_input_file}) {
      if (!file->empty()) inputs.push_back(*file);
    }
    const std::string problem = check_outputs(options_.output, inputs);
    if (!problem.empty()) print_error(calc::DiagnosticId::output_not_possible, problem);
    return problem.empty();
  }

  bool read_policy() {
    if (options_.policy.empty()) return true;
    policy_ = read_policy_or_print(options_.policy, files_);
    if (!policy_ || !is_allowed_or_print(*policy_, options_)) return false;
    // Whoever changes designs may set SOURCE_DATE_EPOCH, and must not revive a waiver by it.
    options_.settings.today = check::day_or_today("");
    StrictWarnings& strict = options_.strict;
    const std::vector<calc::DiagnosticId>& fatal = policy_->fatal_warnings;
    strict.ids.insert(strict.ids.end(), fatal.begin(), fatal.end());
    strict.all = strict.all || policy_->are_all_warnings_fatal;
    strict.has_policy = policy_->are_all_warnings_fatal || !fatal.empty();
    return true;
  }

  bool read_baseline() {
    if (!options_.baseline.empty()) {
      baseline_ = read_whole_result_or_print(options_.baseline, files_);
      return baseline_.has_value();
    }
    if (options_.against.empty()) return true;
    warn_of_changed_settings(options_);
    const Environment& environment = context_.environment;
    old_state_ = OldState::open_or_print(
        options_.input, options_.against,
        {environment.git_dir, environment.git_work_tree, environment.git_index_file}, files_);
    return old_state_.has_value();
  }

  bool open() {
    run_ = open_run_or_print(options_, context_, files_,
                             [&](const auto& plans) { picture_work_ = picture_work(plans); });
    if (!run_) return false;
    if (!options_.store.empty()) {
      folder_ = std::make_shared<calc::EntryFolder>(options_.store);
      run_ = run_->with_light_in(folder_, options_.batch.is_stored_only);
    } else if (old_state_ || options_.advice) {  // what did not change is calculated once
      run_ = run_->with_light_in(std::make_shared<calc::MemoryStore>(kMostMemoryStoreBytes));
    }
    progress_.expect(options_.input.projects.size());
    options_.output.are_messages_printed = !options_.output.quiet;
    provenance_ = provenance_of(options_, *run_);
    if (policy_) {
      provenance_.policy = policy_->name;
      provenance_.policy_sha256 = policy_->sha256;
    }
    return true;
  }

  // The baseline is made of it. An exit code where the run ends.
  std::optional<ExitCode> check_old_state() {
    progress_.expect(old_state_->project_count());
    check::Settings settings = options_.settings;
    settings.today = kWaiversHold;
    const auto check_one = [&](const std::string& path, const check::Run& then,
                               const std::string& shown_path) {
      WatchedProject observer(progress_, shown_path);
      report::ProjectPart part = then.check(path, observer);
      progress_.done(shown_path, report::outcome_words(report::outcome_of(part)));
      return part;
    };
    auto parts = old_state_->check(run_->with_settings(settings), check_one, go_on);
    progress_.clear();
    if (interrupted()) return told_of_interrupt(options_);
    if (!parts) return kNotJudged;
    baseline_.emplace(report::Document{provenance_, std::move(*parts), {}});
    return std::nullopt;
  }

  report::Revision revise(const report::Document& document) const {
    report::Revision revision = report::revise(
        *baseline_, document, old_state_ ? options_.against : options_.baseline, options_.gate);
    if (!old_state_) return revision;
    const std::vector<SettingChange>& changed = options_.input.config.changed;
    add_changed_settings(changed, revision);
    revision.commits = old_state_->commits();
    const std::vector<calc::Message>& notes = old_state_->notes();
    revision.notes.insert(revision.notes.begin(), notes.begin(), notes.end());
    revision.is_of_itself = changed.empty() && have_same_inputs(*baseline_, document) &&
                            old_state_->is_unchanged_head(files_);
    const bool is_gate = options_.gate.mode == report::GateMode::regression;
    if (revision.is_of_itself && is_gate) {  // an error of every report
      print_error(calc::DiagnosticId::revision_is_head, options_.against);
    } else if (revision.is_of_itself) {
      revision.notes.push_back(calc::say<calc::Sentence::revision_of_itself>(options_.against));
    }
    return revision;
  }

  // Empty: no pictures are wanted.
  std::optional<check::PictureDevice::Request> picture_device() {
    if (!options_.pictures || !wants_pictures(options_.output)) return std::nullopt;
    const std::shared_ptr<gpu::DeviceThread>& open = run_->device();
    const auto work = [&] {
      return picture_work_ ? *picture_work_ : picture_work(run_->plan(options_.input.projects));
    };
    const auto warn = [&](const std::string& failure) {
      calc::Diagnostics diagnostics;
      diagnostics.report(calc::DiagnosticId::picture_device_failed, {}, failure);
      progress_.aside([&] { print_diagnostics(diagnostics.all(), options_.output.quiet); });
    };
    return check::PictureDevice::Request{
        check::choose_for_pictures(open == nullptr ? nullptr : &open->device(),
                                   options_.backend.gl_device >= 0, run_->hardware(), work),
        context_.gl_fault, context_.environment.program_folder, open, warn};
  }

  CheckedProject check_project(std::size_t p, PictureQueue& pictures) {
    const std::string& path = options_.input.projects[p];
    CheckObserver observer(options_, progress_, pictures, p);
    check::Run run = *run_;
    // Whatever happens to the file from now on, advice is about what was checked.
    const calc::FileContent as_read = options_.advice ? files_.read(path) : calc::FileContent{};
    const bool is_advised = options_.advice && as_read.ok();
    if (is_advised) run = run.with_text(path, as_read.bytes);
    CheckedProject project;
    project.part = run.check(path, observer);
    if (is_advised && project.part.is_judged) {
      project.part.advice = advice_on(project.part, as_read.bytes, run, progress_);
    }
    tell_set_values(options_.set, project.part);
    if (policy_) report::judge_policy(*policy_, options_.settings.today, project.part);
    project.cost_log = observer.cost_log(project.part);
    project.looks = observer.looks();
    return project;
  }

  ExitCode check_projects() {
    if (vertices_) run_ = run_->with_vertices(*std::move(vertices_));
    CheckedResults results(options_, *run_, context_.environment, provenance_,
                           baseline_
                               ? [&](const report::Document& document) { return revise(document); }
                               : CheckedResults::Revise());
    std::optional<check::PictureDevice::Request> device = picture_device();
    const std::string pictures_line = device ? check::pictures_line(device->choice) : "";
    PictureQueue pictures(options_, std::move(device));
    WarningTally warnings(options_.strict);
    MissingUnits missing;
    std::vector<std::optional<CheckedProject>> checked(options_.input.projects.size());
    std::string cost_log;
    calc::LookCounts looks;
    bool has_chosen = options_.settings.selection.is_all();
    const auto work = [&](std::size_t p) { checked[p] = check_project(p, pictures); };
    const auto deliver = [&](std::size_t p) {
      if (interrupted()) return;
      report::ProjectPart& project = checked[p]->part;
      if (options_.strict.names(calc::DiagnosticId::one_source))
        report::warn_of_one_source(project);
      project.strict_warnings = warnings.add(project.diagnostics);
      progress_.aside([&] {
        print_messages(project, options_.output, context_.environment);
        if (options_.settings.has_times && project.is_judged) print_timing(project);
      });
      progress_.done(project.path, report::outcome_words(report::outcome_of(project)));
      missing.add(project);
      has_chosen = has_chosen || !report::is_nothing_chosen(project);
      cost_log += checked[p]->cost_log;
      looks.read += checked[p]->looks.read;
      looks.computed += checked[p]->looks.computed;
      results.add(std::move(project), recorded_.new_paths());
      checked[p].reset();
    };
    check::in_order(checked.size(), run_->concurrency(), work, deliver, go_on);
    progress_.clear();
    if (!begin_to_write()) return told_of_interrupt(options_);
    if (options_.explain_cost) {
      tell("{}{}{}{}", check::backend_line(run_->backend()), pictures_line, cost_log,
           folder_ || old_state_ ? looks_line(looks, options_) : "");
    }
    bool is_written = results.finish(recorded_.paths());
    warnings.print(options_.output.quiet);
    if (options_.batch.is_stored_only) missing.print(options_.store);
    if (folder_ && !options_.output.quiet) print_troubles(options_.store, folder_->troubles());
    if (is_written && options_.batch.resumes) is_written = remove_resume_store(options_.store);
    if (!has_chosen) print_nothing_chosen(options_.settings.selection);
    return is_written ? exit_code_of(results.outcome()) : kNotJudged;
  }

  static bool go_on() { return !interrupted(); }

  CheckOptions options_;
  const RunContext& context_;
  Progress progress_;
  const ProjectReader disk_{options_.input};
  const RecordingReader recorded_{disk_};
  const check::SetReader files_{recorded_, options_.input.projects, options_.set};
  std::optional<check::VertexSource> vertices_;
  std::optional<report::Policy> policy_;
  std::optional<report::Document> baseline_;
  std::optional<OldState> old_state_;
  std::optional<calc::DrawingWork> picture_work_;  // of all projects, if they were planned
  std::optional<check::Run> run_;
  std::shared_ptr<calc::EntryFolder> folder_;
  report::Provenance provenance_;
};

}  // namespace

ExitCode run_check(const CheckOptions& asked, const RunContext& context) {
  CheckOptions options = asked;
  if (!can_begin(options, context)) return kNotJudged;
  watch_for_interrupt();
  return CheckCommand(std::move(options), context).run();
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
