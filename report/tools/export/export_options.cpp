#include "report/tools/export/export_options.h"

#include "report/shell/command/option_values.h"

#include <fmt/format.h>

namespace cli {

namespace {

// "" = nothing is wrong.
std::string export_contradiction(const ExportOptions& options) {
  if (options.target == kIfc) {
    if (options.results.empty()) return "--results RESULT.json is needed: what goes into the model";
    if (options.output.empty()) return "-o NEW.ifc is needed";
    const bool is_plain = options.scene.empty() && options.space.empty() &&
                          options.rule_files.empty() && options.allowed.empty();
    return is_plain ? "" : "ifc takes --results, -o and --force alone: nothing is calculated";
  }
  if (!options.results.empty()) return "--results is for ifc: all else is made from a project";
  if (options.target == kGltf && !options.scene.empty()) {
    return "--scene is for radiance: a model has the light of full output";
  }
  return options.output.empty() ? "-o FOLDER is needed" : "";
}

}  // namespace

Command export_syntax(ExportOptions& options) {
  Command command{"export", "Write Radiance or glTF files, or results into an IFC model"};
  command.places = {{"target",
                     fmt::format("{}|{}|{}", kRadiance, kGltf, kIfc),
                     "What to write",
                     &options.target,
                     true,
                     {kRadiance, kGltf, kIfc}},
                    {"source", "PROJECT.xml|MODEL.ifc",
                     "The project; for ifc the model that it was begun from", &options.project}};
  command.options = {
      {"--force", "", "Replace files of an earlier export", &options.overwrites},
      {"-o,--output", "FOLDER|FILE", "Where to, made if needed; for ifc the new file. Needed",
       some_text(options.output)},
      jobs_option(options.jobs, "a model"),
      {"--results", "RESULT.json", "Of ifc: what 'check --format json' wrote; needed",
       some_text(options.results)},
      {"--scene", "ID", "Of radiance: luminaires at the levels of this scene; else at full output",
       some_text(options.scene)},
      seed_option(options.seed),
      {"--space", "ID",
       "Which space; radiance needs it if there are several, gltf takes all without it",
       some_text(options.space)},
      rules_option(options.rule_files),
      allow_option(options.allowed)};
  command.notes =
      "radiance writes a scene that Radiance calculates as it is: materials, surfaces, luminaires\n"
      "with their photometry, the points of all planes of illuminance (those of workplaces too), "
      "a\n"
      "script and a README.md. Planes of cylindrical, semicylindrical, hemispherical and scalar\n"
      "illuminance are sums over directions; ratings and ratios are left out, with a message.\n\n"
      "gltf writes ROOM.glb of every room, or of that of --space: a model that any viewer opens,\n"
      "with the maintained illuminance of the surfaces as colours on the scale of all that are\n"
      "written, and as numbers (_ILLUMINANCE_LX), luminaires, planes and legend. For pictures: it\n"
      "is linear between the corners of a mesh, and no verdict. --seed and --jobs are for it.\n\n"
      "ifc writes a copy of the model (IFC 2x3 or 4) with the results as property sets of its\n"
      "rooms: Luxgate_Results, and Luxgate_Plane_ID of each plane, with verdicts in words and\n"
      "values with their intervals; Luxgate_Run of the project with warnings. All else stays byte\n"
      "for byte. Rooms are found by the GlobalId in the ids that 'import' gave. What an earlier\n"
      "export has added is replaced.";
  command.examples = {
      {"luxgate export radiance office.xml -o office-radiance",
       "Then: office-radiance/run.sh && luxgate compare result.json office-radiance/radiance.csv"},
      {"luxgate export gltf office.xml -o models", "A model of every room"}};
  command.exit_codes = {{0, "written"},
                        {1,
                         "ifc: written, but some results have no place in the model, or its rooms "
                         "changed"},
                        {2, "an error"}};
  command.complete = [&options](const Environment&) { return export_contradiction(options); };
  return command;
}

}  // namespace cli
