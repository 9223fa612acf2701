#include "report/tools/rules/pack_words.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "report/text/plain_text.h"

#include <algorithm>
#include <cstddef>

namespace cli {

std::string printable_lines(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    result += report::printable(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string joined_ids(const std::vector<rules::RulePack>& packs) {
  calc::Names names;
  std::vector<std::string> ids;
  for (const rules::RulePack& pack : packs) ids.push_back(pack.full_id());
  for (const std::string& id : ids) names.emplace_back(id);
  return calc::join_choices(names);
}

rules::NamedPack find_pack(const std::string& name, const std::vector<rules::RulePack>& packs,
                           calc::Diagnostics& diagnostics) {
  rules::NamedPack found = rules::named_pack(name, packs);
  if (found.is_ambiguous()) {
    diagnostics.report(calc::DiagnosticId::ambiguous_rule_pack, {}, name, found.candidates);
  }
  return found;
}

}  // namespace cli
