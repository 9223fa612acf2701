#include "rules/pack/named_pack.h"

#include <fmt/format.h>

#include <algorithm>

namespace rules {

NamedPack named_pack(std::string_view name, const std::vector<RulePack>& packs) {
  std::vector<const RulePack*> fitting;
  for (const RulePack& pack : packs) {
    if (name == pack.id || name == pack.full_id()) fitting.push_back(&pack);
  }
  if (fitting.size() > 1) {
    const auto is_in_force = [](const RulePack* pack) { return pack->status == "published"; };
    if (std::count_if(fitting.begin(), fitting.end(), is_in_force) == 1) {
      return {*std::find_if(fitting.begin(), fitting.end(), is_in_force), ""};
    }
    return {nullptr, pack_list(fitting)};
  }
  return {fitting.empty() ? nullptr : fitting.front(), ""};
}

std::string pack_list(const std::vector<const RulePack*>& packs) {
  std::string text;
  for (const RulePack* pack : packs) {
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", pack->full_id(), pack->file);
  }
  return text;
}

}  // namespace rules
