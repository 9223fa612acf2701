#include "calc/base/element_table.h"

#include <algorithm>

namespace calc {
namespace {

// Those of `more` that `rows` has not, by name (groups by their address).
template <class Row, class IsSame>
void add_new(std::vector<Row>& rows, const std::vector<Row>& more, IsSame is_same) {
  for (const Row& row : more) {
    const auto same = [&](const Row& other) { return is_same(row, other); };
    if (std::none_of(rows.begin(), rows.end(), same)) rows.push_back(row);
  }
}

}  // namespace

Names attribute_names(const ElementRow& row) {
  Names names;
  for (const AttributeRow& attribute : row.attributes) names.push_back(attribute.name);
  return names;
}

Names child_names(const ElementRow& row) {
  Names names;
  for (const ChildRow& child : row.children) {
    if (child.group == nullptr) {
      names.push_back(child.name);
    } else {
      for (const ChildRow& one : child.group->children) names.push_back(one.name);
    }
  }
  return names;
}

ElementRow either_of(const ElementRow& one, const ElementRow& other) {
  ElementRow both = one;
  add_new(both.attributes, other.attributes,
          [](const AttributeRow& a, const AttributeRow& b) { return a.name == b.name; });
  add_new(both.children, other.children, [](const ChildRow& a, const ChildRow& b) {
    return a.group == b.group && a.name == b.name;
  });
  return both;
}

}  // namespace calc
