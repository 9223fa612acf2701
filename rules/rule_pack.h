#pragma once
// Requirements of a standard as data: rows by use of a space, each with limits. Loaded from XML,
// see README.md.

#include "calc/diagnostics.h"
#include "rules/requirement.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rules {

enum class RowLevel { required, modified };

// One quantity of a row. `modified` is the limit at level "modified" where it differs.
struct RowLimit {
  Metric metric = Metric::average;  // no percentile, no value at a point
  Comparison comparison = Comparison::at_least;
  double required = 0.0;  // lx, or a ratio
  std::optional<double> modified;
  std::string clause;  // within the standard; the row's ref unless given

  double at_level(RowLevel level) const {
    return level == RowLevel::modified ? modified.value_or(required) : required;
  }
};

struct RuleRow {
  std::string ref;    // "34.2", unique in the pack
  std::string name;   // use of the space, in own words
  std::string trust;  // where the numbers come from, in words
  std::vector<RowLimit> limits;
  calc::SourceLocation where;

  bool has_modified_level() const;
};

// A place where numbers were found.
struct RuleSource {
  std::string id, note;
};

struct RulePack {
  std::string id;       // "en12464-1"
  std::string edition;  // "2021"
  std::string title;    // "EN 12464-1"
  std::string version;  // of the pack itself
  std::string file;     // as named by the user; "built in"
  std::vector<RuleSource> sources;
  std::vector<RuleRow> rows;

  std::string full_id() const { return id + ":" + edition; }
  // nullptr if there is none.
  const RuleRow* find_row(std::string_view ref) const;
  // "EN 12464-1:2021 34.2", with " (modified)" where the level has a value of its own
  std::string clause_text(const RowLimit& limit, RowLevel level) const;
};

// Reads a pack from XML text. `file` is used in messages. Anything unknown, repeated or out of
// range is an error; all are reported, and the result is empty if and only if there was one.
std::optional<RulePack> parse_rule_pack(std::string_view xml, const std::string& file,
                                        calc::Diagnostics& diagnostics);

// The packs that are part of the program (rules/packs/*.xml).
std::vector<RulePack> builtin_rule_packs();

}  // namespace rules
