#pragma once
// The options of `luxgate check`.

#include "report/check/set_values.h"
#include "report/check/settings.h"
#include "report/document/revision.h"
#include "report/shell/options/sandbox.h"
#include "report/shell/options/set_option.h"
#include "report/shell/options/work_options.h"
#include "report/shell/output/output_options.h"
#include "report/shell/output/warning_tally.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// A share of a batch for several machines: shard `number`, from 1, of `count`; 0: all of it.
struct BatchShare {
  std::uint64_t number = 0, count = 0;
};

// How the parts of a batch share a store.
struct BatchOptions {
  BatchShare share;
  std::string units_file;       // that `luxgate plan --units` wrote; "" = planned again
  bool is_stored_only = false;  // nothing is calculated
  bool resumes = false;         // the store is for this run alone, until its reports are written
};

struct CheckOptions {
  ProjectOptions input;
  std::vector<check::SetValue> set;  // in each of the projects
  OutputOptions output;
  check::Settings settings;
  check::BackendRequest backend;
  std::string timestamp;  // "2024-05-01T12:00:00Z" or ""
  bool pictures = true;   // of rooms, in HTML and with --images, where OpenGL can draw
  bool explain_cost = false;
  bool advice = false;  // levels for scenes in which something is not met
  StrictWarnings strict;
  std::string policy;    // the owner's, a file; "" = none
  std::string baseline;  // a result file; "" = none
  std::string against;   // a git revision to compare with instead; "" = none
  report::Gate gate;
  std::string vpl_file;  // light vertices to take instead of tracing; "" = none
  std::string store;     // folder of the result cache; "" = none
  BatchOptions batch;
  SandboxMode sandbox = SandboxMode::automatic;
};

// Return --store; and what is wrong with its folder, after setting it ("" = none). variable:
// LUXGATE_STORE.
Option store_option(std::string& store);
std::string take_store(const std::string& variable, std::string& store);

// Returns --shard.
Option shard_option(BatchShare& share, const std::string& help);
// Returns --stored-only.
Option stored_only_option(bool& is_stored_only);

// Returns the options for the accuracy of the calculation.
std::vector<Option> accuracy_options(check::Settings& settings);

// Returns the arguments of `luxgate check`, which set `options`.
Command check_syntax(CheckOptions& options);

// Returns a command that gives the same numbers again: paths and every option that changes results,
// quoted for a shell. Other options (--jobs, --format, ...) are omitted, so that reports do not
// depend on them.
std::string reproducible_command(const CheckOptions& options);
// Returns the part of it after "luxgate check".
std::string reproducible_words(const CheckOptions& options);

}  // namespace cli
