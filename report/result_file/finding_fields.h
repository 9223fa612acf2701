#pragma once
// The result file, findings: requirements with their verdicts, aggregates, rows of rule packs. See
// result_fields.h.

#include "calc/base/day.h"
#include "calc/base/names.h"
#include "report/result_file/describe.h"
#include "report/text/words.h"
#include "rules/catalogue/aggregate.h"
#include "rules/verdict/coverage.h"
#include "rules/verdict/judge.h"
#include "rules/verdict/waiver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace report {

void describe(auto& v, Is<rules::DecisionPolicy> auto& policy) {
  v.field("compares_rounded", policy.compares_rounded);
  v.field("rounding", policy.rounding);
  v.field("illuminance_digits", policy.illuminance_digits);
  v.field("ratio_digits", policy.ratio_digits);
  v.field("other_digits", policy.other_digits);
  v.field("tolerance", policy.tolerance);
  v.field("tolerance_reason", policy.tolerance_reason, {.holds = Holds::prose});
  v.field("guard", policy.guard);
}

// Returns the units of all possible requirements, each once.
inline std::vector<std::string_view> requirement_units() {
  std::vector<std::string_view> units;
  for (const auto& metric : calc::EnumNames<rules::Metric>::list) {
    const std::string_view unit = rules::metric_unit(metric.value);
    if (std::find(units.begin(), units.end(), unit) == units.end()) units.push_back(unit);
  }
  return units;
}

void describe(auto& v, Is<rules::Waiver> auto& waiver) {
  v.field("reason", waiver.reason);
  v.field("owner", waiver.owner);
  v.field("until", waiver.until, {.words = "The last day, YYYY-MM-DD."});
  v.refuse_if(!calc::is_day(waiver.until), "until", "a day, YYYY-MM-DD, is needed");
}

void describe(auto& v, Is<rules::RequirementName> auto& name) {
  v.is("requirement_name", "One of the project's requirements.");
  v.field("plane", name.plane_id);
  v.field("requirement", name.id);
}

void describe(auto& v, Is<rules::Deviation> auto& deviation) {
  v.is("deviation");
  v.field("in", deviation.aspect);
  v.field("words", deviation.words);
  v.field("accepted", deviation.is_accepted,
          {.words = "The project states it, and its last day is not over."});
  v.field("stated", deviation.stated, {.presence = only_if(deviation.stated.has_value())});
}

// Describes the requirement's argument of this kind by fields(of). If its metric has another kind
// nothing is written or read; only the schema uses it.
template <class Argument>
void argument(auto& requirement, const auto& fields) {
  Argument of = rules::argument_of<Argument>(requirement);
  fields(of);
  const bool is_its_kind =
      std::holds_alternative<Argument>(rules::metric_row(requirement.metric).arguments);
  if (is_its_kind) assign(requirement.arguments, rules::MetricArguments(of));
}

