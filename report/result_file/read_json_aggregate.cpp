#include "report/result_file/read_json_parts.h"
#include "report/text/words.h"

#include <array>

namespace report {
namespace {

rules::AggregateMember member(const JsonCursor& at) {
  return {at["name"].text(), read_verdict(at["verdict"]), at["is_waived"].flag(),
          read_optional_number(at["area_m2"]), at["reason"].text()};
}

}  // namespace

rules::AggregateFinding read_aggregate(const JsonCursor& at) {
  using rules::AggregateKind, rules::AggregateOver, rules::AggregateRule, rules::Severity;
  rules::AggregateFinding f;
  f.kind = at["kind"].one_of(std::array{AggregateKind::aggregate, AggregateKind::row_class},
                             rules::kind_name);
  f.id = at["id"].text();
  f.space_id = at["space"].text();
  f.plane_id = at["plane"].text();
  f.clause = at["clause"].text();
  f.note = at["note"].text();
  f.where = read_location(at["where"]);
  f.rule = at["rule"].one_of(std::array{AggregateRule::all, AggregateRule::any,
                                        AggregateRule::at_least, AggregateRule::share},
                             rules::rule_name);
  f.over = at["over"].one_of(
      std::array{AggregateOver::checks, AggregateOver::planes, AggregateOver::rooms},
      rules::over_name);
  f.count = read_whole(at["count"]);
  f.share = at["share"].finite();
  f.by_area = at["by_area"].flag();
  f.severity = at["severity"].one_of(std::array{Severity::shall, Severity::advice}, severity_key);
  f.verdict = read_verdict(at["verdict"]);
  f.is_waived = at["is_waived"].flag();
  if (f.is_waived && f.verdict == rules::Verdict::pass) {
    at["is_waived"].refuse("what passes cannot be waived");
  }
  f.reason = at["reason"].text();
  f.members = at["members"].list_of(member);
  f.asked = at["asked"].text();
  f.reached = at["reached"].text();
  f.possible = at["possible"].text();
  return f;
}

}  // namespace report
