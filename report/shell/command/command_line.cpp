#include "report/shell/command/command_line.h"

#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "report/document/program_version.h"
#include "report/shell/command/config_file.h"
#include "report/shell/command/help_text.h"
#include "report/shell/command/option_values.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace cli {
namespace {

void add_option(CLI::App& app, const Option& option) {
  if (bool* const* flag = std::get_if<bool*>(&option.target)) {
    CLI::Option* added = app.add_flag(option.names, **flag, option.help);
    for (const std::string& other : option.excludes) added->excludes(app.get_option(other));
    return;
  }
  const auto& parser = std::get<ValueParser>(option.target);
  CLI::Option* added = nullptr;
  if (option.may_have_value) {
    const auto texts = std::make_shared<std::vector<std::string>>();  // lives as long as the check
    added = app.add_flag(option.names, *texts, option.help);
    added->check(CLI::Validator(
        [&parser, texts](std::string& text) { return parser(text == "true" ? "" : text); }, ""));
  } else if (option.value_name.empty()) {
    added = app.add_flag_callback(
        option.names, [&parser] { parser(""); }, option.help);
  } else {
    const auto apply = [&option, &parser](const std::vector<std::string>& texts) {
      for (const std::string& text : texts) {
        const std::string problem = parser(text);
        if (problem.empty()) continue;
        throw CLI::ValidationError(option.names, fmt::format("'{}': {}", text, problem));
      }
    };
    added = app.add_option_function<std::vector<std::string>>(option.names, apply, option.help)
                ->type_name(option.value_name)
                ->expected(1, option.repeats ? CLI::detail::expected_max_vector_size : 1)
                ->allow_extra_args(false);  // a project may follow
  }
  for (const std::string& other : option.excludes) added->excludes(app.get_option(other));
}

void add_place(CLI::App& app, const Place& place) {
  std::visit(
      [&](auto* target) {
        app.add_option(place.name, *target, place.help)
            ->required(place.is_required)
            ->type_name(place.value_name);
      },
      place.target);
}

struct Added {
  CLI::App* app;
  const Command* command;
};

void add_command(CLI::App& parent, const Command& command, std::vector<Added>& added) {
  CLI::App& app = *parent.add_subcommand(command.name, command.summary);
  for (const Place& place : command.places) add_place(app, place);
  for (const Option& option : command.options) add_option(app, option);
  if (!command.actions.empty()) app.require_subcommand(0, 1);
  for (const Command& action : command.actions) add_command(app, action, added);
  if (command.actions.empty()) added.push_back({&app, &command});
}

ParsedLine usage_error(const std::string& message, const std::string& help_command) {
  return {nullptr, kNotJudged, "", usage_error_text(calc::printable(message), help_command)};
}

// The commands and actions at the front of a line.
std::vector<std::string> topic_words(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
    at = at->get_subcommands().front();
    words.push_back(at->get_name());
  }
  return words;
}

std::string line_of(const std::vector<std::string>& words) {
  std::string line = "luxgate";
  for (const std::string& word : words) line += " " + word;
  return line;
}

bool is_given(const CLI::App& app, const std::string& option) {
  const CLI::Option* known = app.get_option_no_throw(option);
  return known != nullptr && known->count() > 0;
}

std::vector<std::string> projects_of(const Command& command) {
  std::vector<std::string> projects;
  for (const Place& place : command.places) {
    if (const auto* many = std::get_if<std::vector<std::string>*>(&place.target)) {
      projects.insert(projects.end(), (*many)->begin(), (*many)->end());
    } else if (const auto* one = std::get_if<std::string*>(&place.target)) {
      projects.push_back(**one);
    }
  }
  return projects;
}

// What the work tree's settings say otherwise than those of the revision, but for what the command
// line says, and what the command does not know.
std::vector<SettingChange> changed_in_tree(const Added& chosen,
                                           const std::vector<std::string>& projects,
                                           const std::optional<ConfigFile>& of_revision) {
  std::string problem;
  const ConfigPlaces disk = config_on_disk();
  const std::string path = find_config(disk, projects, problem);
  calc::Diagnostics unread;
  std::optional<ConfigFile> of_tree;
  if (!path.empty()) of_tree = read_config(path, false, disk, unread);
  std::vector<SettingChange> changes;
  if (problem.empty() && unread.has_errors()) problem = "it cannot be read";
  if (!problem.empty()) {
    const std::string was = of_revision ? of_revision->path : "";
    changes.push_back({kConfigName, was, problem});
    return changes;
  }
  changes = changed_settings(of_revision, of_tree);
  std::erase_if(changes, [&](const SettingChange& change) {
    const std::string option = "--" + change.name;
    const auto& options = chosen.command->options;
    const bool is_known = std::any_of(options.begin(), options.end(),
                                      [&](const Option& one) { return one.long_name() == option; });
    return !is_known || is_given(*chosen.app, option);
  });
  return changes;
}

