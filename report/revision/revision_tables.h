#pragma once
// What a revision did, as tables of words that formats for people lay out.

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

// Results, questions and inputs that changed; those without rows are not there. most: rows of each.
std::vector<RevisionTable> revision_tables(const Document& document, const Texts& t,
                                           std::size_t most);

// What stands below them: how much is the same, notes, what the gate says. Empty without a
// revision.
std::vector<std::string> revision_remarks(const Document& document, const Texts& t);

// "main.json", "main (0123456789)": the file, or the git revision with the id of its commit.
std::string baseline_words(const Revision& revision);
// What a gate for regressions says of it, one sentence; "" without one.
std::string gate_words(const Document& document, const Texts& t);

// "✗ broken", for annotations and machines' reports.
const char* change_words(const Texts& t, ResultChange change);
const char* change_words(const Texts& t, QuestionChange change);
const char* part_words(const Texts& t, QuestionPart part);
// "Office / Task area / average", with the project where there are several.
std::string place_words(const Document& document, const RevisionPlace& place, const Texts& t);

}  // namespace report
