#pragma once
// Several requirements judged as one: aggregates and classes of rule packs, and requirements on all
// rooms of a building. Plain data; judge_aggregates.h and judge_buildings.h make it.

#include "calc/base/diagnostics.h"
#include "calc/base/message.h"
#include "calc/base/names.h"
#include "rules/catalogue/compare.h"
#include "rules/catalogue/finding.h"
#include "rules/catalogue/requirement.h"

#include <optional>
#include <string>
#include <vector>

namespace rules {

// sum: for buildings only; the total of the members over all their floors meets the limit.
enum class AggregateRule { all, any, at_least, share, sum };

// What the members of an aggregate are.
enum class AggregateOver {
  checks,  // of one plane, or of one room if the checks are about several parts of it
  planes,  // of the project
  rooms,   // of the project
};

enum class AggregateKind { aggregate, row_class, building };

struct AggregateMember {
  std::string name;                       // id of the check, the plane or the room
  Verdict verdict = Verdict::not_judged;  // of everything in it together
  bool is_waived = false;                 // something in it is, see waiver.h
  std::optional<double> area_m2 = {};     // its weight in shares of area
  calc::Message reason = {};              // why it does not pass
  // The requirements it is made of; checks that nothing requires may be missing besides.
  std::vector<RequirementName> of = {};
  // Only for a sum: the member's value for each square metre, in the unit of the sum's requirement
  // (empty: not known), and the statement of the project that it rests on.
  std::optional<double> value = {};
  calc::Message stated = {};
  bool is_in_part = false;  // all passes, but is not all that the check is about: not judged
};

struct AggregateFinding {
  AggregateKind kind = AggregateKind::aggregate;
  std::string id;                                        // in its pack; "tower/LENI" of a building
  std::string building_id, building_was, building_name;  // "" of all others
  std::string space_id, plane_id;  // what it is about; both "" = the project, no plane = the room
  calc::Message clause;            // "LEED v4.1 ..."
  bool is_user_supplied = false;   // see RuleOrigin; of a building its sum says it
  calc::Message note;              // what every report must say with it; or ""
  AggregateRule rule = AggregateRule::all;
  AggregateOver over = AggregateOver::checks;
  int count = 0;                        // of at_least
  double share = 0.0;                   // of share, (0, 1]
  bool by_area = false;                 // of share: members weigh as much as their area
  Severity severity = Severity::shall;  // advice does not count
  Verdict verdict = Verdict::not_judged;
  bool is_waived = false;  // does not pass, but would if all that is waived were met
  calc::Message reason;    // of what does not pass
  std::vector<AggregateMember> members;
  // Only for classes: the row that the project requires, the best row that is surely reached and
  // the best that may be; "" = none.
  std::string asked, reached, possible;
  // Only for a sum: the total of the members. Its requirement has no plane; verdict, is_waived and
  // reason are those above.
  std::optional<Finding> sum = {};
  calc::SourceLocation where;
};

}  // namespace rules

namespace calc {

template <>
struct EnumNames<rules::AggregateRule> {
  static constexpr EnumName<rules::AggregateRule> list[] = {
      {rules::AggregateRule::all, "all"},
      {rules::AggregateRule::any, "any"},
      {rules::AggregateRule::at_least, "at-least"},
      {rules::AggregateRule::share, "share"},
      {rules::AggregateRule::sum, "sum"}};
};

template <>
struct EnumNames<rules::AggregateOver> {
  static constexpr EnumName<rules::AggregateOver> list[] = {
      {rules::AggregateOver::checks, "checks"},
      {rules::AggregateOver::planes, "planes"},
      {rules::AggregateOver::rooms, "rooms"}};
};

template <>
struct EnumNames<rules::AggregateKind> {
  static constexpr EnumName<rules::AggregateKind> list[] = {
      {rules::AggregateKind::aggregate, "aggregate"},
      {rules::AggregateKind::row_class, "class"},
      {rules::AggregateKind::building, "building"}};
};

}  // namespace calc
