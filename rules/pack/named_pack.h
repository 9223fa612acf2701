#pragma once
// What the name of a rule pack means, wherever it is written: in a project or on the command line.

#include "rules/pack/rule_pack.h"

#include <string>
#include <string_view>
#include <vector>

namespace rules {

struct NamedPack {
  const RulePack* pack = nullptr;  // null: unknown or ambiguous
  // "en12464-1:2021 (built in), en12464-1:2021-own (own.xml)": all that it may mean, for
  // DiagnosticId::ambiguous_rule_pack. "" = not ambiguous.
  std::string candidates;

  bool is_ambiguous() const { return !candidates.empty(); }
};

// "id:edition", or "id": the only edition that is loaded, else the one in force, which is the only
// one that is published. Several of those are ambiguous, never one of them by its place in the
// list: an edition of one's own beside the published one is chosen by id:edition.
NamedPack named_pack(std::string_view name, const std::vector<RulePack>& packs);

// "en12464-1:2021 (built in), own:1 (own.xml)".
std::string pack_list(const std::vector<const RulePack*>& packs);

}  // namespace rules
