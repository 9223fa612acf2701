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
      {"--list", "", "Name the cases and run none", &options.lists},
      {"--all", "", "A line for every number, not for every case", &options.shows_all},
      {"--timing", "", "Times and rays too; without them equal runs print equal bytes",
       &options.has_timing},
      {"--only", "NAME", "A case or a kind of cases; may be repeated", case_or_kind(options.only),
       true},
      {"--report", "FOLDER",
       "Write validation.html and validation.md there: every case with its\n"
       "numbers. Made if needed",
       some_text(options.report_folder)},
      seed_option(options.seed),
      {"--seeds", "N",
       "As many runs, with this seed and those after it: how often the stated intervals\n"
       "hold, and no verdict that hangs on one seed's luck; 1 to 1000, default 1",
       whole_number(options.seeds, 1, 1000)},
      jobs_option(options.jobs)};
  add(command.options, text_or_json_options(options.as_json));
  command.notes =
      "Every case is a situation whose light is known exactly: by a closed form, by quadrature or\n"
      "by a matrix solution, none of which uses the calculation. 'in': the exact value lies in "
      "our\n"
      "interval, at a level that all numbers together miss in fewer than one of a thousand seeds.";
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
