#include "report/tools/check/check.h"

#include "calc/store/entry_folder.h"
#include "calc/store/memory_store.h"
#include "report/check/check_project.h"
#include "report/check/load_rules.h"
#include "report/check/plan.h"
#include "report/result_file/redact.h"
#include "report/revision/gate.h"
#include "report/revision/revise.h"
#include "report/shell/interrupt.h"
#include "report/shell/open_backend.h"
#include "report/shell/outputs.h"
#include "report/shell/print.h"
#include "report/shell/progress.h"
#include "report/shell/recording_reader.h"
#include "report/shell/result_input.h"
#include "report/tools/check/against.h"
#include "report/tools/check/checked_document.h"
#include "report/tools/pictures/room_pictures.h"
#include "report/tools/plan/plan.h"
#include "rules/verdict/outcome.h"

#include <fmt/format.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace cli {
namespace {

// Looks are small: some 100 KiB for a plane of 1000 points.
constexpr std::size_t kMostMemoryStoreBytes = std::size_t{1} << 30;

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
  fmt::print(
      stderr,
      "{}: {:.3f} s: load {:.3f}, prepare {:.3f}, direct {:.3f}, light paths {:.3f}, "
      "{}connections {:.3f}, near field {:.3f}, verdicts {:.3f}; {} rays from points, {:.3g} /s\n",
      project.path, times.total_s, times.load_s, times.prepare_s, times.direct_s, times.pool_s,
      times.maps_s > 0.0 ? fmt::format("shadow maps {:.3f}, ", times.maps_s) : "", times.connect_s,
      times.near_s, times.judge_s, rays, rays_s > 0.0 ? static_cast<double>(rays) / rays_s : 0.0);
}

// Progress and Ctrl-C, pictures, and what --explain-cost prints.
class CheckObserver : public check::Observer {
 public:
  CheckObserver(const CheckOptions& options, const RunContext& context)
      : options_(options),
        progress_(context.environment.stderr_is_terminal && !options.output.quiet) {
    if (!options.pictures || !wants_pictures(options.output)) return;
    const calc::RadiositySettings& radiosity = options.settings.radiosity;
    pictures_.emplace(PictureSettings{options.output.images, radiosity.seed, radiosity.jobs,
                                      options.backend.gl_device, context.gl_fault,
                                      context.environment.program_folder},
                      [] { return !interrupted(); });
  }

  Progress& progress() { return progress_; }
  const std::string& cost_log() const { return cost_log_; }

  void start_space(const std::string& id) override { progress_.start_space(id); }
  bool go_on(const calc::SolveProgress& progress) override {
    progress_.update(progress);
    return !interrupted();
  }
  bool is_stopped() const override { return interrupted(); }
  // Of all projects.
  const calc::LookCounts& looks() const { return looks_; }
  void solved(const std::string& project_path, const std::string& space_id,
              const calc::PreparedScene& scene, const std::vector<calc::PlaneTask>& tasks,
              const calc::SpaceSolution& solution) override {
    looks_.read += solution.looks.read;
    looks_.computed += solution.looks.computed;
    if (!options_.explain_cost) return;
    cost_log_ +=
        explain_cost(project_path, space_id, scene, tasks, options_.settings.radiosity, solution);
  }
  void judged(const std::string& project_path, const calc::Space& space,
              const calc::PreparedScene& scene, report::SpacePart& part) override {
    if (pictures_) pictures_->add_pictures(project_path, space, scene, part);
  }

 private:
  const CheckOptions& options_;
  Progress progress_;
  std::optional<PictureMaker> pictures_;
  std::string cost_log_;
  calc::LookCounts looks_;
};

// Of projects as they were: neither pictures nor costs.
class OldObserver : public check::Observer {
 public:
  explicit OldObserver(Progress& progress) : progress_(progress) {}
  void start_space(const std::string& id) override { progress_.start_space(id); }
  bool go_on(const calc::SolveProgress& progress) override {
    progress_.update(progress);
    return !interrupted();
  }
  bool is_stopped() const override { return interrupted(); }

 private:
  Progress& progress_;
};

// To standard error alone: nothing of a store is in a result, nor does --strict count it.
void print_troubles(const std::string& folder, const calc::StoreTroubles& troubles) {
  calc::Diagnostics diagnostics;
  if (troubles.unusable > 0) {
    diagnostics.report(calc::DiagnosticId::store_entry_unusable, {folder, 0, 0}, troubles.unusable,
                       troubles.unusable_why);
  }
  if (!troubles.not_written.empty()) {
    diagnostics.report(calc::DiagnosticId::store_not_written, {folder, 0, 0}, troubles.not_written);
  }
  print_diagnostics(diagnostics.all(), false);
}

std::string looks_line(const calc::LookCounts& looks, const CheckOptions& options) {
  const char* from = options.store.empty() ? "--against" : "store";
  return fmt::format("{}: {} looks of planes taken from it, {} computed\n", from, looks.read,
                     looks.computed);
}

