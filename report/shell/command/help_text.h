#pragma once
// What help, manual pages and completions say of a command: all of it from its description in
// command.h.

#include "report/shell/command/command.h"
#include "report/shell/process/environment_variables.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

inline constexpr std::size_t kHelpColumns = 80;

// Something that help can be about: the program, a command or an action.
struct Topic {
  std::string line;                     // "luxgate rules show"
  const Command* about = nullptr;       // of the program: a description without options
  std::span<const Command> parts = {};  // commands of the program, actions of a command
  std::string part_name;                // "COMMAND", "ACTION"; "" = there are none
};

// words: "rules", "show"; none: the program. `problem`: "unknown command 'chek'; did you mean
// 'check'?"; "" = the topic is there.
Topic find_topic(const std::vector<Command>& commands, const std::vector<std::string>& words,
                 std::string& problem);
// The problem of a line that ends where a command or an action is needed.
std::string problem_with_no_part(const Topic& topic);
// The two lines of a wrong command line: what is wrong, and where help is.
std::string usage_error_text(const std::string& problem, const std::string& help_command);
// The topics of all commands and actions, the program's first.
std::vector<Topic> all_topics(const std::vector<Command>& commands);

// -h: one screen: usage, what is most used, a line each, and where there is more.
std::string short_help(const Topic& topic);
// --help: all of it.
std::string long_help(const Topic& topic);

// The line behind "Usage:".
std::string usage_line(const Topic& topic);
// "-o, --output FOLDER"
std::string option_words(const Option& option);
// The first clause of a text, as a line of at most `width` columns: up to ';' or '.', or to ':' if
// that is too long.
std::string first_clause(std::string_view text, std::size_t width);
// The variables that a command or its actions read, in the table's order.
std::vector<const EnvironmentVariable*> variables_of(const Topic& topic);
// Lines that belong together as one; those that begin with a blank are kept as they are.
struct Paragraph {
  bool is_verbatim = false;
  std::string text;  // verbatim: lines
};
std::vector<Paragraph> paragraphs_of(std::string_view notes);

// The options that every command has besides its own.
std::vector<Option> help_options();

// What follows an option or stands at a place, for those who complete it.
enum class ValueKind { none, words, file, folder, other };
ValueKind value_kind(const std::string& value_name, bool has_words);
// "KIND[=FILE]": a file may stand behind the word and '='.
bool has_file_behind_word(const std::string& value_name);

}  // namespace cli
