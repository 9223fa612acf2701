#pragma once
// Explains a rule or a message in words.

#include "rules/pack/rule_pack.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// Returns one line per pack.
std::string list_rule_packs(const std::vector<rules::RulePack>& packs);

// Returns everything of a pack: head, sources, rows with their values, checks with their formulas.
std::string show_rule_pack(const rules::RulePack& pack);

// Returns the requirement of a row, role or check of a pack, its plane, points and light, and the
// sources of its numbers; the first line names the edition. Empty if there is none of that name.
std::optional<std::string> explain_rule(const rules::RulePack& pack, const std::string& name);

// Returns rows, roles and checks of the pack with similar names, the nearest first; if there is
// none, the first of all.
std::string near_names(const rules::RulePack& pack, std::string_view name);

// Returns the meaning of the message with this id. Empty if there is none.
std::optional<std::string> explain_message(const std::string& name);

// Returns ids of messages that contain this word or begin with it part by part: "maintenance" is a
// word of "maintenance-not-stated".
std::vector<std::string> messages_with_word(std::string_view word);

// Returns ids of messages similar to a misspelt one, the nearest first; at most 3.
std::vector<std::string> near_messages(std::string_view name);

}  // namespace cli
