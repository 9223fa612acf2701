#include "rules/binding/deviation_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/names.h"
#include "calc/project/reading/project_elements.h"
#include "calc/project/spaces/waiver_attributes.h"
#include "rules/pack/pack_parts.h"

#include <algorithm>
#include <utility>

namespace rules {
namespace {

using calc::DiagnosticId;
using calc::ElementReader;
using enum calc::Presence;

constexpr std::string_view kName = "deviation";

}  // namespace

const calc::ElementRow& deviation_element() {
  static const calc::ValueType kAspect{
      .name = "fitAspect", .base = &calc::kAnyText, .words = calc::names_of<FitAspect>()};
  static const calc::ElementRow kElement = [] {
    calc::ElementRow element = calc::kDeviationElement;
    element.attributes = {
        {"in", &kAspect, required, "What differs from the plane that the standard means."},
        {"role", &calc::kIdType, optional,
         "The zones of a workplace that it is about; needed there."},
        calc::kBecauseAttribute,
        calc::kByAttribute,
        calc::kUntilAttribute};
    return element;
  }();
  return kElement;
}

std::vector<StatedDeviation> read_deviations(ElementReader& parent, const std::string& role) {
  std::vector<StatedDeviation> stated;
  for (const calc::XmlElement& child : parent.element().children) {
    if (child.name != kName) continue;
    ElementReader reader(child, parent.diagnostics());
    if (!role.empty() && reader.has("role") && reader.text("role") != role) continue;
    reader.allow(deviation_element());
    if (role.empty() && reader.has("role")) {
      reader.report(DiagnosticId::attribute_without_meaning, reader.where("role"), kName, "role",
                    "<require>");
    }
    if (!role.empty()) reader.id("role");
    StatedDeviation one;
    one.aspect = reader.value<FitAspect>("in");
    one.by = calc::read_waiver(reader);
    const auto twice = [&](const StatedDeviation& other) { return other.aspect == one.aspect; };
    if (reader.ok() && std::any_of(stated.begin(), stated.end(), twice)) {
      reader.report(DiagnosticId::duplicate_id, reader.where("in"), kName,
                    calc::name_of(one.aspect), parent.where().line);
    }
    stated.push_back(std::move(one));
  }
  return stated;
}

void check_deviation_roles(ElementReader& workplace, const RulePack& pack) {
  const std::vector<std::string> roles = pack.roles();
  for (const calc::XmlElement& child : workplace.element().children) {
    if (child.name != kName) continue;
    ElementReader reader(child, workplace.diagnostics());
    const std::string role = reader.id("role");
    if (role.empty() || std::find(roles.begin(), roles.end(), role) != roles.end()) continue;
    report_unknown_name(reader.diagnostics(), reader.where("role"), "role", kName, "role", role,
                        calc::Names(roles.begin(), roles.end()));
  }
}

}  // namespace rules