// Settings of a file for options that are not given. Not beside a policy: its owner's word stands
// above the project's, whose folder the file lies in. Empty: all is well.
std::optional<ParsedLine> take_config(const Added& chosen, const Environment& environment) {
  const Command& command = *chosen.command;
  if (command.config == nullptr || is_given(*chosen.app, "--policy")) return std::nullopt;
  std::string problem;
  const std::vector<std::string> projects = projects_of(command);
  const ConfigChoice& choice = *command.config;
  const bool is_of_revision = command.config_revision != nullptr &&
                              !command.config_revision->empty() && choice.file.empty() &&
                              !choice.is_off;
  const ConfigPlaces places =
      is_of_revision ? config_in_revision(*command.config_revision, environment, projects, problem)
                     : config_on_disk();
  // What is wrong with the revision is said where it is read for more than this.
  if (!problem.empty()) return std::nullopt;
  const std::string path = find_config(choice, places, projects, problem);
  if (!problem.empty()) return usage_error(problem, "luxgate " + command.name);
  command.config->taken = path;
  calc::Diagnostics diagnostics;
  std::optional<ConfigFile> file;
  if (!path.empty()) file = read_config(path, !choice.file.empty(), places, diagnostics);
  if (file) {
    apply_config(
        *file, command,
        [&](const Option& option) { return is_given(*chosen.app, option.long_name()); },
        diagnostics);
  }
  if (is_of_revision && !diagnostics.has_errors()) {
    command.config->changed = changed_in_tree(chosen, projects, file);
  }
  if (!diagnostics.has_errors()) return std::nullopt;
  ParsedLine failed{nullptr, kNotJudged, "", ""};
  for (const calc::Diagnostic& one : diagnostics.all()) {
    failed.err += calc::format_diagnostic(one) + "\n";
  }
  return failed;
}

// "; did you mean '--output'?": what begins with it, at most two, else the nearest name.
std::string near_options(std::string_view found, const Command& command) {
  std::vector<std::string> known;
  for (const Option& option : command.options) known.push_back(option.long_name());
  for (const Option& option : help_options()) known.push_back(option.long_name());
  std::vector<std::string_view> names, begun;
  for (const std::string& name : known) {
    if (name.starts_with("--")) names.push_back(name);
    if (name.starts_with(found) && found.size() > 3) begun.push_back(name);
  }
  constexpr std::size_t kMost = 2;
  if (begun.empty() || begun.size() > kMost) return calc::suggestion(found, names);
  return fmt::format("; did you mean '{}'{}?", begun.front(),
                     begun.size() == kMost ? fmt::format(" or '{}'", begun.back()) : "");
}

// Replaces CLI11's "the following arguments were not expected". extra: the first of them.
std::string problem_with_extra(const std::string& extra, const Topic& topic) {
  if (!extra.starts_with('-')) return fmt::format("unexpected argument '{}'", extra);
  const std::string name = extra.substr(0, extra.find('='));
  const bool is_long = name.starts_with("--");
  return fmt::format("unknown option '{}'{}", name,
                     is_long ? near_options(name, *topic.about) : "");
}

// Replaces CLI11's "files is required" by the name that the help shows.
std::string problem_with_missing(const std::string& said, const Command& command) {
  const std::string name = said.substr(0, said.find(' '));
  for (const Place& place : command.places) {
    if (place.name == name) return fmt::format("missing argument {}", place.value_name);
  }
  return said;
}

// Replaces CLI11's "--seed: 1 required N missing" and "--csv excludes --json".
std::string problem_with_option(const std::string& said) {
  constexpr std::string_view kExcludes = " excludes ";
  if (const std::size_t at = said.find(kExcludes); at != std::string::npos) {
    return fmt::format("option '{}' cannot be used with '{}'", said.substr(0, at),
                       said.substr(at + kExcludes.size()));
  }
  constexpr std::string_view kRequired = ": 1 required ";
  constexpr std::string_view kMissing = " missing";
  const std::size_t at = said.find(kRequired);
  if (at == std::string::npos || !said.ends_with(kMissing)) return said;
  const std::size_t begin = at + kRequired.size();
  return fmt::format("option '{}' needs a value {}", said.substr(0, at),
                     said.substr(begin, said.size() - kMissing.size() - begin));
}

