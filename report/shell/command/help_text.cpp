#include "report/shell/command/help_text.h"

#include "calc/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cli {
namespace {

// Of the program itself: what no command says.
const Command& program() {
  static const Command about = [] {
    Command command{"luxgate", "Check calculated illuminance against lighting requirements"};
    command.notes =
        "Results go to standard output, everything else to standard error. Messages have ids:\n"
        "'luxgate explain ID' says what an id means.";
    command.examples = {
        {"luxgate init", "Write a small project to start from"},
        {"luxgate check project.xml --output out", "Print the verdicts, and write a report"},
        {"luxgate help check", "Print all options of a command"}};
    command.exit_codes = {
        {kAllMet, "no error; of 'check': every requirement is met or waived"},
        {kNotMet, "of 'check': at least one requirement is not met"},
        {kNotJudged, "not judged: usage, input or file error, or what could not be judged"},
        {kUndecided, "of 'check': nothing failed, but a result is undecided"},
        {kInterrupted, "interrupted"}};
    command.most_used = {"check", "watch",   "report", "validate",
                         "rules", "explain", "init",   "help"};
    return command;
  }();
  return about;
}

Topic topic_of(const Command& command, const std::string& before) {
  return {before + " " + command.name, &command, command.actions,
          command.actions.empty() ? "" : "ACTION"};
}

Topic program_topic(const std::vector<Command>& commands) {
  return {program().name, &program(), commands, "COMMAND"};
}

void wrap_into(std::string& out, std::string_view text, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::string line;
  for (const std::string_view word : calc::split_words(text)) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > kHelpColumns) {
      out += margin + std::exchange(line, "") + "\n";
    }
    line += (line.empty() ? "" : " ") + std::string(word);
  }
  if (!line.empty()) out += margin + line + "\n";
}

// "  name  what it is", the latter in lines of its own behind a column.
void add_row(std::string& out, const std::string& name, std::string_view text, std::size_t column) {
  std::string wrapped;
  wrap_into(wrapped, text, column);
  std::string head = "  " + name;
  if (head.size() + 2 > column || wrapped.empty()) {
    out += head + "\n" + wrapped;
    return;
  }
  head.resize(column, ' ');
  out += head + wrapped.substr(column);
}

// The same in one line.
void add_line(std::string& out, const std::string& name, std::string_view text,
              std::size_t column) {
  std::string head = "  " + name;
  head.resize(std::max(column, head.size() + 2), ' ');
  out += head + first_clause(text, kHelpColumns - head.size()) + "\n";
}

std::string place_words(const Place& place) {
  std::string words = place.value_name + (place.takes_several() ? "..." : "");
  return place.is_required ? words : "[" + words + "]";
}

bool is_most_used(const Command& command, std::string_view name) {
  const std::vector<std::string>& names = command.most_used;
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<Option> with_help(const Command& command) {
  std::vector<Option> options = command.options;
  add(options, help_options());
  return options;
}

std::size_t column_of(const std::vector<std::pair<std::string, std::string>>& rows) {
  constexpr std::size_t kWidest = 30;
  std::size_t column = 0;
  for (const auto& [name, text] : rows) column = std::max(column, name.size() + 4);
  return std::min(column, kWidest);
}

std::string more_line(const Topic& topic) {
  return topic.about == &program()
             ? "'luxgate help COMMAND' explains a command, 'luxgate --help' lists all of them.\n"
             : fmt::format("All of it: {} --help\n", topic.line);
}

// Names in lists with commas.
bool is_in_list(std::string_view list, std::string_view name) {
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    if (list.substr(begin, end - begin) == name) return true;
    begin = end + 1;
  }
  return false;
}

bool reads(const Command& command, std::string_view words, const EnvironmentVariable& variable) {
  if (is_in_list(variable.commands, words)) return true;
  if (std::any_of(command.options.begin(), command.options.end(), [&](const Option& option) {
        return is_in_list(variable.options, option.long_name());
      })) {
    return true;
  }
  return std::any_of(command.actions.begin(), command.actions.end(), [&](const Command& action) {
    return reads(action, fmt::format("{} {}", words, action.name), variable);
  });
}

// "'luxgate rules' knows list, show or diff"
std::string choices_of(const Topic& topic) {
  std::vector<std::string_view> names;
  for (const Command& part : topic.parts) names.push_back(part.name);
  return fmt::format("'{}' knows {}", topic.line, calc::join_choices(names));
}

