#pragma once
// What of a document people have written in its sentences, for sentence(); and texts of results
// that end in words of people.

#include "report/document/document.h"
#include "report/text/sentences.h"

#include <string>
#include <vector>

namespace report {

// Of a finding its waiver and the statements of its deviations; of a role and a space the zones
// that are left out; of a project these and all waivers.
std::vector<KnownWords> known_words(const Texts& t, const rules::Finding& finding);
std::vector<KnownWords> known_words(const Texts& t, const rules::RoleCoverage& role);
std::vector<KnownWords> known_words(const Texts& t, const SpacePart& space);
std::vector<KnownWords> known_words(const Texts& t, const ProjectPart& project);

// A clause of a rule pack, with how well its number is known; of others as it is. Behind it who
// says the number, where that is not a rule pack that comes with luxgate: "EN 12464-1:2021 34.2
// (project's own)". "" of "".
std::string clause_words(const Texts& t, const std::string& clause, rules::LimitSource source);
std::string clause_words(const Texts& t, const rules::Requirement& requirement);
std::string clause_words(const Texts& t, const rules::AggregateFinding& finding);
// For formats that show no clauses: "" of packs that come with luxgate.
std::string foreign_clause_words(const Texts& t, const rules::Requirement& requirement);

// PlanePart::changed; what stands in brackets at its end is the project's.
std::string changed_words(const Texts& t, const std::string& changed);

}  // namespace report
