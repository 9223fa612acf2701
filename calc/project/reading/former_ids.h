#pragma once
// Reads the attribute `was`: the former ids of renamed elements.

#include "calc/base/xml_reader.h"

#include <map>
#include <string>
#include <utility>

namespace calc {

// The ids of one kind ("plane"), within which ids must differ.
class FormerIds {
 public:
  explicit FormerIds(std::string kind) : kind_(std::move(kind)) {}

  // Returns attribute `was` of the element with this id; "" if there is none or it is not an id.
  std::string read(ElementReader& reader, const std::string& id);

  // Adds an element that has been read. where: of `was`; "" = it has none.
  void add(const std::string& id, int line, const std::string& was, const SourceLocation& where);

  // Checks all ids once all are read. A present id cannot be a former one, and two elements cannot
  // share a former id, because a comparison would confuse them.
  void check(Diagnostics& diagnostics) const;

 private:
  struct Former {
    std::string id;
    SourceLocation where;
  };
  std::string kind_;
  std::map<std::string, int> line_of_id_;
  std::multimap<std::string, Former> of_former_;
};

}  // namespace calc
