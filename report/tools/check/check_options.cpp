#include "report/tools/check/check_options.h"

#include "calc/store/entry_folder.h"
#include "report/shell/command/option_values.h"
#include "report/shell/options/gate_options.h"
#include "report/shell/options/policy_option.h"
#include "report/shell/options/selection_option.h"
#include "report/shell/process/print.h"
#include "report/text/shell_words.h"

#include <fmt/format.h>

#include <filesystem>

namespace cli {
namespace {

std::vector<ExitMeaning> check_exit_codes() {
  return {
      {kAllMet, "every requirement is met or waived, or nothing is required: a warning says so"},
      {kNotMet, "at least one requirement is not met"},
      {kNotJudged,
       "not judged: usage, input or file error, a plane or project that could not be judged, "
       "or a warning that --strict makes count"},
      {kUndecided, "nothing failed, but a result's interval holds its limit: undecided"},
      {kInterrupted, "interrupted; no report was written"}};
}

std::vector<Option> document_options(CheckOptions& options) {
  return {
      {"--pictures", "WHEN",
       "Rooms in false colours, in HTML and with --images: auto (where OpenGL can draw) or\n"
       "off; default auto. Their bytes depend on the machine's OpenGL",
       choice<bool>(options.pictures, {{"auto", true}, {"off", false}})},
      {"--timestamp", "WHEN",
       "Put a date into reports: 'now' or seconds since 1970; default SOURCE_DATE_EPOCH if set,\n"
       "else no date, so that equal inputs give equal files",
       moment(options.timestamp)},
      {"--timing", "", "Print times and counts of rays to standard error and put them into reports",
       &options.settings.has_times},
      {"--explain-cost", "",
       "Print predicted beside true work to standard error: see 'luxgate plan'",
       &options.explain_cost},
      {"--advice", "",
       "Where something is not met: dimming levels with which it would be, with the least power,\n"
       "or why there are none; in HTML, PDF, text, Markdown and JSON. Takes a calculation to\n"
       "--tolerance and at least one check more. See 'luxgate advise', which says more",
       &options.advice},
      color_option(options.output.color)};
}

// Its repository says whether it is one.
ValueParser git_revision(std::string& target) {
  return [&target](const std::string& text) -> std::string {
    if (text.empty() || text.front() == '-') {
      return "a git revision: a branch, a tag, the id of a commit, HEAD~1, main...";
    }
    target = text;
    return "";
  };
}

Option against_option(std::string& target) {
  return {
      "--against",
      "REV",
      "The same since a git revision: branch, tag, commit, HEAD~1, or 'main...' for the commit\n"
      "at which HEAD left main. The projects are checked as they were then, with the same\n"
      "options, from the repository's objects: the work tree is not touched, nothing is\n"
      "fetched. --rules in the repository are those of then, others those of now",
      git_revision(target),
      false,
      {"--baseline", "--set"}};
}

// In the folder of the reports: the light of a run until these are written.
constexpr const char* kResumeFolder = ".luxgate-resume";

constexpr std::uint64_t kMostShards = 1'000'000;

// "3/16"
ValueParser share_of_batch(BatchShare& target) {
  return [&target](const std::string& text) -> std::string {
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto number = parse_count(text.substr(0, slash));
    const auto count = parse_count(slash < text.size() ? text.substr(slash + 1) : "");
    if (!number || !count || *number < 1 || *number > *count || *count > kMostShards) {
      return fmt::format(
          "'{}' is no share of a batch; allowed are I/N with whole numbers, I from 1 to N and N up "
          "to {}",
          text, kMostShards);
    }
    target = {*number, *count};
    return "";
  };
}

std::vector<Option> batch_options(BatchOptions& batch) {
  return {
      shard_option(batch.share,
                   "Calculate only share I of N of the light, from 1 to N, into --store, and judge "
                   "nothing:\n"
                   "for as many machines. Shares are alike in predicted work. Then one run with\n"
                   "--stored-only reports. Exit code 0: all of the share is in the store"),
      {"--units", "FILE",
       "With --shard: the list that 'luxgate plan --units --format json' wrote of the same\n"
       "projects, so that each share reads its own projects only",
       some_text(batch.units_file)},
      stored_only_option(batch.is_stored_only),
      {"--resume", "",
       "Keep finished light in a folder of --output until the reports are written: a run that\n"
       "was ended goes on there when the same command is given again. A --store does that, too",
       &batch.resumes}};
}

// "" or which options cannot stand beside each other.
std::string batch_contradiction(const CheckOptions& options) {
  const BatchOptions& batch = options.batch;
  const bool is_shard = batch.share.count > 0;
  if (!batch.units_file.empty() && !is_shard) return "--units needs --shard";
  if (!is_shard && !batch.is_stored_only) return "";
  const char* name = is_shard ? "--shard" : "--stored-only";
  const auto together = [name](const char* other) {
    return fmt::format("{} and {} exclude each other", name, other);
  };
  if (options.store.empty()) return fmt::format("{} needs --store", name);
  if (is_shard && batch.is_stored_only) return together("--stored-only");
  if (!options.vpl_file.empty()) return together("--vpl");
  if (!options.against.empty()) {
    return together("--against") + "; --baseline compares with a result";
  }
  if (options.settings.radiosity.time_limit_s > 0.0) return together("--time-limit");
  if (options.advice) return together("--advice");
  if (!is_shard) return "";
  const OutputOptions& output = options.output;
  if (!output.formats.empty() || !output.folder.empty() || output.images) {
    return "--shard writes no report; leave --format, --output and --images to the run with "
           "--stored-only";
  }
  if (!options.baseline.empty()) return together("--baseline");
  return options.explain_cost ? together("--explain-cost") : "";
}

// Where a store is used anyway it is all that --resume needs.
std::string take_resume_store(CheckOptions& options) {
  if (!options.batch.resumes) return "";
  if (options.batch.is_stored_only) return "--resume and --stored-only exclude each other";
  if (!options.store.empty()) {
    options.batch.resumes = false;
    return "";
  }
  if (options.output.folder.empty()) {
    return "--resume needs --output FOLDER, where finished light is kept, or a --store";
  }
  if (!options.vpl_file.empty()) return "--resume and --vpl exclude each other";
  options.store = (std::filesystem::path(options.output.folder) / kResumeFolder).string();
  const std::string problem = calc::problem_with_store(options.store);
  return problem.empty() ? "" : "--resume: " + problem;
}

// "" or which options want all of a project, not a part of it.
std::string selection_contradiction(const CheckOptions& options) {
  if (options.settings.selection.is_all()) return "";
  const auto together = [](const char* other) {
    return fmt::format("--space, --plane, --tag and --require choose a part; {} needs all", other);
  };
  if (!options.baseline.empty()) return together("--baseline");
  if (!options.against.empty()) return together("--against");
  if (!options.policy.empty()) return together("--policy");
  if (options.batch.share.count > 0) return together("--shard");
  return "";
}

// "" or what cannot be of a project from standard input: it is in no revision, and read once.
std::string input_contradiction(const CheckOptions& options) {
  if (!options.input.standard_input) return "";
  const auto refuse = [](const char* option) {
    return fmt::format("'-' (standard input) and {} exclude each other", option);
  };
  if (!options.against.empty()) return refuse("--against");
  return options.batch.share.count > 0 ? refuse("--shard") : "";
}

std::string complete(CheckOptions& options, const Environment& environment) {
  if (options.timestamp.empty()) {
    std::string problem = take_source_date(environment.source_date_epoch, options.timestamp);
    if (!problem.empty()) return problem;
  }
  options.settings.today = day_of_moment(options.timestamp);
  options.output.most_bytes = options.settings.budget[calc::BudgetOf::output];
  const bool is_compared = !options.baseline.empty() || !options.against.empty();
  if (std::string problem =
          gate_contradiction(options.gate, is_compared, "a --baseline or --against");
      !problem.empty()) {
    return problem;
  }
  if (!options.vpl_file.empty() && options.input.projects.size() > 1) {
    return fmt::format("--vpl is for one project; found {}", options.input.projects.size());
  }
  std::string problem = take_store(environment.store, options.store);
  if (problem.empty()) problem = take_resume_store(options);
  if (problem.empty()) problem = complete_work(options.settings.radiosity, options.backend);
  if (problem.empty()) problem = output_contradiction(options.output);
  if (problem.empty()) problem = selection_contradiction(options);
  if (problem.empty()) problem = input_contradiction(options);
  return problem.empty() ? batch_contradiction(options) : problem;
}

}  // namespace

Option shard_option(BatchShare& share, const std::string& help) {
  return {"--shard", "I/N", help, share_of_batch(share)};
}

Option stored_only_option(bool& is_stored_only) {
  return {"--stored-only", "",
          "Calculate nothing: take all light from --store. What is not there is named, and not\n"
          "judged",
          &is_stored_only};
}

Option store_option(std::string& store) {
  return {
      "--store", "DIR",
      "Keep looks of planes in this folder, and take from there what did not change; made if it\n"
      "is not there. Results are the same to the bit. 'off': none; default LUXGATE_STORE if "
      "set,\n"
      "else none. See 'luxgate store'",
      some_text(store)};
}

std::string take_store(const std::string& variable, std::string& store) {
  const bool is_given = !store.empty();
  if (!is_given) store = variable;
  if (store == "off") store.clear();
  if (store.empty()) return "";
  const std::string problem = calc::problem_with_store(store);
  return problem.empty() ? "" : (is_given ? "--store: " : "LUXGATE_STORE: ") + problem;
}

std::vector<Option> accuracy_options(check::Settings& settings) {
  return {
      {"--goal", "NAME",
       "What ends the calculation. verdict: a plane is done once each of its requirements passes "
       "or fails;\n"
       "accuracy: once every judged value is known to --tolerance; default verdict",
       choice<rules::Goal>(settings.goal, {{"verdict", rules::Goal::verdict},
                                           {"accuracy", rules::Goal::accuracy}})},
      {"--tolerance", "SHARE",
       "Relative half-width of the intervals to aim at, as 0.02 or 2%, with --goal accuracy\n"
       "and for planes without requirements; default 0.02",
       share_between(settings.tolerance, 0.0, 1.0)},
      {"--confidence", "SHARE",
       "Level of the intervals, as 0.95 or 95%, over all times that a plane is looked at;\n"
       "default 0.95",
       share_between(settings.confidence, 0.5, 1.0)},
      {"--by-luminaire", "",
       "Say in HTML and JSON what each luminaire gives to the average and at the minimum of a\n"
       "plane, reflections included: the ten largest and the rest. Takes more time and memory,\n"
       "and other random numbers are drawn",
       &settings.by_luminaire},
      limit_option(settings.budget),
      seed_option(settings.radiosity.seed),
      {"--time-limit", "SECONDS",
       "Stop refining a project after this time; results then depend on the machine's speed",
       seconds(settings.radiosity.time_limit_s)}};
}

Command check_syntax(CheckOptions& options) {
  Command command{"check", "Calculate projects and judge their requirements"};
  options.input.takes_standard_input = true;
  command.places = {projects_place(options.input)};
  command.options = project_options(options.input);
  add(command.options, {set_option(options.set)});
  add(command.options, selection_options(options.settings.selection));
  add(command.options, output_options(options.output));
  add(command.options, {baseline_option(options.baseline), against_option(options.against)});
  add(command.options, gate_options(options.gate));
  add(command.options, {policy_option(options.policy)});
  add(command.options, document_options(options));
  add(command.options, text_options(options.output));
  add(command.options, accuracy_options(options.settings));
  add(command.options, work_options(options.settings.radiosity));
  add(command.options, backend_options(options.backend));
  add(command.options,
      {{"--vpl",
        "FILE",
        "Take the light vertices of one space from a file of 'luxgate vpl' instead of tracing "
        "them;\n"
        "seed, replicates and the most paths are the file's. Results are the same to the bit",
        some_text(options.vpl_file),
        false,
        {"--seed", "--replicates", "--max-paths", "--by-luminaire", "--against", "--advice"}},
       store_option(options.store)});
  add(command.options, batch_options(options.batch));
  add(command.options, {strict_option(options.strict), sandbox_option(options.sandbox),
                        quiet_option_with_count(options.output.quiet)});
  command.config = &options.input.config;
  command.config_revision = &options.against;
  command.notes = "The worst exit code of all projects counts; worst first: 2, 1, 3, 0.";
  command.examples = {
      {"luxgate check office.xml --output out", "A report for people, tables and JSON into 'out'"},
      {"luxgate check designs/a.xml designs/b.xml --format junit=junit.xml",
       "For a CI system, and text on standard output"},
      {"luxgate check office.xml --against main... --gate regression",
       "Only what became worse since HEAD left the branch main ends with 1"}};
  command.exit_codes = check_exit_codes();
  command.most_used = {"--output",   "--format", "--json",   "--rules", "--goal",
                       "--baseline", "--jobs",   "--strict", "--color", "--quiet"};
  command.complete_projects = [&options] { return complete_projects(options.input); };
  command.complete = [&options](const Environment& environment) {
    return complete(options, environment);
  };
  return command;
}

std::string reproducible_command(const CheckOptions& options) {
  return "luxgate check" + reproducible_words(options);
}

std::string reproducible_words(const CheckOptions& options) {
  const check::Settings defaults;
  const check::Settings& used = options.settings;
  std::string command;
  for (const std::string& project : options.input.projects) {
    command += " " + report::shell_quoted(project);
  }
  for (const std::string& file : options.input.rule_files) {
    command += " --rules " + report::shell_quoted(file);
  }
  // All that it says stands here.
  if (!options.input.config.taken.empty() || options.input.config.is_off) command += " --no-config";
  if (!options.policy.empty()) command += " --policy " + report::shell_quoted(options.policy);
  for (const check::SetValue& value : options.set) {
    command += " --set " + report::shell_quoted(value.words());
  }
  const std::string selection = check::selection_words(used.selection);
  if (!selection.empty()) command += " " + selection;
  const auto add = [&command](const char* name, const auto& value, const auto& default_value) {
    if (value != default_value) command += fmt::format(" {} {}", name, value);
  };
  add("--seed", used.radiosity.seed, defaults.radiosity.seed);
  if (used.goal != defaults.goal) {
    command += fmt::format(" --goal {}", calc::name_of(used.goal));
  }
  add("--tolerance", used.tolerance, defaults.tolerance);
  add("--confidence", used.confidence, defaults.confidence);
  add("--replicates", used.radiosity.replicates, defaults.radiosity.replicates);
  add("--max-paths", used.radiosity.max_paths, defaults.radiosity.max_paths);
  add("--time-limit", used.radiosity.time_limit_s, defaults.radiosity.time_limit_s);
  for (const calc::EnumName<calc::BudgetOf>& limit : calc::EnumNames<calc::BudgetOf>::list) {
    const double most = used.budget[limit.value];
    if (most != defaults.budget[limit.value]) {
      command += fmt::format(" --limit {}={:.17g}", limit.name, most);
    }
  }
  return command + (used.by_luminaire ? " --by-luminaire" : "") +
         (options.advice ? " --advice" : "") + work_words(used.radiosity, options.backend);
}

}  // namespace cli
