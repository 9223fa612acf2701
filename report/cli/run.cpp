#include "report/cli/run.h"

#include "calc/scene/project_xml.h"
#include "gpu/gl_gatherer.h"
#include "report/cli/check_project.h"
#include "report/cli/geometry.h"
#include "report/cli/init.h"
#include "report/cli/interrupt.h"
#include "report/cli/outputs.h"
#include "report/cli/photometry.h"
#include "report/cli/plan.h"
#include "report/cli/progress.h"
#include "report/cli/recording_reader.h"
#include "report/cli/version.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace cli {
namespace {

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

// Built-in packs and those of --rules; empty after an error, which has been printed.
std::optional<std::vector<rules::RulePack>> load_rule_packs(const std::vector<std::string>& paths,
                                                            const calc::FileReader& files) {
  calc::Diagnostics diagnostics;
  std::vector<rules::RulePack> packs = rules::builtin_rule_packs();
  for (const std::string& path : paths) {
    const calc::FileContent content = files.read(path);
    if (!content.ok()) {
      diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
      continue;
    }
    std::optional<rules::RulePack> pack = rules::parse_rule_pack(content.bytes, path, diagnostics);
    if (!pack) continue;
    for (const rules::RulePack& known : packs) {
      if (known.full_id() != pack->full_id()) continue;
      diagnostics.report(calc::DiagnosticId::rule_pack_loaded_twice, {path, 0, 0}, pack->full_id(),
                         known.file);
    }
    packs.push_back(std::move(*pack));
  }
  print_diagnostics(diagnostics.all(), false);
  if (diagnostics.has_errors()) return std::nullopt;
  return packs;
}

// Null after an error, which has been printed. Another backend is never taken instead.
std::unique_ptr<calc::Gatherer> make_gatherer(Backend backend) {
  if (backend == Backend::cpu) return calc::make_cpu_gatherer();
  std::string reason;
  std::unique_ptr<calc::Gatherer> gatherer = gpu::make_gl_gatherer(reason);
  if (!gatherer) print_error(calc::DiagnosticId::backend_not_available, "gpu", reason);
  return gatherer;
}

report::Provenance provenance_of(const Options& options, const calc::Gatherer& gatherer) {
  report::Provenance provenance;
  provenance.program_version = program_version();
  provenance.command_line = reproducible_command(options);
  provenance.timestamp = options.timestamp;
  provenance.seed = options.radiosity.seed;
  provenance.confidence = options.confidence;
  provenance.goal = options.goal;
  provenance.tolerance = options.tolerance;
  provenance.max_paths = options.radiosity.max_paths;
  provenance.replicates = options.radiosity.replicates;
  provenance.backend = gatherer.description();
  return provenance;
}

// Whatever goes wrong in one project must not stop the batch.
report::ProjectPart check_safely(const std::string& path, const CheckContext& context) {
  try {
    return check_project(path, context);
  } catch (const std::exception& error) {
    calc::Diagnostics diagnostics;
    diagnostics.report(calc::DiagnosticId::internal_error, {path, 0, 0}, error.what());
    report::ProjectPart part;
    part.path = path;
    part.diagnostics = diagnostics.all();
    return part;
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
      "connections {:.3f}, near field {:.3f}, verdicts {:.3f}; {} rays from points, {:.3g} /s\n",
      project.path, times.total_s, times.load_s, times.prepare_s, times.direct_s, times.pool_s,
      times.connect_s, times.near_s, times.judge_s, rays,
      rays_s > 0.0 ? static_cast<double>(rays) / rays_s : 0.0);
}

// The format for standard output: as asked for, else text unless --quiet.
std::optional<FormatKind> stdout_format(const Options& options) {
  for (const OutputFormat& format : options.formats) {
    if (format.file.empty()) return format.kind;
  }
  if (options.quiet) return std::nullopt;
  return FormatKind::text;
}

ExitCode write_results(const Options& options, const Environment& environment,
                       const report::Document& document, const std::set<std::string>& inputs) {
  ExitCode code = exit_code_for(document);
  for (const std::string& problem : write_outputs(options, document, inputs)) {
    print_error(calc::DiagnosticId::output_not_possible, problem);
    code = kNotJudged;
  }
  if (const std::optional<FormatKind> kind = stdout_format(options)) {
    const report::TextOptions text{use_color(options.color, environment),
                                   environment.stdout_columns};
    if (!print_result(render(*kind, document, text))) {
      print_error(calc::DiagnosticId::output_not_possible, "cannot write to standard output");
      code = kNotJudged;
    }
  }
  return code;
}

ExitCode run_check(const Options& options, const Environment& environment) {
  const calc::DiskFileReader disk;
  const RecordingReader files(disk);
  const std::string problem = check_outputs(options);
  if (!problem.empty()) {
    print_error(calc::DiagnosticId::output_not_possible, problem);
    return kNotJudged;
  }
  const std::optional<std::vector<rules::RulePack>> packs =
      load_rule_packs(options.rule_files, files);
  const std::unique_ptr<calc::Gatherer> gatherer = make_gatherer(options.backend);
  if (!packs || !gatherer) return kNotJudged;

  watch_for_interrupt();
  Progress progress(environment.stderr_is_terminal && !options.quiet);
  std::string cost_log;
  const CheckContext context{options,   files,    *packs,
                             *gatherer, progress, options.explain_cost ? &cost_log : nullptr};
  report::Document document;
  document.provenance = provenance_of(options, *gatherer);
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
  fmt::print(stderr, "{}", cost_log);
  return write_results(options, environment, document, files.paths());
}

ExitCode run_plan(const Options& options) {
  const calc::DiskFileReader files;
  const std::optional<std::vector<rules::RulePack>> packs =
      load_rule_packs(options.rule_files, files);
  if (!packs) return kNotJudged;
  ExitCode code = kAllMet;
  std::vector<ProjectPlan> plans;
  for (const std::string& path : options.projects) {
    plans.push_back(plan_project(path, files, *packs, options.radiosity));
    print_diagnostics(plans.back().diagnostics, options.quiet);
    if (!plans.back().is_planned) code = kNotJudged;
  }
  const std::string text = options.plan_as_json ? render_plan_json(plans, options.radiosity)
                                                : render_plan_text(plans, options.radiosity);
  return print_result(text) ? code : kNotJudged;
}

ExitCode run_validate(const Options& options) {
  const calc::DiskFileReader files;
  const std::optional<std::vector<rules::RulePack>> packs =
      load_rule_packs(options.rule_files, files);
  if (!packs) return kNotJudged;
  ExitCode code = kAllMet;
  for (const std::string& path : options.projects) {
    const report::ProjectPart part = validate_project(path, files, *packs);
    print_diagnostics(part.diagnostics, options.quiet);
    if (!part.is_judged) code = kNotJudged;
    if (part.is_judged && !options.quiet) fmt::print("{}: no error\n", path);
  }
  return code;
}

ExitCode run_geometry(const Options& options) {
  const calc::DiskFileReader files;
  std::vector<GeometryReport> reports;
  ExitCode code = kAllMet;
  for (const std::string& path : options.geometry_files) {
    reports.push_back(examine_geometry(path, files, options));
    const GeometryReport& report = reports.back();
    print_diagnostics(report.diagnostics, false);
    if (!report.is_readable()) code = kNotJudged;
    if (code == kAllMet && options.strict && !report.diagnostics.empty()) code = kNotMet;
  }
  const std::string text =
      options.geometry_as_json ? render_geometry_json(reports) : render_geometry_text(reports);
  return print_result(text) ? code : kNotJudged;
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

ExitCode print_or_fail(const std::string& text) {
  return print_result(text) ? kAllMet : kNotJudged;
}

}  // namespace

ExitCode run(const Options& options, const Environment& environment) {
  switch (options.command) {
    case Command::check:
      return run_check(options, environment);
    case Command::plan:
      return run_plan(options);
    case Command::validate:
      return run_validate(options);
    case Command::photometry:
      return run_photometry(options, environment);
    case Command::geometry:
      return run_geometry(options);
    case Command::schema:
      return print_or_fail(std::string(calc::project_schema()));
    case Command::init:
      return run_init(options);
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
