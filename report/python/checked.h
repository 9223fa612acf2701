#pragma once
// Checks for the Python module: as `luxgate check` calculates, without its files, messages and
// signals. Settings are options of that command, with its names, values and words.

#include "calc/base/diagnostics.h"
#include "report/document/document.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace python {

// A setting: "--max-paths" and "4096". A flag has no text; a repeated option has several settings.
struct Setting {
  std::string option, text;
};

// An option that is offered here, for help and signatures.
struct OfferedOption {
  std::string name, value_name, help;  // "--max-paths", "N"; a flag has no value_name
  bool is_flag = false;
  bool may_have_value = false;  // a flag, or with a value
  bool repeats = false;
};

// The functions that have the option.
enum class Use { check, validate, write };
std::vector<OfferedOption> offered_options(Use use);
// Returns names of all options of `luxgate check`, to tell options not offered here from mistakes.
std::vector<std::string> known_options();

// A checked document. Its existence is no verdict: see report::outcome_of().
struct Checked {
  std::string problem;                       // with the settings; "" = none
  std::optional<report::Document> document;  // empty: there is a problem, or `messages` say why
  // Messages of the run, as the program prints them; those of the project are in the document.
  std::vector<calc::Diagnostic> messages;
};

// Checks a project. goes_on is called by several threads at any time; once it is false, the project
// is not judged. Reads LUXGATE_STORE and SOURCE_DATE_EPOCH as the program does. Prints nothing, and
// throws only for lack of memory.
Checked check(const std::string& path, const std::vector<Setting>& settings,
              const std::function<bool()>& goes_on);
// Reads and checks everything that a check does, without calculation; the document only has the
// messages.
Checked validate(const std::string& path, const std::vector<Setting>& settings);
// Reads a document from a result file or its bytes. path: for messages.
Checked read_result(const std::string& path);
Checked read_result_bytes(const std::string& path, const std::string& bytes);

// Returns the document in a format of `--format`, as the program writes it. If the format or a
// setting is wrong, sets `problem` and returns nothing.
std::string rendered(const report::Document& document, const std::string& format,
                     const std::vector<Setting>& settings, std::string& problem);

}  // namespace python
