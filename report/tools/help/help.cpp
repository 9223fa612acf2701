#include "report/tools/help/help.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/utf8.h"
#include "report/formats/write.h"
#include "report/shell/command/help_text.h"
#include "report/shell/command/option_values.h"
#include "report/shell/output/output_options.h"
#include "report/shell/process/print.h"
#include "report/tools/help/completions.h"
#include "report/tools/help/man_page.h"
#include "report/tools/help/option_table.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <utility>

namespace cli {
namespace {

Place command_place(std::string& target, const std::vector<std::string>& names) {
  return {"command", "COMMAND", "One of the commands; none: the program", &target, false, names};
}

ExitCode cannot_write(const std::string& file, const std::string& problem) {
  print_error(calc::DiagnosticId::output_not_possible,
              fmt::format("cannot write '{}': {}", file, problem));
  return kNotJudged;
}

ExitCode write_man_pages(const std::vector<ManPage>& pages, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return cannot_write(folder, error.message());
  for (const ManPage& page : pages) {
    const std::string file = (std::filesystem::path(folder) / page.file).string();
    const std::string problem = report::write_file_atomically(file, page.text);
    if (!problem.empty()) return cannot_write(file, problem);
  }
  return kAllMet;
}

}  // namespace

Command help_command(const std::vector<std::string>& names) {
  struct Asked {
    std::string command, action;
    bool table = false;
  };
  const auto asked = std::make_shared<Asked>();
  Command command{"help", "Explain a command: its options, examples and exit codes"};
  command.places = {command_place(asked->command, names),
                    {"action", "ACTION", "An action of the command", &asked->action, false}};
  command.options = {
      {"--options", "", "Print a table of all options of all commands, as CSV", &asked->table}};
  command.examples = {{"luxgate help check", "All of 'check'"},
                      {"luxgate help rules import", "An action"}};
  command.exit_codes = {{kAllMet, "printed"}, {kNotJudged, "there is no such command"}};
  command.run = [asked](const RunContext& context) {
    if (asked->table) return print_outcome({kAllMet, option_table(*context.commands), {}});
    std::vector<std::string> words;
    for (const std::string& word : {asked->command, asked->action}) {
      if (!word.empty()) words.push_back(word);
    }
    std::string problem;
    const Topic topic = find_topic(*context.commands, words, problem);
    if (!problem.empty()) {
      tell("{}", usage_error_text(calc::printable(problem), "luxgate"));
      return kNotJudged;
    }
    return print_outcome({kAllMet, long_help(topic), {}});
  };
  return command;
}

Command completions_command() {
  const auto shell = std::make_shared<std::string>();
  Command command{"completions", "Print the script by which a shell completes commands"};
  command.places = {
      {"shell", "bash|zsh|fish", "The shell", shell.get(), true, {"bash", "zsh", "fish"}}};
  command.notes =
      "An installed luxgate has brought these scripts along. Else write them where the shell "
      "looks\n"
      "for them.";
  command.examples = {
      {"luxgate completions bash > ~/.local/share/bash-completion/completions/luxgate", ""},
      {"luxgate completions zsh > ~/.zfunc/_luxgate", "~/.zfunc must be in fpath"},
      {"luxgate completions fish > ~/.config/fish/completions/luxgate.fish", ""}};
  command.exit_codes = {{kAllMet, "printed"}, {kNotJudged, "an error"}};
  command.run = [shell](const RunContext& context) {
    const Shell which = *shell == "bash" ? Shell::bash : *shell == "zsh" ? Shell::zsh : Shell::fish;
    return print_outcome({kAllMet, completions(which, *context.commands), {}});
  };
  return command;
}

Command man_command(const std::vector<std::string>& names) {
  struct Asked {
    std::string command, folder;
  };
  const auto asked = std::make_shared<Asked>();
  Command command{"man", "Print a manual page, or write all of them"};
  command.places = {command_place(asked->command, names)};
  command.options = {
      {"-o,--output", "FOLDER",
       "Write the pages of the program and of all commands into this folder; made if needed",
       some_text(asked->folder)}};
  command.examples = {{"luxgate man check | man -l -", "Shows the page of 'check'"},
                      {"luxgate man -o man1", "All pages, to be installed"}};
  command.exit_codes = {{kAllMet, "printed or written"}, {kNotJudged, "an error"}};
  command.complete = [asked](const Environment&) -> std::string {
    return asked->command.empty() || asked->folder.empty()
               ? ""
               : "--output is for all pages: COMMAND and it exclude each other";
  };
  command.run = [asked](const RunContext& context) {
    const std::vector<Command>& commands = *context.commands;
    if (asked->folder.empty()) {
      return print_outcome({kAllMet, man_page(commands, asked->command).text, {}});
    }
    std::vector<ManPage> pages = {man_page(commands, "")};
    for (const Command& one : commands) pages.push_back(man_page(commands, one.name));
    return write_man_pages(pages, asked->folder);
  };
  return command;
}

}  // namespace cli
