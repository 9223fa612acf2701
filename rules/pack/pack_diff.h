#pragma once
// In what two rule packs differ, as data: two editions of a standard, or a pack before and after
// somebody has worked on it.

#include "calc/base/names.h"
#include "rules/pack/limit_change.h"
#include "rules/pack/pack_fields.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <string>
#include <vector>

namespace rules {

enum class PartChange { added, removed, changed };

struct FieldDifference {
  std::string name;                        // as of PackField
  std::optional<PackField> before, after;  // empty: it is not there
  // Of this change by itself, with everything else as in either pack. Of row values, entries of
  // tables, limits, severities, tolerances, and shares and counts of aggregates; else unclear.
  Tightening tightening = Tightening::unclear;
};

struct PartDifference {
  PackPart part = PackPart::pack;
  PartChange change = PartChange::changed;
  std::string id;        // in the first pack; of what was added: in the second
  std::string id_after;  // of a row that is matched with another
  std::string title;     // of rows: their name
  // Of a check that is there or not.
  Tightening tightening = Tightening::unclear;
  std::vector<FieldDifference> fields;  // of what was added or removed: all that it has
};

// The parts in the order of PackPart; those of a kind as in the first pack, then what was added as
// in the second. Where they stand in a file is no difference, nor is the file. rows: what rows of
// the first pack are called in the second; others are matched by their ref.
std::vector<PartDifference> diff_of(const RulePack& before, const RulePack& after,
                                    const RowNames& rows = {});

// Rows that only one pack has, and only by their number: those of one name that no other of them
// has.
RowNames likely_row_names(const std::vector<PartDifference>& parts);

// Of texts like "5.26.2=34.2", whose rows must be there.
struct ReadRowNames {
  RowNames names;
  std::string problem;  // in words; "" = none
};
ReadRowNames read_row_names(const std::vector<std::string>& texts, const RulePack& before,
                            const RulePack& after);

}  // namespace rules

namespace calc {

template <>
struct EnumNames<rules::PartChange> {
  static constexpr EnumName<rules::PartChange> list[] = {{rules::PartChange::added, "added"},
                                                         {rules::PartChange::removed, "removed"},
                                                         {rules::PartChange::changed, "changed"}};
};

}  // namespace calc
