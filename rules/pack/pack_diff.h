#pragma once
// The differences between two rule packs, as data: two editions of a standard, or a pack before and
// after an edit.

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
  // The effect of this change by itself, with everything else as in either pack. Known for row
  // values, entries of tables, limits, severities, tolerances, and shares and counts of aggregates;
  // otherwise unclear.
  Tightening tightening = Tightening::unclear;
};

struct PartDifference {
  PackPart part = PackPart::pack;
  PartChange change = PartChange::changed;
  std::string id;        // in the first pack; of what was added: in the second
  std::string id_after;  // of a row that is matched with another
  std::string title;     // of rows: their name
  // The effect of an added or removed check.
  Tightening tightening = Tightening::unclear;
  std::vector<FieldDifference> fields;  // of what was added or removed: all that it has
};

// Returns the changed parts in the order of PackPart, those of a kind in the order of the first
// pack, then the added ones in the order of the second. Places in a file, and the file, make no
// difference. rows: names of the first pack's rows in the second; other rows are matched by ref.
std::vector<PartDifference> diff_of(const RulePack& before, const RulePack& after,
                                    const RowNames& rows = {});

// Returns likely names for rows whose ref is in one pack only: pairs of rows with the same name,
// which no other of these rows has.
RowNames likely_row_names(const std::vector<PartDifference>& parts);

// Row names from texts like "5.26.2=34.2"; the packs must have these rows.
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
