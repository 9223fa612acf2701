#include "report/tools/rules/rules.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/xml_reader.h"
#include "report/check/load_rules.h"
#include "report/formats/console_lines.h"
#include "report/formats/write.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/print.h"
#include "report/text/plain_text.h"
#include "report/text/shell_words.h"
#include "report/tools/rules/explain.h"
#include "report/tools/rules/find_rows.h"
#include "report/tools/rules/pack_words.h"
#include "report/tools/rules/rules_diff.h"
#include "rules/pack/builtin_packs.h"
#include "rules/pack/import_columns.h"
#include "rules/pack/import_rows.h"
#include "rules/pack/named_pack.h"
#include "rules/pack/pack_elements.h"
#include "rules/pack/rule_lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

namespace cli {
namespace {

ExitCode finished(std::string out, const calc::Diagnostics& diagnostics) {
  return print_outcome(
      {diagnostics.has_errors() ? kNotJudged : kAllMet, std::move(out), diagnostics.all()});
}

// part: a row, role or check; "" = all of it.
std::string show(const std::string& pack, const std::string& part,
                 const std::vector<rules::RulePack>& packs, calc::Diagnostics& diagnostics) {
  const rules::NamedPack found = find_pack(pack, packs, diagnostics);
  if (found.is_ambiguous()) return {};
  if (found.pack != nullptr) {
    if (part.empty()) return show_rule_pack(*found.pack);
    std::optional<std::string> text = explain_rule(*found.pack, part);
    if (text) return *std::move(text);
    diagnostics.report(calc::DiagnosticId::rule_import, {},
                       fmt::format("rule pack '{}' has no row, role or check '{}'; 'luxgate rules "
                                   "show {}' lists them",
                                   found.pack->full_id(), part, pack));
    return {};
  }
  diagnostics.report(
      calc::DiagnosticId::rule_import, {},
      fmt::format("there is no rule pack '{}'; allowed: {}", pack, joined_ids(packs)));
  return {};
}

std::string lint(const std::vector<std::string>& paths, const calc::FileReader& files,
                 calc::Diagnostics& diagnostics) {
  std::string out;
  for (const std::string& path : check::rule_files(paths, diagnostics)) {
    const calc::FileContent content = files.read(path);
    if (!content.ok()) {
      diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
      continue;
    }
    const std::optional<rules::RulePack> pack =
        rules::parse_rule_pack(content.bytes, path, diagnostics);
    if (!pack) continue;
    const std::size_t errors = diagnostics.error_count();
    rules::lint_rule_pack(*pack, diagnostics);
    if (diagnostics.error_count() > errors) continue;
    out += fmt::format("{}: no error ({}: {} rows, {} checks)\n", path, pack->full_id(),
                       pack->rows.size(), pack->checks.size());
  }
  return out;
}

struct ImportOptions {
  std::string csv, output;  // output "" = standard output
  std::string pack_id = "en12464-1-own";
  bool wants_template = false;
};

std::string import_summary(const rules::ImportedPack& pack, const std::string& output) {
  std::string text = fmt::format("Wrote {}: {} rows", output, pack.rows);
  if (pack.floor_rows > 0) text += fmt::format(", {} of them on the floor", pack.floor_rows);
  if (pack.upright_rows > 0) text += fmt::format(", {} of them upright", pack.upright_rows);
  if (pack.left_out > 0) text += fmt::format("; {} left out", pack.left_out);
  return text + fmt::format(". Next: luxgate rules lint {}\n", output);
}

std::string import_table(const ImportOptions& options, const calc::FileReader& files,
                         calc::Diagnostics& diagnostics) {
  constexpr const char* kLike = "en12464-1:2021";
  if (options.wants_template) return rules::import_template();
  if (!calc::is_id(options.pack_id)) {
    diagnostics.report(calc::DiagnosticId::not_an_id, {}, "--id", "rules import", options.pack_id);
    return {};
  }
  const calc::FileContent csv = files.read(options.csv);
  if (!csv.ok()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {options.csv, 0, 0}, options.csv,
                       csv.error);
    return {};
  }
  std::error_code ignored;
  if (!options.output.empty() &&
      std::filesystem::equivalent(options.output, options.csv, ignored)) {
    diagnostics.report(calc::DiagnosticId::output_not_possible, {},
                       fmt::format("'{}' is the table itself", options.output));
    return {};
  }
  for (const std::string_view text : rules::builtin_pack_texts()) {
    calc::Diagnostics own;
    if (rules::parse_rule_pack(text, "built in", own)->full_id() != kLike) continue;
    const std::string name = std::filesystem::path(options.csv).filename().string();
    const std::optional<rules::ImportedPack> pack =
        rules::import_rows(csv.bytes, name, text, options.pack_id, diagnostics);
    if (!pack) return {};
    if (options.output.empty()) return pack->text;
    const std::string problem = report::write_file_atomically(options.output, pack->text);
    if (!problem.empty()) {
      diagnostics.report(calc::DiagnosticId::output_not_possible, {},
                         fmt::format("cannot write '{}': {}", options.output, problem));
      return {};
    }
    return import_summary(*pack, options.output);
  }
  return {};
}

// The command that lists all rows with these words, from the packs of this command.
std::string find_command(const std::string& words, const std::vector<std::string>& rule_files) {
  std::string line = "luxgate rules find " + report::shell_quoted(words);
  for (const std::string& file : rule_files) line += " --rules " + report::shell_quoted(file);
  return line;
}

// Rows and messages that have the word, for somebody who does not know the id. "" = none.
std::string found_by_word(const std::string& word, const std::vector<rules::RulePack>& packs,
                          const std::vector<std::string>& rule_files) {
  constexpr std::size_t kMostShown = 8;
  const std::vector<FoundRow> rows = find_rows(word, packs);
  const std::vector<std::string> messages = messages_with_word(word);
  if (rows.empty() && messages.empty()) return {};
  std::string text = fmt::format("'{}' is not an id.\n", word);
  if (!rows.empty()) {
    text += "\nRows with this word:\n\n" + row_list(rows, kMostShown);
    if (rows.size() > kMostShown) {
      text +=
          calc::and_more(rows.size() - kMostShown) + ": " + find_command(word, rule_files) + "\n";
    }
    text += fmt::format("\nExplain a row: luxgate explain {}\n",
                        report::shell_quoted(rows.front().id()));
  }
  if (!messages.empty()) {
    text += "\n" + report::wrapped_lines(
                       "", "Messages with this word: " + calc::list_names(messages, kMostShown), 2,
                       kTextColumns);
  }
  return text;
}

// Rows of the pack that have the word, else ids that are near it.
std::string names_like(const std::string& word, const rules::RulePack& pack,
                       const std::vector<rules::RulePack>& packs) {
  constexpr std::size_t kMostShown = 8;
  std::vector<std::string> names;
  for (const FoundRow& found : find_rows(word, packs)) {
    if (found.pack == &pack) names.push_back(found.row->ref + " (" + found.row->name + ")");
  }
  return names.empty() ? near_names(pack, word) : calc::list_names(names, kMostShown);
}

// "PACK/ROW", "PACK/ROLE" or "PACK/CHECK".
std::string explain_part(const std::string& what, const std::vector<rules::RulePack>& packs,
                         calc::Diagnostics& diagnostics) {
  const std::size_t slash = what.find('/');
  const rules::NamedPack found = find_pack(what.substr(0, slash), packs, diagnostics);
  if (found.is_ambiguous()) return {};
  if (found.pack == nullptr) {
    diagnostics.report(calc::DiagnosticId::nothing_to_explain, {}, what,
                       "packs: ", joined_ids(packs));
    return {};
  }
  const std::string name = what.substr(slash + 1);
  if (std::optional<std::string> text = explain_rule(*found.pack, name)) return *std::move(text);
  diagnostics.report(calc::DiagnosticId::nothing_to_explain, {}, what,
                     fmt::format("{} has ", found.pack->full_id()),
                     names_like(name, *found.pack, packs));
  return {};
}

// The id of a message, or a word to search for.
std::string explain_word(const std::string& what, const std::vector<rules::RulePack>& packs,
                         const std::vector<std::string>& rule_files,
                         calc::Diagnostics& diagnostics) {
  if (std::optional<std::string> text = explain_message(what)) return *std::move(text);
  const rules::NamedPack found = find_pack(what, packs, diagnostics);
  if (found.is_ambiguous()) return {};
  if (found.pack != nullptr) {
    diagnostics.report(
        calc::DiagnosticId::nothing_to_explain, {}, what,
        fmt::format("'luxgate rules show {}' shows this pack, which has ", found.pack->full_id()),
        near_names(*found.pack, ""));
    return {};
  }
  std::string text = found_by_word(what, packs, rule_files);
  if (!text.empty()) return text;
  std::vector<std::string> near = near_messages(what);
  for (std::string& id : near) id = "'" + id + "'";
  const std::vector<std::string_view> choices(near.begin(), near.end());
  diagnostics.report(calc::DiagnosticId::nothing_to_explain, {}, what,
                     near.empty() ? "packs: " : "did you mean ",
                     near.empty() ? joined_ids(packs) : calc::join_choices(choices) + "?");
  return {};
}

std::string explain(const std::string& what, const std::vector<rules::RulePack>& packs,
                    const std::vector<std::string>& rule_files, calc::Diagnostics& diagnostics) {
  return what.find('/') == std::string::npos ? explain_word(what, packs, rule_files, diagnostics)
                                             : explain_part(what, packs, diagnostics);
}

std::vector<ExitMeaning> rules_exit_codes() { return {{0, "no error"}, {2, "at least one error"}}; }

// An action that prints what `make` gives of its options.
template <class Options>
Command action(Command command, const std::shared_ptr<Options>& options,
               std::string (*make)(const Options&, const calc::FileReader&, calc::Diagnostics&)) {
  command.exit_codes = rules_exit_codes();
  command.run = [options, make](const RunContext&) {
    calc::Diagnostics diagnostics;
    std::string out = make(*options, calc::DiskFileReader(), diagnostics);
    return finished(std::move(out), diagnostics);
  };
  return command;
}

// What most actions take: a name, files or nothing, and packs besides those delivered.
struct PackOptions {
  std::string name, part;
  std::vector<std::string> files, rule_files;
};

Command list_action() {
  const auto options = std::make_shared<PackOptions>();
  Command command{"list", "List the rule packs"};
  command.examples = {
      {"luxgate rules list --rules own.xml", "Those delivered and one of your own"}};
  command.options = {rules_option(options->rule_files)};
  return action<PackOptions>(
      std::move(command), options,
      [](const PackOptions& given, const calc::FileReader& files, calc::Diagnostics& diagnostics) {
        return printable_lines(
            list_rule_packs(check::load_rule_packs(given.rule_files, files, diagnostics)));
      });
}

Command show_action() {
  const auto options = std::make_shared<PackOptions>();
  Command command{"show", "Print a rule pack, or one row of it"};
  command.places = {{"pack", "PACK", "Its id, or id:edition", &options->name},
                    {"part", "ROW",
                     "A row, role or check of it: to which planes it applies, and "
                     "what is required there",
                     &options->part, false}};
  command.options = {rules_option(options->rule_files)};
  command.examples = {{"luxgate rules show en12464-1 34.2", "One row of a standard"}};
  return action<PackOptions>(
      std::move(command), options,
      [](const PackOptions& given, const calc::FileReader& files, calc::Diagnostics& diagnostics) {
        const auto packs = check::load_rule_packs(given.rule_files, files, diagnostics);
        return printable_lines(show(given.name, given.part, packs, diagnostics));
      });
}

struct FindOptions {
  std::vector<std::string> words, rule_files;
};

// As grep: no hit is no error, but a script can tell it from one.
ExitCode run_find(const FindOptions& options) {
  calc::Diagnostics diagnostics;
  const auto packs =
      check::load_rule_packs(options.rule_files, calc::DiskFileReader(), diagnostics);
  std::string words;
  for (const std::string& word : options.words) words += (words.empty() ? "" : " ") + word;
  const std::vector<FoundRow> rows = find_rows(words, packs);
  if (diagnostics.has_errors() || !rows.empty()) {
    return finished(row_list(rows, rows.size()), diagnostics);
  }
  tell("luxgate: no row has '{}' in its id or names\n", report::printable(words));
  return print_outcome({kNotMet, "", diagnostics.all()});
}

Command find_action() {
  const auto options = std::make_shared<FindOptions>();
  Command command{"find", "Find rows of all packs by their names, in English or German"};
  command.places = {{"words", "WORD",
                     "Words that the id or a name of the row has, in any order. Case makes\n"
                     "no difference; ae, oe and ue stand for umlauts",
                     &options->words}};
  command.options = {rules_option(options->rule_files)};
  command.notes =
      "A row of the list is PACK/ROW and its names. 'luxgate explain PACK/ROW' says what the\n"
      "row requires. Common words with the same meaning also count: 'meeting' finds\n"
      "'conference room'.";
  command.examples = {{"luxgate rules find classroom", "Rows about classrooms"},
                      {"luxgate rules find Treppe", "The same search in German"}};
  command.exit_codes = {
      {kAllMet, "at least one row was found"}, {kNotMet, "none was"}, {kNotJudged, "an error"}};
  command.run = [options](const RunContext&) { return run_find(*options); };
  return command;
}

Command lint_action() {
  const auto options = std::make_shared<PackOptions>();
  Command command{"lint", "Find errors and doubtful entries in rule packs"};
  command.places = {{"files", "FILE|DIR", "Rule packs, or folders of them", &options->files}};
  command.examples = {{"luxgate rules lint own.xml", "Before it is used"}};
  return action<PackOptions>(
      std::move(command), options,
      [](const PackOptions& given, const calc::FileReader& files, calc::Diagnostics& diagnostics) {
        return printable_lines(lint(given.files, files, diagnostics));
      });
}

Command import_action() {
  const auto options = std::make_shared<ImportOptions>();
  Command command{"import", "Make a private rule pack for indoor work places from a table"};
  command.places = {
      {"csv", "TABLE.csv", "Table with a line of column names, see below", &options->csv, false}};
  command.options = {
      {"-o,--output", "PACK.xml", "Write the pack into this file; default standard output",
       any_text(options->output)},
      {"--id", "ID", "Set the id of the new pack; default en12464-1-own",
       any_text(options->pack_id)},
      {"--template", "", "Print a table of two rows to start from, and nothing else",
       &options->wants_template}};
  command.complete = [options](const Environment&) -> std::string {
    return options->csv.empty() == options->wants_template
               ? ""
               : "either TABLE.csv or --template is needed";
  };
  command = action<ImportOptions>(std::move(command), options, import_table);
  command.notes = rules::import_columns_help();
  command.examples = {
      {"luxgate rules import --template", "A table to begin with"},
      {"luxgate rules import rows.csv -o own.xml", "Then: luxgate rules lint own.xml"}};
  return command;
}

Command schema_action() {
  Command command{"schema", "Print the XML schema of rule packs"};
  command.examples = {{"luxgate rules schema", "For an editor or a validator"}};
  return action<PackOptions>(std::move(command), std::make_shared<PackOptions>(),
                             [](const PackOptions&, const calc::FileReader&, calc::Diagnostics&) {
                               return rules::rule_pack_schema();
                             });
}

}  // namespace

