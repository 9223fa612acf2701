#pragma once
// Names of rule packs on the command line, and texts from packs for people.

#include "calc/base/diagnostics.h"
#include "rules/pack/named_pack.h"
#include "rules/pack/rule_pack.h"

#include <string>
#include <string_view>
#include <vector>

namespace cli {

inline constexpr int kTextColumns = 80;  // of lines for people

// Returns a text of a pack, which may contain anything, in a printable form.
std::string printable_lines(std::string_view text);

// Returns "a:1, b:2".
std::string joined_ids(const std::vector<rules::RulePack>& packs);

// Returns the pack. Reports an ambiguous name, but not an unknown one.
rules::NamedPack find_pack(const std::string& name, const std::vector<rules::RulePack>& packs,
                           calc::Diagnostics& diagnostics);

}  // namespace cli
