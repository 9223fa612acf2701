#pragma once
// A rule pack as parts with named fields, in words: what two packs are compared by. A field has the
// name of its attribute in the file, as pack_elements.h has them.

#include "calc/base/names.h"
#include "rules/pack/rule_pack.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rules {

// In the order in which they are told.
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

// Names that another pack has for its rows, by their own.
using RowNames = std::map<std::string, std::string>;

// Everything of a pack but where it was read from. Lists whose order means nothing are sorted. The
// planes of a role are numbered, for the first one counts in most places: "wall", "wall-2". Names
// of rows within other parts mean those of `rows`.
std::vector<PartFields> fields_of(const RulePack& pack, const RowNames& rows = {});

// Of a row: "Em trust", "Em modified"; "key 500 lx" of a table.
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
