#pragma once
// Help, manual pages and completions of a command, all from its description in command.h.

#include "report/shell/command/command.h"
#include "report/shell/process/environment_variables.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

inline constexpr std::size_t kHelpColumns = 80;

// A topic of help: the program, a command or an action.
struct Topic {
  std::string line;                     // "luxgate rules show"
  const Command* about = nullptr;       // of the program: a description without options
  std::span<const Command> parts = {};  // commands of the program, actions of a command
  std::string part_name;                // "COMMAND", "ACTION"; "" = there are none
};

// Returns the topic. words: "rules", "show"; none: the program. `problem`: "unknown command 'chek';
// did you mean 'check'?"; "" = the topic exists.
Topic find_topic(const std::vector<Command>& commands, const std::vector<std::string>& words,
                 std::string& problem);
// Returns the problem of a line that ends where a command or an action is needed.
std::string problem_with_no_part(const Topic& topic);
// Returns the two lines for a wrong command line: the mistake, and how to get help.
std::string usage_error_text(const std::string& problem, const std::string& help_command);
// Returns the topics of all commands and actions, the program's first.
std::vector<Topic> all_topics(const std::vector<Command>& commands);

// Returns the text of -h, one screen: usage, the most used options, a line each, and where to find
// more.
std::string short_help(const Topic& topic);
// Returns the text of --help: everything.
std::string long_help(const Topic& topic);

// Returns the line behind "Usage:".
std::string usage_line(const Topic& topic);
// Returns "-o, --output FOLDER".
std::string option_words(const Option& option);
// Returns the first clause of a text, as a line of at most `width` columns: up to ';' or '.', or to
// ':' if that is too long.
std::string first_clause(std::string_view text, std::size_t width);
// Returns the variables that a command or its actions read, in the table's order.
std::vector<const EnvironmentVariable*> variables_of(const Topic& topic);
// Lines that are joined into one; lines that begin with a blank stay as they are.
struct Paragraph {
  bool is_verbatim = false;
  std::string text;  // verbatim: lines
};
std::vector<Paragraph> paragraphs_of(std::string_view notes);

// Returns the options that every command has besides its own.
std::vector<Option> help_options();

// The kind of value of an option or argument, for completion.
enum class ValueKind { none, words, file, folder, other };
ValueKind value_kind(const std::string& value_name, bool has_words);
// Returns whether a file may follow the word and '=': "KIND[=FILE]".
bool has_file_behind_word(const std::string& value_name);

}  // namespace cli
