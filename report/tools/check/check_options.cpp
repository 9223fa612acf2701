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
  return {{kAllMet, "every requirement is met or waived, or nothing is required (with a warning)"},
          {kNotMet, "at least one requirement is not met"},
          {kNotJudged,
           "not judged: usage, input or file error, a plane or project that could not be judged, "
           "or a warning that --strict makes count"},
          {kUndecided, "nothing failed, but a result's interval holds its limit: undecided"},
          {kInterrupted, "interrupted; no report was written"}};
}

std::vector<Option> document_options(CheckOptions& options) {
  return {{"--pictures", "WHEN",
           "Draw rooms in false colours, in HTML and with --images: auto or off; default auto. "
           "auto draws where OpenGL can. The bytes of pictures depend on the machine's OpenGL",
           choice<bool>(options.pictures, {{"auto", true}, {"off", false}})},
          {"--timestamp", "WHEN",
           "Print a date in reports: 'now' or seconds since 1970; default SOURCE_DATE_EPOCH. "
           "Without either there is no date, and equal inputs give equal files",
           moment(options.timestamp)},
          {"--timing", "", "Print times and numbers of rays to standard error, and in reports",
           &options.settings.has_times},
          {"--explain-cost", "",
           "Print predicted and actual work to standard error. See 'luxgate plan'",
           &options.explain_cost},
          {"--advice", "",
           "Find dimming levels that meet what is not met, with the least power. If there are "
           "none, the report says why. It is in HTML, PDF, text, Markdown and JSON. This takes a "
           "calculation to --tolerance and at least one more check. See 'luxgate advise' for more",
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
  return {"--against",
          "REV",
          "Compare with the projects of a git revision: branch, tag, commit, HEAD~1 or 'main...'. "
          "'main...' is the commit at which HEAD left main. Those projects are checked with the "
          "same options. They are read from the repository's objects: the work tree is not "
          "touched, and nothing is fetched. Rule packs of --rules in the repository are read from "
          "the revision, others as they are now",
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
          "'{}' is not a share of a batch; give I/N with whole numbers, I from 1 to N and N up "
          "to {}",
          text, kMostShards);
    }
    target = {*number, *count};
    return "";
  };
}

std::vector<Option> batch_options(BatchOptions& batch) {
  return {shard_option(
              batch.share,
              "Calculate only share I of N into --store, for N machines; I from 1 to N. Nothing "
              "is judged. Shares have about the same predicted work. Afterwards one run with "
              "--stored-only writes the reports. Exit code 0: all of the share is in the "
              "store"),
          {"--units", "FILE",
           "Read the list that 'luxgate plan --units --format json' wrote, with --shard. Each "
           "share then reads only its own projects",
           some_text(batch.units_file)},
          stored_only_option(batch.is_stored_only),
          {"--resume", "",
           "Continue an interrupted run of the same command. Finished light is kept in a folder of "
           "--output until the reports are written. A --store does that, too",
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
          "Take all light from --store and calculate nothing. What is not in the cache is named, "
          "and not judged",
          &is_stored_only};
}

Option store_option(std::string& store) {
  return {"--store", "DIR",
          "Keep a result cache in this folder; 'off' for none; default LUXGATE_STORE if set, else "
          "none. Only what changed is calculated. The folder is made if needed. Results are the "
          "same to the bit. See 'luxgate store'",
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
  return {{"--goal", "NAME",
           "Choose when a calculation ends: verdict or accuracy; default verdict. verdict: each "
           "requirement of the plane passes or fails. accuracy: every judged value is known to "
           "--tolerance",
           choice<rules::Goal>(settings.goal, {{"verdict", rules::Goal::verdict},
                                               {"accuracy", rules::Goal::accuracy}})},
          {"--tolerance", "SHARE",
           "Set the relative half-width of intervals to reach, as 0.02 or 2%; default 0.02. It "
           "holds with --goal accuracy and for planes without requirements",
           share_between(settings.tolerance, 0.0, 1.0)},
          {"--confidence", "SHARE",
           "Set the confidence level of intervals, as 0.95 or 95%, above 50%; default 0.95. It "
           "holds for all sampling rounds of a plane together",
           share_between(settings.confidence, 0.5, 1.0)},
          {"--by-luminaire", "",
           "Print each luminaire's share of the average and of the minimum in HTML and JSON. "
           "Reflections are included. The ten largest are listed, and the rest as a sum. This "
           "takes more time and memory, and other random numbers are drawn",
           &settings.by_luminaire},
          limit_option(settings.budget),
          seed_option(settings.radiosity.seed),
          {"--time-limit", "SECONDS",
           "Stop the calculation of a project after this time in seconds; default none. Results "
           "then depend on the speed of the machine",
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
        "Read the light vertices of one space from a file of 'luxgate vpl'. Seed, replicates and "
        "the number of paths are those of the file. Results are the same to the bit",
        some_text(options.vpl_file),
        false,
        {"--seed", "--replicates", "--max-paths", "--by-luminaire", "--against", "--advice"}},
       store_option(options.store)});
  add(command.options, batch_options(options.batch));
  add(command.options, {strict_option(options.strict), sandbox_option(options.sandbox),
                        quiet_option_with_count(options.output.quiet)});
  command.config = &options.input.config;
  command.config_revision = &options.against;
  command.notes = "The worst exit code of all projects counts. From worst to best: 2, 1, 3, 0.";
  command.examples = {{"luxgate check office.xml --output out",
                       "Write a report for people, tables and JSON into 'out'"},
                      {"luxgate check designs/a.xml designs/b.xml --format junit=junit.xml",
                       "Write JUnit for a CI system, and text to standard output"},
                      {"luxgate check office.xml --against main... --gate regression",
                       "End with 1 only for what became worse since HEAD left the branch main"}};
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
