#include "report/tools/plan/plan.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_reader.h"
#include "report/check/set_values.h"
#include "report/check/settings.h"
#include "report/shell/command/option_values.h"
#include "report/shell/options/open_backend.h"
#include "report/shell/options/project_reader.h"
#include "report/shell/options/selection_option.h"
#include "report/shell/process/print.h"
#include "report/tools/pictures/room_pictures.h"
#include "report/tools/plan/units_list.h"
#include "rules/verdict/outcome.h"

#include <memory>

namespace cli {
namespace {

using rules::Outcome;

ExitCode run_plan(const PlanOptions& options, const RunContext& context) {
  if (!enter_sandbox_or_print(options.sandbox, {places_of(options.input), {}},
                              context.environment)) {
    return kNotJudged;
  }
  const ProjectReader disk(options.input);
  const check::SetReader files(disk, options.input.projects, options.set);
  if (!check_values_or_print(options.input, options.set, "set", disk)) return kNotJudged;
  const auto packs = load_packs_or_print(options.input.rule_files, files);
  if (!packs) return kNotJudged;
  Outcome outcome = Outcome::nothing_asked;
  WarningTally warnings(options.strict);
  const std::vector<check::ProjectPlan> plans =
      check::plan_projects(options.input.projects, files, *packs, options.radiosity,
                           check::day_or_today(day_of_moment(options.date)), options.budget,
                           options.selection, options.strict.names(calc::DiagnosticId::one_source));
  bool has_chosen = options.selection.is_all();
  for (const check::ProjectPlan& plan : plans) {
    print_diagnostics(plan.diagnostics, options.quiet);
    warnings.add(plan.diagnostics);
    if (!plan.is_planned) outcome = graver(outcome, Outcome::not_judged);
    has_chosen = has_chosen || !plan.is_planned || !plan.spaces.empty();
  }
  if (!has_chosen) {
    print_nothing_chosen(options.selection);
    outcome = graver(outcome, Outcome::not_judged);
  }
  check::Hardware hardware(context.gl_fault, context.environment.program_folder);
  const check::BackendChoice backend =
      check::choose_backend(options.backend, options.radiosity.shadow_map_texels, hardware,
                            [&] { return first_look_work(plans, options.radiosity); });
  const std::optional<check::OpenBackend> opened =
      open_or_complain(backend, context.gl_fault, "", options.quiet);
  if (!opened) outcome = graver(outcome, Outcome::not_judged);
  const check::DrawingChoice pictures = check::choose_for_pictures(
      opened && opened->device ? &opened->device->device() : nullptr,
      options.backend.gl_device >= 0, hardware, [&] { return picture_work(plans); });
  warnings.print(options.quiet);
  outcome = graver(outcome, warnings.outcome());
  if (options.as_units) {
    const std::vector<check::Unit> units = check::units_of(plans, options.radiosity);
    return print_outcome({exit_code_of(outcome),
                          options.as_json ? render_units_json(units) : render_units_text(units),
                          {}});
  }
  const std::string text = options.as_json
                               ? render_plan_json(plans, options.radiosity, backend, pictures)
                               : render_plan_text(plans, options.radiosity, backend, pictures);
  return print_outcome({exit_code_of(outcome), text, {}});
}

}  // namespace

Command plan_syntax(PlanOptions& options) {
  Command command{"plan", "Print what 'check' would do, omit and cost, without calculating"};
  options.input.takes_standard_input = true;
  command.places = {projects_place(options.input)};
  command.options = project_options(options.input);
  command.config = &options.input.config;
  add(command.options, {set_option(options.set), limit_option(options.budget)});
  add(command.options, selection_options(options.selection));
  add(command.options, work_options(options.radiosity));
  add(command.options, backend_options(options.backend));
  add(command.options, text_or_json_options(options.as_json));
  add(command.options,
      {{"--units",
        "",
        "List the jobs that machines can calculate separately, with predicted costs. 'luxgate "
        "check --shard' calculates them. A job is a room, or a plane of a large room",
        &options.as_units,
        false,
        {"--space", "--plane", "--tag", "--require"}},
       strict_option(options.strict),
       sandbox_option(options.sandbox),
       quiet_option_with_count(options.quiet)});
  command.examples = {
      {"luxgate plan office.xml", "Print what is proved to add nothing, and the cost of the rest"},
      {"luxgate plan designs/a.xml designs/b.xml --units --json",
       "List the jobs that machines can share"}};
  command.exit_codes = {{0, "no error"},
                        {2, "at least one error, or a warning that --strict makes count"}};
  command.most_used = {"--rules", "--backend", "--units", "--format",
                       "--json",  "--strict",  "--quiet"};
  command.complete_projects = [&options] { return complete_projects(options.input); };
  command.complete = [&options](const Environment& environment) {
    std::string problem = take_source_date(environment.source_date_epoch, options.date);
    return problem.empty() ? complete_work(options.radiosity, options.backend) : problem;
  };
  return command;
}

Command plan_command() {
  const auto options = std::make_shared<PlanOptions>();
  Command command = plan_syntax(*options);
  command.run = [options](const RunContext& context) { return run_plan(*options, context); };
  return command;
}

}  // namespace cli
