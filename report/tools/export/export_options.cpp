#include "report/tools/export/export_options.h"

#include "report/shell/option_values.h"

#include <fmt/format.h>

namespace cli {

namespace {

// "" = nothing is wrong.
std::string export_contradiction(const ExportOptions& options) {
  if (options.target == kGltf && !options.scene.empty()) {
    return "--scene is for radiance: a model has the light of full output";
  }
  return options.folder.empty() ? "-o FOLDER is needed" : "";
}

}  // namespace

Command export_syntax(ExportOptions& options) {
  Command command{
      "export", "Write a project as a scene of Radiance, or rooms with their light as glTF models"};
  command.places = {{"target",
                     fmt::format("{}|{}", kRadiance, kGltf),
                     "What to write",
                     &options.target,
                     true,
                     {kRadiance, kGltf}},
                    project_place(options.project)};
  command.options = {
      {"--force", "", "Replace files of an earlier export", &options.overwrites},
      {"-o,--output", "FOLDER", "Where to; needed, made if needed", some_text(options.folder)},
      jobs_option(options.jobs, "a model"),
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
      "is linear between the corners of a mesh, and no verdict. --seed and --jobs are for it.";
  command.examples = {
      {"luxgate export radiance office.xml -o office-radiance",
       "Then: office-radiance/run.sh && luxgate compare result.json office-radiance/radiance.csv"},
      {"luxgate export gltf office.xml -o models", "A model of every room"}};
  command.exit_codes = {{0, "written"}, {2, "an error"}};
  command.complete = [&options](const Environment&) { return export_contradiction(options); };
  return command;
}

}  // namespace cli
