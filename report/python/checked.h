#pragma once
// A check for the Python module: what `luxgate check` calculates, without its files, messages and
// signals. Settings are options of that command, with its names, values and words.

#include "calc/base/diagnostics.h"
#include "report/document/document.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace python {

// "--max-paths" and "4096". A flag has no text, and of what repeats there is one for each time.
struct Setting {
  std::string option, text;
};

// Of an option that is offered here, for help and signatures.
struct OfferedOption {
  std::string name, value_name, help;  // "--max-paths", "N"; a flag has no value_name
  bool is_flag = false;
  bool may_have_value = false;  // a flag, or with a value
  bool repeats = false;
};

// Which function they are for.
enum class Use { check, validate, write };
std::vector<OfferedOption> offered_options(Use use);
// Names of all options of `luxgate check`, to tell those that are not offered from mistakes.
std::vector<std::string> known_options();

// That there is a document is no verdict: see report::outcome_of().
struct Checked {
  std::string problem;                       // with the settings; "" = none
  std::optional<report::Document> document;  // empty: there is a problem, or `messages` say why
  // Of the run, as the program prints them; those of the project are in the document.
  std::vector<calc::Diagnostic> messages;
};

// goes_on is asked by several threads at any time; once it is false, the project is not judged.
// Reads LUXGATE_STORE and SOURCE_DATE_EPOCH as the program does. Prints nothing, throws only what
// memory lacks.
Checked check(const std::string& path, const std::vector<Setting>& settings,
              const std::function<bool()>& goes_on);
// Everything that a check reads, without calculation; the document has the messages alone.
Checked validate(const std::string& path, const std::vector<Setting>& settings);
// A document again, from a result file or its bytes. path: for messages.
Checked read_result(const std::string& path);
Checked read_result_bytes(const std::string& path, const std::string& bytes);

// The document in a format of `--format`, as the program writes it. `problem` is set and nothing
// returned where the format or a setting is wrong.
std::string rendered(const report::Document& document, const std::string& format,
                     const std::vector<Setting>& settings, std::string& problem);

}  // namespace python
