#pragma once
// A revision as tables of words, which formats for people lay out.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

struct RevisionTable {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  // as long as the head
  std::size_t left_out = 0;                    // rows beyond `most`
  std::vector<std::size_t> english = {};       // columns that are English in every language
};

// Returns tables of changed results, requirements and inputs; tables without rows are omitted.
// most: rows of each.
std::vector<RevisionTable> revision_tables(const Document& document, const Texts& t,
                                           std::size_t most);

// Returns the remarks below them: unchanged results, notes, the gate's decision. Empty without a
// revision.
std::vector<std::string> revision_remarks(const Document& document, const Texts& t);

// Returns "main.json", "main (0123456789)": the file, or the git revision with the id of its
// commit.
std::string baseline_words(const Revision& revision);
// Returns the decision of a gate for regressions as a sentence; "" without a gate.
std::string gate_words(const Document& document, const Texts& t);

// Returns "✗ broken", for annotations and machine-readable reports.
const char* change_words(const Texts& t, ResultChange change);
const char* change_words(const Texts& t, QuestionChange change);
const char* part_words(const Texts& t, QuestionPart part);
// Returns "Office / Task area / average", with the project if there are several.
std::string place_words(const Document& document, const RevisionPlace& place, const Texts& t);

}  // namespace report
