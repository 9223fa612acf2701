#include "rules/pack/pack_elements.h"

#include "calc/base/names.h"
#include "calc/base/xml_schema.h"
#include "rules/catalogue/aggregate.h"
#include "rules/catalogue/metric.h"
#include "rules/catalogue/policy.h"
#include "rules/catalogue/requirement.h"
#include "rules/catalogue/unit.h"
#include "rules/pack/rule_pack.h"

#include <vector>

namespace rules {
namespace {

using enum calc::Presence;
using calc::AttributeRow;
using calc::ElementRow;
using calc::kAnyDouble;
using calc::kAnyText;
using calc::ValueType;

ValueType words_type(std::string_view name, const calc::Names& words) {
  return {.name = name, .base = &kAnyText, .words = words};
}

ValueType number_type(std::string_view name, const calc::NumberRange& range) {
  return {.name = name, .base = &kAnyDouble, .range = range};
}

const ValueType kIdType{.name = "id", .base = &kAnyText, .pattern = R"(\s*[A-Za-z0-9_.:\-]+\s*)"};
const ValueType kIdsType{.name = "ids",
                         .base = &kAnyText,
                         .pattern = R"(\s*[A-Za-z0-9_.:\-]+(\s+[A-Za-z0-9_.:\-]+)*\s*)"};
const ValueType kTextType{.name = "text", .base = &kAnyText, .least = 1};
const ValueType kPositiveIntegerType{"xs:positiveInteger"};

const ValueType kAmountType = number_type("amount", calc::kNonNegative);
const ValueType kPositiveType = number_type("positive", calc::kPositive);
const ValueType kSmallShareType = number_type("smallShare", kSmallShare);
const ValueType kStripShareType = number_type("stripShare", kStripShare);
const ValueType kPercentType = number_type("percent", kPercent);
const ValueType kShareType = number_type("share", calc::kPositiveFraction);

const ValueType kUnitType = words_type("unit", unit_names());
const ValueType kTrustType = words_type("trust", calc::names_of<Trust>());
const ValueType kRoundingType = words_type("rounding", calc::names_of<Rounding>());
const ValueType kTableMatchType = words_type("tableMatch", calc::names_of<TableMatch>());
const ValueType kNoValueType = words_type("noValue", calc::names_of<NoValue>());
const ValueType kQuantityType = words_type("quantity", quantity_names());
const ValueType kStatisticType = words_type("statistic", metric_names());
const ValueType kLightStateType = words_type("lightState", calc::names_of<LightState>());
const ValueType kLightSourcesType = words_type("lightSources", calc::names_of<LightSources>());
const ValueType kAggregateOverType = words_type("aggregateOver", calc::names_of<AggregateOver>());
const ValueType kEntryValueType{.name = "entryValue", .verbatim = R"(<xs:union memberTypes="amount">
  <xs:simpleType>
    <xs:restriction base="xs:string"><xs:enumeration value="key"/></xs:restriction>
  </xs:simpleType>
</xs:union>)"};

const AttributeRow kIdAttribute{"id", &kIdType, required};
const AttributeRow kUnitAttribute{"unit", &kUnitType, required};
const AttributeRow kTrustAttribute{"trust", &kTrustType};
const AttributeRow kNoteAttribute{"note", &kAnyText};
const AttributeRow kClauseAttribute{"clause", &kAnyText};
const AttributeRow kMaskAttribute{"mask", &kIdType};
const AttributeRow kMetresAttribute{"metres", &kAmountType, required};
const AttributeRow kUpToWidthAttribute{"up-to-width", &kPositiveType};

}  // namespace

const ValueType kDigitsType = words_type("digits", {"0", "1", "2", "3", "4", "5", "6"});
const ValueType kStepsType = words_type("steps", {"0", "1", "2", "3"});
const ValueType kComparedAsType = words_type("comparedAs", {"raw", "rounded"});
const ValueType kGridMethodType =
    words_type("gridMethod", {"formula-power", "fixed-spacing", "fixed-count", "project"});
const ValueType kGridCountType = words_type("gridCount", {"nearest", "up", "odd-up", "given"});
const ValueType kOrientationType =
    words_type("orientation", {"horizontal-up", "horizontal-down", "vertical", "surface", "free"});
const ValueType kHeightsAreType = words_type("heightsAre", {"required", "usual"});
const ValueType kZoneAreaType =
    words_type("zoneArea", {"task", "band", "task-and-band", "walls", "ceiling"});
const ValueType kCheckSeverityType =
    words_type("checkSeverity", {"shall", "should", "may", "info", "in-aggregate"});
const ValueType kCountedLightType = words_type("countedLight", {"all", "direct"});
const ValueType kSpecialPlaceType =
    words_type("specialPlace", {calc::name_of(calc::SpecialPlace::unknown_task),
                                calc::name_of(calc::SpecialPlace::other_wall)});
const ValueType kOutageType = words_type("outage", {"none", "any-one-unit"});
const ValueType kWaysType = words_type("ways", {"all", "level"});
const ValueType kAggregateRuleType = [] {
  calc::Names names = calc::names_of<AggregateRule>();
  std::erase(names, calc::name_of(AggregateRule::sum));  // of buildings, which projects have
  return words_type("aggregateRule", names);
}();
const ValueType kAggregateByType = words_type("aggregateBy", {"count", "area"});
const ValueType kAggregateSeverityType =
    words_type("aggregateSeverity", {"shall", "should", "may", "info"});
const ValueType kPackKindType = words_type(
    "packKind", {"standard", "law", "code", "scheme", "guideline", "contract", "company"});
const ValueType kPackStatusType =
    words_type("packStatus", {"draft", "published", "superseded", "withdrawn"});
const ValueType kPackLicenceType =
    words_type("packLicence", {"public", "internal", "user-supplied"});

const ElementRow kSourceElement{
    .type = "source",
    .attributes = {kIdAttribute, {"note", &kTextType, required}, {"address", &kAnyText}}};

const ElementRow kNameElement{
    .type = "name",
    .attributes = {kIdAttribute, kUnitAttribute, {"meaning", &kTextType, required}}};

const ElementRow kPolicyElement{
    .type = "policy",
    .attributes = {{"compare", &kComparedAsType, optional, "", "raw"},
                   {"rounding", &kRoundingType, optional, "", "half-up"},
                   {"digits-illuminance", &kDigitsType},
                   {"digits-ratio", &kDigitsType},
                   {"digits-other", &kDigitsType},
                   {"tolerance", &kSmallShareType},
                   {"tolerance-reason", &kTextType},
                   {"guard", &kSmallShareType}}};

const ElementRow kEntryElement{
    .type = "entry",
    .attributes = {{"key", &kAmountType, required}, {"value", &kEntryValueType, required}}};

const ElementRow kTableElement{.type = "table",
                               .attributes = {kIdAttribute,
                                              {"key-unit", &kUnitType, required},
                                              {"value-unit", &kUnitType, required},
                                              {"match", &kTableMatchType, required},
                                              kTrustAttribute},
                               .children = {{"entry", &kEntryElement}},
                               .needs_child = true};

const ElementRow kScaleElement{
    .type = "scale",
    .meaning =
        "Preferred values, ascending. of: the parameter whose required value a project may move "
        "along the scale, with a reason (level=\"+1\"). down and up: how many steps.",
    .attributes = {kIdAttribute,
                   kUnitAttribute,
                   {"values", &kTextType, required},
                   {"of", &kIdType},
                   {"down", &kStepsType},
                   {"up", &kStepsType},
                   kTrustAttribute}};

const ElementRow kStripElement{
    .type = "strip",
    .attributes = {kMetresAttribute, {"share", &kStripShareType}, kUpToWidthAttribute}};
const ElementRow kMaskWallsElement{.type = "maskWalls", .attributes = {kMetresAttribute}};
const ElementRow kCentreLineElement{.type = "centreLine", .attributes = {kUpToWidthAttribute}};
const ElementRow kMaskElement{.type = "mask",
                              .attributes = {kIdAttribute},
                              .children = {{"inset", &kStripElement},
                                           {"walls", &kMaskWallsElement},
                                           {"border", &kMaskWallsElement},
                                           {"across", &kStripElement},
                                           {"centre-line", &kCentreLineElement}},
                              .needs_child = true};

const ElementRow kGridElement{
    .type = "grid",
    .meaning =
        R"(formula-power: p = factor x base^(log10 d) m, at most max-spacing; d is the longer side, or the shorter one from the
ratio of the sides on that "ratio" says; side / p, rounded as "count" says. Without these numbers: EN 12464-1.
fixed-spacing: at most "spacing" along the longer and the shorter side, count up. fixed-count: "cells", and
project: as the project says, count given.)",
    .attributes = {kIdAttribute,
                   {"method", &kGridMethodType, required},
                   {"count", &kGridCountType, required},
                   {"factor", &kAnyDouble},
                   {"base", &kAnyDouble},
                   {"max-spacing", &kAnyDouble},
                   {"ratio", &kAnyDouble},
                   {"spacing", &kTextType},
                   {"least", &kTextType, optional,
                    "Least points along the longer and the shorter side with fixed-spacing, "
                    "however small the area is."},
                   {"cells", &kTextType},
                   kTrustAttribute,
                   kNoteAttribute}};

