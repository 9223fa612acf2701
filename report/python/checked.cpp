#include "report/python/checked.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_reader.h"
#include "calc/radiosity/looks/solve.h"
#include "calc/store/entry_folder.h"
#include "report/check/check_project.h"
#include "report/check/load_rules.h"
#include "report/check/run.h"
#include "report/check/set_values.h"
#include "report/formats/format.h"
#include "report/result_file/read_json.h"
#include "report/result_file/redact.h"
#include "report/shell/command/option_values.h"
#include "report/shell/options/selection_option.h"
#include "report/shell/output/output_options.h"
#include "report/shell/output/warning_tally.h"
#include "report/shell/process/environment.h"
#include "report/text/one_source_note.h"
#include "report/tools/check/check_options.h"
#include "report/tools/check/checked_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>
#include <variant>

namespace python {
namespace {

// What is not here is about files, terminals, batches or revisions. An option that is new to the
// program is refused until somebody has put it here: nothing is taken and then not obeyed.
constexpr std::string_view kOfCheck[] = {
    "--rules",        "--allow",     "--set",       "--space",      "--plane",
    "--tag",          "--require",   "--goal",      "--tolerance",  "--confidence",
    "--by-luminaire", "--limit",     "--seed",      "--time-limit", "--replicates",
    "--max-paths",    "--jobs",      "--method",    "--visibility", "--clamp",
    "--no-skip",      "--backend",   "--gl-device", "--gpu-stages", "--store",
    "--strict",       "--timestamp", "--timing"};
constexpr std::string_view kOfValidate[] = {"--rules", "--allow", "--set", "--limit",
                                            "--timestamp"};
constexpr std::string_view kOfWrite[] = {
    "--language", "--decimal", "--paper",  "--detail", "--annex",     "--cover",   "--scale",
    "--palette",  "--redact",  "--passes", "--notes",  "--dxf-scale", "--dxf-unit"};

bool is_of(Use use, std::string_view name) {
  const auto has = [name](const auto& names) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
  };
  switch (use) {
    case Use::check:
      return has(kOfCheck);
    case Use::validate:
      return has(kOfValidate);
    case Use::write:
      break;
  }
  return has(kOfWrite);
}

// "" or what is wrong.
std::string apply(const cli::Option& option, const std::string& text) {
  if (bool* const* flag = std::get_if<bool*>(&option.target)) {
    **flag = true;
    return "";
  }
  return std::get<cli::ValueParser>(option.target)(text);
}

std::string apply(const std::vector<cli::Option>& options, Use use,
                  const std::vector<Setting>& settings) {
  std::vector<std::string_view> given;
  for (const Setting& setting : settings) {
    const auto option = std::find_if(
        options.begin(), options.end(),
        [&](const cli::Option& candidate) { return candidate.long_name() == setting.option; });
    if (option == options.end() || !is_of(use, setting.option)) {
      return setting.option + ": not offered";
    }
    for (const std::string& other : option->excludes) {
      if (std::find(given.begin(), given.end(), other) != given.end()) {
        return fmt::format("{} excludes {}", setting.option, other);
      }
    }
    given.push_back(setting.option);
    const std::string problem = apply(*option, setting.text);
    if (problem.empty()) continue;
    return setting.text.empty()
               ? fmt::format("{}: {}", setting.option, problem)
               : fmt::format("{}: '{}': {}", setting.option, setting.text, problem);
  }
  return "";
}

// The options of a check of one project, completed. `options` is what they say.
std::string read_settings(const std::string& path, Use use, const std::vector<Setting>& settings,
                          const cli::Environment& environment, cli::CheckOptions& options) {
  const cli::Command command = cli::check_syntax(options);
  options.input.projects = {path};
  const std::string problem = apply(command.options, use, settings);
  return problem.empty() ? command.complete(environment) : problem;
}

class Watcher : public check::Observer {
 public:
  explicit Watcher(const std::function<bool()>& goes_on) : goes_on_(goes_on) {}

  bool go_on(const calc::SolveProgress& /*progress*/) override { return goes_on_(); }
  bool is_stopped() const override { return !goes_on_(); }

 private:
  const std::function<bool()>& goes_on_;
};

Checked refused(std::string problem) { return {std::move(problem), std::nullopt, {}}; }
Checked refused(const calc::Diagnostics& diagnostics) {
  return {"", std::nullopt, diagnostics.all()};
}

void tell_of_store(const std::string& folder, const calc::StoreTroubles& troubles,
                   calc::Diagnostics& diagnostics) {
  if (troubles.unusable > 0) {
    diagnostics.report(calc::DiagnosticId::store_entry_unusable, {folder, 0, 0}, troubles.unusable,
                       troubles.unusable_why);
  }
  if (!troubles.not_written.empty()) {
    diagnostics.report(calc::DiagnosticId::store_not_written, {folder, 0, 0}, troubles.not_written);
  }
}

}  // namespace

std::vector<OfferedOption> offered_options(Use use) {
  cli::CheckOptions targets;
  std::vector<OfferedOption> offered;
  for (const cli::Option& option : cli::check_syntax(targets).options) {
    const std::string name = option.long_name();
    if (!is_of(use, name)) continue;
    const bool is_flag = std::holds_alternative<bool*>(option.target) ||
                         (option.value_name.empty() && !option.may_have_value);
    offered.push_back(
        {name, option.value_name, option.help, is_flag, option.may_have_value, option.repeats});
  }
  return offered;
}

