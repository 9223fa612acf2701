#include "report/text/clause_words.h"

#include "report/text/sentences.h"

namespace report {

std::string clause_words(const Texts& t, const calc::Message& clause, rules::LimitSource source) {
  if (clause.empty()) return {};
  const std::string words = sentence(t, clause);
  switch (source) {
    case rules::LimitSource::pack:
      return words;
    case rules::LimitSource::project:
      return t.say<Text::clause_and_source>(words, t[Text::source_project]);
    case rules::LimitSource::user_pack:
      break;
  }
  return t.say<Text::clause_and_source>(words, t[Text::source_user_pack]);
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

}  // namespace report
