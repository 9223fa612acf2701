#pragma once
// Ids that were renamed: the attribute `was`.

#include "calc/base/xml_reader.h"

#include <map>
#include <string>
#include <utility>

namespace calc {

// Of one kind ("plane"), as far as its ids must differ.
class FormerIds {
 public:
  explicit FormerIds(std::string kind) : kind_(std::move(kind)) {}

  // Attribute `was` of the element with this id; "" if it has none, or none that is an id.
  std::string read(ElementReader& reader, const std::string& id);

  // Of an element that has been read. where: of `was`; "" = it has none.
  void add(const std::string& id, int line, const std::string& was, const SourceLocation& where);

  // Once all are read. What is there cannot be what another one was, and two cannot have been one:
  // a comparison would take one thing for another.
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
