#pragma once
// What a command of the program is: what may stand behind its name, and what it does. Every tool
// describes itself by one of these; command_line.cpp alone knows how such a line is read.

#include "gpu/egl_context.h"
#include "report/shell/environment.h"
#include "report/shell/exit_code.h"

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace cli {

// Sets its target and returns "", or returns what is allowed and leaves the target alone.
using ValueParser = std::function<std::string(const std::string& text)>;

// "--seed N", or a flag.
struct Option {
  std::string names;       // "--seed", "-o,--output"
  std::string value_name;  // as the help shows it; "" of a flag
  std::string help;        // lines of at most 80 characters
  std::variant<ValueParser, bool*> target;
  bool repeats = false;
  std::vector<std::string> excludes = {};  // options listed before it that it cannot stand beside
  // A flag that may have a value, behind '=' only: what follows it is never taken for one. The
  // target is a parser, which gets "" where there is none; value_name is empty.
  bool may_have_value = false;
};

// What stands on the line without a name of its own.
struct Place {
  std::string name, value_name, help;
  std::variant<std::string*, std::vector<std::string>*> target;  // the latter takes one or more
  bool is_required = true;
};

// Which luxgate.toml is meant: "" = the closest one to the projects.
struct ConfigChoice {
  std::string file;
  bool is_off = false;
  std::string taken = {};  // the file that settings were taken from; "" = none
};

// What a run needs of its surroundings.
struct RunContext {
  Environment environment;
  gpu::Fault gl_fault = gpu::Fault::none;  // for tests
};

// Targets must live as long as it: a command that owns them does so in `run`.
struct Command {
  std::string name, summary;
  std::vector<Place> places = {};
  std::vector<Option> options = {};
  std::string footer = {};
  // Sub-commands, one of which must be given; then it has no places, options or run of its own.
  std::vector<Command> actions = {};
  // Of commands whose options may stand in a luxgate.toml, see config_file.h; null: not this one.
  ConfigChoice* config = nullptr;
  // The git revision in which that file is looked for, "" = as it is now; null: always so.
  const std::string* config_revision = nullptr;
  // Called once all options are read. "", or what is wrong with all of them together. May complete
  // them.
  std::function<std::string(const Environment&)> complete = {};
  std::function<ExitCode(const RunContext&)> run = {};
};

// Appends.
void add(std::vector<Option>& options, std::vector<Option> more);

}  // namespace cli
