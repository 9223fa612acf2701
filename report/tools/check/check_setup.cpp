#include "report/tools/check/check_setup.h"

#include "report/check/check_project.h"
#include "report/check/plan.h"
#include "report/shell/open_backend.h"

#include <utility>

namespace cli {

std::optional<CheckSetup> set_up_or_print(const CheckOptions& options, const RunContext& context,
                                          const calc::FileReader& files) {
  auto packs = load_packs_or_print(options.input.rule_files, files);
  if (!packs) return std::nullopt;
  const calc::RadiositySettings& radiosity = options.settings.radiosity;
  check::BackendChoice backend =
      check::choose_backend(options.backend, radiosity.shadow_map_texels, context.gl_fault, [&] {
        return first_look_work(check::plan_projects(options.input.projects, files, *packs,
                                                    radiosity, options.settings.today,
                                                    options.settings.budget));
      });
  std::optional<check::OpenBackend> opened = open_or_complain(
      backend, context.gl_fault, context.environment.program_folder, options.output.quiet);
  if (!opened) return std::nullopt;
  const check::Crew crew{radiosity.jobs, check::most_at_once(options.settings, backend.backend)};
  return CheckSetup{*std::move(packs), std::move(backend), *std::move(opened), crew};
}

}  // namespace cli
