#pragma once
// What a rule or a message means, in words.

#include "rules/rule_pack.h"

#include <optional>
#include <string>
#include <vector>

namespace cli {

// One line per pack.
std::string list_rule_packs(const std::vector<rules::RulePack>& packs);

// By id or id:edition; a bare id means the edition in force. nullptr if there is none.
const rules::RulePack* find_rule_pack(const std::vector<rules::RulePack>& packs,
                                      const std::string& name);

// Everything of a pack: head, sources, rows with their values, checks with their formulas.
std::string show_rule_pack(const rules::RulePack& pack);

// "PACK/ROW", "PACK/ROLE" or "PACK/CHECK": what is required, on which plane, of which points and
// light, and where the numbers come from; or the id of a message. Empty if `what` is none of these.
std::optional<std::string> explain(const std::string& what,
                                   const std::vector<rules::RulePack>& packs);

}  // namespace cli
