#pragma once
// Finds the rule pack for a name, as written in a project or on the command line.

#include "rules/pack/rule_pack.h"

#include <string>
#include <string_view>
#include <vector>

namespace rules {

struct NamedPack {
  const RulePack* pack = nullptr;  // null: unknown or ambiguous
  // "en12464-1:2021 (built in), en12464-1:2021-own (own.xml)": all packs that the name may mean,
  // for DiagnosticId::ambiguous_rule_pack. "" = not ambiguous.
  std::string candidates;

  bool is_ambiguous() const { return !candidates.empty(); }
};

// Returns the pack for "id:edition" or "id". "id" alone is the only edition that is loaded, or else
// the only published one, which is in force. If several are published the name is ambiguous; the
// place in the list never decides. A user's edition beside the published one needs id:edition.
NamedPack named_pack(std::string_view name, const std::vector<RulePack>& packs);

// Returns "en12464-1:2021 (built in), own:1 (own.xml)".
std::string pack_list(const std::vector<const RulePack*>& packs);

}  // namespace rules