Command rules_command() {
  Command command{"rules", "Find, show, compare, check and import rule packs (standards as data)"};
  command.actions = {list_action(), find_action(),   show_action(),  diff_action(),
                     lint_action(), import_action(), schema_action()};
  return command;
}

Command explain_command() {
  const auto options = std::make_shared<PackOptions>();
  Command command{"explain", "Explain what a rule requires, or what a message means"};
  command.places = {
      {"what", "WHAT",
       "PACK/ROW, PACK/ROLE or PACK/CHECK, PACK being the id of a rule pack or id:edition; "
       "the id of a message; or a word, which lists rows and messages that have it",
       &options->name}};
  command.options = {rules_option(options->rule_files)};
  command.examples = {{"luxgate explain en12464-1/34.2", "A row of a standard"},
                      {"luxgate explain light-leaves-room", "A message"},
                      {"luxgate explain classroom", "Rows with this word in a name"}};
  command = action<PackOptions>(
      std::move(command), options,
      [](const PackOptions& given, const calc::FileReader& files, calc::Diagnostics& diagnostics) {
        const auto packs = check::load_rule_packs(given.rule_files, files, diagnostics);
        return printable_lines(explain(given.name, packs, given.rule_files, diagnostics));
      });
  command.exit_codes = {
      {kAllMet, "explained, or a list of what has the word"},
      {kNotJudged, "nothing has this id or word (ids like it are suggested), or another error"}};
  return command;
}

}  // namespace cli
