#include "report/tools/vpl/vpl_options.h"

#include "calc/base/text.h"
#include "report/shell/command/option_values.h"

#include <algorithm>
#include <filesystem>

namespace cli {

bool is_exr(const std::string& file) {
  return calc::ascii_lowered(std::filesystem::path(file).extension().string()) == ".exr";
}

namespace {

// "" = nothing is wrong.
std::string vpl_contradiction(const VplOptions& options) {
  if (options.output.empty() && options.view.empty()) {
    return "-o FILE.ply is needed, or --view OUT.png";
  }
  if (options.gl_device >= 0 && options.view.empty()) return "--gl-device is for --view";
  if (options.view.empty() || is_exr(options.view)) return "";
  const std::string ending = std::filesystem::path(options.view).extension().string();
  return ending == ".png" || ending == ".PNG"
             ? ""
             : "--view: a name that ends in .png or .exr is needed";
}

}  // namespace

Command vpl_syntax(VplOptions& options) {
  calc::RadiositySettings& settings = options.radiosity;
  Command command{"vpl", "Trace the light vertices of a space and write them as a PLY file"};
  command.places = {project_place(options.project)};
  command.options = {
      {"-o,--output", "FILE.ply",
       "Write the light vertices into this file, never over an input. This or --view is needed",
       some_text(options.output)},
      {"--view", "OUT.png|.exr",
       "Draw the room with its light vertices as dots, by OpenGL. The area of a dot shows its "
       "flux. The picture has one replicate of the first round: its first 1024 paths, or --paths "
       "if that is less",
       some_text(options.view)},
      {"--gl-device", "N",
       "Choose the OpenGL device for --view; default the one that draws sooner. 'luxgate devices' "
       "lists them",
       whole_number(options.gl_device, 0, 1000)},
      {"--paths", "N", "Trace N light paths in each replicate, a power of two; default 4096",
       power_of_two(settings.max_paths, 16, calc::kMostPaths)},
      {"--replicates", "N",
       "Repeat the tracing N times, 1 to 64; default 16. 'check --vpl' needs at least 4 for its "
       "intervals",
       whole_number(settings.replicates, 1, 64)},
      seed_option(settings.seed),
      allow_option(options.allowed),
      space_option(options.space),
      jobs_option(settings.jobs, "the file")};
  command.examples = {
      {"luxgate vpl office.xml -o office.ply", "For any mesh viewer, and for 'check --vpl'"},
      {"luxgate vpl office.xml --space room --view room.png", "A picture with them as dots"}};
  command.exit_codes = {{0, "written"}, {2, "an error"}};
  command.complete = [&options](const Environment&) { return vpl_contradiction(options); };
  return command;
}

}  // namespace cli
