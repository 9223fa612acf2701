#include "calc/project/reading/former_ids.h"

#include "calc/base/diagnostic_ids.h"

namespace calc {

std::string FormerIds::read(ElementReader& reader, const std::string& id) {
  const std::string was = reader.has("was") ? reader.id("was") : "";
  add(id, reader.where().line, was, reader.where("was"));
  return was;
}

void FormerIds::add(const std::string& id, int line, const std::string& was,
                    const SourceLocation& where) {
  line_of_id_.try_emplace(id, line);
  if (!was.empty()) of_former_.emplace(was, Former{id, where});
}

void FormerIds::check(Diagnostics& diagnostics) const {
  for (auto entry = of_former_.begin(); entry != of_former_.end(); ++entry) {
    const auto& [was, former] = *entry;
    if (const auto there = line_of_id_.find(was); there != line_of_id_.end()) {
      diagnostics.report(DiagnosticId::former_id_in_use, former.where, was, kind_, was,
                         there->second);
    }
    const auto first = of_former_.lower_bound(was);
    if (first == entry) continue;
    diagnostics.report(DiagnosticId::former_id_twice, former.where, was, kind_, first->second.id,
                       first->second.where.line);
  }
}

}  // namespace calc
