#include "report/tools/help/completions.h"

#include "report/shell/command/help_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cli {
namespace {

constexpr std::size_t kDescription = 60;

// "check", "rules list"; "" of the program.
std::string words_of(const Topic& topic) {
  const std::size_t blank = topic.line.find(' ');
  return blank == std::string::npos ? "" : topic.line.substr(blank + 1);
}

std::vector<Option> options_of(const Topic& topic) {
  std::vector<Option> options = topic.about->options;
  add(options, help_options());
  if (words_of(topic).empty()) {
    options.push_back(
        {"-V,--version", "", "The version", [](const std::string&) { return std::string(); }});
  }
  return options;
}

// "-o --output", with something between.
std::string names_of(const Option& option, std::string_view between) {
  const std::string one_letter = option.short_name();
  return one_letter.empty() ? option.long_name()
                            : fmt::format("{}{}{}", one_letter, between, option.long_name());
}

std::string replaced(std::string_view text, char what, std::string_view with) {
  std::string out;
  for (const char c : text) {
    if (c == what) {
      out += with;
    } else {
      out += c;
    }
  }
  return out;
}

// --- bash ---

constexpr std::string_view kBashHead =
    R"(# Completion of luxgate for bash, made by 'luxgate completions bash'.
_luxgate() {
  local word=${COMP_WORDS[COMP_CWORD]} option='' kind='' words='' options='' behind=''
  local -i at=$COMP_CWORD
  # '=' is a word of its own there: '--name = value', '--name KIND = FILE'.
  if [[ $word == '=' ]]; then
    word=''
  elif (( at > 1 )) && [[ ${COMP_WORDS[at-1]} == '=' ]]; then
    at+=-1
  fi
  if [[ ${COMP_WORDS[at]} == '=' ]]; then
    option=${COMP_WORDS[at-1]}
    if [[ $option != -* ]]; then
      behind=yes
      option=${COMP_WORDS[at-2]}
      [[ $option == '=' ]] && option=${COMP_WORDS[at-3]}
    fi
  else
    option=${COMP_WORDS[at-1]}
  fi
)";

constexpr std::string_view kBashTail = R"(  if [[ -n $behind ]]; then
    [[ $kind == *file ]] && kind=file || kind=none
  elif [[ -z $kind && $word == -* ]]; then
    kind=words words=$options
  elif [[ -z $kind ]]; then
    kind=$place words=$place_words
  fi
  case $kind in
    words*) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word") ;;
    file)
      mapfile -t COMPREPLY < <(compgen -f -- "$word")
      compopt -o filenames 2> /dev/null
      ;;
    folder)
      mapfile -t COMPREPLY < <(compgen -d -- "$word")
      compopt -o filenames 2> /dev/null
      ;;
    *) COMPREPLY=() ;;
  esac
  [[ ${COMPREPLY[0]} == *[=:] ]] && compopt -o nospace 2> /dev/null
  return 0
}
complete -F _luxgate luxgate
)";

// What the script calls the kind of a value: "wordsfile" is a word, perhaps with '=' and a file.
std::string bash_kind(const std::string& value_name, const std::vector<std::string>& words) {
  switch (value_kind(value_name, !words.empty())) {
    case ValueKind::words:
      return has_file_behind_word(value_name) ? "wordsfile" : "words";
    case ValueKind::file:
      return "file";
    case ValueKind::folder:
      return "folder";
    case ValueKind::none:
    case ValueKind::other:
      break;
  }
  return "none";
}

std::string bash_case(const Topic& topic) {
  std::string names, values;
  for (const Option& option : options_of(topic)) {
    names += (names.empty() ? "" : " ") + names_of(option, " ");
    const std::vector<std::string> words = option.words();
    if (option.may_have_value) {  // behind '=' only
      values +=
          fmt::format("        {}) [[ ${{COMP_WORDS[at]}} == '=' ]] && kind=words words='{}' ;;\n",
                      option.long_name(), fmt::join(words, " "));
      continue;
    }
    if (option.value_name.empty()) continue;
    const std::string list = words.empty() ? "" : fmt::format(" words='{}'", fmt::join(words, " "));
    values += fmt::format("        {}) kind={}{} ;;\n", names_of(option, "|"),
                          bash_kind(option.value_name, words), list);
  }
  std::string place = "none", place_words;
  const std::vector<Place>& places = topic.about->places;
  if (!topic.parts.empty()) {
    place = "words";
    for (const Command& part : topic.parts) {
      place_words += (place_words.empty() ? "" : " ") + part.name;
    }
  } else if (!places.empty()) {
    place = bash_kind(places.front().value_name, places.front().words);
    place_words = fmt::format("{}", fmt::join(places.front().words, " "));
  }
  std::string text = fmt::format("    '{}')\n      options='{}'\n      place={} place_words='{}'\n",
                                 words_of(topic), names, place, place_words);
  if (places.size() > 1) {  // the first has been typed: a word, behind which another thing stands
    const Place& second = places[1];
    text += fmt::format(
        "      (( at > {} )) && [[ ${{COMP_WORDS[at-1]}} != -* ]] && place={} place_words='{}'\n",
        1 + (words_of(topic).find(' ') == std::string::npos ? 1 : 2),
        bash_kind(second.value_name, second.words), fmt::join(second.words, " "));
  }
  if (!values.empty()) text += "      case $option in\n" + values + "      esac\n";
  return text + "      ;;\n";
}