const ElementRow kPlaneElement{
    .type = "plane",
    .attributes = {
        {"role", &kIdType, required},
        {"orientation", &kOrientationType, required,
         "Orientation of the plane's normal. For cylinders it is the axis; either end may be up."},
        {"heights", &kTextType},
        {"heights-are", &kHeightsAreType, optional, "", "required"},
        {"grid", &kIdType, optional,
         "A plane with fewer points than the grid gives to the same area does not fit. Without it "
         "any number fits."},
        kMaskAttribute,
        {"missing", &kSmallShareType, optional,
         "Share of the points that bodies or walls may take.", "0.1"},
        kNoteAttribute,
        {"area", &kZoneAreaType, optional,
         R"(What a workplace makes: the task area ("height" above the floor, needed); a band of "width" around the zone of
another role; the task area with such a band; every wall; the ceiling. "margin" is left out along walls, or
along the edges of walls and ceiling.)"},
        {"around", &kIdType, optional,
         "Role of the zone inside this zone, which is at least \"width\" wide. Without \"area\" "
         "the project draws it, and no workplace makes it."},
        {"holds", &kIdType, optional, "Role of the zone inside this zone; no workplace makes it."},
        {"width", &kAmountType},
        {"height", &kAmountType},
        {"margin", &kAmountType},
        {"narrow-below", &kPositiveType, optional,
         "For horizontal areas: in rooms less wide than this, the margin is at most narrow-share "
         "of the width."},
        {"narrow-share", &kStripShareType}}};

