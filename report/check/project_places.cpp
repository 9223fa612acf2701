#include "report/check/project_places.h"

#include "calc/project/reading/project_elements.h"
#include "rules/binding/project_schema.h"

#include <algorithm>

namespace check {
namespace {

const calc::ElementRow& complete_row(const calc::ElementRow& row) {
  for (const calc::ElementRow& other : rules::rows_about_rules()) {
    if (other.type == row.type) return other;
  }
  return row;
}

// Null: the schema has no such child.
const calc::ElementRow* child_row(const calc::ElementRow& parent, std::string_view name) {
  for (const calc::ChildRow& child : parent.children) {
    if (child.group == nullptr) {
      if (child.name == name) return &complete_row(*child.row);
      continue;
    }
    for (const calc::ChildRow& one : child.group->children) {
      if (one.name == name) return &complete_row(*one.row);
    }
  }
  return nullptr;
}

// Whether the words end with this one; ids may hold dots themselves. rest: those before it.
bool takes(std::string_view words, std::string_view last, std::string_view& rest) {
  if (!words.ends_with(last)) return false;
  rest = words.substr(0, words.size() - last.size());
  if (rest.empty()) return true;
  if (!rest.ends_with('.') || rest.size() < 2) return false;
  rest.remove_suffix(1);
  return true;
}

}  // namespace

std::string_view key_attribute(std::string_view element) {
  if (element == "dim" || element == "part") return "group";
  return element == "zone" || element == "without" ? "role" : "id";
}

Places::Places(const XmlElement& root) {
  add(root, complete_row(*calc::kProjectRoot.row), 0);
  about_to_be_.name = calc::kAboutName;
  about_to_be_.where = root.where;
  const bool has_about =
      std::any_of(root.children.begin(), root.children.end(),
                  [](const XmlElement& child) { return child.name == calc::kAboutName; });
  if (!has_about) add(about_to_be_, calc::kAboutElement, 0);
}

std::vector<const Place*> Places::find(std::string_view words) const {
  std::vector<const Place*> by_key, by_name;
  for (std::size_t p = 0; p < places_.size(); ++p) {
    if (matches(p, words, false)) {
      by_key.push_back(&places_[p]);
    } else if (matches(p, words, true)) {
      by_name.push_back(&places_[p]);
    }
  }
  return by_key.empty() ? by_name : by_key;
}

std::string Places::path_of(const Place& place) const {
  std::string path(place.key.empty() ? std::string_view(place.element->name) : place.key);
  for (const Place* p = &place; p->parent != 0;) {
    p = &places_[p->parent];
    path = std::string(p->key.empty() ? std::string_view(p->element->name) : p->key) + "." + path;
  }
  return path;
}

void Places::add(const XmlElement& element, const calc::ElementRow& row, std::size_t parent) {
  const std::size_t own = places_.size();
  const XmlAttribute* key = element.find("id");
  if (key == nullptr) key = element.find(key_attribute(element.name));
  places_.push_back({&element, &row, parent, key == nullptr ? "" : std::string_view(key->value)});
  for (const XmlElement& child : element.children) {
    if (const calc::ElementRow* its = child_row(row, child.name)) add(child, *its, own);
  }
}

bool Places::matches(std::size_t own, std::string_view words, bool with_names) const {
  const Place& place = places_[own];
  const std::string_view name = place.element->name;
  const bool has_key = !place.key.empty();
  std::string_view rest;
  if (has_key && takes(words, place.key, rest)) {
    if (is_rest_around(own, rest, with_names)) return true;
    std::string_view before;
    if (with_names && takes(rest, name, before) && is_rest_around(own, before, true)) return true;
  }
  return with_names && takes(words, name, rest) && is_rest_around(own, rest, true);
}

bool Places::is_rest_around(std::size_t own, std::string_view words, bool with_names) const {
  if (words.empty()) return true;
  while (own != 0) {
    own = places_[own].parent;
    if (matches(own, words, with_names)) return true;
  }
  return false;
}

}  // namespace check
