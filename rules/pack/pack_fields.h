#pragma once
// A rule pack as parts with named fields, in words, for comparing two packs. A field has the name
// of its attribute in the file, as in pack_elements.h.

#include "calc/base/names.h"
#include "rules/pack/rule_pack.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rules {

// The kinds of parts, in the order of reports.
enum class PackPart {
  pack,  // its head
  policy,
  source,
  parameter,
  fact,
  table,
  scale,
  mask,
  grid,
  plane,
  row,
  check,
  aggregate,
  row_class
};

struct PackField {
  std::string name;             // "statistic"; of rows "Em", "Em modified"; of tables "key 500 lx"
  std::string text;             // for people; "" = it is not there
  std::optional<double> value;  // of amounts, in base units
  std::string meaning{};        // fields with the same one are the same; "" = the text is it
};
bool is_same(const PackField& a, const PackField& b);

struct PartFields {
  PackPart part = PackPart::pack;
  std::string id;  // unique among the parts of its kind; "" of head and policy
  std::vector<PackField> fields;
};

// Names that another pack has for the rows of a pack, by their own names.
using RowNames = std::map<std::string, std::string>;

// Returns all fields of a pack except where it was read from. Lists without a meaningful order are
// sorted. The planes of a role are numbered, because the first counts in most places: "wall",
// "wall-2". Other parts name rows as `rows` does.
std::vector<PartFields> fields_of(const RulePack& pack, const RowNames& rows = {});

// Return the field names of a row, "Em trust" and "Em modified", and of a table, "key 500 lx".
std::string trust_field(const std::string& parameter);
std::string modified_field(const std::string& parameter);
std::string key_field(const RuleTable& table, const RuleTable::Entry& entry);

}  // namespace rules

namespace calc {

template <>
struct EnumNames<rules::PackPart> {
  static constexpr EnumName<rules::PackPart> list[] = {{rules::PackPart::pack, "pack"},
                                                       {rules::PackPart::policy, "policy"},
                                                       {rules::PackPart::source, "source"},
                                                       {rules::PackPart::parameter, "parameter"},
                                                       {rules::PackPart::fact, "fact"},
                                                       {rules::PackPart::table, "table"},
                                                       {rules::PackPart::scale, "scale"},
                                                       {rules::PackPart::mask, "mask"},
                                                       {rules::PackPart::grid, "grid"},
                                                       {rules::PackPart::plane, "plane"},
                                                       {rules::PackPart::row, "row"},
                                                       {rules::PackPart::check, "check"},
                                                       {rules::PackPart::aggregate, "aggregate"},
                                                       {rules::PackPart::row_class, "class"}};
};

}  // namespace calc