ExitCode told_of_interrupt() {
  fmt::print(stderr, "luxgate: interrupted; nothing was written\n");
  return kInterrupted;
}

}  // namespace

ExitCode run_check(const CheckOptions& asked, const RunContext& context) {
  const calc::DiskFileReader disk;
  const RecordingReader files(disk);
  CheckOptions options = asked;
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
  if (const std::string problem = check_outputs(options.output, inputs); !problem.empty()) {
    print_error(calc::DiagnosticId::output_not_possible, problem);
    return kNotJudged;
  }
  std::optional<report::Document> baseline;
  if (!options.baseline.empty()) {
    baseline = read_result_or_print(options.baseline, files);
    if (!baseline) return kNotJudged;
  }
  std::optional<OldState> old_state;
  if (!options.against.empty()) {
    const Environment& environment = context.environment;
    old_state = OldState::open_or_print(options.input, options.against,
                                        {environment.git_dir, environment.git_work_tree}, files);
    if (!old_state) return kNotJudged;
  }
  const auto packs = load_packs_or_print(options.input.rule_files, files);
  if (!packs) return kNotJudged;
  const calc::RadiositySettings& radiosity = options.settings.radiosity;
  const check::BackendChoice backend =
      check::choose_backend(options.backend, radiosity.shadow_map_texels, context.gl_fault, [&] {
        return first_look_work(check::plan_projects(options.input.projects, files, *packs,
                                                    radiosity, options.settings.today));
      });
  const std::optional<check::OpenBackend> opened = open_or_complain(
      backend, context.gl_fault, context.environment.program_folder, options.output.quiet);
  if (!opened) return kNotJudged;

  watch_for_interrupt();
  const calc::Stages stages = opened->stages();
  std::optional<calc::EntryFolder> folder;
  std::optional<calc::MemoryStore> memory;
  std::optional<calc::LookStore> store;
  if (!options.store.empty()) {
    folder.emplace(options.store);
    store.emplace(calc::LookStore{*folder, opened->identity});
  } else if (old_state) {  // what did not change is calculated once
    memory.emplace(kMostMemoryStoreBytes);
    store.emplace(calc::LookStore{*memory, opened->identity});
  }
  CheckObserver observer(options, context);
  options.output.are_messages_printed = !options.output.quiet;
  WarningTally warnings(options.strict);
  report::Document document;
  document.provenance = provenance_of(options, backend.backend, opened->description);
  if (old_state) {
    OldObserver old_observer(observer.progress());
    const auto check_one = [&](const std::string& path, const calc::FileReader& old_files,
                               const std::vector<rules::RulePack>& old_packs,
                               const std::string& shown_path) {
      observer.progress().start_project(shown_path);
      report::ProjectPart part =
          check_safely(path, {options.settings, old_files, old_packs, stages, old_observer, nullptr,
                              store ? &*store : nullptr});
      observer.progress().clear();
      return part;
    };
    auto parts = old_state->check(check_one, [] { return !interrupted(); });
    if (interrupted()) return told_of_interrupt();
    if (!parts) return kNotJudged;
    baseline.emplace(report::Document{document.provenance, std::move(*parts), {}});
  }
  for (const std::string& path : options.input.projects) {
    observer.progress().start_project(path);
    document.projects.push_back(
        check_safely(path, {options.settings, files, *packs, stages, observer,
                            vertices ? &*vertices : nullptr, store ? &*store : nullptr}));
    observer.progress().clear();
    if (interrupted()) return told_of_interrupt();
    report::ProjectPart& project = document.projects.back();
    project.strict_warnings = warnings.add(project.diagnostics);
    print_diagnostics(project.diagnostics, options.output.quiet);
    if (options.settings.has_times && project.is_judged) print_timing(project);
  }
  complete_provenance(document, options.settings.today, backend.backend);
  if (options.explain_cost) {
    fmt::print(stderr, "{}{}{}", check::backend_line(backend), observer.cost_log(),
               store ? looks_line(observer.looks(), options) : "");
  }
  if (baseline) {
    document.revision = report::revise(
        *baseline, document, old_state ? options.against : options.baseline, options.gate);
    if (old_state) {
      report::Revision& revision = *document.revision;
      revision.commits = old_state->commits();
      const std::vector<std::string>& notes = old_state->notes();
      revision.notes.insert(revision.notes.begin(), notes.begin(), notes.end());
    }
  }
  if (options.output.redact) report::redact(document);
  const bool is_written =
      write_results(options.output, context.environment, document, files.paths());
  warnings.print(options.output.quiet);
  if (folder && !options.output.quiet) print_troubles(options.store, folder->troubles());
  return is_written ? exit_code_of(report::gate_outcome(document)) : kNotJudged;
}

Command check_command() {
  const auto options = std::make_shared<CheckOptions>();
  Command command = check_syntax(*options);
  command.run = [options](const RunContext& context) { return run_check(*options, context); };
  return command;
}

}  // namespace cli
