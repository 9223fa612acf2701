#pragma once
// Which parts of a rule pack's row a room covers: a task that passes does not meet the whole row.

#include "calc/base/message.h"
#include "calc/base/names.h"
#include "calc/scene/project.h"
#include "rules/catalogue/compare.h"
#include "rules/pack/rule_pack.h"
#include "rules/verdict/judge_aggregates.h"
#include "rules/verdict/outcome.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rules {

enum class RoleState {
  met,
  failed,
  undecided,
  not_judged,
  waived,          // something of it, and the rest is met
  left_out,        // by the project, by name
  left_out_ended,  // so it was, and the last day is over
  not_made,        // by a workplace, which has no place for it in this room
  not_possible,    // its quantity is neither measured on planes nor stated by the makers
  never_asked,
  asked_in_part,  // of some of the walls only; or it is not known which walls there are
};

// Returns the state of a required role, from the outcome of all its requirements. has_waived: some
// of them are waived.
RoleState state_of(Outcome outcome, bool has_waived);
// Returns whether the state comes from findings: something is required.
constexpr bool is_of_findings(RoleState state) {
  switch (state) {
    case RoleState::met:
    case RoleState::failed:
    case RoleState::undecided:
    case RoleState::not_judged:
    case RoleState::waived:
      return true;
    case RoleState::left_out:
    case RoleState::left_out_ended:
    case RoleState::not_made:
    case RoleState::not_possible:
    case RoleState::never_asked:
    case RoleState::asked_in_part:
      break;
  }
  return false;
}
// A role, or a part of it, that the project omits.
struct LeftOutZone {
  std::string zone;  // "ceiling", "wall.2"
  calc::Waiver by;
  bool has_ended = false;
};

// One role: task, surround, wall, ...
struct RoleCoverage {
  std::string role;
  RoleState state = RoleState::never_asked;
  // left_out, not_made and not_possible: why. asked_in_part: what is missing. Parts of a role:
  // which part. Roles judged by another number than the row's: the project's reason.
  calc::Message words;
  std::vector<RequirementName> of = {};  // that its state is from; empty: none is asked
  std::vector<LeftOutZone> left_out = {};
};

// One row in a room, required by a workplace or by the <require> elements of the room's planes
// together.
struct RowCoverage {
  std::string workplace;            // its id; "" of <require> elements
  calc::Message clause;             // "EN 12464-1:2021 34.2", "EN 1838:2024 1, scene night"
  std::vector<RoleCoverage> roles;  // that the row requires something of, in the pack's order
  std::string was = {};             // the workplace's id in earlier revisions; "" = the same
  bool is_user_supplied = false;    // see RuleOrigin

  // Returns whether every role is required, now and in full, or has a stated reason why it is not.
  bool is_whole() const;
  // Returns whether the row is whole and no role is beyond judgement: all of the row has a verdict.
  bool asks_all() const;
  // Returns whether the project waives or omits a part of the row.
  bool has_exceptions() const;
  // Returns whether the row is whole and every part neither waived nor omitted is met.
  bool is_accepted() const;
  // Returns whether the row is met without exceptions; only then may a report say so.
  bool is_met() const { return is_accepted() && !has_exceptions(); }
};

// Returns why colour rendering is not judged in a light scene ("" = all luminaires at full output)
// against the row's comparison and limit; "" = there is no reason.
using RenderingProblem =
    std::function<calc::Message(const std::string& scene, Comparison comparison, double limit)>;

// Returns the coverage of all rows that the space refers to: workplaces in file order, then rows of
// <require> elements in the order of their planes. planes: of the space, see planes_asked(). Packs
// without rows have none. Advice does not count. today: YYYY-MM-DD.
std::vector<RowCoverage> row_coverage(const calc::Space& space,
                                      const std::vector<JudgedPlane>& planes,
                                      const std::vector<RulePack>& packs, std::string_view today,
                                      const RenderingProblem& rendering_problem);

// Returns all planes of the space, then those whose omission by a workplace has ended: they are
// required again, and cannot be judged.
std::vector<const calc::CalcPlane*> planes_asked(const calc::Space& space, std::string_view today);

// The eyes of a plane and the finding about their glare.
struct EyesAsked {
  const calc::CalcPlane* plane;
  const Finding* finding;
};
// Returns a remark for eyes that the project places itself and that meet their limit, if they look
// one way only or see no source that could be rated. "" = neither.
calc::Message eyes_in_part(const std::vector<EyesAsked>& eyes);

// Returns "leaving it out ended on 2027-06-30, by A. Meier: glass".
calc::Message ended_words(const calc::Waiver& by);

}  // namespace rules

namespace calc {

template <>
struct EnumNames<rules::RoleState> {
  static constexpr EnumName<rules::RoleState> list[] = {
      {rules::RoleState::met, "met"},
      {rules::RoleState::failed, "failed"},
      {rules::RoleState::undecided, "undecided"},
      {rules::RoleState::not_judged, "not-judged"},
      {rules::RoleState::waived, "waived"},
      {rules::RoleState::left_out, "left-out"},
      {rules::RoleState::left_out_ended, "left-out-ended"},
      {rules::RoleState::not_made, "not-made"},
      {rules::RoleState::not_possible, "not-possible"},
      {rules::RoleState::never_asked, "never-asked"},
      {rules::RoleState::asked_in_part, "asked-in-part"}};
};

}  // namespace calc
