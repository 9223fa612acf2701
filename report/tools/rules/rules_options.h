#pragma once
// Options of `luxgate rules` and `luxgate explain`.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cli {

enum class RulesAction { list, show, lint, import_rows, schema };

struct RulesOptions {
  RulesAction action = RulesAction::list;
  std::string pack;                       // of show
  std::vector<std::string> files;         // of lint: files and folders
  std::string csv, output;                // of import; output "" = standard output
  std::string pack_id = "en12464-1-own";  // of import
  std::string explained;  // of explain: PACK/ROW, PACK/ROLE, PACK/CHECK or a message's id
};

// rule_files: of --rules.
void add_rules_options(CLI::App& rules, RulesOptions& options,
                       std::vector<std::string>& rule_files);
void add_explain_options(CLI::App& explain, RulesOptions& options,
                         std::vector<std::string>& rule_files);

}  // namespace cli
