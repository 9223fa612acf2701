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
       "Compare the values that both have; what one lacks is noted, no error. Questions and\n"
       "verdicts are not compared then",
       &options.is_partial},
      {"--tolerance", "SHARE",
       "Difference allowed besides the intervals, as 0.05 or 5% of B; default none",
       share_between(options.tolerance, 0.0, 1.0)},
      {"--distance", "METRES", "Points this near to each other are the same; default 0.01",
       positive_number(options.distance_m)},
      {"--plane", "ID[=ID]",
       "Only this plane: its values, and what is asked and judged of it.\n=ID where B calls it so: "
       "values "
       "alone; may be repeated",
       [&options](const std::string& text) -> std::string {
         const std::size_t equals = text.find('=');
         if (text.empty() || equals == 0 || equals + 1 == text.size()) {
           return "a plane's id is needed, or two with '=' between";
         }
         options.planes.push_back(text);
         return "";
       },
       true},
      {"--worst", "N", "Points to name, furthest apart first; default 5",
       whole_number(options.worst, 0, 1000)}};
  add(command.options,
      data_format_options(
          options.outputs,
          "text, csv (all points), json, html or markdown, to FILE or (one kind only) to standard\n"
          "output; default text; may be repeated",
          true));
  add(command.options, page_options(options.page, "html"));
  add(command.options, {quiet_option(options.quiet)});
  command.notes =
      "Of two results, the first thing said is what is judged and asked otherwise than in B, as\n"
      "'check --baseline' says it: what became worse, what is asked for less, what has changed in\n"
      "the input. Projects are matched by path, else by name; planes by their ids.\n\n"
      "A table has a line of names, then one line per point: 'plane,column,row' or 'x,y,z' (m)\n"
      "with or without 'plane'; 'lx' or 'fc'; perhaps 'error_lx' or 'error_fc', a standard error,\n"
      "or 'low_lx,high_lx'; perhaps 'quantity', as planar. 'points.csv' of 'check' is one.\n\n"
      "Values are maintained illuminances at full output. Ratings and ratios are named and left\n"
      "out.\n\n"
      "Points are judged, all together, and each plane's average, which shows a common bias that\n"
      "no point does; an average whose interval is not known (--partial, some points) is not\n"
      "judged.";
  command.examples = {
      {"luxgate compare result.json measured.csv --tolerance 10% --format html=c.html",
       "A result against measured values, with a page of all differences"}};
  command.exit_codes = {
      {0, "values are alike within intervals and tolerance, and all is asked and judged as in B"},
      {1, "they are not"},
      {2, "an error"}};
  command.complete = [&options](const Environment&) {
    return data_output_problem(options.outputs);
  };
  return command;
}

}  // namespace cli
