#include "report/tools/submit/submit.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_reader.h"
#include "calc/base/utf8.h"
#include "report/check/set_values.h"
#include "report/check/settings.h"
#include "report/check/units.h"
#include "report/formats/write.h"
#include "report/shell/command/option_values.h"
#include "report/shell/options/open_backend.h"
#include "report/shell/options/policy_option.h"
#include "report/shell/options/project_reader.h"
#include "report/shell/output/outputs.h"
#include "report/shell/process/print.h"
#include "report/text/shell_words.h"
#include "report/tools/check/check_options.h"
#include "report/tools/check/policy_bounds.h"
#include "report/tools/plan/units_list.h"
#include "report/tools/submit/job_script.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSubmitNotes =
    "Shards calculate into the result cache, and the closing job writes the reports from it. The\n"
    "reports have the bytes of a run on one machine. The same command again completes what\n"
    "was cut off: light in the cache is read, not calculated. Cache, job folder, projects\n"
    "and luxgate must have the same paths on all machines. Where only some machines have a\n"
    "GPU, set --backend. Each batch has its own folder in the job folder, which may be\n"
    "deleted later. All other options are those of 'check'; options of reports apply to the\n"
    "closing job only.";

struct SubmitOptions {
  CheckOptions check;
  std::optional<Engine> engine;
  std::string job_folder;    // "" = beside the store
  std::uint64_t shards = 0;  // 0 = by predicted seconds
  int jobs = 1, at_once = 0;
  int closing_jobs = 0;  // 0 = the engine's default
  bool sends = false, waits = false;
  // Options of `check` as they were given, one each, quoted for a shell.
  std::vector<std::string> words, report_words;
  std::string source_date_epoch;
};

constexpr auto kNotOfBatches =
    std::to_array<std::string_view>({"--advice", "--against", "--explain-cost", "--jobs", "--plane",
                                     "--require", "--resume", "--shard", "--space", "--stored-only",
                                     "--tag", "--time-limit", "--units", "--verbose", "--vpl"});
// All others say how a report looks.
constexpr auto kOfShards = std::to_array<std::string_view>(
    {"--allow",     "--backend", "--by-luminaire", "--clamp",     "--confidence",
     "--gl-device", "--goal",    "--gpu-stages",   "--max-paths", "--method",
     "--no-skip",   "--quiet",   "--replicates",   "--rules",     "--sandbox",
     "--seed",      "--set",     "--timestamp",    "--tolerance", "--visibility"});

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string as_written(const Option& option, const std::string& name, const std::string& value) {
  if (option.may_have_value) {
    return value.empty() ? name : name + "=" + report::shell_quoted(value);
  }
  if (option.value_name.empty()) return name;
  const bool is_plain = !value.empty() && value.front() != '-';
  return name + (is_plain ? " " : "=") + report::shell_quoted(value);
}

// The same option, which also writes down that it was given.
Option recorded(Option option, std::vector<std::string>& words) {
  const std::string name = option.long_name();
  if (bool* const* flag = std::get_if<bool*>(&option.target)) {
    option.target = [target = *flag, name, &words](const std::string&) -> std::string {
      *target = true;
      words.push_back(name);
      return "";
    };
    return option;
  }
  const auto parse = [parser = std::get<ValueParser>(option.target), plain = option, name,
                      &words](const std::string& text) -> std::string {
    std::string problem = parser(text);
    if (problem.empty()) words.push_back(as_written(plain, name, text));
    return problem;
  };
  option.target = ValueParser(parse, option.words());
  return option;
}

// The script says them itself; what a luxgate.toml sets stands there as options.
constexpr auto kOfScript =
    std::to_array<std::string_view>({"--config", "--files-from", "--no-config", "--store"});

std::vector<Option> options_of_check(SubmitOptions& options, std::vector<Option> all) {
  std::vector<Option> kept;
  for (Option& option : all) {
    const std::string name = option.long_name();
    if (is_among(kNotOfBatches, name)) continue;
    std::erase_if(option.excludes,
                  [](const std::string& other) { return is_among(kNotOfBatches, other); });
    if (is_among(kOfScript, name)) {
      kept.push_back(std::move(option));
    } else {
      kept.push_back(recorded(std::move(option),
                              is_among(kOfShards, name) ? options.words : options.report_words));
    }
  }
  return kept;
}

ValueParser engine_parser(std::optional<Engine>& target) {
  const std::vector<std::pair<std::string_view, Engine>> engines = {
      {"slurm", Engine::slurm}, {"parallel", Engine::parallel}, {"local", Engine::local}};
  std::vector<std::string> words;
  for (const auto& [name, engine] : engines) words.emplace_back(name);
  const auto parse = [&target, engines](const std::string& text) {
    Engine engine = Engine::local;
    std::string problem = choice<Engine>(engine, engines)(text);
    if (problem.empty()) target = engine;
    return problem;
  };
  return {parse, std::move(words)};
}

std::string without_end_slash(std::string path) {
  while (path.size() > 1 && path.ends_with('/')) path.pop_back();
  return path;
}

