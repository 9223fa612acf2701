#pragma once
// Words for the source of a limit.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>
#include <string_view>

namespace report {

// A clause of a rule pack, with "[unverified requirement]" where nobody has verified its number; of
// others as it is. That a number rests on one public source is said once per report, see
// one_source_note.h. Behind it who says the number, where that is not a rule pack that comes with
// luxgate: "EN 12464-1:2021 34.2 (project's own)". "" of "".
std::string clause_words(const Texts& t, const calc::Message& clause, rules::LimitSource source);
std::string clause_words(const Texts& t, const rules::Requirement& requirement);
std::string clause_words(const Texts& t, const rules::AggregateFinding& finding);
// Returns the source for formats that show no clauses; "" for packs that come with luxgate.
std::string foreign_clause_words(const Texts& t, const rules::Requirement& requirement);

// Returns the words of rules::level_words() in the reader's language; other words unchanged.
std::string level_words(const Texts& t, std::string_view english);

}  // namespace report