// "" or what stands where one of a few words is needed.
std::string problem_with_places(const Command& command) {
  for (const Place& place : command.places) {
    std::string* const* word = std::get_if<std::string*>(&place.target);
    if (word == nullptr || (*word)->empty() || place.words.empty()) continue;
    const std::vector<std::string>& words = place.words;
    if (std::find(words.begin(), words.end(), **word) != words.end()) continue;
    return fmt::format("'{}': {}", **word, one_of_message(**word, {words.begin(), words.end()}));
  }
  return "";
}

// Checks that the first words of a line are a command and its action: CLI11 would only say that a
// subcommand is required. "" = they are.
std::string problem_with_command(const std::vector<Command>& commands, int argc,
                                 const char* const* argv, std::vector<std::string>& words) {
  std::string problem;
  Topic topic = find_topic(commands, words, problem);
  for (int at = 1; !topic.parts.empty(); ++at) {
    const std::string word = at < argc ? argv[at] : "";
    if (word.empty()) return problem_with_no_part(topic);
    if (word.starts_with('-')) return "";
    words.push_back(word);
    topic = find_topic(commands, words, problem);
    if (problem.empty()) continue;
    words.pop_back();
    return problem;
  }
  return "";
}

}  // namespace

ParsedLine parse_command_line(const std::vector<Command>& commands, int argc,
                              const char* const* argv, const Environment& environment) {
  CLI::App app{"", "luxgate"};
  app.set_help_flag("-h");
  app.set_help_all_flag("--help");
  app.set_version_flag("-V,--version", "luxgate " + report::program_version());
  app.require_subcommand(0, 1);  // what follows a command is none, whatever it is called
  std::vector<Added> added;
  for (const Command& command : commands) add_command(app, command, added);

  std::vector<std::string> words;
  const std::string no_command = problem_with_command(commands, argc, argv, words);
  if (!no_command.empty()) return usage_error(no_command, line_of(words));
  std::string problem;
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {nullptr, kAllMet, short_help(find_topic(commands, topic_words(app), problem)), ""};
  } catch (const CLI::CallForAllHelp&) {
    return {nullptr, kAllMet, long_help(find_topic(commands, topic_words(app), problem)), ""};
  } catch (const CLI::CallForVersion& version) {
    return {nullptr, kAllMet, fmt::format("{}\n", version.what()), ""};
  } catch (const CLI::ExtrasError& error) {
    words = topic_words(app);
    const std::vector<std::string> extras = app.remaining(true);
    const auto option = std::find_if(extras.begin(), extras.end(), [](const std::string& extra) {
      return extra.starts_with('-');
    });
    if (extras.empty()) return usage_error(error.what(), line_of(words));
    return usage_error(problem_with_extra(option == extras.end() ? extras.front() : *option,
                                          find_topic(commands, words, problem)),
                       line_of(words));
  } catch (const CLI::RequiredError& error) {
    words = topic_words(app);
    return usage_error(
        problem_with_missing(error.what(), *find_topic(commands, words, problem).about),
        line_of(words));
  } catch (const CLI::ValidationError& error) {
    return usage_error(error.what(), line_of(topic_words(app)));
  } catch (const CLI::Error& error) {
    return usage_error(problem_with_option(error.what()), line_of(topic_words(app)));
  }
  words = topic_words(app);
  const auto chosen = std::find_if(added.begin(), added.end(),
                                   [](const Added& candidate) { return candidate.app->parsed(); });
  if (chosen == added.end()) {
    const Topic topic = find_topic(commands, words, problem);
    return usage_error(problem_with_no_part(topic), line_of(words));
  }
  const Command& command = *chosen->command;
  problem = command.complete_projects ? command.complete_projects() : "";
  if (!problem.empty()) return usage_error(problem, line_of(words));
  if (const auto failed = take_config(*chosen, environment)) return *failed;
  problem = problem_with_places(*chosen->command);
  if (!problem.empty()) return usage_error(problem, line_of(words));
  problem = chosen->command->complete ? chosen->command->complete(environment) : "";
  if (!problem.empty()) return usage_error(problem, line_of(words));
  return {chosen->command, kAllMet, "", ""};
}

}  // namespace cli
