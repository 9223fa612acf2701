#include "report/tools/config/config.h"

#include "calc/base/utf8.h"
#include "report/shell/command/config_file.h"
#include "report/shell/command/option_values.h"
#include "report/shell/options/project_folders.h"
#include "report/shell/process/print.h"
#include "report/tools/check/check_options.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cli {
namespace {

constexpr std::string_view kDashes = "--", kDefault = "default ";

struct ShowOptions {
  std::vector<std::string> projects;
  ConfigChoice config;
  bool as_json = false;
};

const ConfigSetting* find_setting(const ConfigFile& file, std::string_view name) {
  const auto found = std::find_if(file.settings.begin(), file.settings.end(),
                                  [&](const ConfigSetting& one) { return one.name == name; });
  return found == file.settings.end() ? nullptr : &*found;
}

// What holds without the setting, in the words of its option's help: "0.02", "as in the language".
// A flag is off then, and a list that has no such words is empty.
std::string default_words(const Command& command, std::string_view setting) {
  const auto option = std::find_if(
      command.options.begin(), command.options.end(),
      [&](const Option& one) { return one.long_name().substr(kDashes.size()) == setting; });
  std::string words = option->help;
  std::replace(words.begin(), words.end(), '\n', ' ');
  const std::size_t at = words.find(kDefault);
  if (at == std::string::npos)
    return std::holds_alternative<bool*>(option->target) ? "off" : "none";
  words.erase(0, at + kDefault.size());
  return words.substr(0, std::min({words.size(), words.find(';'), words.find(". ")}));
}

std::string as_text(const Command& command, const ConfigFile& file) {
  std::string text = file.path.empty()
                         ? fmt::format("No {} here: everything is as by default.\n", kConfigName)
                         : fmt::format("Settings of {}:\n", calc::printable_path(file.path));
  std::size_t width = 0;
  for (const std::string_view name : setting_names()) width = std::max(width, name.size());
  for (const std::string_view name : setting_names()) {
    const ConfigSetting* setting = find_setting(file, name);
    text +=
        setting == nullptr
            ? fmt::format("  {:<{}}  {}  (by default)\n", name, width, default_words(command, name))
            : fmt::format("  {:<{}}  {}  ({}:{})\n", name, width, calc::printable(setting->words()),
                          calc::printable_path(file.path), setting->where.line);
  }
  return text;
}

std::string as_json(const Command& command, const ConfigFile& file) {
  nlohmann::ordered_json settings = nlohmann::ordered_json::object();
  for (const std::string_view name : setting_names()) {
    nlohmann::ordered_json& row = settings[std::string(name)];
    const ConfigSetting* setting = find_setting(file, name);
    if (setting == nullptr) {
      row["from"] = "default";
      row["words"] = default_words(command, name);
      continue;
    }
    if (setting->flag) {
      row["value"] = *setting->flag;
    } else if (setting->is_list) {
      row["value"] = setting->values;
    } else {
      row["value"] = setting->values.front();
    }
    row["from"] = file.path;
    row["line"] = setting->where.line;
  }
  nlohmann::ordered_json all;
  if (file.path.empty()) {
    all["file"] = nullptr;
  } else {
    all["file"] = file.path;
  }
  all["settings"] = std::move(settings);
  return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

ExitCode run_show(const ShowOptions& options) {
  std::string problem;
  const ConfigPlaces places = config_on_disk();
  std::vector<std::string> projects = options.projects;
  problem = expand_folders(projects);
  const std::string path =
      problem.empty() ? find_config(options.config, places, projects, problem) : "";
  if (!problem.empty()) {
    tell("luxgate: error: {}\n", calc::printable(problem));
    return kNotJudged;
  }
  CheckOptions check;
  const Command command = check_syntax(check);
  CommandOutcome outcome;
  ConfigFile file;
  if (!path.empty()) {
    calc::Diagnostics diagnostics;
    auto read = read_config(path, !options.config.file.empty(), places, diagnostics);
    if (read) {  // what `check` refuses is wrong here, too
      apply_config(
          *read, command, [](const Option&) { return false; }, diagnostics);
      file = std::move(*read);
    }
    if (diagnostics.has_errors()) return print_outcome({kNotJudged, "", diagnostics.all()});
  }
  outcome.text = options.as_json ? as_json(command, file) : as_text(command, file);
  return print_outcome(outcome);
}

}  // namespace

Command config_command() {
  const auto options = std::make_shared<ShowOptions>();
  Command show{"show", "Print the settings in force for projects, with the file and line of each"};
  show.places = {{"projects", "PROJECT.xml",
                  "Projects whose settings are printed; default those of the current folder",
                  &options->projects, false}};
  show.options = config_options(options->config);
  add(show.options, text_or_json_options(options->as_json));
  show.notes = "Options of the command line override settings of the file.";
  show.examples = {{"luxgate config show office.xml", "Those that hold for a project"}};
  show.exit_codes = {{0, "shown"}, {2, "an error"}};
  show.run = [options](const RunContext&) { return run_show(*options); };
  Command command{"config", "Show the settings of luxgate.toml"};
  command.actions = {std::move(show)};
  return command;
}

}  // namespace cli
