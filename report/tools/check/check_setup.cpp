#include "report/tools/check/check_setup.h"

#include "report/git/repository_places.h"
#include "report/shell/options/open_backend.h"
#include "report/shell/output/outputs.h"
#include "report/shell/process/print.h"
#include "report/tools/pictures/room_pictures.h"

#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace cli {
namespace {

namespace fs = std::filesystem;

// Each folder of projects is asked once.
std::vector<std::string> places_of_repositories(const std::vector<std::string>& projects,
                                                const Environment& environment) {
  std::vector<std::string> places;
  std::set<std::string> known;
  for (const std::string& project : projects) {
    if (!known.insert(fs::path(project).parent_path().string()).second) continue;
    for (std::string& place :
         git::repository_places(project, {environment.git_dir, environment.git_work_tree})) {
      places.push_back(std::move(place));
    }
  }
  return places;
}

// Whether shaders may be compiled: on a GPU, or by software for pictures and on demand.
bool may_compile(const CheckOptions& options) {
  if (options.backend.backend == check::Backend::gpu) return true;
  if (options.settings.radiosity.shadow_map_texels > 0) return true;
  if (options.pictures && wants_pictures(options.output)) return true;
  std::error_code ignored;
  return options.backend.backend == check::Backend::automatic &&
         (fs::exists("/dev/dri", ignored) || fs::exists("/dev/nvidiactl", ignored));
}

}  // namespace

bool enter_sandbox_or_print(CheckOptions& options, const RunContext& context) {
  if (options.sandbox == SandboxMode::off) return true;
  const Environment& environment = context.environment;
  SandboxRules rules{places_of(options.input), written_rooms(options.output)};
  for (const std::string* file :
       {&options.policy, &options.baseline, &options.vpl_file, &options.batch.units_file}) {
    if (!file->empty()) rules.read.push_back(*file);
  }
  if (!options.against.empty()) {
    for (std::string& place : places_of_repositories(options.input.projects, environment)) {
      rules.read.push_back(std::move(place));
    }
  }
  if (!options.store.empty()) rules.write.push_back(options.store);
  if (!environment.program_folder.empty() && may_compile(options)) {
    // They are made now, or else whatever is in the user's folder could be written.
    const fs::path drivers = fs::path(environment.program_folder) / "drivers";
    std::error_code failure;
    fs::create_directories(drivers, failure);
    if (!failure) {
      rules.write.push_back(environment.program_folder);
      rules.driver_folder = drivers.string();
    }
  }
  open_spill_files(options.output);
  return enter_sandbox_or_print(options.sandbox, rules, environment);
}

std::optional<check::Run> open_run_or_print(const CheckOptions& options, const RunContext& context,
                                            const calc::FileReader& files, SeePlans planned) {
  auto packs = load_packs_or_print(options.input.rule_files, files);
  if (!packs) return std::nullopt;
  return open_run_or_print(options, context, files, *std::move(packs), std::move(planned));
}

std::optional<check::Run> open_run_or_print(const CheckOptions& options, const RunContext& context,
                                            const calc::FileReader& files,
                                            std::vector<rules::RulePack> packs, SeePlans planned) {
  calc::Diagnostics diagnostics;
  std::optional<check::Run> run =
      check::Run::open({options.settings, std::move(packs), options.backend,
                        context.environment.program_folder, context.gl_fault, std::move(planned)},
                       files, options.input.projects, diagnostics);
  print_diagnostics(diagnostics.all(), options.output.quiet);
  return run;
}

}  // namespace cli
