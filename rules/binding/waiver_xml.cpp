#include "rules/binding/waiver_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/project/reading/project_elements.h"
#include "calc/project/spaces/waiver_attributes.h"
#include "rules/pack/pack_parts.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace rules {
namespace {

using calc::DiagnosticId;
using calc::ElementReader;

constexpr std::string_view kWaiverName = "waiver";

}  // namespace

const calc::ElementRow& waiver_element() {
  static const calc::ValueType kChecks{.name = "checkIds", .item = &calc::kIdType, .least = 1};
  static const calc::ElementRow kElement = [] {
    calc::ElementRow element = calc::kWaiverElement;
    element.attributes = {{"checks", &kChecks, calc::Presence::required,
                           "Ids of checks that are required here, separated by blanks; luxgate "
                           "rules show names them."},
                          calc::kBecauseAttribute,
                          calc::kByAttribute,
                          calc::kUntilAttribute};
    return element;
  }();
  return kElement;
}

std::vector<WaivedCheck> read_waived_checks(ElementReader& parent, const RulePack* pack) {
  std::vector<WaivedCheck> waived;
  for (const calc::XmlElement& child : parent.element().children) {
    if (child.name != kWaiverName) continue;
    ElementReader reader(child, parent.diagnostics());
    reader.allow(waiver_element());
    const std::string checks = reader.text("checks");
    const calc::Waiver by = calc::read_waiver(reader);
    for (const std::string_view id : calc::split_words(checks)) {
      if (pack != nullptr && pack->find_check(id) == nullptr) {
        calc::Names all;
        for (const RuleCheck& check : pack->checks) all.emplace_back(check.id);
        report_unknown_name(reader.diagnostics(), reader.where("checks"), "checks", kWaiverName,
                            "check", id, all);
        continue;
      }
      const auto is_it = [&](const WaivedCheck& other) { return other.check == id; };
      const auto first = std::find_if(waived.begin(), waived.end(), is_it);
      if (first != waived.end()) {
        reader.report(DiagnosticId::duplicate_id, reader.where("checks"), "waived check", id,
                      first->where.line);
        continue;
      }
      waived.push_back({std::string(id), by, reader.where("checks")});
    }
  }
  return waived;
}

void check_waived_are_asked(ElementReader& parent, const std::vector<WaivedCheck>& waived,
                            const RulePack& pack, const std::vector<std::string>& asked) {
  for (const WaivedCheck& one : waived) {
    if (std::find(asked.begin(), asked.end(), one.check) != asked.end()) continue;
    const RuleCheck* check = pack.find_check(one.check);
    if (check == nullptr) continue;  // reported where it was read
    parent.report(DiagnosticId::waiver_not_asked, one.where, one.check, check->role,
                  calc::join_choices(calc::Names(asked.begin(), asked.end())));
  }
}

}  // namespace rules
