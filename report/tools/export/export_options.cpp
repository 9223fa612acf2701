#include "report/tools/export/export_options.h"

#include "report/shell/option_values.h"

namespace cli {

namespace {

// "" = nothing is wrong.
std::string export_contradiction(const ExportOptions& options) {
  if (options.target != "radiance") {
    return one_of_message(options.target, {"radiance"});
  }
  return options.folder.empty() ? "-o FOLDER is needed" : "";
}

}  // namespace

Command export_syntax(ExportOptions& options) {
  Command command{"export", "Write a project as a scene for another program (Radiance)"};
  command.places = {{"target", "radiance", "The program to write for", &options.target},
                    project_place(options.project)};
  command.options = {
      {"--force", "", "Replace files of an earlier export", &options.overwrites},
      {"-o,--output", "FOLDER", "Where to; needed, made if needed", some_text(options.folder)},
      space_option(options.space),
      rules_option(options.rule_files),
      allow_option(options.allowed)};
  command.footer =
      "Writes a scene that Radiance calculates as it is: materials, surfaces, luminaires with "
      "their\n"
      "photometry, the points of all planes of planar illuminance (those of workplaces too), a "
      "script and a README.md.\n"
      "Example: luxgate export radiance office.xml -o office-radiance\n"
      "         office-radiance/run.sh && luxgate compare result.json "
      "office-radiance/radiance.csv\n"
      "Exit codes: 0 written, 2 an error.";
  command.complete = [&options](const Environment&) { return export_contradiction(options); };
  return command;
}

}  // namespace cli
