#include "report/tools/compare/compare_options.h"

#include "report/shell/command/option_values.h"

namespace cli {
Command compare_syntax(CompareOptions& options) {
  Command command{"compare",
                  "Compare a result with an earlier one, another program's or measured values"};
  command.places = {
      {"a", "A.json", "A result of 'check --format json'", &options.a},
      {"b", "B.json|B.csv", "An earlier one, or a table of another program's or measured values",
       &options.b}};
  command.options = {
      {"--partial", "",
       "Compare only values that both sides have. What one side lacks is noted and is not an "
       "error. Requirements and verdicts are not compared",
       &options.is_partial},
      {"--tolerance", "SHARE",
       "Allow this difference besides the intervals, as 0.05 or 5% of B; default none",
       share_between(options.tolerance, 0.0, 1.0)},
      {"--distance", "METRES",
       "Treat points within this distance as the same, in metres; default 0.01",
       positive_number(options.distance_m)},
      {"--plane", "ID[=ID]",
       "Compare only this plane: its values, requirements and verdicts; repeatable. ID=ID where B "
       "has another id: values alone",
       [&options](const std::string& text) -> std::string {
         const std::size_t equals = text.find('=');
         if (text.empty() || equals == 0 || equals + 1 == text.size()) {
           return "a plane's id is needed, or two with '=' between";
         }
         options.planes.push_back(text);
         return "";
       },
       true},
      {"--worst", "N", "Name N points, largest difference first, 0 to 1000; default 5",
       whole_number(options.worst, 0, 1000)}};
  add(command.options,
      data_format_options(
          options.outputs,
          "text, csv (all points), json, html or markdown; default text. It is repeatable. Without "
          "FILE, or with '-', it goes to standard output, which takes one kind only",
          true));
  add(command.options, page_options(options.page, "html"));
  add(command.options, {quiet_option(options.quiet)});
  command.notes =
      "For two results the differences of requirements and verdicts come first, as 'check\n"
      "--baseline' prints them: what became worse, what is required less, and what changed in the\n"
      "input. Projects are matched by path, else by name, and planes by their ids.\n\n"
      "A table has a line of names, then one line per point. Columns are 'plane,column,row' or\n"
      "'x,y,z' (m, with or without 'plane'), and 'lx' or 'fc'. Others are optional: 'error_lx' or\n"
      "'error_fc', a standard error, or 'low_lx,high_lx'; and 'quantity', as planar. 'points.csv'\n"
      "of 'check' is such a table.\n\n"
      "Values are maintained illuminances at full output. Ratings and ratios are named and\n"
      "omitted.\n\n"
      "All points are judged together, and so is the average of each plane. The average shows a\n"
      "common bias that no single point shows. An average without a known interval (--partial, "
      "some\n"
      "points) is not judged.";
  command.examples = {
      {"luxgate compare result.json measured.csv --tolerance 10% --format html=c.html",
       "A result against measured values, with a page of all differences"}};
  command.exit_codes = {
      {0, "values agree within intervals and tolerance, and requirements and verdicts are as in B"},
      {1, "they do not"},
      {2, "an error"}};
  command.complete = [&options](const Environment&) {
    return data_output_problem(options.outputs);
  };
  return command;
}

}  // namespace cli