std::string complete(SubmitOptions& options, const Environment& environment) {
  if (!options.engine) return "--engine is needed: slurm, parallel or local";
  const std::string& store = options.check.store.empty() ? environment.store : options.check.store;
  if (store.empty()) return "--store is needed: shards and the closing job share it";
  if (store == "off") return "--store: a batch needs one; 'off' is not allowed";
  if (options.waits && !options.sends) return "--wait needs --send";
  if (options.waits && options.engine != Engine::slurm) {
    return "--wait is for --engine slurm; the others always wait";
  }
  options.source_date_epoch = environment.source_date_epoch;
  if (options.job_folder.empty()) {
    options.job_folder = without_end_slash(store) + "-job";
  }
  return "";
}

ExitCode complain(const std::string& problem) {
  print_error(calc::DiagnosticId::output_not_possible, problem);
  return kNotJudged;
}

// Of the program that runs; as it was called if the system does not say it.
std::string own_path() {
  std::error_code error;
  const fs::path path = fs::read_symlink("/proc/self/exe", error);
  return error ? "luxgate" : path.string();
}

// "" or why an engine or the list of units cannot have these names.
std::string path_problem(const BatchJob& job, const std::vector<std::string>& projects) {
  const auto refused = [&job](const char* who, const char* sign) {
    return fmt::format("{} does not allow '{}' in the name of the job folder, '{}'", who, sign,
                       job.job_folder);
  };
  if (job.engine == Engine::slurm && job.job_folder.find('\\') != std::string::npos) {
    return refused("Slurm", "\\");
  }
  if (job.engine == Engine::parallel && job.job_folder.find('{') != std::string::npos) {
    return refused("GNU parallel", "{");
  }
  for (const std::string& project : projects) {
    if (calc::first_invalid_utf8(project)) {
      return fmt::format("the name of the project '{}' is not UTF-8", calc::printable(project));
    }
  }
  return "";
}

// What it says of files. "" or what is wrong.
std::string write_job(const BatchJob& job, const std::string& units, const std::string& projects) {
  std::error_code error;
  fs::create_directories(job.job_folder, error);
  if (error) {
    return fmt::format("cannot make the folder '{}': {}", job.job_folder, error.message());
  }
  const std::pair<std::string, std::string> files[] = {{units_file(job), units},
                                                       {projects_file(job), projects},
                                                       {job_file(job), render_job_script(job)}};
  for (const auto& [file, text] : files) {
    const std::string problem = report::write_file_atomically(file, text);
    if (!problem.empty()) return fmt::format("cannot write '{}': {}", file, problem);
  }
  fs::remove(job_log(job), error);  // of a batch before, of which no shard is done now
  return error ? fmt::format("cannot delete '{}': {}", job_log(job), error.message()) : "";
}

// Returns only if it cannot.
ExitCode become_script(const BatchJob& job, bool waits) {
  std::fflush(stdout);
  std::fflush(stderr);
  const std::string file = job_file(job);
  execlp("bash", "bash", file.c_str(), waits ? "wait" : "send", static_cast<char*>(nullptr));
  return complain(fmt::format("cannot start bash: {}", std::strerror(errno)));
}

