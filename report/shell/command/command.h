#pragma once
// The description of a command of the program: its arguments and what it does. Every tool describes
// itself this way; only command_line.cpp knows how a command line is read.

#include "report/shell/process/environment.h"
#include "report/shell/process/exit_code.h"

#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace gpu {
enum class Fault;
}

namespace cli {

// Sets its target and returns "", or returns the allowed values and leaves the target alone.
class ValueParser {
 public:
  template <class Parse>
  requires(!std::is_same_v<std::remove_cvref_t<Parse>, ValueParser> &&
           std::is_invocable_r_v<std::string, Parse&, const std::string&>) ValueParser(Parse parse)
      : parse_(std::move(parse)) {}
  template <class Parse>
  ValueParser(Parse parse, std::vector<std::string> words)
      : parse_(std::move(parse)), words_(std::move(words)) {}

  std::string operator()(const std::string& text) const { return parse_(text); }
  // Returns the allowed texts if they are a list, or their first words ("html" of html=FILE), for
  // completion in a shell. Empty: anything else.
  const std::vector<std::string>& words() const { return words_; }

 private:
  std::function<std::string(const std::string& text)> parse_;
  std::vector<std::string> words_;
};

// "--seed N", or a flag.
struct Option {
  std::string names;       // "--seed", "-o,--output"
  std::string value_name;  // as the help shows it; "" of a flag
  // Sentences in the imperative; the first is short and has the default: "...; default 16. ...".
  std::string help;
  std::variant<ValueParser, bool*> target;
  bool repeats = false;
  std::vector<std::string> excludes = {};  // options listed before it that it cannot stand beside
  // A flag that may have a value, only after '=': the next word is never its value. The target is a
  // parser, which gets "" without a value; value_name is empty.
  bool may_have_value = false;

  // Return "--output" and "-o" for "-o,--output"; "" if there is no short name.
  std::string long_name() const { return names.substr(names.find_last_of(',') + 1); }
  std::string short_name() const {
    return names.find(',') == std::string::npos ? "" : names.substr(0, names.find(','));
  }
  // See ValueParser::words().
  std::vector<std::string> words() const {
    const ValueParser* parser = std::get_if<ValueParser>(&target);
    return parser == nullptr ? std::vector<std::string>() : parser->words();
  }
};

// A positional argument.
struct Place {
  std::string name, value_name, help;
  std::variant<std::string*, std::vector<std::string>*> target;  // the latter takes one or more
  bool is_required = true;
  std::vector<std::string> words = {};  // as those of an option
  bool takes_several() const { return std::holds_alternative<std::vector<std::string>*>(target); }
};

// Values as written, "0.95"; "" = absent.
struct SettingChange {
  std::string name, before, after;
};

// The chosen luxgate.toml: "" = the closest one to the projects.
struct ConfigChoice {
  std::string file;
  bool is_off = false;
  std::string taken = {};  // the file that settings were taken from; "" = none
  // If that file is from a git revision: different values in the work tree's file, of settings that
  // are not on the command line.
  std::vector<SettingChange> changed = {};
};

// A line as a user would write it, and its purpose.
struct Example {
  std::string line, meaning;
};

// The meaning of an exit code of a command.
struct ExitMeaning {
  int code = 0;
  std::string meaning;
};

struct Command;

// The surroundings that a run needs.
struct RunContext {
  Environment environment;
  gpu::Fault gl_fault{};                           // for tests; gpu::Fault::none
  const std::vector<Command>* commands = nullptr;  // all, for those that explain them
};

// A command. Its targets must live as long as it does: a command that owns them keeps them in
// `run`.
struct Command {
  std::string name, summary;
  std::vector<Place> places = {};
  std::vector<Option> options = {};
  std::string notes = {};  // what is to be said besides, in paragraphs of lines
  std::vector<Example> examples = {};
  std::vector<ExitMeaning> exit_codes = {};
  std::vector<std::string> most_used = {};  // long names, for the short help; empty = all
  // Sub-commands, of which one must be given; then it has no places, options or run of its own.
  std::vector<Command> actions = {};
  // For commands whose options may be in a luxgate.toml, see config_file.h; null: not this command.
  ConfigChoice* config = nullptr;
  // The git revision in which that file is searched, "" = the current files; null: always so.
  const std::string* config_revision = nullptr;
  // Called once the line is read, before a luxgate.toml is searched: replaces lists and folders of
  // projects by projects. Returns "" or what is wrong with them.
  std::function<std::string()> complete_projects = {};
  // Called once all options are read. Returns "", or what is wrong with all of them together. May
  // complete them.
  std::function<std::string(const Environment&)> complete = {};
  std::function<ExitCode(const RunContext&)> run = {};
};

// Appends `more` to `options`.
void add(std::vector<Option>& options, std::vector<Option> more);

}  // namespace cli
