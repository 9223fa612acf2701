#include "report/aggregate_words.h"

#include "report/number_format.h"
#include "report/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace report {
namespace {

bool is_class(const rules::AggregateFinding& finding) {
  return finding.kind == rules::AggregateKind::row_class;
}

std::string members_words(const rules::AggregateFinding& finding) {
  std::string noun = rules::over_name(finding.over);
  if (finding.members.size() == 1) noun.pop_back();  // "check"
  return fmt::format("{} {}", finding.members.size(), noun);
}

}  // namespace

std::string aggregate_title(const rules::AggregateFinding& finding) {
  return fmt::format("{} {}", rules::kind_name(finding.kind), finding.id);
}

std::string aggregate_required(const rules::AggregateFinding& finding) {
  if (is_class(finding)) return finding.asked;
  const std::string members = members_words(finding);
  switch (finding.rule) {
    case rules::AggregateRule::all:
      return "all of " + members;
    case rules::AggregateRule::any:
      return "any of " + members;
    case rules::AggregateRule::at_least:
      return fmt::format("at least {} of {}", finding.count, members);
    case rules::AggregateRule::share:
      break;
  }
  return fmt::format("at least {} of {}{}", format_percent(finding.share), members,
                     finding.by_area ? " by area" : "");
}

std::string aggregate_measured(const rules::AggregateFinding& finding) {
  if (!is_class(finding)) {
    const auto met =
        std::count_if(finding.members.begin(), finding.members.end(),
                      [](const auto& member) { return member.verdict == rules::Verdict::pass; });
    return fmt::format("{} of {} met", met, finding.members.size());
  }
  std::string words = finding.reached.empty() ? "none reached" : finding.reached + " reached";
  if (finding.possible != finding.reached) words += ", " + finding.possible + " possible";
  return words;
}

std::string aggregate_place(const ProjectPart& project, const rules::AggregateFinding& finding) {
  if (finding.space_id.empty()) return std::string(title_of(project.name, project.path));
  for (const SpacePart& space : project.spaces) {
    if (space.id != finding.space_id) continue;
    const std::string room(title_of(space.name, space.id));
    for (const PlanePart& plane : space.planes) {
      if (plane.id != finding.plane_id) continue;
      return room + " / " + std::string(title_of(plane.name, plane.id));
    }
    return room;
  }
  return finding.space_id;
}

std::string aggregate_note(const rules::AggregateFinding& finding) {
  std::string words = finding.note;
  const auto add = [&](const char* text) {
    words += (words.empty() ? "" : "; ") + std::string(text);
  };
  if (is_class(finding)) {
    add("its requirements count one by one");
  } else if (finding.severity != rules::Severity::shall) {
    add("advice: does not count");
  }
  return words;
}

}  // namespace report