std::string bash_completions(const std::vector<Command>& commands) {
  std::string with_actions, cases;
  for (const Topic& topic : all_topics(commands)) {
    if (!topic.parts.empty() && !words_of(topic).empty()) {
      with_actions += (with_actions.empty() ? "" : "|") + words_of(topic);
    }
    cases += bash_case(topic);
  }
  return std::string(kBashHead) +
         fmt::format(
             "  local topic='' place='' place_words=''\n"
             "  (( COMP_CWORD > 1 )) && topic=${{COMP_WORDS[1]}}\n"
             "  case $topic in\n"
             "    {}) (( COMP_CWORD > 2 )) && topic+=\" ${{COMP_WORDS[2]}}\" ;;\n"
             "  esac\n"
             "  case $topic in\n",
             with_actions) +
         cases + "  esac\n" + std::string(kBashTail);
}

// --- zsh ---

std::string zsh_text(std::string_view text) {
  std::string out = replaced(first_clause(text, kDescription), '\'', "'\\''");
  out = replaced(replaced(out, '[', "\\["), ']', "\\]");
  return replaced(out, ':', "\\:");
}

std::string zsh_action(const std::string& value_name, const std::vector<std::string>& words) {
  switch (value_kind(value_name, !words.empty())) {
    case ValueKind::words:
      if (has_file_behind_word(value_name)) {
        return fmt::format(" _luxgate_word_or_file {}", fmt::join(words, " "));
      }
      return replaced(fmt::format("({})", fmt::join(words, " ")), ':', "\\:");
    case ValueKind::file:
      return "_files";
    case ValueKind::folder:
      return "_files -/";
    case ValueKind::none:
    case ValueKind::other:
      break;
  }
  return " ";
}

std::string zsh_option(const Option& option) {
  const std::string one_letter = option.short_name(), name = option.long_name();
  const std::string text = zsh_text(option.help);
  std::string value;
  if (option.may_have_value) {
    value = fmt::format("::ID:({})", fmt::join(option.words(), " "));
  } else if (!option.value_name.empty()) {
    value = fmt::format(":{}:{}", zsh_text(option.value_name),
                        zsh_action(option.value_name, option.words()));
  }
  const std::string repeats = option.repeats ? "*" : "";
  const std::string equals = option.may_have_value ? "=-" : value.empty() ? "" : "=";
  std::string spec = fmt::format("'{}{}{}[{}]{}'", repeats, name, equals, text, value);
  if (one_letter.empty()) return spec;
  const std::string other = option.repeats ? "*" : fmt::format("({} {})", one_letter, name);
  return fmt::format("'{0}{1}{2}[{3}]{4}' '{0}{5}{6}[{3}]{4}'", other, one_letter,
                     value.empty() ? "" : "+", text, value, name, equals);
}

std::string zsh_arguments(const Topic& topic, const std::string& indent) {
  std::string text = indent + "_arguments -S";
  for (const Option& option : options_of(topic)) {
    text += " \\\n" + indent + "  " + zsh_option(option);
  }
  std::size_t number = 0;
  for (const Place& place : topic.about->places) {
    const std::string at = place.takes_several() ? "*" : fmt::format("{}", ++number);
    text += fmt::format(" \\\n{}  '{}:{}:{}'", indent, at, zsh_text(place.value_name),
                        zsh_action(place.value_name, place.words));
  }
  return text + "\n";
}

std::string zsh_list(const Topic& topic, const std::string& indent) {
  std::string text = indent + "local -a parts=(\n";
  for (const Command& part : topic.parts) {
    text += fmt::format("{}  '{}:{}'\n", indent, part.name, zsh_text(part.summary));
  }
  return text + indent + ")\n";
}

