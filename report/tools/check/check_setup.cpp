#include "report/tools/check/check_setup.h"

#include "report/check/check_project.h"
#include "report/check/plan.h"
#include "report/git/repository_places.h"
#include "report/shell/open_backend.h"
#include "report/shell/outputs.h"
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

std::vector<check::ProjectPlan> plans_of(const CheckOptions& options,
                                         const std::vector<rules::RulePack>& packs,
                                         const calc::FileReader& files) {
  return check::plan_projects(options.input.projects, files, packs, options.settings.radiosity,
                              options.settings.today, options.settings.budget,
                              options.settings.selection);
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

std::optional<CheckSetup> set_up_or_print(const CheckOptions& options, const RunContext& context,
                                          const calc::FileReader& files) {
  auto packs = load_packs_or_print(options.input.rule_files, files);
  if (!packs) return std::nullopt;
  const calc::RadiositySettings& radiosity = options.settings.radiosity;
  check::Hardware hardware(context.gl_fault, context.environment.program_folder);
  std::optional<calc::DrawingWork> pictures;
  check::BackendChoice backend =
      check::choose_backend(options.backend, radiosity.shadow_map_texels, hardware, [&] {
        const std::vector<check::ProjectPlan> plans = plans_of(options, *packs, files);
        pictures = picture_work(plans);
        return first_look_work(plans, radiosity);
      });
  std::optional<check::OpenBackend> opened = open_or_complain(
      backend, context.gl_fault, context.environment.program_folder, options.output.quiet);
  if (!opened) return std::nullopt;
  const check::Crew crew{radiosity.jobs, check::most_at_once(options.settings, backend.backend)};
  return CheckSetup{*std::move(packs),   std::move(backend),
                    *std::move(opened),  crew,
                    std::move(hardware), pictures};
}

check::DrawingChoice choose_for_pictures(const CheckOptions& options, const calc::FileReader& files,
                                         CheckSetup& setup) {
  const gpu::DeviceThread* const open = setup.opened.device.get();
  return check::choose_for_pictures(open == nullptr ? nullptr : &open->device(),
                                    options.backend.gl_device >= 0, setup.hardware, [&] {
                                      if (!setup.pictures)
                                        setup.pictures =
                                            picture_work(plans_of(options, setup.packs, files));
                                      return *setup.pictures;
                                    });
}

}  // namespace cli