// What is wrong with a word where one of `names`, the parts of a topic, is needed.
std::string problem_with_part(const Topic& topic, const std::string& word,
                              const std::vector<std::string_view>& names) {
  if (names.empty()) return fmt::format("unexpected argument '{}'", word);
  const std::string problem =
      fmt::format("unknown {} '{}'", calc::ascii_lowered(topic.part_name), word);
  const std::string near = calc::suggestion(word, names);
  if (!near.empty()) return problem + near;
  if (topic.about != &program()) return problem + "; " + choices_of(topic);
  return word.ends_with(".xml") ? fmt::format("{}; did you mean 'luxgate check {}'?", problem, word)
                                : problem;
}

}  // namespace

Topic find_topic(const std::vector<Command>& commands, const std::vector<std::string>& words,
                 std::string& problem) {
  Topic topic = program_topic(commands);
  for (const std::string& word : words) {
    std::vector<std::string_view> names;
    const Command* found = nullptr;
    for (const Command& part : topic.parts) {
      names.push_back(part.name);
      if (part.name == word) found = &part;
    }
    if (found == nullptr) {
      problem = problem_with_part(topic, word, names);
      return topic;
    }
    topic = topic_of(*found, topic.line);
  }
  return topic;
}

std::string problem_with_no_part(const Topic& topic) {
  const std::string problem = fmt::format("no {} given", calc::ascii_lowered(topic.part_name));
  // A command has few actions, and the program has many commands.
  return topic.about == &program() ? problem : problem + "; " + choices_of(topic);
}

std::string usage_error_text(const std::string& problem, const std::string& help_command) {
  return fmt::format("luxgate: error: {}\ntry '{} --help'\n", problem, help_command);
}

std::vector<Topic> all_topics(const std::vector<Command>& commands) {
  std::vector<Topic> topics = {program_topic(commands)};
  for (const Command& command : commands) {
    topics.push_back(topic_of(command, program().name));
    for (const Command& action : command.actions) {
      topics.push_back(topic_of(action, topics.front().line + " " + command.name));
    }
  }
  return topics;
}

std::string usage_line(const Topic& topic) {
  std::string line = topic.line;
  if (!topic.part_name.empty()) return line + " " + topic.part_name + " ...";
  if (!topic.about->options.empty()) line += " [OPTIONS]";
  for (const Place& place : topic.about->places) line += " " + place_words(place);
  return line;
}

std::string option_words(const Option& option) {
  std::string words = option.long_name();
  if (const std::string one_letter = option.short_name(); !one_letter.empty()) {
    words = one_letter + ", " + words;
  }
  if (option.may_have_value) return words + "[=ID,...]";
  return option.value_name.empty() ? words : words + " " + option.value_name;
}

std::string first_clause(std::string_view text, std::size_t width) {
  std::string line;
  for (const std::string_view word : calc::split_words(text)) {
    line += (line.empty() ? "" : " ") + std::string(word);
    if (line.ends_with(';') || line.ends_with('.')) {
      line.pop_back();
      break;
    }
  }
  // What stands before a colon says what the list behind it is of.
  if (const std::size_t colon = line.find(": "); line.size() > width && colon != line.npos) {
    line.resize(colon);
  }
  if (line.size() <= width) return line;
  constexpr std::string_view kCut = "...";
  line.resize(width - kCut.size());
  return line + std::string(kCut);
}

std::vector<const EnvironmentVariable*> variables_of(const Topic& topic) {
  const bool is_program = topic.about == &program();
  const std::size_t blank = topic.line.find(' ');
  const std::string words = is_program ? "" : topic.line.substr(blank + 1);
  std::vector<const EnvironmentVariable*> variables;
  for (const EnvironmentVariable& variable : kEnvironmentVariables) {
    if (is_program || reads(*topic.about, words, variable)) variables.push_back(&variable);
  }
  return variables;
}

std::vector<Paragraph> paragraphs_of(std::string_view notes) {
  std::vector<Paragraph> paragraphs;
  bool is_new = true;
  while (!notes.empty()) {
    const std::size_t end = std::min(notes.find('\n'), notes.size());
    const std::string_view line = notes.substr(0, end);
    notes.remove_prefix(std::min(end + 1, notes.size()));
    if (line.empty()) {
      is_new = true;
      continue;
    }
    const bool is_verbatim = line.front() == ' ';
    if (is_new || paragraphs.back().is_verbatim != is_verbatim) {
      paragraphs.push_back({is_verbatim, ""});
    }
    std::string& text = paragraphs.back().text;
    if (!is_verbatim && !text.empty()) text += ' ';
    text += line;
    if (is_verbatim) text += '\n';
    is_new = false;
  }
  return paragraphs;
}

