#include "report/tools/rules/rules.h"

#include "calc/base/text.h"
#include "calc/base/xml_reader.h"
#include "report/check/load_rules.h"
#include "report/shell/exit_code.h"
#include "report/shell/write.h"
#include "report/text/plain_text.h"
#include "report/tools/rules/explain.h"
#include "rules/pack/builtin_packs.h"
#include "rules/pack/import_rows.h"
#include "rules/pack/named_pack.h"
#include "rules/pack/rule_lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

namespace cli {
namespace {

// What a pack says may hold anything.
std::string printable_lines(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    result += report::printable(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

RulesRun finished(std::string out, const calc::Diagnostics& diagnostics) {
  RulesRun run;
  run.out = std::move(out);
  for (const calc::Diagnostic& diagnostic : diagnostics.all()) {
    run.err += calc::format_diagnostic(diagnostic) + "\n";
  }
  run.exit_code = diagnostics.has_errors() ? kNotJudged : kAllMet;
  return run;
}

std::string joined_ids(const std::vector<rules::RulePack>& packs) {
  calc::Names names;
  std::vector<std::string> ids;
  for (const rules::RulePack& pack : packs) ids.push_back(pack.full_id());
  for (const std::string& id : ids) names.emplace_back(id);
  return calc::join_choices(names);
}

// An ambiguous name is reported; one that is unknown is left to the caller.
rules::NamedPack find_pack(const std::string& name, const std::vector<rules::RulePack>& packs,
                           calc::Diagnostics& diagnostics) {
  rules::NamedPack found = rules::named_pack(name, packs);
  if (found.is_ambiguous()) {
    diagnostics.report(calc::DiagnosticId::ambiguous_rule_pack, {}, name, found.candidates);
  }
  return found;
}

std::string show(const Options& options, const std::vector<rules::RulePack>& packs,
                 calc::Diagnostics& diagnostics) {
  const rules::NamedPack found = find_pack(options.rules_command.pack, packs, diagnostics);
  if (found.is_ambiguous()) return {};
  if (found.pack != nullptr) return show_rule_pack(*found.pack);
  diagnostics.report(calc::DiagnosticId::rule_import, {},
                     fmt::format("there is no rule pack '{}'; allowed: {}",
                                 options.rules_command.pack, joined_ids(packs)));
  return {};
}

std::string lint(const Options& options, const calc::FileReader& files,
                 calc::Diagnostics& diagnostics) {
  std::string out;
  for (const std::string& path : rule_files(options.rules_command.files, diagnostics)) {
    const calc::FileContent content = files.read(path);
    if (!content.ok()) {
      diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
      continue;
    }
    const std::optional<rules::RulePack> pack =
        rules::parse_rule_pack(content.bytes, path, diagnostics);
    if (!pack) continue;
    rules::lint_rule_pack(*pack, diagnostics);
    out += fmt::format("{}: no error ({}: {} rows, {} checks)\n", path, pack->full_id(),
                       pack->rows.size(), pack->checks.size());
  }
  return out;
}

std::string import_table(const Options& options, const calc::FileReader& files,
                         calc::Diagnostics& diagnostics) {
  constexpr const char* kLike = "en12464-1:2021";
  const RulesOptions& rules_options = options.rules_command;
  if (!calc::is_id(rules_options.pack_id)) {
    diagnostics.report(calc::DiagnosticId::not_an_id, {}, "--id", "rules import",
                       rules_options.pack_id);
    return {};
  }
  const calc::FileContent csv = files.read(rules_options.csv);
  if (!csv.ok()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {rules_options.csv, 0, 0},
                       rules_options.csv, csv.error);
    return {};
  }
  std::error_code ignored;
  if (!rules_options.output.empty() &&
      std::filesystem::equivalent(rules_options.output, rules_options.csv, ignored)) {
    diagnostics.report(calc::DiagnosticId::output_not_possible, {},
                       fmt::format("'{}' is the table itself", rules_options.output));
    return {};
  }
  for (const std::string_view text : rules::builtin_pack_texts()) {
    calc::Diagnostics own;
    if (rules::parse_rule_pack(text, "built in", own)->full_id() != kLike) continue;
    const std::string name = std::filesystem::path(rules_options.csv).filename().string();
    const std::optional<std::string> pack =
        rules::import_rows(csv.bytes, name, text, rules_options.pack_id, diagnostics);
    if (!pack || rules_options.output.empty()) return pack.value_or("");
    const std::string problem = report::write_file_atomically(rules_options.output, *pack);
    if (!problem.empty()) {
      diagnostics.report(calc::DiagnosticId::output_not_possible, {},
                         fmt::format("cannot write '{}': {}", rules_options.output, problem));
      return {};
    }
    return fmt::format("Wrote {}. Next: luxgate rules lint {}\n", rules_options.output,
                       rules_options.output);
  }
  return {};
}

// "PACK/ROW", "PACK/ROLE", "PACK/CHECK" or the id of a message.
std::string explain(const std::string& what, const std::vector<rules::RulePack>& packs,
                    calc::Diagnostics& diagnostics) {
  const std::size_t slash = what.find('/');
  std::optional<std::string> text;
  if (slash == std::string::npos) {
    text = explain_message(what);
  } else {
    const rules::NamedPack found = find_pack(what.substr(0, slash), packs, diagnostics);
    if (found.is_ambiguous()) return {};
    if (found.pack != nullptr) text = explain_rule(*found.pack, what.substr(slash + 1));
  }
  if (!text) {
    diagnostics.report(calc::DiagnosticId::nothing_to_explain, {}, what,
                       "packs: ", joined_ids(packs));
  }
  return text.value_or("");
}

}  // namespace

RulesRun run_rules(const Options& options, const calc::FileReader& files) {
  calc::Diagnostics diagnostics;
  std::string out;
  switch (options.rules_command.action) {
    case RulesAction::list:
      out =
          printable_lines(list_rule_packs(load_rule_packs(options.rule_files, files, diagnostics)));
      break;
    case RulesAction::show:
      out = printable_lines(
          show(options, load_rule_packs(options.rule_files, files, diagnostics), diagnostics));
      break;
    case RulesAction::lint:
      out = printable_lines(lint(options, files, diagnostics));
      break;
    case RulesAction::import_rows:
      out = import_table(options, files, diagnostics);
      break;
    case RulesAction::schema:
      out = std::string(rules::rule_pack_schema());
      break;
  }
  return finished(std::move(out), diagnostics);
}

RulesRun run_explain(const Options& options, const calc::FileReader& files) {
  calc::Diagnostics diagnostics;
  const std::vector<rules::RulePack> packs =
      load_rule_packs(options.rule_files, files, diagnostics);
  std::string out = printable_lines(explain(options.rules_command.explained, packs, diagnostics));
  return finished(std::move(out), diagnostics);
}

}  // namespace cli
