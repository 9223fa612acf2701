#include "report/text/room_causes.h"

#include "report/text/aggregate_words.h"
#include "report/text/pass_factor.h"
#include "report/text/plain_text.h"
#include "report/text/plane_names.h"
#include "report/text/room_titles.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace report {
namespace {

void add_new(std::vector<std::string>& list, std::string text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(std::move(text));
}

std::string quantity_of(const Texts& t, const RoomCause::Part& part) {
  const rules::Requirement& requirement = part.finding->requirement;
  return quantity_words(t, requirement, part.plane->kernel) + scene_words(t, requirement);
}

const char* causes_title(const Texts& t, rules::Outcome outcome) {
  switch (outcome) {
    case rules::Outcome::fail:
      return t[Text::causes_fail];
    case rules::Outcome::undecided:
      return t[Text::causes_undecided];
    case rules::Outcome::waived:
      return t[Text::causes_waived];
    default:
      return t[Text::causes_not_judged];
  }
}

void add_entry(const std::string& room, std::vector<CauseWords> causes,
               std::vector<CauseEntry>& entries) {
  const auto known = std::find_if(entries.begin(), entries.end(),
                                  [&](const CauseEntry& one) { return one.causes == causes; });
  if (known == entries.end()) {
    entries.push_back({{room}, std::move(causes)});
  } else {
    known->rooms.push_back(room);
  }
}

CauseWords aggregate_cause(const Texts& t, const rules::AggregateFinding& finding) {
  CauseWords words{aggregate_title(t, finding), {}};
  if (finding.verdict != rules::Verdict::not_judged) {
    words.what = t.say<Text::cause_of_all>(words.what, aggregate_measured(t, finding),
                                           aggregate_required(t, finding));
  }
  if (!finding.reason.empty()) words.more.push_back(sentence(t, finding.reason));
  return words;
}

}  // namespace

std::string some_names(const Texts& t, std::vector<std::string> names) {
  constexpr std::size_t kMostNamed = 3;
  const std::size_t more = names.size() - std::min(names.size(), kMostNamed);
  names.resize(names.size() - more);
  const std::string named = fmt::format("{}", fmt::join(names, ", "));
  return more == 0 ? named : t.say<Text::names_and_more>(named, more);
}

CauseWords cause_words(const Texts& t, const RoomSummary& room, const RoomCause& cause) {
  if (cause.aggregate != nullptr) return aggregate_cause(t, *cause.aggregate);
  std::vector<std::string> planes, quantities;
  for (const RoomCause::Part& part : cause.parts) {
    add_new(planes, plane_in_room(t, *room.space, *part.plane));
    add_new(quantities, quantity_of(t, part));
  }
  const std::string where = some_names(t, planes);
  const rules::Finding& finding = *cause.worst().finding;
  const rules::Requirement& requirement = finding.requirement;
  CauseWords words;
  if (finding.verdict == rules::Verdict::not_judged) {
    words.what = where + t[Text::colon] + fmt::format("{}", fmt::join(quantities, ", "));
  } else {
    const std::string measured = measured_words(t, finding);
    const std::string required = format_required(
        t, Threshold{requirement.limit, requirement.comparison}, rules::unit_of(requirement));
    words.what = cause.parts.size() == 1
                     ? t.say<Text::cause_of_one>(where, quantities.front(), measured, required)
                     : t.say<Text::cause_of_several>(
                           where, quantities.front(), measured,
                           plane_in_room(t, *room.space, *cause.worst().plane), required);
  }
  if (!finding.reason.empty()) words.more.push_back(sentence(t, finding.reason));
  if (std::string remedy = remedy_words(t, *room.space, finding); !remedy.empty()) {
    words.more.push_back(std::move(remedy));
  }
  return words;
}

std::vector<CauseBlock> cause_blocks(const Texts& t, const ProjectPart& project) {
  const std::vector<std::string> titles = room_titles(project);
  std::map<rules::Outcome, CauseBlock> blocks;
  for (const RoomSummary& room : room_summaries(project)) {
    std::map<rules::Outcome, std::vector<CauseWords>> own;
    for (const RoomCause& cause : room.causes) {
      std::vector<CauseWords>& causes = own[cause.outcome];
      CauseWords words = cause_words(t, room, cause);
      if (!causes.empty() && causes.back().more == words.more) causes.back().more.clear();
      causes.push_back(std::move(words));
    }
    const auto place = static_cast<std::size_t>(room.space - project.spaces.data());
    for (auto& [outcome, causes] : own) {
      CauseBlock& block = blocks[outcome];
      block.outcome = outcome;
      block.title = causes_title(t, outcome);
      add_entry(titles[place], std::move(causes), block.entries);
    }
  }
  std::vector<CauseBlock> list;
  for (auto& [outcome, block] : blocks) list.push_back(std::move(block));
  return list;
}

}  // namespace report