std::vector<Option> help_options() {
  const auto nothing = [](const std::string&) { return std::string(); };
  return {{"-h", "", "Print a short help, of one screen", nothing},
          {"--help", "", "Print all of the help: options, examples, exit codes and environment",
           nothing}};
}

std::string short_help(const Topic& topic) {
  const Command& command = *topic.about;
  std::string out = command.summary + "\n\nUsage: " + usage_line(topic) + "\n\n";
  std::vector<std::pair<std::string, std::string>> rows;
  std::string others;
  for (const Command& part : topic.parts) {
    if (is_most_used(command, part.name)) {
      rows.emplace_back(part.name, part.summary);
    } else {
      others += (others.empty() ? "" : ", ") + part.name;
    }
  }
  for (const Place& place : command.places) rows.emplace_back(place.value_name, place.help);
  std::size_t left_out = 0;
  for (const Option& option : command.options) {
    if (is_most_used(command, option.long_name())) {
      rows.emplace_back(option_words(option), option.help);
    } else {
      ++left_out;
    }
  }
  const std::size_t column = column_of(rows);
  for (const auto& [name, text] : rows) add_line(out, name, text, column);
  if (!others.empty()) wrap_into(out, "and " + others, 2);
  if (left_out > 0) out += fmt::format("  and {} more options\n", left_out);
  if (!rows.empty()) out += "\n";
  if (!command.exit_codes.empty()) out += "Exit codes:\n";
  for (const ExitMeaning& code : command.exit_codes) {
    add_line(out, fmt::format("{}", code.code), code.meaning, 7);
  }
  return out + more_line(topic);
}

std::string long_help(const Topic& topic) {
  const Command& command = *topic.about;
  constexpr std::size_t kIndent = 6;
  std::string out = command.summary + "\n\nUsage: " + usage_line(topic) + "\n";
  if (!topic.parts.empty()) {
    out += topic.part_name == "COMMAND" ? "\nCommands:\n" : "\nActions:\n";
    std::vector<std::pair<std::string, std::string>> rows;
    for (const Command& part : topic.parts) rows.emplace_back(part.name, part.summary);
    for (const auto& [name, text] : rows) add_row(out, name, text, column_of(rows));
  }
  if (!command.places.empty()) {
    out += "\nArguments:\n";
    for (const Place& place : command.places) {
      add_row(out, place.value_name, place.help, kIndent);
    }
  }
  out += "\nOptions:\n";
  for (const Option& option : with_help(command)) {
    add_row(out, option_words(option), option.help, kIndent);
  }
  if (command.name == program().name) {
    add_row(out, "-V, --version", "Print the version", kIndent);
  }
  for (const Paragraph& paragraph : paragraphs_of(command.notes)) {
    if (!paragraph.is_verbatim) out += "\n";
    if (paragraph.is_verbatim) {
      out += paragraph.text;
    } else {
      wrap_into(out, paragraph.text, 0);
    }
  }
  if (!command.examples.empty()) out += "\nExamples:\n";
  for (const Example& example : command.examples) {
    if (!example.meaning.empty()) wrap_into(out, example.meaning + ":", 2);
    out += "    " + example.line + "\n";
  }
  if (!command.exit_codes.empty()) out += "\nExit codes:\n";
  for (const ExitMeaning& code : command.exit_codes) {
    add_row(out, fmt::format("{}", code.code), code.meaning, 7);
  }
  const auto variables = variables_of(topic);
  if (!variables.empty()) out += "\nEnvironment variables:\n";
  for (const EnvironmentVariable* variable : variables) {
    add_row(out, std::string(variable->name), variable->meaning, kIndent);
  }
  if (!topic.part_name.empty()) {
    out += fmt::format("\n'{} {} --help' explains one.\n", topic.line, topic.part_name);
  }
  return out;
}

ValueKind value_kind(const std::string& value_name, bool has_words) {
  if (value_name.empty()) return ValueKind::none;
  if (has_words) return ValueKind::words;
  const auto has = [&](std::string_view part) {
    return value_name.find(part) != std::string::npos;
  };
  if (has("FILE") || has(".")) return ValueKind::file;  // "OUT.svg|.png", "PROJECT.xml"
  if (has("DIR") || has("FOLDER")) return ValueKind::folder;
  return ValueKind::other;
}

bool has_file_behind_word(const std::string& value_name) {
  return value_name.find("=FILE") != std::string::npos;
}

}  // namespace cli
