#include "report/tools/selftest/selftest_options.h"

#include "report/shell/command/option_values.h"
#include "report/tools/selftest/case.h"

#include <fmt/format.h>

#include <string_view>

namespace cli {
namespace {

ValueParser case_or_kind(std::vector<std::string>& target) {
  return [&target](const std::string& text) -> std::string {
    std::vector<std::string> names;
    for (const selftest::Kind& kind : selftest::kinds()) names.push_back(kind.name);
    for (const selftest::SelftestCase& item : selftest::all_cases()) names.push_back(item.name);
    for (const std::string& name : names) {
      if (name != text) continue;
      target.push_back(text);
      return "";
    }
    return one_of_message(text, {names.begin(), names.end()});
  };
}

// "" = nothing is wrong.
std::string selftest_contradiction(const SelftestOptions& options) {
  if (options.lists && (options.shows_all || options.has_timing || options.as_json ||
                        !options.report_folder.empty())) {
    return "--list goes with --only only";
  }
  if (!options.report_folder.empty() && !options.only.empty()) {
    return "--report is about all cases: leave out --only";
  }
  return "";
}

}  // namespace

Command selftest_syntax(SelftestOptions& options) {
  Command command{"selftest", "Calculate cases whose light is known exactly, and compare"};
  command.options = {
      {"--list", "", "Print the names of the cases and run none", &options.lists},
      {"--all", "", "Print a line for every number instead of every case", &options.shows_all},
      {"--timing", "", "Print times and numbers of rays. Without it equal runs print equal bytes",
       &options.has_timing},
      {"--only", "NAME", "Run only this case or kind of cases; repeatable",
       case_or_kind(options.only), true},
      {"--report", "FOLDER",
       "Write validation.html and validation.md into this folder; made if needed. They have every "
       "case with its numbers",
       some_text(options.report_folder)},
      seed_option(options.seed),
      {"--seeds", "N",
       "Run with N seeds, from --seed on, 1 to 1000; default 1. It shows how often the stated "
       "intervals hold, and no verdict then depends on one seed",
       whole_number(options.seeds, 1, 1000)},
      jobs_option(options.jobs)};
  add(command.options, text_or_json_options(options.as_json));
  command.notes =
      "The light of every case is known exactly: by a closed form, by quadrature or by a matrix\n"
      "solution. None of them uses the calculation. 'in': the exact value is in the interval. "
      "Fewer\n"
      "than one of a thousand seeds miss any of the numbers at this level.";
  command.examples = {
      {"luxgate selftest --only cie171-5.8 --all", "Every number of one kind of cases"}};
  command.exit_codes = {{kAllMet, "all cases are right"},
                        {kNotMet, "a case is wrong or too vague"},
                        {kNotJudged, "an error"},
                        {kInterrupted, "interrupted"}};
  command.complete = [&options](const Environment&) { return selftest_contradiction(options); };
  return command;
}

}  // namespace cli
