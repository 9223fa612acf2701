#include "report/cli/run.h"

#include "calc/base/numbers_version.h"
#include "calc/project/project_xml.h"
#include "calc/rays/instruction_set.h"
#include "gpu/egl_context.h"
#include "report/check/backend.h"
#include "report/check/check_project.h"
#include "report/check/load_rules.h"
#include "report/check/plan.h"
#include "report/document/same_bits.h"
#include "report/result_file/read_json.h"
#include "report/result_file/result_schema.h"
#include "report/shell/interrupt.h"
#include "report/shell/outputs.h"
#include "report/shell/progress.h"
#include "report/shell/recording_reader.h"
#include "report/text/redact.h"
#include "report/tools/compare/compare.h"
#include "report/tools/converge/converge.h"
#include "report/tools/devices/devices.h"
#include "report/tools/devices/version.h"
#include "report/tools/export/export.h"
#include "report/tools/geometry/geometry.h"
#include "report/tools/init/init.h"
#include "report/tools/photometry/photometry.h"
#include "report/tools/rules/rules.h"
#include "report/tools/selftest/selftest.h"
#include "report/tools/vpl/vpl.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cli {
namespace {

using rules::Outcome;

void print_diagnostics(const std::vector<calc::Diagnostic>& diagnostics, bool errors_only) {
  for (const calc::Diagnostic& diagnostic : diagnostics) {
    if (errors_only && diagnostic.severity() != calc::Severity::error) continue;
    fmt::print(stderr, "{}\n", calc::format_diagnostic(diagnostic));
  }
}

void print_error(calc::DiagnosticId id, const std::string& a, const std::string& b = "") {
  calc::Diagnostics diagnostics;
  diagnostics.report(id, {}, a, b);
  print_diagnostics(diagnostics.all(), true);
}

// False if not all of it could be written, e.g. to a full disk.
bool print_result(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  return std::fflush(stdout) == 0 && written;
}

// Empty after an error, which has been printed.
std::optional<std::vector<rules::RulePack>> load_packs_or_print(
    const std::vector<std::string>& paths, const calc::FileReader& files) {
  calc::Diagnostics diagnostics;
  std::vector<rules::RulePack> packs = load_rule_packs(paths, files, diagnostics);
  print_diagnostics(diagnostics.all(), false);
  if (diagnostics.has_errors()) return std::nullopt;
  return packs;
}

std::vector<ProjectPlan> plan_projects(const Options& options, const calc::FileReader& files,
                                       const std::vector<rules::RulePack>& packs) {
  std::vector<ProjectPlan> plans;
  for (const std::string& path : options.projects) {
    plans.push_back(plan_project(path, files, packs, options.radiosity));
  }
  return plans;
}

// Empty after an error, which has been printed. Another backend is never taken instead.
std::optional<OpenBackend> open_or_complain(const BackendChoice& choice, gpu::Fault fault,
                                            const std::string& program_folder, bool quiet) {
  std::string problem, software;
  std::optional<OpenBackend> backend =
      open_backend(choice, fault, program_folder, problem, software);
  if (!backend) print_error(calc::DiagnosticId::backend_not_available, "gpu", problem);
  if (!software.empty()) {
    calc::Diagnostics diagnostics;
    diagnostics.report(calc::DiagnosticId::backend_is_software, {}, software);
    print_diagnostics(diagnostics.all(), quiet);
  }
  return backend;
}

report::Provenance provenance_of(const Options& options, Backend backend,
                                 const std::string& description) {
  report::Provenance provenance;
  provenance.program_version = program_version();
  Options used = options;  // what `auto` came to; its answer `cpu` is the usual one
  if (backend == Backend::gpu) used.backend = backend;
  provenance.command_line = reproducible_command(used);
  provenance.timestamp = options.timestamp;
  provenance.seed = options.radiosity.seed;
  provenance.confidence = options.confidence;
  provenance.goal = options.goal;
  provenance.tolerance = options.tolerance;
  provenance.max_paths = options.radiosity.max_paths;
  provenance.replicates = options.radiosity.replicates;
  provenance.backend = description;
  provenance.numbers_version = calc::kNumbersVersion;
  return provenance;
}

report::ProjectPart failed_project(const std::string& path, calc::DiagnosticId id,
                                   const std::string& reason) {
  calc::Diagnostics diagnostics;
  diagnostics.report(id, {path, 0, 0}, reason);
  report::ProjectPart part;
  part.path = path;
  part.diagnostics = diagnostics.all();
  return part;
}

// Whatever goes wrong in one project must not stop the batch.
report::ProjectPart check_safely(const std::string& path, const CheckContext& context) {
  try {
    return check_project(path, context);
  } catch (const calc::BackendFailure& failure) {
    return failed_project(path, calc::DiagnosticId::backend_failed, failure.what());
  } catch (const std::exception& error) {
    return failed_project(path, calc::DiagnosticId::internal_error, error.what());
  }
}

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

// The format for standard output: as asked for, else text unless --quiet.
std::optional<FormatKind> stdout_format(const Options& options) {
  for (const OutputFormat& format : options.formats) {
    if (format.file.empty()) return format.kind;
  }
  if (options.quiet) return std::nullopt;
  return FormatKind::text;
}

// False after an error, which has been printed; the other formats are written all the same.
bool write_results(const Options& options, const Environment& environment,
                   const report::Document& document, const std::set<std::string>& inputs) {
  bool is_written = true;
  for (const std::string& problem : write_outputs(options, document, inputs)) {
    print_error(calc::DiagnosticId::output_not_possible, problem);
    is_written = false;
  }
  if (const std::optional<FormatKind> kind = stdout_format(options)) {
    const report::TextOptions text{use_color(options.color, environment),
                                   environment.stdout_columns};
    if (!print_result(render(*kind, document, text, report_texts(options)))) {
      print_error(calc::DiagnosticId::output_not_possible, "cannot write to standard output");
      is_written = false;
    }
  }
  return is_written;
}

// Options with a cache's seed, replicates and paths; empty after an error, which has been printed.
std::optional<Options> with_cache(const Options& options, const calc::FileReader& files,
                                  std::optional<calc::VertexCache>& cache) {
  Options used = options;
  if (options.vpl_file.empty()) return used;
  calc::Diagnostics diagnostics;
  cache = read_vertex_cache(options.vpl_file, files, diagnostics);
  print_diagnostics(diagnostics.all(), true);
  if (!cache) return std::nullopt;
  use_settings_of(*cache, used.radiosity);
  return used;
}

ExitCode run_check(const Options& asked, const Environment& environment, gpu::Fault fault) {
  const calc::DiskFileReader disk;
  const RecordingReader files(disk);
  std::optional<calc::VertexCache> cache;
  const std::optional<Options> used = with_cache(asked, files, cache);
  if (!used) return kNotJudged;
  const Options& options = *used;
  const std::string problem = check_outputs(options);
  if (!problem.empty()) {
    print_error(calc::DiagnosticId::output_not_possible, problem);
    return kNotJudged;
  }
  const std::optional<std::vector<rules::RulePack>> packs =
      load_packs_or_print(options.rule_files, files);
  if (!packs) return kNotJudged;
  const BackendChoice backend = choose_backend(
      options, fault, [&] { return first_look_work(plan_projects(options, files, *packs)); });
  const std::optional<OpenBackend> opened =
      open_or_complain(backend, fault, environment.program_folder, options.quiet);
  if (!opened) return kNotJudged;

  watch_for_interrupt();
  Progress progress(environment.stderr_is_terminal && !options.quiet);
  std::string cost_log = options.explain_cost ? backend_line(backend) : "";
  const calc::Stages stages = opened->stages();
  std::optional<PictureMaker> pictures;
  if (wants_pictures(options)) {
    pictures.emplace(
        options, fault, [] { return !interrupted(); }, environment.program_folder);
  }
  const CheckContext context{options,
                             files,
                             *packs,
                             stages,
                             progress,
                             pictures ? &*pictures : nullptr,
                             options.explain_cost ? &cost_log : nullptr,
                             cache ? &*cache : nullptr};
  report::Document document;
  document.provenance = provenance_of(options, backend.backend, opened->description);
  for (const std::string& path : options.projects) {
    progress.start_project(path);
    document.projects.push_back(check_safely(path, context));
    progress.clear();
    if (interrupted()) {
      fmt::print(stderr, "luxgate: interrupted; nothing was written\n");
      return kInterrupted;
    }
    print_diagnostics(document.projects.back().diagnostics, options.quiet);
    if (options.timing && document.projects.back().is_judged)
      print_timing(document.projects.back());
  }
  document.provenance.same_bits = report::same_bits_of(document, backend.backend == Backend::gpu);
  fmt::print(stderr, "{}", cost_log);
  if (options.redact) report::redact(document);
  const bool is_written = write_results(options, environment, document, files.paths());
  return is_written ? exit_code_of(outcome_of(document)) : kNotJudged;
}

ExitCode run_report(const Options& options, const Environment& environment) {
  const std::string output_problem = check_outputs(options);
  if (!output_problem.empty()) {
    print_error(calc::DiagnosticId::output_not_possible, output_problem);
    return kNotJudged;
  }
  const calc::FileContent content = calc::DiskFileReader().read(options.result_file);
  if (!content.ok()) {
    print_error(calc::DiagnosticId::file_not_readable, options.result_file, content.error);
    return kNotJudged;
  }
  std::string problem;
  std::optional<report::Document> document = report::read_json(content.bytes, problem);
  if (!document) {
    print_error(calc::DiagnosticId::result_not_readable, options.result_file, problem);
    return kNotJudged;
  }
  if (options.redact) report::redact(*document);
  return write_results(options, environment, *document, {path_identity(options.result_file)})
             ? kAllMet
             : kNotJudged;
}

ExitCode run_plan(const Options& options, gpu::Fault fault) {
  const calc::DiskFileReader files;
  const std::optional<std::vector<rules::RulePack>> packs =
      load_packs_or_print(options.rule_files, files);
  if (!packs) return kNotJudged;
  Outcome outcome = Outcome::nothing_asked;
  const std::vector<ProjectPlan> plans = plan_projects(options, files, *packs);
  for (const ProjectPlan& plan : plans) {
    print_diagnostics(plan.diagnostics, options.quiet);
    if (!plan.is_planned) outcome = graver(outcome, Outcome::not_judged);
  }
  const BackendChoice backend =
      choose_backend(options, fault, [&] { return first_look_work(plans); });
  if (!open_or_complain(backend, fault, "", options.quiet)) {
    outcome = graver(outcome, Outcome::not_judged);
  }
  const std::string text = options.plan_as_json
                               ? render_plan_json(plans, options.radiosity, backend)
                               : render_plan_text(plans, options.radiosity, backend);
  return print_result(text) ? exit_code_of(outcome) : kNotJudged;
}

ExitCode run_validate(const Options& options) {
  const calc::DiskFileReader files;
  const std::optional<std::vector<rules::RulePack>> packs =
      load_packs_or_print(options.rule_files, files);
  if (!packs) return kNotJudged;
  Outcome outcome = Outcome::nothing_asked;
  for (const std::string& path : options.projects) {
    const report::ProjectPart part = validate_project(path, files, *packs);
    print_diagnostics(part.diagnostics, options.quiet);
    if (!part.is_judged) outcome = graver(outcome, Outcome::not_judged);
    if (part.is_judged && !options.quiet) fmt::print("{}: no error\n", path);
  }
  return exit_code_of(outcome);
}

// Results to standard output, messages before them to standard error.
ExitCode print_outcome(const CommandOutcome& outcome, bool quiet) {
  print_diagnostics(outcome.diagnostics, quiet);
  return print_result(outcome.text) ? outcome.code : kNotJudged;
}

ExitCode run_geometry(const Options& options) {
  const calc::DiskFileReader files;
  std::vector<GeometryReport> reports;
  Outcome outcome = Outcome::nothing_asked;
  for (const std::string& path : options.geometry_files) {
    reports.push_back(examine_geometry(path, files, options));
    const GeometryReport& report = reports.back();
    print_diagnostics(report.diagnostics, false);
    if (!report.is_readable()) outcome = graver(outcome, Outcome::not_judged);
    if (options.strict && !report.diagnostics.empty()) outcome = graver(outcome, Outcome::fail);
  }
  const std::string text =
      options.geometry_as_json ? render_geometry_json(reports) : render_geometry_text(reports);
  return print_result(text) ? exit_code_of(outcome) : kNotJudged;
}

ExitCode run_init(const Options& options) {
  const InitResult result = write_starter_project(options.init_folder);
  if (!result.error.empty()) {
    print_error(calc::DiagnosticId::output_not_possible, result.error);
    return kNotJudged;
  }
  fmt::print("Wrote {0} and its photometry. Next: luxgate check {0}\n", result.project_file);
  return kAllMet;
}

ExitCode run_photometry(const Options& options, const Environment& environment) {
  const PhotometryRun result =
      run_photometry(options, calc::DiskFileReader(), use_color(options.color, environment));
  fmt::print(stderr, "{}", result.err);
  return print_result(result.out) ? static_cast<ExitCode>(result.exit_code) : kNotJudged;
}

ExitCode run_devices(const Options& options, gpu::Fault fault) {
  const gpu::DeviceList list = gpu::list_devices(fault);
  const std::string text =
      options.devices_as_json ? render_devices_json(list) : render_devices_text(list);
  return print_result(text) && gpu::preferred_device(list) >= 0 ? kAllMet : kNotJudged;
}

ExitCode print_run(const RulesRun& run) {
  fmt::print(stderr, "{}", run.err);
  return print_result(run.out) ? static_cast<ExitCode>(run.exit_code) : kNotJudged;
}

ExitCode print_or_fail(const std::string& text) {
  return print_result(text) ? kAllMet : kNotJudged;
}

}  // namespace