ExitCode run_submit(const SubmitOptions& options, const RunContext& context) {
  const ProjectReader disk(options.check.input);
  const CheckOptions& check = options.check;
  const check::SetReader files(disk, check.input.projects, check.set);
  if (!check_values_or_print(check.input, check.set, "set", disk)) return kNotJudged;
  const calc::RadiositySettings& radiosity = check.settings.radiosity;
  std::vector<std::string> inputs = check.input.projects;
  inputs.insert(inputs.end(), check.input.rule_files.begin(), check.input.rule_files.end());
  if (!check.baseline.empty()) inputs.push_back(check.baseline);
  if (const std::string problem = check_outputs(check.output, inputs); !problem.empty()) {
    return complain(problem);
  }
  if (!check.policy.empty()) {  // before hours of work
    const auto policy = read_policy_or_print(check.policy, disk);
    if (!policy || !is_allowed_or_print(*policy, check)) return kNotJudged;
  }
  const auto packs = load_packs_or_print(check.input.rule_files, files);
  if (!packs) return kNotJudged;
  const std::vector<check::ProjectPlan> plans =
      check::plan_projects(check.input.projects, files, *packs, radiosity,
                           check::day_of(check.settings), check.settings.budget);
  bool is_planned = true;
  for (const check::ProjectPlan& plan : plans) {
    print_diagnostics(plan.diagnostics, true);  // the closing job tells warnings
    is_planned = is_planned && plan.is_planned;
  }
  if (!is_planned) {
    return complain(
        "no job is made: correct the projects with errors, or omit them from the batch");
  }
  const std::vector<check::Unit> units = check::units_of(plans, radiosity);

  BatchJob job;
  job.engine = *options.engine;
  job.program = own_path();
  std::error_code error;
  const fs::path here = fs::current_path(error);
  if (error) return complain(fmt::format("no working folder: {}", error.message()));
  job.working_folder = here.string();
  job.job_folder = without_end_slash((here / options.job_folder).lexically_normal().string());
  job.store = check.store;
  job.options = options.words;
  const ConfigChoice& config = check.input.config;
  if (!config.taken.empty() || config.is_off) job.options.emplace_back("--no-config");
  job.report_options = options.report_words;
  job.source_date_epoch = options.source_date_epoch;
  job.units = units.size();
  for (const check::Unit& unit : units) job.first_look_s += unit.first_look_s;
  job.shards = options.shards == 0 ? shards_for(job.units, job.first_look_s)
                                   : std::clamp<std::size_t>(job.units, 1, options.shards);
  job.jobs = options.jobs;
  job.closing_jobs = options.closing_jobs;
  if (job.closing_jobs == 0 && job.engine == Engine::slurm) job.closing_jobs = job.jobs;
  job.at_once = options.at_once;
  check::Hardware hardware(context.gl_fault, context.environment.program_folder);
  const check::BackendChoice backend =
      check::choose_backend(check.backend, radiosity.shadow_map_texels, hardware,
                            [&] { return first_look_work(plans, radiosity); });
  job.needs_gpu = backend.backend == check::Backend::gpu && backend.device != gpu::kPreferSoftware;
  const std::string units_text = render_units_json(units);
  const std::string projects = render_project_list(check.input.projects);
  job.job_folder += "/" + batch_id(job, units_text, projects);
  std::string problem = path_problem(job, check.input.projects);
  if (problem.empty()) problem = write_job(job, units_text, projects);
  if (!problem.empty()) return complain(problem);
  if (!check.output.quiet) {
    tell(
        "luxgate: jobs: {}, shards: {}; by prediction {:.3g} s of one core for the first sampling "
        "rounds; {}'bash {}'\n",
        job.units, job.shards, job.first_look_s,
        options.sends ? "" : "to start: ", report::shell_quoted(job_file(job)));
  }
  if (options.sends) return become_script(job, options.waits);
  return print_outcome({kAllMet, render_job_script(job), {}});
}

}  // namespace

Command submit_command() {
  const auto options = std::make_shared<SubmitOptions>();
  Command of_check = check_syntax(options->check);
  Command command{"submit", "Write or send a batch for Slurm, GNU parallel or all cores here"};
  // Jobs that start later read the projects again.
  options->check.input.takes_standard_input = false;
  command.places = {projects_place(options->check.input)};
  command.options = {
      {"--engine", "NAME",
       "Choose what runs the batch: slurm, parallel or local. slurm: an array of shards and a "
       "closing job. parallel: GNU parallel. local: bash alone",
       engine_parser(options->engine)},
      {"--shards", "N",
       "Split the batch into N shards, at most one per job; default about three minutes each. The "
       "predicted first rounds are taken for a quarter of the work",
       whole_number(options->shards, 1, 1'000'000)},
      {"--job-folder", "DIR",
       "Write the script, lists and logs into this folder; default the name of the cache with "
       "'-job'. It is made if needed",
       some_text(options->job_folder)},
      jobs_option(options->jobs),
      {"--closing-jobs", "N",
       "Use N threads in the closing job, which mostly wait for the cache; 1 to 1024. By default "
       "as many as a shard with slurm, otherwise one per core. With slurm it is also the number of "
       "cores that are requested",
       whole_number(options->closing_jobs, 1, 1024)},
      {"--at-once", "N",
       "Run at most N shards at a time; default all that slurm has room for, else one per core",
       whole_number(options->at_once, 1, 1'000'000)},
      {"--send", "", "Start the batch instead of printing the script", &options->sends},
      {"--wait", "",
       "Wait for the closing job, print its results and end with its exit code; with --send and "
       "slurm",
       &options->waits}};
  command.options[3].help =
      "Use N threads in a shard, 1 to 1024; default 1. With slurm it is also the number of cores "
      "that are requested";
  add(command.options, options_of_check(*options, std::move(of_check.options)));
  command.config = of_check.config;
  command.config_revision = of_check.config_revision;
  command.notes = kSubmitNotes;
  command.examples = {
      {"luxgate submit designs/a.xml designs/b.xml --engine slurm --store /srv/store --output out",
       "Prints the script; 'sbatch' starts it, or --send"},
      {"luxgate submit designs/a.xml --engine local --store store --send", "On all cores here"}};
  command.exit_codes = {
      {kAllMet, "no error; with --send that of the closing job, but for slurm without --wait"},
      {kNotMet, "with --send: as 'check' ends"},
      {kNotJudged, "an error; with --send also as 'check' ends"},
      {kUndecided, "with --send: as 'check' ends"}};
  command.most_used = {"--engine", "--store",  "--shards", "--job-folder", "--jobs",
                       "--output", "--format", "--send",   "--wait",       "--quiet"};
  command.complete_projects = of_check.complete_projects;
  command.complete = [options, rest = of_check.complete](const Environment& environment) {
    const std::string problem = complete(*options, environment);
    return problem.empty() ? rest(environment) : problem;
  };
  command.run = [options](const RunContext& context) { return run_submit(*options, context); };
  return command;
}

}  // namespace cli