const ElementRow kValueElement{.type = "value",
                               .attributes = {{"of", &kIdType, required},
                                              {"required", &kAmountType},
                                              {"modified", &kAmountType},
                                              {"none", &kNoValueType},
                                              kTrustAttribute}};

const ElementRow kRowElement{
    .type = "row",
    .attributes = {{"ref", &kIdType, required},
                   {"name", &kTextType, required},
                   {"name-de", &kTextType, optional, "The name for readers of the German edition."},
                   {"trust", &kTrustType, required},
                   {"sources", &kIdsType},
                   kNoteAttribute,
                   {"task-heights", &kTextType},
                   {"task-orientation", &kOrientationType, optional,
                    "Of the task and the band around it, where it is not "
                    "that of the role's plane."}},
    .children = {{"value", &kValueElement}}};

const ElementRow kSpecialElement{
    .type = "special",
    .meaning =
        R"(A separate limit for a special place of a workplace: its task may be anywhere on the plane, or the plane is not on the
wall in front. rows: the rows that it is for; all rows if not given.)",
    .attributes = {
        {"place", &kSpecialPlaceType, required},
        {"limit", &kTextType, required, "A number with the unit of the limited quantity."},
        {"rows", &kIdsType},
        {"trust", &kTrustType, required},
        kNoteAttribute}};