ExitCode run(const Options& options, const Environment& environment) {
  const std::optional<gpu::Fault> fault = find_gl_fault(environment.gl_fault);
  if (!fault) {
    print_error(calc::DiagnosticId::backend_not_available, "gpu",
                fmt::format("LUXGATE_GL_FAULT, which is for tests, is '{}'", environment.gl_fault));
    return kNotJudged;
  }
  const std::vector<std::string_view> here = calc::instruction_sets();
  const std::string_view wanted = calc::wanted_instruction_set();
  if (!wanted.empty() && std::find(here.begin(), here.end(), wanted) == here.end()) {
    print_error(calc::DiagnosticId::instruction_set_not_available, std::string(wanted),
                fmt::format("{}", fmt::join(here, ", ")));
    return kNotJudged;
  }
  switch (options.command) {
    case Command::check:
      return run_check(options, environment, *fault);
    case Command::report:
      return run_report(options, environment);
    case Command::plan:
      return run_plan(options, *fault);
    case Command::validate:
      return run_validate(options);
    case Command::vpl:
      return print_outcome(run_vpl(options.vpl, calc::DiskFileReader(), environment, *fault),
                           false);
    case Command::converge:
      watch_for_interrupt();
      return print_outcome(
          run_converge(options.converge, calc::DiskFileReader(), environment, *fault), false);
    case Command::selftest:
      watch_for_interrupt();
      return print_outcome(run_selftest(options.selftest, environment), false);
    case Command::compare:
      return print_outcome(run_compare(options.compare, calc::DiskFileReader()), false);
    case Command::export_scene:
      return print_outcome(run_export(options.export_scene, calc::DiskFileReader()), false);
    case Command::photometry:
      return run_photometry(options, environment);
    case Command::geometry:
      return run_geometry(options);
    case Command::rules:
      return print_run(run_rules(options, calc::DiskFileReader()));
    case Command::explain:
      return print_run(run_explain(options, calc::DiskFileReader()));
    case Command::schema:
      return print_or_fail(
          std::string(options.result_schema ? report::result_schema() : calc::project_schema()));
    case Command::init:
      return run_init(options);
    case Command::devices:
      return run_devices(options, *fault);
    case Command::version:
      return print_or_fail(version_text(options.version_as_json));
  }
  return kNotJudged;
}

int run_program(int argc, const char* const* argv) {
  try {
    const Environment environment = read_environment();
    const ParseResult parsed = parse_options(argc, argv, environment.source_date_epoch);
    if (!parsed.options) {
      fmt::print(stderr, "{}", parsed.err);
      return print_result(parsed.out) ? parsed.exit_code : kNotJudged;
    }
    return run(*parsed.options, environment);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "luxgate: error[internal-error]: %s\n", error.what());
    return kNotJudged;
  }
}

}  // namespace cli
