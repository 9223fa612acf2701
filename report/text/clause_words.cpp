#include "report/text/clause_words.h"

#include "report/document/one_source.h"
#include "report/text/sentences.h"
#include "rules/catalogue/row_level.h"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

namespace report {
namespace {

std::string words_of(const Texts& t, const rules::RowLevel& level) {
  if (level.is_modified) return t[Text::level_modified];
  const std::string steps = fmt::format("{:+}", level.steps);
  const bool is_one = level.steps == 1 || level.steps == -1;
  return is_one ? t.say<Text::level_step>(steps) : t.say<Text::level_steps>(steps);
}

// Of "EN 12464-1:2021 34.2 (+2 steps)", as clauses of rule packs have it.
std::string with_level(const Texts& t, std::string words) {
  if (t.language() == Language::english) return words;
  for (const std::string_view name : rules::level_names()) {
    const rules::RowLevel level = rules::level_named(name);
    if (level == rules::RowLevel::required) continue;
    const std::string english = " (" + rules::level_words(level) + ")";
    if (const std::size_t at = words.find(english); at != std::string::npos)
      return words.replace(at, english.size(), " (" + words_of(t, level) + ")");
  }
  return words;
}

}  // namespace

std::string clause_words(const Texts& t, const calc::Message& clause, rules::LimitSource source) {
  if (clause.empty()) return {};
  std::string words = sentence(t, without_one_source(clause));
  switch (source) {
    case rules::LimitSource::pack:
      return with_level(t, std::move(words));
    case rules::LimitSource::project:
      return t.say<Text::clause_and_source>(words, t[Text::source_project]);
    case rules::LimitSource::user_pack:
      break;
  }
  return t.say<Text::clause_and_source>(words, t[Text::source_user_pack]);
}

std::string level_words(const Texts& t, std::string_view english) {
  for (const std::string_view name : rules::level_names()) {
    const rules::RowLevel level = rules::level_named(name);
    if (level != rules::RowLevel::required && rules::level_words(level) == english)
      return words_of(t, level);
  }
  return std::string(english);
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
