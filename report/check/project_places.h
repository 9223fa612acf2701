#pragma once
// Every element of a project's file that the schema knows, and the paths that name them.

#include "calc/base/element_table.h"
#include "calc/base/xml_document.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace check {

using calc::XmlAttribute;
using calc::XmlElement;

// Returns the attribute that names an element without an id.
std::string_view key_attribute(std::string_view element);

struct Place {
  const XmlElement* element = nullptr;
  const calc::ElementRow* row = nullptr;
  std::size_t parent = 0;  // of the root: itself
  std::string_view key;    // "" = none
};

// Every element that the schema knows, in the order of the file. Project data also have a place if
// the file has none, because CI knows the revision of any file.
class Places {
 public:
  explicit Places(const XmlElement& root);
  Places(const Places&) = delete;  // places point into it
  Places& operator=(const Places&) = delete;

  bool is_to_be_made(const Place& place) const { return place.element == &about_to_be_; }

  const std::vector<Place>& all() const { return places_; }

  // Returns the elements that the words before the attribute name.
  std::vector<const Place*> find(std::string_view words) const;

  // Returns all ids around the element, in full.
  std::string path_of(const Place& place) const;

 private:
  void add(const XmlElement& element, const calc::ElementRow& row, std::size_t parent);
  // Returns whether the last word names this element and the words before it elements around it.
  // With names an element may be given by its name, its id or both.
  bool matches(std::size_t own, std::string_view words, bool with_names) const;
  bool is_rest_around(std::size_t own, std::string_view words, bool with_names) const;

  std::vector<Place> places_;
  XmlElement about_to_be_;
};

}  // namespace check
