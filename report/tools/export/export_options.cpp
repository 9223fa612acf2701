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
    return is_plain ? "" : "ifc takes only --results, -o and --force: it calculates nothing";
  }
  if (!options.results.empty()) return "--results is for ifc; the other formats need a project";
  if (options.target == kGltf && !options.scene.empty()) {
    return "--scene is for radiance: a model has the light of full output";
  }
  return options.output.empty() ? "-o FOLDER is needed" : "";
}

}  // namespace

Command export_syntax(ExportOptions& options) {
  Command command{"export", "Write Radiance or glTF files, or results into an IFC model"};
  command.places = {
      {"target",
       fmt::format("{}|{}|{}", kRadiance, kGltf, kIfc),
       "What to write",
       &options.target,
       true,
       {kRadiance, kGltf, kIfc}},
      {"source", "PROJECT.xml|MODEL.ifc",
       "The project, or with ifc the model from which it was imported", &options.project}};
  command.options = {
      {"--force", "", "Replace files of an earlier export", &options.overwrites},
      {"-o,--output", "FOLDER|FILE",
       "Write into this folder, or with ifc into this new file; needed. It is made if needed",
       some_text(options.output)},
      jobs_option(options.jobs, "a model"),
      {"--results", "RESULT.json",
       "Write the results of this file, with ifc; needed. 'check --format json' wrote it",
       some_text(options.results)},
      {"--scene", "ID",
       "Set luminaires to the levels of this scene, with radiance; default full output",
       some_text(options.scene)},
      seed_option(options.seed),
      {"--space", "ID",
       "Choose the space by its id. radiance needs it if there are several; gltf writes all "
       "without it",
       some_text(options.space)},
      rules_option(options.rule_files),
      allow_option(options.allowed)};
  command.notes =
      "radiance writes a scene that Radiance can calculate: materials, surfaces, luminaires with\n"
      "their photometry, the points of all planes of illuminance, a script and a README.md. "
      "Planes\n"
      "of cylindrical, semicylindrical, hemispherical and scalar illuminance are sums over\n"
      "directions. Ratings and ratios are omitted, with a message.\n\n"
      "gltf writes ROOM.glb for every room, or for the one of --space: a model that any viewer\n"
      "opens. It has luminaires, planes and a legend. Surfaces show the maintained illuminance as\n"
      "colours, on one scale for all files, and as numbers (_ILLUMINANCE_LX). Values are linear\n"
      "between the corners of a mesh: they are for pictures, not for verdicts. --seed and --jobs\n"
      "apply to gltf.\n\n"
      "ifc writes a copy of the model (IFC 2x3 or 4) with the results as property sets of its\n"
      "rooms: Luxgate_Results, and Luxgate_Plane_ID for each plane. They have verdicts in words "
      "and\n"
      "values with their intervals. Luxgate_Run of the project has the warnings. All other bytes\n"
      "stay as they are. Rooms are found by the GlobalId in the ids that 'import' gave. Results "
      "of\n"
      "an earlier export are replaced.";
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
