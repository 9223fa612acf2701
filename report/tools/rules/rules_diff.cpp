#include "report/tools/rules/rules_diff.h"

#include "calc/base/diagnostic_ids.h"
#include "report/check/load_rules.h"
#include "report/check/settings.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/interrupt.h"
#include "report/shell/process/print.h"
#include "report/tools/check/check_setup.h"
#include "report/tools/rules/diff_text.h"
#include "report/tools/rules/pack_words.h"
#include "report/tools/rules/project_effect.h"
#include "rules/pack/pack_diff.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

namespace cli {
namespace {

struct DiffOptions {
  std::string before, after;  // names of packs, or files
  std::vector<std::string> rows;
  bool as_json = false;
  std::string project;  // "" = none
  CheckOptions check;   // of the project; its rule_files are --rules
};

bool is_file(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

// A pack that is loaded, or else of a file. Empty after an error, which is reported.
std::optional<rules::RulePack> find_or_read(const std::string& name,
                                            const std::vector<rules::RulePack>& packs,
                                            const calc::FileReader& files,
                                            calc::Diagnostics& diagnostics) {
  const rules::NamedPack found = find_pack(name, packs, diagnostics);
  if (found.is_ambiguous()) return std::nullopt;
  if (found.pack != nullptr) return *found.pack;
  if (!is_file(name)) {
    diagnostics.report(
        calc::DiagnosticId::rule_import, {},
        fmt::format("there is no rule pack and no file '{}'; packs: {}", name, joined_ids(packs)));
    return std::nullopt;
  }
  const calc::FileContent content = files.read(name);
  if (!content.ok()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {name, 0, 0}, name, content.error);
    return std::nullopt;
  }
  return rules::parse_rule_pack(content.bytes, name, diagnostics);
}

ExitCode run_diff(const DiffOptions& asked, const RunContext& context) {
  DiffOptions options = asked;
  if (!options.project.empty()) {
    options.check.input.projects = {options.project};
    options.check.settings.today = check::day_of(options.check.settings);
    CheckOptions places = options.check;  // with the files of packs, which are read, too
    for (const std::string& name : {options.before, options.after}) {
      if (is_file(name)) places.input.rule_files.push_back(name);
    }
    if (!enter_sandbox_or_print(places, context)) return kNotJudged;
  }
  const calc::DiskFileReader files;
  calc::Diagnostics diagnostics;
  const auto packs = check::load_rule_packs(options.check.input.rule_files, files, diagnostics);
  const auto before = find_or_read(options.before, packs, files, diagnostics);
  const auto after = find_or_read(options.after, packs, files, diagnostics);
  rules::ReadRowNames rows;
  if (before && after) rows = rules::read_row_names(options.rows, *before, *after);
  if (!rows.problem.empty()) {
    diagnostics.report(calc::DiagnosticId::rule_import, {}, "--rows: " + rows.problem);
  }
  if (diagnostics.has_errors()) return print_outcome({kNotJudged, "", diagnostics.all()});
  ShownDiff diff{*before, *after, rules::diff_of(*before, *after, rows.names), std::nullopt};
  ExitCode code = diff.parts.empty() ? kAllMet : kNotMet;
  if (!options.project.empty()) {
    diff.effect = check_with_both(options.check, context, {*before, *after, rows.names});
    if (interrupted()) return kInterrupted;
    if (!diff.effect) code = kNotJudged;
  }
  return print_outcome({code, options.as_json ? diff_json(diff) : printable_lines(diff_text(diff)),
                        diagnostics.all()});
}

}  // namespace

Command diff_action() {
  const auto options = std::make_shared<DiffOptions>();
  Command command{"diff", "Print how two rule packs differ, and what that changes in a project"};
  command.places = {{"a", "A", "A pack: its id, or id:edition, or a file", &options->before},
                    {"b", "B", "Another one", &options->after}};
  command.options = {
      {"--rows", "FROM=TO",
       "Compare row FROM of A with row TO of B, which has another number; repeatable",
       one_more(options->rows), true},
      {"--project", "FILE",
       "Check this project with A and with B, and print which limits and verdicts change. The "
       "project may name either of them",
       some_text(options->project)},
      rules_option(options->check.input.rule_files),
      jobs_option(options->check.settings.radiosity.jobs)};
  add(command.options, text_or_json_options(options->as_json));
  command.notes =
      "[stricter] and [easier] describe a single change, with everything else as in A or as in B.\n"
      "They are printed only where that is certain.";
  command.examples = {{"luxgate rules diff en12464-1:2011 en12464-1:2021 --project office.xml",
                       "What another edition changes in a project"}};
  command.exit_codes = {
      {kAllMet, "the packs are equal"},
      {kNotMet, "they differ; verdicts of --project change no code"},
      {kNotJudged,
       "at least one error, also one that leaves the project unread or not calculated with one of "
       "them"},
      {kInterrupted, "interrupted"}};
  command.complete = [options](const Environment& environment) -> std::string {
    std::string date;
    const std::string problem = take_source_date(environment.source_date_epoch, date);
    options->check.settings.today = day_of_moment(date);
    return problem;
  };
  command.run = [options](const RunContext& context) { return run_diff(*options, context); };
  return command;
}

}  // namespace cli
