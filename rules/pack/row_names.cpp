#include "rules/pack/row_names.h"

#include "rules/pack/rule_pack.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace rules {
namespace {

using NamesOfRows = std::map<std::pair<std::string, std::string>, RowName>;  // by pack and row

NamesOfRows all_row_names() {
  NamesOfRows names;
  for (const RulePack& pack : builtin_rule_packs()) {
    for (const RuleRow& row : pack.rows) {
      names[{pack.full_id(), row.ref}] = {pack.title + ":" + pack.edition, row.name, row.name_de};
    }
  }
  return names;
}

}  // namespace

const RowName* builtin_row_name(std::string_view pack, std::string_view row) {
  static const NamesOfRows names = all_row_names();
  const auto found = names.find({std::string(pack), std::string(row)});
  return found == names.end() ? nullptr : &found->second;
}

}  // namespace rules
