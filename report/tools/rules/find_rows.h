#pragma once
// Finds rows of rule packs by common words for rooms and tasks, in English and German.

#include "rules/pack/rule_pack.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// Returns the text in lower case, with ae, oe, ue and ss in place of the German letters: "flaechen"
// for "Flächen".
std::string search_form(std::string_view text);

struct FoundRow {
  const rules::RulePack* pack;
  const rules::RuleRow* row;

  std::string id() const;  // "en12464-1:2021/34.2"
};

// Returns the rows that have every word of `words` in their id or in one of their names. Upper case
// and ways to write umlauts make no difference, and common words with the same meaning count:
// "meeting" finds "conference room". Rows with the words themselves come first, then the order is
// that of the packs. No words find no rows.
std::vector<FoundRow> find_rows(std::string_view words, const std::vector<rules::RulePack>& packs);

// Returns the first `most` of them, one a line: id, English name and German name. Lines have at
// most 80 columns.
std::string row_list(const std::vector<FoundRow>& rows, std::size_t most);

}  // namespace cli
