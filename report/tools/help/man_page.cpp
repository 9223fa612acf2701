#include "report/tools/help/man_page.h"

#include "calc/base/text.h"
#include "report/document/program_version.h"
#include "report/shell/command/help_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace cli {
namespace {

// Text as troff prints it: none of it is a request, and what is typed keeps its signs.
std::string escaped(std::string_view text) {
  std::string out;
  bool is_line_start = true;
  for (const char c : text) {
    if (is_line_start && (c == '.' || c == '\'')) out += "\\&";
    is_line_start = c == '\n';
    switch (c) {
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      default:
        out += c;
    }
  }
  return out;
}

// A text whose lines say nothing, as one.
std::string flowing(std::string_view text) {
  std::string line;
  for (const std::string_view word : calc::split_words(text)) {
    line += (line.empty() ? "" : " ") + std::string(word);
  }
  return escaped(line) + "\n";
}

std::string bold(std::string_view text) { return "\\fB" + escaped(text) + "\\fR"; }

// ".TP", what it is about and what is said of it.
std::string item(const std::string& head, std::string_view text) {
  return ".TP\n" + head + "\n" + flowing(text);
}

std::string option_head(const Option& option) {
  std::string head;
  if (const std::string one_letter = option.short_name(); !one_letter.empty()) {
    head = bold(one_letter) + ", ";
  }
  head += bold(option.long_name());
  if (option.may_have_value) return head + "[=\\fIID\\fR,...]";
  return option.value_name.empty() ? head : head + " \\fI" + escaped(option.value_name) + "\\fR";
}

std::string notes_of(const Command& command) {
  std::string out;
  for (const Paragraph& paragraph : paragraphs_of(command.notes)) {
    if (paragraph.is_verbatim) {
      out += ".PP\n.nf\n" + escaped(paragraph.text) + ".fi\n";
    } else {
      out += ".PP\n" + flowing(paragraph.text);
    }
  }
  return out;
}

// Places and options of a command or an action.
std::string arguments_of(const Command& command) {
  std::string out;
  for (const Place& place : command.places) {
    out += item("\\fI" + escaped(place.value_name) + "\\fR", place.help);
  }
  for (const Option& option : command.options) out += item(option_head(option), option.help);
  return out;
}

std::string examples_of(const Command& command) {
  std::string out;
  for (const Example& example : command.examples) {
    if (!example.meaning.empty()) out += ".PP\n" + flowing(example.meaning + ":");
    out += ".PP\n.in +4n\n.nf\n" + escaped(example.line) + "\n.fi\n.in\n";
  }
  return out;
}

std::string exit_codes_of(const Command& command) {
  std::string out;
  for (const ExitMeaning& code : command.exit_codes) {
    out += item(bold(fmt::format("{}", code.code)), code.meaning);
  }
  return out;
}

std::string section(const std::string& name, const std::string& text) {
  return text.empty() ? "" : ".SH " + name + "\n" + text;
}

std::string page_name(const std::string& command) {
  return command.empty() ? "luxgate" : "luxgate-" + command;
}

}  // namespace

ManPage man_page(const std::vector<Command>& commands, const std::string& command) {
  std::string problem;
  const Topic topic = find_topic(
      commands, command.empty() ? std::vector<std::string>() : std::vector<std::string>{command},
      problem);
  const Command& about = *topic.about;
  const std::string name = page_name(command);
  std::string title = name;
  for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));

  std::string text = ".\\\" Made by 'luxgate man'.\n";
  text += fmt::format(".TH \"{}\" 1 \"\" \"luxgate {}\" \"luxgate\"\n.nh\n.ad l\n", escaped(title),
                      escaped(report::program_version()));
  text += fmt::format(".SH NAME\n{} \\- {}", escaped(name), flowing(about.summary));

  std::string synopsis, parts, examples = examples_of(about), codes = exit_codes_of(about);
  std::string options = arguments_of(about);
  if (command.empty()) {
    synopsis = bold("luxgate") + " \\fICOMMAND\\fR ...\n";
    for (const Command& part : topic.parts) {
      parts += item(bold(page_name(part.name)) + "(1)", part.summary);
    }
    options += item(bold("-V") + ", " + bold("--version"), "The version.");
  } else if (topic.parts.empty()) {
    synopsis = escaped(usage_line(topic)) + "\n";
  } else {
    for (const Command& part : topic.parts) {
      const Topic action = find_topic(commands, {command, part.name}, problem);
      synopsis += (synopsis.empty() ? "" : ".br\n") + escaped(usage_line(action)) + "\n";
      parts += fmt::format(".SS \"{}\"\n", escaped(part.name)) + flowing(part.summary + ".") +
               notes_of(part) + arguments_of(part) + exit_codes_of(part);
      examples += examples_of(part);
    }
  }
  for (const Option& option : help_options()) options += item(option_head(option), option.help);
  text += section("SYNOPSIS", synopsis);
  text += section("DESCRIPTION", flowing(about.summary + ".") + notes_of(about));
  text += section(command.empty() ? "COMMANDS" : "ACTIONS", parts);
  text += section("OPTIONS", options);
  text += section("EXAMPLES", examples);
  text += section("EXIT STATUS", codes);
  std::string environment;
  for (const EnvironmentVariable* variable : variables_of(topic)) {
    environment += item(bold(variable->name), variable->meaning);
  }
  text += section("ENVIRONMENT", environment);
  if (!command.empty()) text += section("SEE ALSO", bold("luxgate") + "(1)\n");
  return {name + ".1", text};
}

}  // namespace cli