std::string zsh_completions(const std::vector<Command>& commands) {
  const std::vector<Topic> topics = all_topics(commands);
  std::string text =
      "#compdef luxgate\n"
      "# Completion of luxgate for zsh, made by 'luxgate completions zsh'.\n"
      "_luxgate_word_or_file() {\n"
      "  if compset -P '*='; then _files; else compadd -- \"$@\"; fi\n"
      "}\n"
      "_luxgate() {\n"
      "  if (( CURRENT == 2 )); then\n"
      "    if [[ $words[2] == -* ]]; then\n" +
      zsh_arguments(topics.front(), "      ") + "    else\n" + zsh_list(topics.front(), "      ") +
      "      _describe command parts\n    fi\n    return\n  fi\n"
      "  local topic=$words[2]\n"
      "  shift words\n  (( CURRENT -= 1 ))\n"
      "  case $topic in\n";
  for (const Command& command : commands) {
    std::string problem;
    const Topic topic = find_topic(commands, {command.name}, problem);
    text += fmt::format("    {})\n", command.name);
    if (topic.parts.empty()) {
      text += zsh_arguments(topic, "      ");
    } else {
      text += "      if (( CURRENT == 2 )); then\n" + zsh_list(topic, "        ") +
              "        _describe action parts\n        return\n      fi\n"
              "      topic=$words[2]\n      shift words\n      (( CURRENT -= 1 ))\n"
              "      case $topic in\n";
      for (const Command& action : command.actions) {
        text += fmt::format("        {})\n", action.name) +
                zsh_arguments(find_topic(commands, {command.name, action.name}, problem),
                              "          ") +
                "          ;;\n";
      }
      text += "      esac\n";
    }
    text += "      ;;\n";
  }
  return text + "  esac\n}\n" +
         "if [[ $funcstack[1] == _luxgate ]]; then _luxgate \"$@\"; else compdef _luxgate luxgate; "
         "fi\n";
}

// --- fish ---

constexpr std::string_view kFishHead =
    R"(# Completion of luxgate for fish, made by 'luxgate completions fish'.
# Whether the words behind 'luxgate' begin with these.
function __luxgate_is
    set -l words (commandline -opc)
    set -e words[1]
    test (count $words) -ge (count $argv); or return 1
    for i in (seq (count $argv))
        test "$words[$i]" = "$argv[$i]"; or return 1
    end
end
# Whether they are these, and nothing else.
function __luxgate_at
    test (count (commandline -opc)) -eq (math (count $argv) + 1); and __luxgate_is $argv
end
complete -c luxgate -f
)";

std::string fish_text(std::string_view text) {
  return "'" + replaced(replaced(first_clause(text, kDescription), '\\', "\\\\"), '\'', "\\'") +
         "'";
}

std::string fish_value(const std::string& value_name, const std::vector<std::string>& words) {
  switch (value_kind(value_name, !words.empty())) {
    case ValueKind::words:
      return fmt::format(" {} -a '{}'", has_file_behind_word(value_name) ? "-r -F" : "-x",
                         fmt::join(words, " "));
    case ValueKind::file:
      return " -r -F";
    case ValueKind::folder:
      return " -x -a '(__fish_complete_directories)'";
    case ValueKind::other:
      return " -x";
    case ValueKind::none:
      break;
  }
  return "";
}

std::string fish_completions(const std::vector<Command>& commands) {
  std::string text(kFishHead);
  for (const Topic& topic : all_topics(commands)) {
    const std::string words = words_of(topic);
    const std::string blank = words.empty() ? "" : " ";
    for (const Command& part : topic.parts) {
      text += fmt::format("complete -c luxgate -n '__luxgate_at{}{}' -a {} -d {}\n", blank, words,
                          part.name, fish_text(part.summary));
    }
    const std::string condition =
        words.empty() ? "__luxgate_at" : fmt::format("__luxgate_is {}", words);
    for (const Option& option : options_of(topic)) {
      std::string names;
      for (const std::string& name : {option.short_name(), option.long_name()}) {
        if (name.starts_with("--")) {
          names += " -l " + name.substr(2);
        } else if (!name.empty()) {
          names += " -s " + name.substr(1);
        }
      }
      text += fmt::format("complete -c luxgate -n '{}'{}{} -d {}\n", condition, names,
                          fish_value(option.value_name, option.words()), fish_text(option.help));
    }
    bool is_behind_words = false;
    for (const Place& place : topic.about->places) {
      const std::string where = is_behind_words
                                    ? fmt::format("{}; and not __luxgate_at {}", condition, words)
                                    : condition;
      is_behind_words = is_behind_words || !place.words.empty();
      if (!place.words.empty()) {
        text += fmt::format("complete -c luxgate -n '__luxgate_at {}' -a '{}'\n", words,
                            fmt::join(place.words, " "));
      } else if (value_kind(place.value_name, false) == ValueKind::file) {
        text += fmt::format("complete -c luxgate -n '{}' -F\n", where);
      } else if (value_kind(place.value_name, false) == ValueKind::folder) {
        text +=
            fmt::format("complete -c luxgate -n '{}' -a '(__fish_complete_directories)'\n", where);
      }
    }
  }
  return text;
}

}  // namespace

std::string completions(Shell shell, const std::vector<Command>& commands) {
  switch (shell) {
    case Shell::bash:
      return bash_completions(commands);
    case Shell::zsh:
      return zsh_completions(commands);
    case Shell::fish:
      break;
  }
  return fish_completions(commands);
}

}  // namespace cli
