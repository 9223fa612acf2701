#include "report/shell/command_line.h"

#include "calc/base/utf8.h"
#include "report/document/program_version.h"
#include "report/shell/config_file.h"
#include "report/shell/option_values.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>
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
  app.footer(command.footer);
  for (const Place& place : command.places) add_place(app, place);
  for (const Option& option : command.options) add_option(app, option);
  if (!command.actions.empty()) app.require_subcommand(1);
  for (const Command& action : command.actions) add_command(app, action, added);
  if (command.actions.empty()) added.push_back({&app, &command});
}

ParsedLine usage_error(const std::string& message, const std::string& help_command) {
  return {nullptr, kNotJudged, "",
          fmt::format("luxgate: error: {}\nSee '{} --help'.\n", calc::printable(message),
                      help_command)};
}

// CLI11 would only say that a subcommand is required. "" = `first` is a command or an option.
std::string problem_with_command(const std::vector<Command>& commands, std::string_view first) {
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.push_back(command.name);
  if (first.starts_with('-') || std::find(names.begin(), names.end(), first) != names.end()) {
    return "";
  }
  const std::string needed = one_of_message(first, names);
  return first.empty() ? "no command: " + needed : fmt::format("'{}': {}", first, needed);
}

std::string chosen_name(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? "luxgate" : "luxgate " + chosen.front()->get_name();
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
  if (path.empty()) return std::nullopt;
  command.config->taken = path;
  calc::Diagnostics diagnostics;
  const auto file = read_config(path, !choice.file.empty(), places, diagnostics);
  if (file) {
    apply_config(
        *file, command,
        [&](const Option& option) {
          return is_given(*chosen.app, option.names.substr(0, option.names.find(',')));
        },
        diagnostics);
  }
  if (!diagnostics.has_errors()) return std::nullopt;
  ParsedLine failed{nullptr, kNotJudged, "", ""};
  for (const calc::Diagnostic& one : diagnostics.all()) {
    failed.err += calc::format_diagnostic(one) + "\n";
  }
  return failed;
}

ParsedLine from_cli11(const CLI::App& app, const CLI::Error& error) {
  if (error.get_exit_code() == 0) {  // --help, --version
    std::ostringstream out, err;
    app.exit(error, out, err);
    return {nullptr, kAllMet, out.str(), ""};
  }
  return usage_error(error.what(), chosen_name(app));
}

}  // namespace

ParsedLine parse_command_line(const std::vector<Command>& commands, int argc,
                              const char* const* argv, const Environment& environment) {
  CLI::App app{"luxgate checks calculated illuminance against lighting requirements.", "luxgate"};
  app.set_version_flag("--version", "luxgate " + report::program_version());
  app.require_subcommand(1);
  app.footer("'luxgate COMMAND --help' explains a command.");
  std::vector<Added> added;
  for (const Command& command : commands) add_command(app, command, added);

  const std::string no_command = problem_with_command(commands, argc < 2 ? "" : argv[1]);
  if (!no_command.empty()) return usage_error(no_command, "luxgate");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Error& error) {
    return from_cli11(app, error);
  }
  const auto chosen = std::find_if(added.begin(), added.end(),
                                   [](const Added& candidate) { return candidate.app->parsed(); });
  if (chosen == added.end()) return usage_error("no action is given", chosen_name(app));
  if (const auto failed = take_config(*chosen, environment)) return *failed;
  const std::string problem =
      chosen->command->complete ? chosen->command->complete(environment) : "";
  if (!problem.empty()) return usage_error(problem, chosen_name(app));
  return {chosen->command, kAllMet, "", ""};
}

}  // namespace cli
