#pragma once
// The option for the language of texts for people; its values are report::kLanguages.

#include "report/shell/command/option_values.h"
#include "report/text/texts.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cli {

// Returns "en, de or fr".
inline std::string language_names() {
  std::string names;
  for (const report::LanguageRow& row : report::kLanguages) {
    const bool is_last = &row == &report::kLanguages.back();
    names += (names.empty() ? "" : is_last ? " or " : ", ") + std::string(row.tag);
  }
  return names;
}

inline ValueParser language_choice(report::Language& target) {
  std::vector<std::pair<std::string_view, report::Language>> table;
  for (const report::LanguageRow& row : report::kLanguages) {
    table.emplace_back(row.tag, row.language);
  }
  return choice<report::Language>(target, std::move(table));
}

}  // namespace cli
