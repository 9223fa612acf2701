#include "report/tools/converge/converge.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"
#include "report/check/load_judged_project.h"
#include "report/document/program_version.h"
#include "report/shell/options/chosen_space.h"
#include "report/shell/options/recording_reader.h"
#include "report/shell/process/interrupt.h"
#include "report/shell/process/print.h"
#include "report/text/number_format.h"
#include "report/tools/converge/converge_measure.h"
#include "report/tools/converge/converge_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

namespace cli {
namespace {

constexpr std::uint64_t kReferenceSeed = 0x7265666572656e63u;  // far from the seeds of runs
constexpr int kReferenceReplicates = 64;

// A space with its chosen planes, ready to be calculated.
struct Subject {
  calc::Project project;
  const calc::Space* space = nullptr;
  std::vector<const calc::CalcPlane*> planes;
  std::vector<calc::SensorGrid> grids;
  calc::PreparedScene scene;
  std::vector<calc::PlaneTask> tasks;
};

bool choose_planes(const ConvergeOptions& options, Subject& subject,
                   calc::Diagnostics& diagnostics) {
  std::vector<std::string_view> ids;
  for (const calc::CalcPlane& plane : subject.space->planes) ids.push_back(plane.id);
  for (const std::string& wanted : options.planes) {
    if (std::find(ids.begin(), ids.end(), wanted) != ids.end()) continue;
    diagnostics.report(calc::DiagnosticId::choose_plane, subject.space->where, wanted,
                       calc::join_choices(ids));
  }
  for (const calc::CalcPlane& plane : subject.space->planes) {
    const bool is_wanted =
        options.planes.empty() ||
        std::find(options.planes.begin(), options.planes.end(), plane.id) != options.planes.end();
    if (!is_wanted) continue;
    if (plane.derived != calc::DerivedQuantity::none) {
      if (options.planes.empty()) continue;
      diagnostics.report(calc::DiagnosticId::converge_not_possible, plane.where,
                         fmt::format("plane '{}' has the quantity '{}', which is computed from "
                                     "several illuminances; only illuminances are compared",
                                     plane.id, calc::quantity_name(plane.kernel, plane.derived)));
      continue;
    }
    std::optional<calc::SensorGrid> grid =
        calc::make_sensor_grid(plane, *subject.space, diagnostics);
    if (!grid) continue;
    subject.planes.push_back(&plane);
    subject.grids.push_back(std::move(*grid));
  }
  if (subject.grids.empty() && !diagnostics.has_errors()) {
    diagnostics.report(calc::DiagnosticId::converge_not_possible, subject.space->where,
                       "the space has no plane to calculate");
  }
  return !diagnostics.has_errors();
}

// Fills `subject`, which must not move afterwards; false after an error.
bool load(const ConvergeOptions& options, const calc::FileReader& files, Subject& subject,
          report::ConvergeDocument& document, calc::Diagnostics& diagnostics) {
  const double begin_s = calc::now_s();
  std::optional<calc::Project> project =
      check::load_judged_project(options.project, files, options.rule_files, diagnostics);
  if (!project) return false;
  subject.project = std::move(*project);
  document.load_s = calc::now_s() - begin_s;
  subject.space = find_chosen_space(subject.project, options.space, diagnostics);
  if (subject.space == nullptr || !choose_planes(options, subject, diagnostics)) return false;
  const double prepare_s = calc::now_s();
  subject.scene = calc::prepare_scene(subject.project, *subject.space);
  document.prepare_s = calc::now_s() - prepare_s;
  for (std::size_t p = 0; p < subject.planes.size(); ++p) {
    subject.tasks.push_back({subject.planes[p]->id, &subject.grids[p]});
  }
  return true;
}

std::uint64_t reference_paths(const ConvergeOptions& options) {
  return options.reference_paths > 0 ? options.reference_paths : 2 * options.max_paths;
}

struct Reference {
  std::vector<report::ConvergeTruth> truths;  // empty after an error or an interruption
  bool is_interrupted = false;
};

Reference own_reference(const ConvergeOptions& options, EstimatorContext context,
                        calc::Diagnostics& diagnostics) {
  context.replicates = kReferenceReplicates;
  const EstimatorRun run =
      find_estimator("core")(context, reference_paths(options), kReferenceSeed ^ options.seed);
  if (run.is_interrupted) return {{}, true};
  if (!run.problem.empty()) {
    diagnostics.report(calc::DiagnosticId::converge_not_possible, {options.project, 0, 0},
                       run.problem);
    return {};
  }
  Reference reference;
  for (const calc::PlaneField& field : run.fields) {
    reference.truths.push_back(report::truth_of(replicates_of(field, options.is_indirect)));
  }
  return reference;
}

Reference find_reference(const ConvergeOptions& options, const EstimatorContext& context,
                         const calc::FileReader& files, calc::Diagnostics& diagnostics) {
  if (options.reference == "own") return own_reference(options, context, diagnostics);
  const calc::FileContent content = files.read(options.reference);
  if (!content.ok()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {options.reference, 0, 0},
                       options.reference, content.error);
    return {};
  }
  std::optional<std::vector<report::ConvergeTruth>> truths =
      read_reference(content.bytes, options.reference, context.tasks, diagnostics);
  return truths ? Reference{std::move(*truths)} : Reference{};
}

void describe(const ConvergeOptions& options, const Subject& subject,
              report::ConvergeDocument& document) {
  document.project = subject.project.name;
  document.path = options.project;
  document.space_id = subject.space->id;
  document.program = report::program_version();
  document.part = options.is_indirect ? "indirect" : "total";
  document.reference =
      options.reference == "own"
          ? fmt::format(
                "luxgate's core, other random numbers: {} replicates of {} paths; its own "
                "error is subtracted",
                kReferenceReplicates, report::format_count(reference_paths(options)))
          : options.reference;
  if (options.reference == "own") {
    document.reference_replicates = kReferenceReplicates;
    document.reference_paths = reference_paths(options);
  }
  document.replicates = options.replicates;
  document.seeds = options.seeds;
  document.first_seed = options.seed;
  document.jobs = options.jobs;
  document.triangles = subject.scene.triangle.size();
  document.luminaires = subject.scene.luminaires.size();
  const bool is_clamped = std::find(options.methods.begin(), options.methods.end(),
                                    "clamped-instant-radiosity") != options.methods.end();
  document.clamp_per_m2 = is_clamped ? options.clamp_per_m2 : 0.0;
}

void add_planes(const Subject& subject, const std::vector<report::ConvergeTruth>& truths,
                Ladder& ladder, report::ConvergeDocument& document,
                calc::Diagnostics& diagnostics) {
  document.methods = std::move(ladder.methods);
  for (std::size_t p = 0; p < truths.size(); ++p) {
    report::ConvergePlane& plane = document.planes.emplace_back();
    plane.id = subject.planes[p]->id;
    plane.name = subject.planes[p]->name;
    plane.points = truths[p].lx.size();
    plane.average_lx = truths[p].average_lx;
    plane.minimum_lx = *std::min_element(truths[p].lx.begin(), truths[p].lx.end());
    plane.uo = truths[p].uo;
    plane.reference_error = report::relative_error(truths[p]);
    plane.curves = std::move(ladder.curves[p]);
    document.points += plane.points;
    double smallest = 1e300;
    bool is_below = false;
    for (const report::ConvergeCurve& curve : plane.curves) {
      for (const auto& errors : curve.errors) {
        smallest = std::min(smallest, errors[0].value);
        is_below = is_below || errors[0].is_below;
      }
    }
    if (is_below || smallest < plane.reference_error) {
      diagnostics.report(calc::DiagnosticId::reference_is_rough, subject.planes[p]->where, plane.id,
                         100.0 * plane.reference_error, 100.0 * smallest);
    }
  }
}

std::string render(DataFormat kind, const report::ConvergeDocument& document,
                   const PageChoice& page) {
  switch (kind) {
    case DataFormat::csv:
      return report::render_converge_csv(document);
    case DataFormat::json:
      return report::render_converge_json(document);
    case DataFormat::html:
      return report::render_converge_html(document, page.texts(), page.paper);
    case DataFormat::text:
    case DataFormat::markdown:  // not offered
      break;
  }
  return report::render_converge_text(document);
}

// Writes the files; what is for standard output comes back.
std::string write(const ConvergeOptions& options, const report::ConvergeDocument& document,
                  calc::Diagnostics& diagnostics) {
  const auto render_as = [&](DataFormat kind) { return render(kind, document, options.page); };
  return write_data_outputs(options.outputs, render_as, options.quiet, diagnostics);
}

// For the methods that need OpenGL, if there are any; false after an error.
bool open_device(const ConvergeOptions& options, const Environment& environment,
                 gpu::Fault gl_fault, EstimatorContext& context, report::ConvergeDocument& document,
                 calc::Diagnostics& diagnostics) {
  const auto first = std::find_if(options.methods.begin(), options.methods.end(), needs_opengl);
  if (first == options.methods.end()) return true;
  std::string problem;
  context.device =
      gpu::DeviceThread::open({options.gl_device, gl_fault, environment.program_folder}, problem);
  if (!context.device) {
    diagnostics.report(calc::DiagnosticId::converge_not_possible, {},
                       fmt::format("the method '{}' needs OpenGL: {}", *first, problem));
    return false;
  }
  document.opengl = context.device->device().name();
  document.is_software_opengl = context.device->device().is_software;
  return true;
}

CommandOutcome converge(const ConvergeOptions& options, const RecordingReader& files,
                        const Environment& environment, gpu::Fault gl_fault,
                        calc::Diagnostics& diagnostics) {
  const auto announce = [&](const std::string& what) {
    if (environment.stderr_is_terminal) tell("luxgate: {}\n", what);
  };
  Subject subject;
  report::ConvergeDocument document;
  if (!load(options, files, subject, document, diagnostics)) return {kNotJudged, "", {}};
  EstimatorContext context{subject.scene, subject.tasks,        options.replicates,
                           options.jobs,  options.clamp_per_m2, nullptr};
  if (!open_device(options, environment, gl_fault, context, document, diagnostics)) {
    return {kNotJudged, "", {}};
  }
  const bool has_file = options.reference != "own";
  std::set<std::string> inputs = files.paths();
  if (has_file) inputs.insert(options.reference);
  check_data_outputs(options.outputs, inputs, diagnostics);
  if (diagnostics.has_errors()) return {kNotJudged, "", {}};
  announce("reference");
  const double begin_s = calc::now_s();
  const Reference reference = find_reference(options, context, files, diagnostics);
  document.reference_s = has_file ? 0.0 : calc::now_s() - begin_s;
  if (reference.is_interrupted) return {kInterrupted, "", {}};
  if (reference.truths.empty()) return {kNotJudged, "", {}};
  Ladder ladder = climb(options, context, reference.truths, announce);
  if (ladder.is_interrupted) return {kInterrupted, "", {}};
  if (!ladder.problem.empty()) {
    diagnostics.report(calc::DiagnosticId::converge_not_possible, {options.project, 0, 0},
                       ladder.problem);
    return {kNotJudged, "", {}};
  }
  describe(options, subject, document);
  add_planes(subject, reference.truths, ladder, document, diagnostics);
  CommandOutcome outcome;
  outcome.text = write(options, document, diagnostics);
  if (diagnostics.has_errors()) outcome.code = kNotJudged;
  return outcome;
}

}  // namespace

CommandOutcome run_converge(const ConvergeOptions& options, const calc::FileReader& disk,
                            const Environment& environment, gpu::Fault gl_fault) {
  const RecordingReader files(disk);
  calc::Diagnostics diagnostics;
  CommandOutcome outcome = converge(options, files, environment, gl_fault, diagnostics);
  if (outcome.code == kInterrupted) tell("luxgate: interrupted; nothing was written\n");
  outcome.diagnostics = diagnostics.all();
  return outcome;
}

Command converge_command() {
  const auto options = std::make_shared<ConvergeOptions>();
  Command command = converge_syntax(*options);
  command.run = [options](const RunContext& context) {
    watch_for_interrupt();
    return print_outcome(run_converge(*options, calc::DiskFileReader(options->allowed),
                                      context.environment, context.gl_fault),
                         options->quiet);
  };
  return command;
}

}  // namespace cli