void describe(auto& v, Is<rules::Finding> auto& finding) {
  auto& requirement = finding.requirement;
  v.is("finding");
  v.field("requirement", requirement.id, {.words = "Its id, unique within the plane."});
  v.field("was", requirement.was, {.presence = only_if(!requirement.was.empty())});
  v.field("quantity", requirement.metric, {.unknown = "unknown quantity"});
  v.written("unit", [&] { return std::string_view(rules::unit_of(requirement)); },
            {.choices = requirement_units()});
  v.field("comparison", requirement.comparison);
  v.field("limit", or_null(requirement.limit));
  v.field("state", requirement.state);
  v.field("scene", requirement.scene, {.words = "'': every luminaire at full output."});
  v.field("clause", requirement.clause);
  v.written(
      "source", [&] { return rules::source_of(requirement); },
      {.words = "Who says the limit: the project itself, a rule pack that comes with luxgate, "
                "or one that the user has given. A clause is free text.",
       .presence = kSinceLater});
  v.field("where", requirement.where);
  v.field("verdict", finding.verdict);
  const bool is_judged = finding.verdict != rules::Verdict::not_judged;
  v.refuse_if(is_judged && std::isnan(requirement.limit), "limit", "a number is needed");
  v.field("measured", finding.measured, {.null_if = !is_judged});
  v.field("margin", or_null(finding.margin),
          {.words = "(measured - limit) / limit, the sign turned for at_most: positive is good. "
                    "Null also where there is none, as for a limit of 0.",
           .null_if = !is_judged});
  v.field("without_replicate", finding.without_replicate,
          {.words = "The value without each replicate in turn: what differences between results "
                    "are made of.",
           .presence = only_if(!finding.without_replicate.empty())});
  v.field("is_close", finding.is_close, {.words = "Usual rounding would change the verdict."});
  v.field("place_m", finding.place_m, {.null_if = !is_judged});
  v.field("reason", finding.reason);
  v.field("doubtful", finding.is_doubtful,
          {.words = "There if samples do not show that the interval can be trusted: undecided, "
                    "wherever it lies.",
           .presence = only_if(finding.is_doubtful),
           .is_mark = true});
  v.written("note", [&] { return marked_note_words(finding); },
            {.words = "What must be read with the finding, in words.", .holds = Holds::prose});
  v.written("policy", [&] { return rules::policy_text(requirement.policy); },
            {.words = "How values are compared, in words.", .holds = Holds::prose});
  v.field("decision", requirement.policy);
  v.field("requirement_note", requirement.note);
  v.field("severity", requirement.severity);
  v.field("direct_only", requirement.direct_only);
  v.field("by_tolerance", finding.by_tolerance);
  const auto waiver = [&](auto& o) {
    rules::Waiver of = requirement.waiver.value_or(rules::Waiver{});
    describe(o, of);
    assign(requirement.waiver, of);
    o.field("applies", finding.is_waived);
    o.refuse_if(finding.is_waived && !rules::can_be_waived(finding.verdict), "applies",
                "only 'fail' and 'undecided' can be waived");
  };
  v.object("waiver", waiver, {.presence = only_if(requirement.waiver.has_value())});
  const auto rule = [&](auto& o) {
    o.field("pack", requirement.origin.pack, {.words = "With its edition: en12464-1:2021."});
    o.field("row", requirement.origin.row);
    o.field("check", requirement.origin.check);
    std::string level = rules::level_name(requirement.origin.level);
    o.field("level", level,
            {.words = "Which values of the row count.",
             .presence = kSinceLater,
             .choices = rules::level_names()});
    assign(requirement.origin.level, rules::level_named(level));
    o.field("is_weakened", requirement.origin.is_weakened,
            {.words = "Its limit is easier than what the row requires.",
             .presence = only_if(requirement.origin.is_weakened),
             .is_mark = true});
    o.field("user_supplied", requirement.origin.is_user_supplied,
            {.words = "The pack does not come with luxgate.",
             .presence = only_if(requirement.origin.is_user_supplied),
             .is_mark = true});
    bool is_of_other_role = !requirement.origin.is_of_own_role;
    o.field("of_other_role", is_of_other_role,
            {.words = "Of another role than the one that the pack is about: not of the task, but "
                      "of a wall, an observer ...",
             .presence = only_if(is_of_other_role),
             .is_mark = true});
    assign(requirement.origin.is_of_own_role, !is_of_other_role);
    o.field("workplaces", requirement.origin.workplaces,
            {.words = "Ids of those that ask for it; none: a <require>.",
             .presence = only_if(!requirement.origin.workplaces.empty())});
  };
  v.object("rule", rule, {.presence = only_if(!requirement.origin.pack.empty())});
  v.field("deviations", requirement.deviations,
          {.words = "In what the plane is not the one that the rule pack's number is about.",
           .presence = only_if(!requirement.deviations.empty())});
  // The ends of a range have one name in lx, and another without a unit.
  const bool is_share = requirement.metric == rules::Metric::share;
  const bool is_plain = calc::is_plain_number(requirement.derived);
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  argument<rules::ValueRange>(requirement, [&](rules::ValueRange& range) {
    v.field(
        "from", range.from,
        {.words = "Of quantities without unit, as to.", .presence = only_if(is_share && is_plain)});
    v.field("to", or_null(range.to, kOpen),
            {.words = "null: no upper end.", .presence = only_if(is_share && is_plain)});
    v.field("from_lx", range.from, {.presence = only_if(is_share && !is_plain)});
    v.field("to_lx", or_null(range.to, kOpen),
            {.words = "null: no upper end.", .presence = only_if(is_share && !is_plain)});
  });
  argument<rules::HeightRange>(requirement, [&](rules::HeightRange& range) {
    const Presence presence = only_if(rules::has_mounting_heights(requirement.metric));
    v.field("from_m", range.from_m,
            {.words = "Of the luminaires that count, above the floor.", .presence = presence});
    v.field("to_m", or_null(range.to_m, kOpen),
            {.words = "They hang below it. null: no upper end.", .presence = presence});
  });
  const auto mask = [&](auto& o) {
    o.field("id", requirement.mask.id);
    o.field("points_used", finding.points_used);
    o.field("words", requirement.mask_words, {.presence = kSinceLater});
  };
  v.object("mask", mask, {.presence = only_if(!requirement.mask.id.empty())});
  const bool is_energy = requirement.metric == rules::Metric::leni;
  v.field("energy", requirement.stated_words,
          {.words = "From which hours and factors: also in requirement_note.",
           .presence = only_if(is_energy && !requirement.stated_words.empty())});
  v.field(
      "stated", requirement.stated_words,
      {.words = "What the project states of a road or a field, or the makers of their luminaires, "
                "in words: the value rests on it and is not calculated.",
       .presence = only_if(!is_energy && !requirement.stated_words.empty())});
  argument<rules::LitField>(requirement, [&](rules::LitField& field) {
    v.field("field_reflectance", field.reflectance,
            {.words = "Stated, of the field that GR is rated on.",
             .presence = only_if(field.reflectance > 0.0)});
  });
  argument<rules::Percentile>(requirement, [&](rules::Percentile& of) {
    v.field("percent", of.percent,
            {.presence = only_if(requirement.metric == rules::Metric::percentile)});
  });
  argument<rules::PointOfValue>(requirement, [&](rules::PointOfValue& at) {
    v.field("point_m", at.point_m, {.presence = only_if(at.point_m.has_value())});
    v.field("facing", at.facing, {.presence = only_if(at.facing.has_value())});
  });
}

