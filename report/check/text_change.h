#pragma once
// Changes the text of an XML file and leaves everything else as it is: blanks, comments, line
// numbers.

#include "calc/base/xml_document.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace check {

class TextChange {
 public:
  // text: in UTF-8, as parse_xml() read it. The elements below are from its tree, which must
  // outlive this.
  explicit TextChange(std::string text);

  // Sets an attribute of this element; the value is escaped here.
  void set(const calc::XmlElement& element, std::string_view name, std::string_view value);
  // Removes this attribute, if the element has it; later lines keep their numbers.
  void unset(const calc::XmlElement& element, std::string_view name);
  // Sets an attribute of a child that the element lacks: the child is added first, with all
  // attributes set this way. At most one such child.
  void set_in_new(const calc::XmlElement& parent, const calc::XmlElement& child,
                  std::string_view name, std::string_view value);
  // Removes all of an element; later lines keep their numbers.
  void remove(const calc::XmlElement& element);
  // Adds finished XML before all children of this element; once per element.
  void add_children(const calc::XmlElement& parent, const std::string& xml);

  // Returns the changed text, in UTF-8 whatever it was before.
  std::string apply();

 private:
  struct Edit {
    std::size_t begin, length;
    std::string text;
  };

  std::size_t offset_of(const calc::SourceLocation& where) const;
  std::size_t end_of_attributes(const calc::XmlElement& element) const;
  // Returns the range between its quotes.
  std::pair<std::size_t, std::size_t> value_of(const calc::XmlAttribute& attribute) const;
  std::pair<std::size_t, std::size_t> declared_encoding() const;

  std::string text_;
  std::vector<std::size_t> line_start_;
  std::vector<Edit> edits_;
  std::vector<std::pair<std::size_t, std::size_t>> gone_;  // elements: their begin and end
  const calc::XmlElement* new_parent_ = nullptr;
  std::string new_child_, new_attributes_;
};

// Returns the text escaped for an attribute in double quotes.
std::string escaped_attribute(std::string_view value);

}  // namespace check
