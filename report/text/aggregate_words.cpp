#include "report/text/aggregate_words.h"

#include "calc/base/elementary.h"
#include "report/document/one_source.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace report {
namespace {

bool is_class(const rules::AggregateFinding& finding) {
  return finding.kind == rules::AggregateKind::row_class;
}

// Of the members' area, for those that weigh by it; empty if an area is not known.
std::optional<double> share_met(const rules::AggregateFinding& finding) {
  if (!finding.by_area) return std::nullopt;
  double met_m2 = 0.0, all_m2 = 0.0;
  for (const rules::AggregateMember& member : finding.members) {
    if (!member.area_m2) return std::nullopt;
    all_m2 += *member.area_m2;
    if (member.verdict == rules::Verdict::pass) met_m2 += *member.area_m2;
  }
  return all_m2 > 0.0 ? std::optional(met_m2 / all_m2) : std::nullopt;
}

// "89.96 %": as many digits as keep it on its side of what is required.
std::string share_text(double share, double required) {
  const auto is_kept = [&](int decimals) {
    const double scale = calc::pow(10.0, decimals);
    return (std::round(100.0 * share * scale) >= 100.0 * required * scale) == (share >= required);
  };
  int decimals = 1;
  while (decimals < 9 && !is_kept(decimals)) ++decimals;
  return format_fixed(100.0 * share, decimals) + " %";
}

// "1 check", "5 rooms"
std::string members_words(const Texts& t, const rules::AggregateFinding& finding) {
  const std::size_t count = finding.members.size();
  switch (finding.over) {
    case rules::AggregateOver::checks:
      return count == 1 ? t.say<Text::one_check>(count) : t.say<Text::some_checks>(count);
    case rules::AggregateOver::planes:
      return count == 1 ? t.say<Text::one_plane>(count) : t.say<Text::some_planes>(count);
    case rules::AggregateOver::rooms:
      break;
  }
  return count == 1 ? t.say<Text::one_room>(count) : t.say<Text::some_rooms>(count);
}

// "5.93 W/m² (14 rooms, 208.4 m²)"
std::string sum_words(const Texts& t, const rules::AggregateFinding& finding) {
  const std::size_t count = finding.members.size();
  const std::string rooms =
      count == 1 ? t.say<Text::one_room>(count) : t.say<Text::rooms_together>(count);
  if (finding.verdict == rules::Verdict::not_judged) return rooms;
  const rules::Requirement& asked = finding.sum->requirement;
  double area_m2 = 0.0;
  for (const rules::AggregateMember& member : finding.members) {
    area_m2 += member.area_m2.value_or(0.0);
  }
  return fmt::format("{} ({}, {} m²)",
                     format_measured(t, finding.sum->measured, rules::unit_of(asked),
                                     Threshold{asked.limit, asked.comparison}),
                     rooms, format_fixed(t, area_m2, 1));
}

}  // namespace

std::string aggregate_title(const Texts& t, const rules::AggregateFinding& finding) {
  if (finding.sum && finding.kind == rules::AggregateKind::building) {
    return quantity_words(t, finding.sum->requirement);
  }
  return is_class(finding) ? t.say<Text::class_title>(finding.id)
                           : t.say<Text::aggregate_title>(finding.id);
}

std::string aggregate_required(const Texts& t, const rules::AggregateFinding& finding) {
  if (is_class(finding)) return finding.asked;
  if (finding.sum) {
    const rules::Requirement& asked = finding.sum->requirement;
    return format_required(t, {asked.limit, asked.comparison}, rules::unit_of(asked));
  }
  const std::string members = members_words(t, finding);
  switch (finding.rule) {
    case rules::AggregateRule::all:
      return t.say<Text::all_of>(members);
    case rules::AggregateRule::any:
      return t.say<Text::any_of>(members);
    case rules::AggregateRule::at_least:
      return t.say<Text::at_least_of>(finding.count, members);
    case rules::AggregateRule::share:
    case rules::AggregateRule::sum:
      break;
  }
  const std::string share = format_percent(t, finding.share);
  return finding.by_area ? t.say<Text::at_least_of_area>(share, members)
                         : t.say<Text::at_least_of>(share, members);
}

std::string aggregate_measured(const Texts& t, const rules::AggregateFinding& finding) {
  if (finding.sum) return sum_words(t, finding);
  if (!is_class(finding)) {
    const auto met =
        std::count_if(finding.members.begin(), finding.members.end(),
                      [](const auto& member) { return member.verdict == rules::Verdict::pass; });
    const std::string words = t.say<Text::met_of>(met, finding.members.size());
    const std::optional<double> share = share_met(finding);
    return share ? t.say<Text::area_met>(t.number(share_text(*share, finding.share)), words)
                 : words;
  }
  const std::string reached = finding.reached.empty() ? std::string(t[Text::no_class_reached])
                                                      : t.say<Text::class_reached>(finding.reached);
  return finding.possible == finding.reached
             ? reached
             : reached + ", " + t.say<Text::class_possible>(finding.possible);
}

std::string aggregate_place(const ProjectPart& project, const rules::AggregateFinding& finding) {
  if (finding.kind == rules::AggregateKind::building) {
    return std::string(title_of(finding.building_name, finding.building_id));
  }
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

const char* aggregate_remark(const Texts& t, const rules::AggregateFinding& finding) {
  if (is_class(finding)) return t[Text::count_one_by_one];
  return finding.severity == rules::Severity::shall ? "" : t[Text::note_advice];
}

std::string aggregate_note(const Texts& t, const rules::AggregateFinding& finding) {
  if (finding.sum) {
    const std::string close = close_words(t, *finding.sum);
    const std::string note = note_words(t, *finding.sum);
    return note + (note.empty() || close.empty() ? "" : "; ") + close;
  }
  const std::string remark = aggregate_remark(t, finding);
  const std::string note = sentence(t, without_one_source(finding.note));
  return note + (note.empty() || remark.empty() ? "" : "; ") + remark;
}

}  // namespace report