void describe(auto& v, Is<rules::LeftOutZone> auto& zone) {
  v.is("left_out_zone");
  v.field("zone", zone.zone, {.words = "The role, or a part of it: wall.2."});
  describe(v, zone.by);
  v.field("has_ended", zone.has_ended,
          {.words = "The last day is over: the zone counts as not judged."});
}

void describe(auto& v, Is<rules::RoleCoverage> auto& role) {
  v.is("role_coverage");
  v.field("role", role.role);
  v.field("state", role.state);
  v.field("words", role.words);
  v.field("of", role.of, {.words = "What the state is from; empty: nothing is asked."});
  v.field("left_out", role.left_out,
          {.words = "What of the role the project leaves out.",
           .presence = only_if(!role.left_out.empty())});
}

void describe(auto& v, Is<rules::RowCoverage> auto& row) {
  v.is("row_coverage");
  v.field("workplace", row.workplace, {.words = "'': the require elements of the space's planes."});
  v.field("was", row.was, {.presence = only_if(!row.was.empty())});
  v.field("clause", row.clause);
  v.field("user_supplied", row.is_user_supplied,
          {.words = "The pack does not come with luxgate.",
           .presence = only_if(row.is_user_supplied),
           .is_mark = true});
  v.written("is_whole", [&] { return row.is_whole(); },
            {.words = "Nothing of the row was never asked."});
  v.written("is_met", [&] { return row.is_met(); },
            {.words = "All of the row is met, with nothing waived and nothing left out."});
  v.written("is_accepted", [&] { return row.is_accepted(); },
            {.words = "All of the row is met but for what is waived or left out.",
             .presence = kSinceLater});
  v.field("roles", row.roles);
}

