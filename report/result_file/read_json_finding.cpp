#include "report/result_file/read_json_parts.h"
#include "report/text/words.h"

#include <array>
#include <optional>

namespace report {
namespace {

rules::DecisionPolicy policy(const JsonCursor& at) {
  using enum rules::Rounding;
  rules::DecisionPolicy p;
  p.compares_rounded = at["compares_rounded"].flag();
  p.rounding = at["rounding"].one_of(std::array{half_up, half_even, down}, rules::rounding_name);
  p.illuminance_digits = read_whole(at["illuminance_digits"]);
  p.ratio_digits = read_whole(at["ratio_digits"]);
  p.other_digits = read_whole(at["other_digits"]);
  p.tolerance = at["tolerance"].finite();
  p.tolerance_reason = at["tolerance_reason"].text();
  p.guard = at["guard"].finite();
  return p;
}

rules::Requirement requirement(const JsonCursor& at, const PlanePart& plane) {
  rules::Requirement r;
  r.plane_id = plane.id;
  r.derived = plane.derived;
  r.id = at["requirement"].text();
  const JsonCursor quantity = at["quantity"];
  const std::optional<rules::Metric> metric = rules::metric_from_name(quantity.text());
  if (!metric) quantity.refuse("no quantity has that name");
  r.metric = *metric;
  r.comparison = at["comparison"].one_of(
      std::array{rules::Comparison::at_least, rules::Comparison::at_most,
                 rules::Comparison::more_than, rules::Comparison::less_than},
      comparison_key);
  r.limit = at["limit"].number();
  r.state = at["state"].one_of(std::array{rules::LightState::maintained, rules::LightState::initial,
                                          rules::LightState::end_of_duration},
                               rules::state_name);
  r.scene = at["scene"].text();
  r.clause = at["clause"].text();
  r.where = read_location(at["where"]);
  r.note = at["requirement_note"].text();
  r.severity = at["severity"].one_of(
      std::array{rules::Severity::shall, rules::Severity::advice, rules::Severity::in_aggregate},
      severity_key);
  r.direct_only = at["direct_only"].flag();
  r.policy = policy(at["decision"]);
  if (const auto waiver = at.find("waiver")) {
    r.waiver = rules::Waiver{(*waiver)["reason"].text(), (*waiver)["owner"].text(),
                             (*waiver)["until"].text()};
  }
  if (const auto mask = at.find("mask")) r.mask.id = (*mask)["id"].text();
  const bool is_plain = calc::is_plain_number(r.derived);
  if (const auto from = at.find(is_plain ? "from" : "from_lx")) r.range.from = from->finite();
  const auto to = at.find(is_plain ? "to" : "to_lx");
  if (to && !to->is_null()) r.range.to = to->finite();
  if (const auto percent = at.find("percent")) r.percent = percent->finite();
  if (const auto point = at.find("point_m")) r.point_m = read_vec3(*point);
  return r;
}

}  // namespace

rules::Verdict read_verdict(const JsonCursor& at) {
  return at.one_of(std::array{rules::Verdict::pass, rules::Verdict::fail, rules::Verdict::undecided,
                              rules::Verdict::not_judged},
                   verdict_key);
}

rules::Finding read_finding(const JsonCursor& at, const PlanePart& plane) {
  rules::Finding f;
  f.requirement = requirement(at, plane);
  f.verdict = read_verdict(at["verdict"]);
  if (f.verdict != rules::Verdict::not_judged) {
    at["limit"].finite();  // only what is not judged may lack one
    f.measured = read_estimate(at["measured"]);
    f.margin = at["margin"].number();
    if (!at["place_m"].is_null()) f.place_m = read_vec3(at["place_m"]);
  }
  f.is_close = at["is_close"].flag();
  f.by_tolerance = at["by_tolerance"].flag();
  if (const auto waiver = at.find("waiver")) {
    const bool may_be_waived =
        f.verdict == rules::Verdict::fail || f.verdict == rules::Verdict::undecided;
    f.is_waived = (*waiver)["applies"].flag();
    if (f.is_waived && !may_be_waived) {
      (*waiver)["applies"].refuse("only 'fail' and 'undecided' can be waived");
    }
  }
  if (const auto mask = at.find("mask")) f.points_used = read_size((*mask)["points_used"]);
  f.reason = at["reason"].text();
  return f;
}

}  // namespace report
