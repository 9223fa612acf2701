#pragma once
// What a command of the program is: what may stand behind its name, and what it does. Every tool
// describes itself by one of these; command_line.cpp alone knows how such a line is read.

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

// Sets its target and returns "", or returns what is allowed and leaves the target alone.
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
  // What may be written, where that is a list, or the words that it begins with ("html" of
  // html=FILE): what a shell completes. Empty: anything else.
  const std::vector<std::string>& words() const { return words_; }

 private:
  std::function<std::string(const std::string& text)> parse_;
  std::vector<std::string> words_;
};

// "--seed N", or a flag.
struct Option {
  std::string names;       // "--seed", "-o,--output"
  std::string value_name;  // as the help shows it; "" of a flag
  // Sentences in the imperative; the first is short and says the default: "...; default 16. ...".
  std::string help;
  std::variant<ValueParser, bool*> target;
  bool repeats = false;
  std::vector<std::string> excludes = {};  // options listed before it that it cannot stand beside
  // A flag that may have a value, behind '=' only: what follows it is never taken for one. The
  // target is a parser, which gets "" where there is none; value_name is empty.
  bool may_have_value = false;

  // Of "-o,--output": "--output", and "-o" or "".
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

// What stands on the line without a name of its own.
struct Place {
  std::string name, value_name, help;
  std::variant<std::string*, std::vector<std::string>*> target;  // the latter takes one or more
  bool is_required = true;
  std::vector<std::string> words = {};  // as those of an option
  bool takes_several() const { return std::holds_alternative<std::vector<std::string>*>(target); }
};

// As written, "0.95"; "" = not there.
struct SettingChange {
  std::string name, before, after;
};

// Which luxgate.toml is meant: "" = the closest one to the projects.
struct ConfigChoice {
  std::string file;
  bool is_off = false;
  std::string taken = {};  // the file that settings were taken from; "" = none
  // Where that is the file of a git revision: what the work tree's says otherwise of settings that
  // are not on the command line.
  std::vector<SettingChange> changed = {};
};

// A line as a user would write it, and what it is for.
struct Example {
  std::string line, meaning;
};

// What an exit code of a command says.
struct ExitMeaning {
  int code = 0;
  std::string meaning;
};

struct Command;

// What a run needs of its surroundings.
struct RunContext {
  Environment environment;
  gpu::Fault gl_fault{};                           // for tests; gpu::Fault::none
  const std::vector<Command>* commands = nullptr;  // all, for those that explain them
};

// Targets must live as long as it: a command that owns them does so in `run`.
struct Command {
  std::string name, summary;
  std::vector<Place> places = {};
  std::vector<Option> options = {};
  std::string notes = {};  // what is to be said besides, in paragraphs of lines
  std::vector<Example> examples = {};
  std::vector<ExitMeaning> exit_codes = {};
  std::vector<std::string> most_used = {};  // long names, for the short help; empty = all
  // Sub-commands, one of which must be given; then it has no places, options or run of its own.
  std::vector<Command> actions = {};
  // Of commands whose options may stand in a luxgate.toml, see config_file.h; null: not this one.
  ConfigChoice* config = nullptr;
  // The git revision in which that file is looked for, "" = as it is now; null: always so.
  const std::string* config_revision = nullptr;
  // Called once the line is read, and before a luxgate.toml is looked for: puts projects where
  // lists and folders of them are given. "" or what is wrong with these.
  std::function<std::string()> complete_projects = {};
  // Called once all options are read. "", or what is wrong with all of them together. May complete
  // them.
  std::function<std::string(const Environment&)> complete = {};
  std::function<ExitCode(const RunContext&)> run = {};
};

// Appends.
void add(std::vector<Option>& options, std::vector<Option> more);

}  // namespace cli
