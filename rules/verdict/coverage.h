#pragma once
// What of a row of a rule pack is asked in a room: a task that passes is not yet a row that is met.

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

// Of a role that is asked for: what everything that is asked came to. has_waived: something of it
// is waived.
RoleState state_of(Outcome outcome, bool has_waived);
// Something is asked for, and this is what it came to.
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
// A role, or a part of it, that the project leaves out.
struct LeftOutZone {
  std::string zone;  // "ceiling", "wall.2"
  calc::Waiver by;
  bool has_ended = false;
};

// One role: task, surround, wall, ...
struct RoleCoverage {
  std::string role;
  RoleState state = RoleState::never_asked;
  // Of left_out, not_made and not_possible: why; of asked_in_part: without what; parts of a role:
  // which. Of what is asked by another number than the row's: what the project says for it.
  calc::Message words;
  std::vector<RequirementName> of = {};  // that its state is from; empty: none is asked
  std::vector<LeftOutZone> left_out = {};
};

// One row in a room, by a workplace or by the <require> elements of the room's planes together.
struct RowCoverage {
  std::string workplace;            // its id; "" of <require> elements
  calc::Message clause;             // "EN 12464-1:2021 34.2", "EN 1838:2024 1, scene night"
  std::vector<RoleCoverage> roles;  // that the row requires something of, in the pack's order
  std::string was = {};             // the workplace's id in earlier revisions; "" = the same
  bool is_user_supplied = false;    // see RuleOrigin

  // Nothing of it was never asked, or is no longer, or is asked of a part only.
  bool is_whole() const;
  // So it is, and nothing of it cannot be judged: all of the row has a verdict.
  bool asks_all() const;
  // Something of it is waived, or left out by the project.
  bool has_exceptions() const;
  // Whole, and all that is neither waived nor left out is met.
  bool is_accepted() const;
  // So it is, without exceptions: only then may anybody say that the row is met.
  bool is_met() const { return is_accepted() && !has_exceptions(); }
};

// Why the colour rendering of the space's luminaires is not asked of a row, in a light scene by its
// name ("" = all at full output), with the row's comparison and limit; "" = nothing speaks against
// it.
using RenderingProblem =
    std::function<calc::Message(const std::string& scene, Comparison comparison, double limit)>;

// Of all rows that something in the space refers to: workplaces in file order, then rows of
// <require> elements in the order of their planes. planes: of the space, see planes_asked(). Packs
// without rows have none. What is advice only does not count. today: YYYY-MM-DD.
std::vector<RowCoverage> row_coverage(const calc::Space& space,
                                      const std::vector<JudgedPlane>& planes,
                                      const std::vector<RulePack>& packs, std::string_view today,
                                      const RenderingProblem& rendering_problem);

// All planes of the space, and after them those that a workplace has left out up to a day that is
// over: they are asked for again, and cannot be judged.
std::vector<const calc::CalcPlane*> planes_asked(const calc::Space& space, std::string_view today);

// Eyes of a plane, with what was found of their glare.
struct EyesAsked {
  const calc::CalcPlane* plane;
  const Finding* finding;
};
// Of eyes that the project places itself and that meet their limit: whoever looks one way only has
// chosen the way, and what no eye sees was not rated. "" = neither.
calc::Message eyes_in_part(const std::vector<EyesAsked>& eyes);

// "leaving it out ended on 2027-06-30, by A. Meier: glass"
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