const ElementRow kCheckElement{
    .type = "check",
    .attributes =
        {kIdAttribute,
         {"role", &kIdType, required},
         kClauseAttribute,
         {"severity", &kCheckSeverityType, optional, "", "shall"},
         {"quantity", &kQuantityType, required},
         {"statistic", &kStatisticType, required},
         {"percent", &kPercentType},
         {"from", &kTextType},
         {"to", &kTextType},
         kMaskAttribute,
         {"state", &kLightStateType, optional, "", "maintained"},
         {"sources", &kLightSourcesType, optional, "", "all"},
         {"light", &kCountedLightType, optional, "", "all"},
         {"outage", &kOutageType, optional, "", "none"},
         {"ways", &kWaysType, optional, "level: only for planes and routes that are level.", "all"},
         {"at-least", &kTextType},
         {"at-most", &kTextType},
         {"more-than", &kTextType},
         {"less-than", &kTextType},
         {"instead-of", &kIdType, optional,
          "Another check that requires the same in another way. It is enough to meet either."},
         kTrustAttribute,
         kNoteAttribute},
    .children = {{"special", &kSpecialElement}}};

const ElementRow kAggregateElement{
    .type = "aggregate",
    .attributes = {kIdAttribute,
                   {"rule", &kAggregateRuleType, required},
                   {"count", &kPositiveIntegerType},
                   {"share", &kShareType},
                   {"of", &kIdsType, required},
                   {"over", &kAggregateOverType, optional, "", "checks"},
                   {"by", &kAggregateByType, optional, "", "count"},
                   {"severity", &kAggregateSeverityType, optional, "", "shall"},
                   kClauseAttribute,
                   kTrustAttribute,
                   kNoteAttribute}};

const ElementRow kClassElement{
    .type = "class",
    .attributes = {kIdAttribute, {"rows", &kIdsType, required}, {"of", &kIdsType, required}}};

const ElementRow kRulePackElement{.type = "rulePack",
                                  .attributes = {kIdAttribute,
                                                 {"edition", &kIdType, required},
                                                 {"title", &kTextType, required},
                                                 {"version", &kIdType, required},
                                                 {"kind", &kPackKindType, required},
                                                 {"status", &kPackStatusType, required},
                                                 {"jurisdiction", &kAnyText},
                                                 {"licence", &kPackLicenceType, required},
                                                 {"licence-note", &kAnyText},
                                                 {"role", &kIdType, required}},
                                  .children = {{"source", &kSourceElement},
                                               {"parameter", &kNameElement},
                                               {"fact", &kNameElement},
                                               {"policy", &kPolicyElement},
                                               {"table", &kTableElement},
                                               {"scale", &kScaleElement},
                                               {"mask", &kMaskElement},
                                               {"grid", &kGridElement},
                                               {"plane", &kPlaneElement},
                                               {"row", &kRowElement},
                                               {"check", &kCheckElement},
                                               {"aggregate", &kAggregateElement},
                                               {"class", &kClassElement}},
                                  .needs_child = true};

std::string rule_pack_schema() {
  constexpr std::string_view kMeaning =
      R"(Rule packs of luxgate: a standard as data. rules/README.md explains every element. Beyond this schema luxgate checks
the formulas of limits: their names, their units, and that they do not go round in a circle.)";
  constexpr std::string_view kOfRoot =
      R"(<xs:unique name="rowRef"><xs:selector xpath="row"/><xs:field xpath="@ref"/></xs:unique>
<xs:unique name="checkId"><xs:selector xpath="check"/><xs:field xpath="@id"/></xs:unique>
<xs:key name="parameterId"><xs:selector xpath="parameter"/><xs:field xpath="@id"/></xs:key>
<xs:keyref name="valueOf" refer="parameterId"><xs:selector xpath="row/value"/><xs:field xpath="@of"/></xs:keyref>)";
  return calc::xml_schema(
      {"'luxgate rules schema'", kMeaning, {"rule-pack", &kRulePackElement, kOfRoot}});
}

}  // namespace rules
