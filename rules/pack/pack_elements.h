#pragma once
// Tables of the rule pack file format, and its schema. rules/README.md explains every element.

#include "calc/base/element_table.h"

#include <string>

namespace rules {

inline constexpr calc::NumberRange kSmallShare{0.0, 0.2, false, "a share from 0 to 0.2"};
inline constexpr calc::NumberRange kStripShare{0.0, 0.4999, false, "a share from 0 to below 0.5"};
inline constexpr calc::NumberRange kPercent{0.0, 100.0, false, "a number from 0 to 100"};

// Types for choices of words that have no enum.
extern const calc::ValueType kDigitsType, kStepsType, kComparedAsType, kGridMethodType,
    kGridCountType, kOrientationType, kHeightsAreType, kZoneAreaType, kCheckSeverityType,
    kCountedLightType, kSpecialPlaceType, kOutageType, kWaysType, kAggregateRuleType,
    kAggregateByType, kAggregateSeverityType, kPackKindType, kPackStatusType, kPackLicenceType;

// The order of its children is the order in which a pack is read.
extern const calc::ElementRow kRulePackElement;
extern const calc::ElementRow kSourceElement, kNameElement, kPolicyElement, kScaleElement,
    kGridElement, kPlaneElement, kCheckElement, kSpecialElement, kAggregateElement, kClassElement;
extern const calc::ElementRow kTableElement, kEntryElement;
extern const calc::ElementRow kMaskElement, kStripElement, kMaskWallsElement, kCentreLineElement;
extern const calc::ElementRow kRowElement, kValueElement;

// Returns the text of rules/pack/luxgate-rules-1.xsd, which 'luxgate rules schema' writes.
std::string rule_pack_schema();

}  // namespace rules