std::vector<std::string> known_options() {
  cli::CheckOptions targets;
  std::vector<std::string> names;
  for (const cli::Option& option : cli::check_syntax(targets).options) {
    names.push_back(option.long_name());
  }
  return names;
}

Checked check(const std::string& path, const std::vector<Setting>& settings,
              const std::function<bool()>& goes_on) {
  const cli::Environment environment = cli::read_environment();
  cli::CheckOptions options;
  if (std::string problem = read_settings(path, Use::check, settings, environment, options);
      !problem.empty()) {
    return refused(std::move(problem));
  }
  if (std::string problem = problem_with(options.settings); !problem.empty()) {
    return refused(std::move(problem));
  }
  const calc::DiskFileReader disk(options.input.allowed);
  const check::SetReader files(disk, options.input.projects, options.set);
  calc::Diagnostics diagnostics;
  if (!options.set.empty()) {
    check::check_values(options.input.projects, options.set, "set", disk, diagnostics);
    if (diagnostics.has_errors()) return refused(diagnostics);
  }
  std::vector<rules::RulePack> packs =
      check::load_rule_packs(options.input.rule_files, files, diagnostics);
  if (diagnostics.has_errors()) return refused(diagnostics);
  std::optional<check::Run> run =
      check::Run::open({options.settings, std::move(packs), options.backend,
                        environment.program_folder, gpu::Fault::none, nullptr},
                       files, options.input.projects, diagnostics);
  if (!run) return refused(diagnostics);
  std::shared_ptr<calc::EntryFolder> folder;
  if (!options.store.empty()) {
    folder = std::make_shared<calc::EntryFolder>(options.store);
    run = run->with_light_in(folder);
  }

  Watcher watcher(goes_on);
  report::ProjectPart part = run->check(path, watcher);
  cli::tell_set_values(options.set, part);
  if (report::is_nothing_chosen(part)) {
    diagnostics.report(calc::DiagnosticId::selection_empty, {},
                       check::selection_words(options.settings.selection));
    return refused(diagnostics);
  }
  if (options.strict.names(calc::DiagnosticId::one_source)) report::warn_of_one_source(part);
  part.strict_warnings = cli::WarningTally(options.strict).add(part.diagnostics);
  if (folder) tell_of_store(options.store, folder->troubles(), diagnostics);

  report::Document document;
  document.provenance = cli::provenance_of(options, *run);
  document.projects.push_back(std::move(part));
  cli::complete_provenance(document.provenance, totals_of(document), *run);
  return {"", std::move(document), diagnostics.all()};
}

Checked validate(const std::string& path, const std::vector<Setting>& settings) {
  cli::CheckOptions options;
  if (std::string problem =
          read_settings(path, Use::validate, settings, cli::read_environment(), options);
      !problem.empty()) {
    return refused(std::move(problem));
  }
  const calc::DiskFileReader disk(options.input.allowed);
  const check::SetReader files(disk, options.input.projects, options.set);
  calc::Diagnostics diagnostics;
  if (!options.set.empty()) {
    check::check_values(options.input.projects, options.set, "set", disk, diagnostics);
  }
  const std::vector<rules::RulePack> packs =
      check::load_rule_packs(options.input.rule_files, files, diagnostics);
  if (diagnostics.has_errors()) return refused(diagnostics);
  report::Document document;
  document.projects.push_back(check::validate_project(path, files, packs, day_of(options.settings),
                                                      options.settings.budget));
  cli::tell_set_values(options.set, document.projects.front());
  return {"", std::move(document), diagnostics.all()};
}

Checked read_result_bytes(const std::string& path, const std::string& bytes) {
  calc::Diagnostics diagnostics;
  std::string problem;
  std::optional<report::Document> document = report::read_json(bytes, problem);
  if (!document) {
    diagnostics.report(calc::DiagnosticId::result_not_readable, {path, 0, 0}, path, problem);
  }
  return {"", std::move(document), diagnostics.all()};
}

Checked read_result(const std::string& path) {
  const calc::FileContent content = calc::DiskFileReader().read(path);
  if (content.ok()) return read_result_bytes(path, content.bytes);
  calc::Diagnostics diagnostics;
  diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
  return refused(diagnostics);
}

std::string rendered(const report::Document& document, const std::string& name,
                     const std::vector<Setting>& settings, std::string& problem) {
  const report::Format* format = report::find_format(name);
  if (format == nullptr || format->is_printed) {
    std::vector<std::string_view> names;
    for (const report::Format& known : report::formats()) {
      if (!known.is_printed) names.push_back(known.name);
    }
    problem = fmt::format("format '{}': {}{}", name, cli::one_of_message(name, names),
                          format == nullptr ? ""
                                            : "; what is printed is made by 'luxgate report' of "
                                              "the json");
    return "";
  }
  cli::CheckOptions options;
  problem = apply(cli::check_syntax(options).options, Use::write, settings);
  if (!problem.empty()) return "";
  report::FormatStyle style;
  style.texts = cli::report_texts(options.output);
  style.page = options.output.page;
  style.terminal.lists_passes = options.output.lists_passes;
  style.terminal.shows_notes = options.output.shows_notes;
  if (!options.output.redact) return format->render(document, style);
  report::Document redacted = document;
  report::redact(redacted);
  return format->render(redacted, style);
}

}  // namespace python
