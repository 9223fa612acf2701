#pragma once
// What a rule or a message means, in words.

#include "rules/pack/rule_pack.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// One line per pack.
std::string list_rule_packs(const std::vector<rules::RulePack>& packs);

// Everything of a pack: head, sources, rows with their values, checks with their formulas.
std::string show_rule_pack(const rules::RulePack& pack);

// A row, role or check of a pack: what is required, on which plane, of which points and light, and
// where the numbers come from; the first line names the edition. Empty if there is none of that
// name.
std::optional<std::string> explain_rule(const rules::RulePack& pack, const std::string& name);

// Rows, roles and checks of the pack with names like this one, the nearest first; if there is none,
// the first of all.
std::string near_names(const rules::RulePack& pack, std::string_view name);

// What the message with this id means. Empty if there is none.
std::optional<std::string> explain_message(const std::string& name);

// Ids of messages that have this word or begin with it part by part: "maintenance" is a word of
// "maintenance-not-stated".
std::vector<std::string> messages_with_word(std::string_view word);

// Ids of messages that may be meant by a misspelt one, the nearest first; at most 3.
std::vector<std::string> near_messages(std::string_view name);

}  // namespace cli