void describe(auto& v, Is<rules::AggregateMember> auto& member) {
  v.field("name", member.name);
  v.field("verdict", member.verdict);
  v.field("is_waived", member.is_waived);
  v.field("area_m2", member.area_m2);
  v.field("in_part", member.is_in_part,
          {.words = "There if all of it passes, and it is not all that the check is about, such as "
                    "eyes that look one way only: not judged.",
           .presence = only_if(member.is_in_part),
           .is_mark = true});
  v.field("reason", member.reason);
  v.field("of", member.of, {.words = "What it is made of, beside checks that nothing asks for."});
  v.field("value", member.value,
          {.words = "Of a sum: what it has for each square metre, in the unit of the sum.",
           .presence = only_if(member.value.has_value())});
  v.field("stated", member.stated,
          {.words = "Of a sum: what the project states that the value rests on.",
           .presence = only_if(!member.stated.empty())});
}

void describe(auto& v, Is<rules::AggregateFinding> auto& finding) {
  v.is("aggregate",
       "Several requirements as one, as a rule pack has them: an aggregate, or a class of rows. "
       "What "
       "is about one plane names it; without plane it is about the room, without space about the "
       "project. Or what is asked of the rooms of a building together.");
  v.field("kind", finding.kind);
  v.field("id", finding.id);
  const bool is_building = finding.kind == rules::AggregateKind::building;
  v.field("building", finding.building_id, {.presence = only_if(is_building)});
  v.field("building_was", finding.building_was,
          {.presence = only_if(!finding.building_was.empty())});
  v.field("building_name", finding.building_name,
          {.presence = only_if(!finding.building_name.empty())});
  v.field("space", finding.space_id);
  v.field("plane", finding.plane_id);
  v.field("clause", finding.clause);
  v.field("user_supplied", finding.is_user_supplied,
          {.words = "The pack does not come with luxgate.",
           .presence = only_if(finding.is_user_supplied),
           .is_mark = true});
  v.field("note", finding.note);
  v.field("where", finding.where);
  v.field("rule", finding.rule);
  v.field("over", finding.over, {.words = "What the members are."});
  v.field("count", finding.count, {.words = "Of at-least."});
  v.field("share", finding.share, {.words = "Of share.", .least = 0.0, .most = 1.0});
  v.field("by_area", finding.by_area);
  // An aggregate counts by itself or not at all, never in another one.
  v.field("severity", finding.severity, {.choices = {"shall", "advice"}});
  v.field("verdict", finding.verdict);
  v.field("is_waived", finding.is_waived);
  v.refuse_if(finding.is_waived && finding.verdict == rules::Verdict::pass, "is_waived",
              "what passes cannot be waived");
  v.field("reason", finding.reason);
  v.field("members", finding.members);
  v.field("asked", finding.asked,
          {.words = "Of classes: the one asked for, the best that is reached for certain, the best "
                    "that may be; empty: none."});
  v.field("reached", finding.reached);
  v.field("possible", finding.possible);
  v.field("sum", finding.sum,
          {.words = "Of a sum: what its members come to over all of their floors.",
           .presence = only_if(finding.sum.has_value())});
  v.refuse_if((finding.rule == rules::AggregateRule::sum) != finding.sum.has_value(), "sum",
              "a sum has it, and nothing else has");
}

}  // namespace report
