#include "report/text/room_causes.h"

#include "report/text/aggregate_words.h"
#include "report/text/pass_factor.h"
#include "report/text/plane_names.h"
#include "report/text/sentences.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
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
  const char* unit = rules::unit_of(requirement);
  const Threshold threshold{requirement.limit, requirement.comparison};
  CauseWords words;
  if (finding.verdict == rules::Verdict::not_judged) {
    words.what = where + t[Text::colon] + fmt::format("{}", fmt::join(quantities, ", "));
  } else {
    const std::string measured = format_measured(t, finding.measured, unit, threshold);
    const std::string required = format_required(t, threshold, unit);
    words.what = cause.parts.size() == 1
                     ? t.say<Text::cause_of_one>(where, quantities.front(), measured, required)
                     : t.say<Text::cause_of_several>(
                           where, quantities.front(), measured,
                           plane_in_room(t, *room.space, *cause.worst().plane), required);
  }
  if (!finding.reason.empty()) words.more.push_back(sentence(t, finding.reason));
  if (std::string factor = pass_factor_words(t, finding); !factor.empty()) {
    words.more.push_back(std::move(factor));
  }
  return words;
}

}  // namespace report
