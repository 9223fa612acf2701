#include "report/tools/rules/rules_options.h"

#include <CLI/CLI.hpp>

namespace cli {
namespace {

constexpr const char* kExitCodes = "Exit codes: 0 no error, 2 at least one error.";

void add_rule_files(CLI::App& app, std::vector<std::string>& rule_files) {
  app.add_option("--rules", rule_files,
                 "Rule pack, or folder of rule packs, to know besides those delivered; may be "
                 "repeated")
      ->type_name("FILE|DIR")
      ->expected(1, CLI::detail::expected_max_vector_size)
      ->allow_extra_args(false);
}

CLI::App& add_action(CLI::App& rules, RulesOptions& options, RulesAction action, const char* name,
                     const char* help) {
  CLI::App& app = *rules.add_subcommand(name, help);
  app.callback([&options, action] { options.action = action; });
  app.footer(kExitCodes);
  return app;
}

}  // namespace

void add_rules_options(CLI::App& rules, RulesOptions& options,
                       std::vector<std::string>& rule_files) {
  rules.require_subcommand(1);
  rules.footer("'luxgate rules ACTION --help' explains an action.");
  CLI::App& list = add_action(rules, options, RulesAction::list, "list", "List the rule packs");
  add_rule_files(list, rule_files);
  CLI::App& show =
      add_action(rules, options, RulesAction::show, "show", "Print all of one rule pack");
  show.add_option("pack", options.pack, "Its id, or id:edition")->required()->type_name("PACK");
  add_rule_files(show, rule_files);
  CLI::App& lint = add_action(rules, options, RulesAction::lint, "lint",
                              "Find errors and doubtful things in rule pack files");
  lint.add_option("files", options.files, "Rule packs, or folders of them")
      ->required()
      ->type_name("FILE|DIR");
  CLI::App& import = add_action(rules, options, RulesAction::import_rows, "import",
                                "Make a private rule pack for indoor work places from a table");
  import.add_option("csv", options.csv, "Table with a line of column names; see rules/README.md")
      ->required()
      ->type_name("TABLE.csv");
  import.add_option("-o,--output", options.output, "Where to; default standard output")
      ->type_name("PACK.xml");
  import.add_option("--id", options.pack_id, "Id of the new pack; default en12464-1-own")
      ->type_name("ID");
  add_action(rules, options, RulesAction::schema, "schema", "Print the XML schema of rule packs");
}

void add_explain_options(CLI::App& explain, RulesOptions& options,
                         std::vector<std::string>& rule_files) {
  explain
      .add_option(
          "what", options.explained,
          "PACK/ROW, PACK/ROLE or PACK/CHECK, PACK being the id of a rule pack or id:edition; "
          "or the id of a message")
      ->required()
      ->type_name("WHAT");
  add_rule_files(explain, rule_files);
  explain.footer(kExitCodes);
}

}  // namespace cli
