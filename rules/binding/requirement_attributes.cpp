#include "rules/binding/requirement_attributes.h"

#include "calc/project/reading/project_elements.h"
#include "rules/catalogue/requirement.h"
#include "rules/pack/pack_elements.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace rules {
namespace {

using enum AttributeForm;
using enum AttributeKind;

const calc::ValueType kRequiredQuantityType{
    .name = "requiredQuantity", .base = &calc::kAnyText, .words = all_metric_names()};
const calc::ValueType kPercentageType{
    .name = "percentage", .base = &calc::kDecimalType, .range = kPercent};
const calc::ValueType kRequiredStateType{
    .name = "lightState",
    .base = &calc::kAnyText,
    .words = {calc::name_of(LightState::maintained), calc::name_of(LightState::initial)}};
const calc::ValueType kLimitUnitType{
    .name = "limitUnit", .base = &calc::kAnyText, .words = {"lx", "fc"}};
const calc::ValueType kLevelType{
    .name = "rowLevel", .base = &calc::kAnyText, .words = level_names()};

std::vector<RequirementAttribute> make_attributes() {
  return {
      {"id", own, id, &calc::kIdType,
       "Name of the requirement, unique on its plane; its quantity if not given."},
      {"was", own, id, &calc::kIdType,
       "Its id in earlier revisions. Comparisons use it to find renamed requirements."},
      {"quantity", own, words, &kRequiredQuantityType,
       "Statistic of the plane's points, or power or energy of the plane's room."},
      {"at-least", own, number, &calc::kNonNegativeType,
       "Lower limit; exactly one of at-least and at-most."},
      {"at-most", own, number, &calc::kNonNegativeType,
       "Upper limit; exactly one of at-least and at-most."},
      {"percent", own, number, &kPercentageType,
       "The share of the points that do not exceed a percentile."},
      {"at", own, point, &calc::kVectorType,
       "The point x y z of a value, in metres, in world coordinates."},
      {"facing", own, point, &calc::kVectorType,
       "The direction x y z in which the point of a value faces. Needed if several points of a "
       "list are at the same place."},
      {"state", own, words, &kRequiredStateType,
       "With the maintenance factor or as new; maintained if not given, initial for ugr."},
      {"scene", either, id, &calc::kIdType,
       "Id of a scene; every luminaire is at full output if not given.", calc::Presence::optional},
      {"clause", own, empty_text, &calc::kAnyText, "Free text for reports."},
      {"unit", own, words, &kLimitUnitType, "Unit of a limit in illuminance; lx if not given."},
      {"pack", row, text, &calc::kTextType,
       "Rule pack, by id or id:edition; luxgate rules list names them.", calc::Presence::required},
      {"row", row, text, &calc::kTextType, "Row of the rule pack; luxgate rules show names them.",
       calc::Presence::required},
      {"level", row, words, &kLevelType,
       "Which values of the row count; required if not given. +1: the required value, one step up "
       "the standard's scale.",
       calc::Presence::optional},
      {"level-because", row, text, &calc::kTextType,
       "Why this level; needed for steps along the scale.", calc::Presence::optional},
      {"role", row, id, &calc::kIdType, "What the plane is; the pack's first role if not given."},
      {"facts", row, text, &calc::kTextType,
       "Facts that only the project knows: task-illuminance=500 lx, several separated by ;",
       calc::Presence::optional},
      {"from", own, number, &calc::kNonNegativeType,
       "Of a share: the lower end of the range, which is in it. Of a glare-intensity or "
       "peak-intensity: luminaires from this height above the floor on, in metres."},
      {"to", own, number, &calc::kNonNegativeType,
       "Of a share: the upper end of the range, which is in it. Of a glare-intensity or "
       "peak-intensity: luminaires below this height, in metres."},
      {"reflectance", either, number, &calc::kPositiveFractionType,
       "Of GR: of the field, above 0, up to 1; grass has 0.15 to 0.25."},
      {"light", own, words, &kCountedLightType,
       "With or without reflected light; all if not given."},
      {"waived-because", waiver, text, &calc::kTextType,
       "Why a limit of the project's own is waived; all three attributes or none."},
      {"waived-by", waiver, text, &calc::kTextType, "Who has waived it."},
      {"waived-until", waiver, date, &calc::kDayType, "The last day of the waiver, YYYY-MM-DD."},
  };
}

calc::ElementRow make_require_element() {
  calc::ElementRow element = calc::kRequireElement;
  for (const RequirementAttribute& attribute : requirement_attributes()) {
    element.attributes.push_back(
        {attribute.name, attribute.type, calc::Presence::optional, attribute.meaning});
  }
  return element;
}

calc::ElementRow with_row(calc::ElementRow element) {
  for (const RequirementAttribute& attribute : requirement_attributes()) {
    if (!attribute.of_workplace) continue;
    element.attributes.push_back(
        {attribute.name, attribute.type, *attribute.of_workplace, attribute.meaning});
  }
  return element;
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

const calc::ElementRow& require_element() {
  static const calc::ElementRow kElement = make_require_element();
  return kElement;
}

const calc::ElementRow& workplace_element() {
  static const calc::ElementRow kElement = with_row(calc::kWorkplaceElement);
  return kElement;
}

const calc::ElementRow& workplace_grid_element() {
  static const calc::ElementRow kElement = with_row(calc::kWorkplaceGridElement);
  return kElement;
}

void check_value(calc::ElementReader& reader, std::string_view name) {
  if (!reader.has(name)) return;
  const RequirementAttribute& attribute = requirement_attribute(name);
  switch (attribute.kind) {
    case words:
      reader.choice(name, attribute.type->words);
      return;
    case number:
      reader.number(name, *attribute.type->range);
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
