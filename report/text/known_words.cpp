#include "report/text/known_words.h"

#include <algorithm>
#include <cstddef>

namespace report {

std::vector<KnownWords> known_words(const Texts& t, const rules::RoleCoverage& role) {
  std::vector<KnownWords> known;
  for (const rules::LeftOutZone& zone : role.left_out) add_known(t, zone.by, known);
  return known;
}

std::vector<KnownWords> known_words(const Texts& t, const rules::Finding& finding) {
  std::vector<KnownWords> known;
  if (finding.requirement.waiver) add_known(t, *finding.requirement.waiver, known);
  for (const rules::Deviation& deviation : finding.requirement.deviations)
    if (deviation.stated) add_known(t, *deviation.stated, known);
  return known;
}

std::vector<KnownWords> known_words(const Texts& t, const SpacePart& space) {
  std::vector<KnownWords> known;
  for (const rules::RowCoverage& row : space.coverage) {
    for (const rules::RoleCoverage& role : row.roles) {
      const std::vector<KnownWords> zones = known_words(t, role);
      known.insert(known.end(), zones.begin(), zones.end());
    }
  }
  return known;
}

std::vector<KnownWords> known_words(const Texts& t, const ProjectPart& project) {
  std::vector<KnownWords> known;
  for (const SpacePart& space : project.spaces) {
    const std::vector<KnownWords> zones = known_words(t, space);
    known.insert(known.end(), zones.begin(), zones.end());
    for (const PlanePart& plane : space.planes) {
      for (const rules::Finding& finding : plane.findings)
        if (finding.requirement.waiver) add_known(t, *finding.requirement.waiver, known);
    }
  }
  for (const rules::AggregateFinding& aggregate : project.aggregates) {
    if (aggregate.sum && aggregate.sum->requirement.waiver)
      add_known(t, *aggregate.sum->requirement.waiver, known);
  }
  const auto is_less = [](const KnownWords& a, const KnownWords& b) {
    return a.english < b.english;
  };
  std::sort(known.begin(), known.end(), is_less);
  known.erase(
      std::unique(known.begin(), known.end(),
                  [](const KnownWords& a, const KnownWords& b) { return a.english == b.english; }),
      known.end());
  return known;
}

std::string clause_words(const Texts& t, const std::string& clause, rules::LimitSource source) {
  if (clause.empty()) return {};
  // What a project writes is no phrase of ours, whatever it ends with.
  if (source == rules::LimitSource::project) {
    return t.say<Text::clause_and_source>(clause, t[Text::source_project]);
  }
  const std::string words = clause.ends_with(']') ? phrases(t, clause) : clause;
  return source == rules::LimitSource::pack
             ? words
             : t.say<Text::clause_and_source>(words, t[Text::source_user_pack]);
}

std::string clause_words(const Texts& t, const rules::Requirement& requirement) {
  return clause_words(t, requirement.clause, rules::source_of(requirement));
}

std::string clause_words(const Texts& t, const rules::AggregateFinding& finding) {
  return finding.sum
             ? clause_words(t, finding.sum->requirement)
             : clause_words(t, finding.clause, rules::source_of_pack(finding.is_user_supplied));
}

std::string foreign_clause_words(const Texts& t, const rules::Requirement& requirement) {
  return rules::source_of(requirement) == rules::LimitSource::pack ? ""
                                                                   : clause_words(t, requirement);
}

std::string changed_words(const Texts& t, const std::string& changed) {
  const std::size_t remark = std::min(changed.find(" ("), changed.size());
  return phrases(t, changed.substr(0, remark)) + changed.substr(remark);
}

}  // namespace report
