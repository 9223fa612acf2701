#pragma once
// Numbers of standards that rest on one public source. Results keep the mark at the clause and in
// the note of each requirement. A report says it once, with the rows, see
// report/text/one_source_note.h.

#include "calc/base/message.h"
#include "rules/catalogue/requirement.h"

#include <string>
#include <vector>

namespace report {

struct ProjectPart;
struct Totals;

// Returns whether the clause or the note has the mark.
bool rests_on_one_source(const calc::Message& clause, const calc::Message& note);

// Returns a clause or note as it is read beside a single requirement: without the mark. The graver
// mark, that nobody has verified a number, stays.
calc::Message without_one_source(const calc::Message& message);

// Adds the clause, without the mark, of a requirement that has it, unless it is there.
void add_one_source_row(const rules::Requirement& requirement, std::vector<calc::Message>& rows);
// Adds those of all findings and aggregates, in their order.
void add_one_source_rows(const ProjectPart& project, std::vector<calc::Message>& rows);

// Returns their names in English, for result files.
std::vector<std::string> one_source_names(const Totals& totals);

}  // namespace report
