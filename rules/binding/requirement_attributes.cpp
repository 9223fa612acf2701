#include "rules/binding/requirement_attributes.h"

#include "rules/catalogue/requirement.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace rules {
namespace {

using enum AttributeForm;
using enum AttributeKind;

constexpr calc::NumberRange kPercent{0.0, 100.0, false, "a number from 0 to 100"};

std::vector<RequirementAttribute> make_attributes() {
  return {
      {"id", own, id, "id",
       "Name of the requirement, unique on its plane; its quantity if not given."},
      {.name = "quantity",
       .form = own,
       .kind = words,
       .schema_type = "requiredQuantity",
       .meaning = "Statistic of the plane's points, or power or energy of the plane's room.",
       .words = all_metric_names()},
      {"at-least", own, number, "nonNegative", "Lower limit; exactly one of at-least and at-most."},
      {"at-most", own, number, "nonNegative", "Upper limit; exactly one of at-least and at-most."},
      {.name = "percent",
       .form = own,
       .kind = number,
       .schema_type = "percentage",
       .meaning = "Of a percentile: the share of the points that do not exceed it.",
       .range = kPercent},
      {"at", own, point, "vector", "Of a value: its point x y z, in metres, in world coordinates."},
      {.name = "state",
       .form = own,
       .kind = words,
       .schema_type = "lightState",
       .meaning =
           "With the maintenance factor or as new; maintained if not given, initial for ugr.",
       .words = {calc::name_of(LightState::maintained), calc::name_of(LightState::initial)}},
      {.name = "scene",
       .form = either,
       .kind = id,
       .schema_type = "id",
       .meaning = "Id of a scene; every luminaire is at full output if not given.",
       .is_of_workplace = true},
      {"clause", own, empty_text, "xs:string", "Free text for reports."},
      {.name = "unit",
       .form = own,
       .kind = words,
       .schema_type = "limitUnit",
       .meaning = "Of a limit in illuminance; lx if not given.",
       .words = {"lx", "fc"}},
      {.name = "pack",
       .form = row,
       .kind = text,
       .schema_type = "text",
       .meaning = "Rule pack, by id or id:edition; luxgate rules list names them.",
       .is_of_workplace = true},
      {.name = "row",
       .form = row,
       .kind = text,
       .schema_type = "text",
       .meaning = "Row of the rule pack; luxgate rules show names them.",
       .is_of_workplace = true},
      {.name = "level",
       .form = row,
       .kind = words,
       .schema_type = "rowLevel",
       .meaning = "Which values of the row count; required if not given.",
       .words = {"required", "modified"},
       .is_of_workplace = true},
      {"role", row, id, "id", "What the plane is; the pack's first role if not given."},
      {.name = "facts",
       .form = row,
       .kind = text,
       .schema_type = "text",
       .meaning = "What only the project knows: task-illuminance=500 lx, several separated by ;",
       .is_of_workplace = true},
      {"from", own, number, "nonNegative",
       "Of a share: the lower end of the range, which is in it."},
      {"to", own, number, "nonNegative", "Of a share: the upper end of the range, which is in it."},
      {.name = "light",
       .form = own,
       .kind = words,
       .schema_type = "countedLight",
       .meaning = "With or without reflected light; all if not given.",
       .words = {"all", "direct"}},
      {"waived-because", waiver, text, "text", "Why the requirement is waived; all three or none."},
      {"waived-by", waiver, text, "text", "Who has waived it."},
      {"waived-until", waiver, date, "day", "The last day of the waiver, YYYY-MM-DD."},
  };
}

}  // namespace

const std::vector<RequirementAttribute>& requirement_attributes() {
  static const std::vector<RequirementAttribute> kAttributes = make_attributes();
  return kAttributes;
}

const RequirementAttribute& requirement_attribute(std::string_view name) {
  for (const RequirementAttribute& attribute : requirement_attributes()) {
    if (attribute.name == name) return attribute;
  }
  throw std::logic_error("<require> has no attribute " + std::string(name));
}

calc::Names requirement_attribute_names() {
  calc::Names names;
  for (const auto& attribute : requirement_attributes()) names.push_back(attribute.name);
  return names;
}

calc::Names workplace_rule_names() {
  calc::Names names;
  for (const auto& attribute : requirement_attributes()) {
    if (attribute.is_of_workplace) names.push_back(attribute.name);
  }
  return names;
}

void check_value(calc::ElementReader& reader, std::string_view name) {
  if (!reader.has(name)) return;
  const RequirementAttribute& attribute = requirement_attribute(name);
  switch (attribute.kind) {
    case words:
      reader.choice(name, attribute.words);
      return;
    case number:
      reader.number(name, attribute.range);
      return;
    case point:
      reader.numbers(name, 3, kPointWords);
      return;
    case id:
      reader.id(name);
      return;
    case text:
      reader.text(name);
      return;
    case empty_text:
    case date:  // of waivers, which hang on nothing
      return;
  }
}

}  // namespace rules
