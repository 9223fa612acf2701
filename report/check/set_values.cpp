#include "report/check/set_values.h"

#include "calc/base/element_table.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_document.h"
#include "calc/base/xml_encoding.h"
#include "calc/project/project_elements.h"
#include "rules/binding/project_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace check {
namespace {

using calc::XmlAttribute;
using calc::XmlElement;

constexpr std::size_t kMostNamed = 8;

// What stands for an element: comparisons, stores and reports go by it.
constexpr std::array<std::string_view, 2> kNaming{"id", "was"};
// Only files that lie there are read, so that nobody reads others by an option.
constexpr std::array<std::string_view, 2> kFiles{"file", "photometry"};
// Who lives with what, and why: it must stand in the file, signed. These elements say it with all
// of their attributes.
constexpr std::array<std::string_view, 3> kSignedElements{"waiver", "deviation", "without"};
constexpr std::array<std::string_view, 2> kSignatures{"waived-by", "waived-until"};

template <class List>
bool is_among(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// "" or why no option sets it.
std::string_view refusal(std::string_view element, std::string_view attribute) {
  if (is_among(kSignedElements, element)) return "what somebody has signed must stand in the file";
  if (is_among(kNaming, attribute)) return "it says which element this is";
  if (attribute == "version") return "it says how the file is to be read";
  if (is_among(kFiles, attribute)) return "it names a file; vary the type that is used instead";
  if (attribute == "logo") return "it names a file";
  if (attribute.ends_with("because") || is_among(kSignatures, attribute)) {
    return "what somebody has signed must stand in the file";
  }
  return "";
}

// By what an element without an id is known.
std::string_view key_attribute(std::string_view element) {
  if (element == "dim" || element == "part") return "group";
  return element == "zone" || element == "without" ? "role" : "id";
}

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

struct Place {
  const XmlElement* element = nullptr;
  const calc::ElementRow* row = nullptr;
  std::size_t parent = 0;  // of the root: itself
  std::string_view key;    // "" = none
};

// Every element that the schema knows, in the order of the file. Project data have a place also
// where the file has none: CI knows the revision, whoever has written the file.
class Places {
 public:
  explicit Places(const XmlElement& root) {
    add(root, complete_row(*calc::kProjectRoot.row), 0);
    about_to_be_.name = calc::kAboutName;
    about_to_be_.where = root.where;
    const bool has_about =
        std::any_of(root.children.begin(), root.children.end(),
                    [](const XmlElement& child) { return child.name == calc::kAboutName; });
    if (!has_about) add(about_to_be_, calc::kAboutElement, 0);
  }
  Places(const Places&) = delete;  // places point into it
  Places& operator=(const Places&) = delete;

  bool is_to_be_made(const Place& place) const { return place.element == &about_to_be_; }

  const std::vector<Place>& all() const { return places_; }

  // Those that the words before the attribute mean.
  std::vector<const Place*> find(std::string_view words) const {
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

  // All ids around it, in full.
  std::string path_of(const Place& place) const {
    std::string path(place.key.empty() ? std::string_view(place.element->name) : place.key);
    for (const Place* p = &place; p->parent != 0;) {
      p = &places_[p->parent];
      path = std::string(p->key.empty() ? std::string_view(p->element->name) : p->key) + "." + path;
    }
    return path;
  }

 private:
  void add(const XmlElement& element, const calc::ElementRow& row, std::size_t parent) {
    const std::size_t own = places_.size();
    const XmlAttribute* key = element.find("id");
    if (key == nullptr) key = element.find(key_attribute(element.name));
    places_.push_back({&element, &row, parent, key == nullptr ? "" : std::string_view(key->value)});
    for (const XmlElement& child : element.children) {
      if (const calc::ElementRow* its = child_row(row, child.name)) add(child, *its, own);
    }
  }

  // The last of the words is about this element, those before it about elements around it. With
  // names an element may be meant by its name, its id or both.
  bool matches(std::size_t own, std::string_view words, bool with_names) const {
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

  bool is_rest_around(std::size_t own, std::string_view words, bool with_names) const {
    if (words.empty()) return true;
    while (own != 0) {
      own = places_[own].parent;
      if (matches(own, words, with_names)) return true;
    }
    return false;
  }

  // Whether the words end with this one; ids may hold dots themselves. rest: those before it.
  static bool takes(std::string_view words, std::string_view last, std::string_view& rest) {
    if (!words.ends_with(last)) return false;
    rest = words.substr(0, words.size() - last.size());
    if (rest.empty()) return true;
    if (!rest.ends_with('.') || rest.size() < 2) return false;
    rest.remove_suffix(1);
    return true;
  }

  std::vector<Place> places_;
  XmlElement about_to_be_;
};

std::string tag(const Place& place) { return "<" + place.element->name + ">"; }

class TextChange {
 public:
  // text: in UTF-8, as parse_xml() read it.
  explicit TextChange(std::string text) : text_(std::move(text)) {
    line_start_.push_back(text_.size() - calc::without_byte_order_mark(text_).size());
    for (std::size_t i = 0; i < text_.size(); ++i) {
      if (text_[i] == '\n') line_start_.push_back(i + 1);
    }
  }

  void set(const XmlElement& element, std::string_view name, std::string_view value) {
    if (const XmlAttribute* attribute = element.find(name)) {
      const auto [begin, end] = value_of(*attribute);
      const std::string_view old(text_.data() + begin, end - begin);
      // Later lines keep their numbers, whatever lines the old value had.
      const auto lines = static_cast<std::size_t>(std::count(old.begin(), old.end(), '\n'));
      edits_.push_back({begin, end - begin, escaped(value)});
      if (lines > 0) edits_.push_back({end + 1, 0, std::string(lines, '\n')});
      return;
    }
    edits_.push_back(
        {end_of_attributes(element), 0, fmt::format(" {}=\"{}\"", name, escaped(value))});
  }

  // A child of this element, which has no such child, before all others.
  void set_in_new(const XmlElement& parent, const XmlElement& child, std::string_view name,
                  std::string_view value) {
    new_parent_ = &parent;
    new_child_ = child.name;
    new_attributes_ += fmt::format(" {}=\"{}\"", name, escaped(value));
  }

  // It is UTF-8 now, whatever it was.
  std::string apply() {
    if (new_parent_ != nullptr) make_child();
    std::stable_sort(edits_.begin(), edits_.end(),
                     [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
    std::string changed;
    std::size_t done = 0;
    const auto [begin, end] = declared_encoding();
    if (end > begin) {
      changed = text_.substr(0, begin) + "UTF-8";
      done = end;
    }
    for (const Edit& edit : edits_) {
      changed.append(text_, done, edit.begin - done);
      changed += edit.text;
      done = edit.begin + edit.length;
    }
    return changed.append(text_, done);
  }

 private:
  struct Edit {
    std::size_t begin, length;
    std::string text;
  };

  std::size_t offset_of(const calc::SourceLocation& where) const {
    std::size_t offset = line_start_[static_cast<std::size_t>(where.line) - 1];
    for (int column = 1; column < where.column; ++column) {
      ++offset;
      while (offset < text_.size() && calc::is_utf8_continuation(text_[offset])) ++offset;
    }
    return offset;
  }

  std::size_t end_of_attributes(const XmlElement& element) const {
    return element.attributes.empty() ? offset_of(element.where) + 1 + element.name.size()
                                      : value_of(element.attributes.back()).second + 1;
  }

  void make_child() {
    const std::string child = fmt::format("<{}{}/>", new_child_, new_attributes_);
    const std::size_t tag_end = text_.find('>', end_of_attributes(*new_parent_));
    if (text_[tag_end - 1] == '/') {
      edits_.push_back({tag_end - 1, 1, ""});
      edits_.push_back({tag_end + 1, 0, fmt::format("{}</{}>", child, new_parent_->name)});
    } else {
      edits_.push_back({tag_end + 1, 0, child});
    }
  }

  // Between its quotes.
  std::pair<std::size_t, std::size_t> value_of(const XmlAttribute& attribute) const {
    const std::size_t quote = text_.find_first_of("\"'", offset_of(attribute.where));
    return {quote + 1, text_.find(text_[quote], quote + 1)};
  }

  std::pair<std::size_t, std::size_t> declared_encoding() const {
    constexpr std::string_view kWord = "encoding";
    const std::string_view content = std::string_view(text_).substr(line_start_[0]);
    if (!content.starts_with("<?xml") || content.find_first_of(" \t\r\n", 5) != 5) return {0, 0};
    const std::size_t word = text_.find(kWord), end = text_.find("?>");
    if (word == text_.npos || word > end) return {0, 0};
    const std::size_t quote = text_.find_first_of("\"'", word);
    return {quote + 1, text_.find(text_[quote], quote + 1)};
  }

  static std::string escaped(std::string_view value) {
    std::string text;
    for (const char c : value) {
      switch (c) {
        case '&':
          text += "&amp;";
          break;
        case '<':
          text += "&lt;";
          break;
        case '>':
          text += "&gt;";
          break;
        case '"':
          text += "&quot;";
          break;
        case '\'':
          text += "&apos;";
          break;
        default:
          text += c;
      }
    }
    return text;
  }

  std::string text_;
  std::vector<std::size_t> line_start_;
  std::vector<Edit> edits_;
  const XmlElement* new_parent_ = nullptr;
  std::string new_child_, new_attributes_;
};

// Finds what paths mean in one project.
class Resolver {
 public:
  Resolver(const Places& places, const std::string& file, std::string_view option,
           calc::Diagnostics& diagnostics)
      : places_(places), file_(file), option_(option), diagnostics_(diagnostics) {}

  // Null after an error.
  const Place* resolve(const std::string& path, std::string_view& attribute) {
    const std::size_t dot = path.rfind('.');
    if (dot == path.npos || dot == 0 || dot + 1 == path.size()) {
      fail({file_}, path,
           "a path is ID.attribute, with ids of the elements around it where one id is not enough: "
           "ID.ID.attribute; the root is 'luxgate'");
      return nullptr;
    }
    const std::string_view words = std::string_view(path).substr(0, dot);
    attribute = std::string_view(path).substr(dot + 1);
    const std::vector<const Place*> found = places_.find(words);
    if (found.empty()) {
      fail_unknown(path, words);
      return nullptr;
    }
    const Place& place = *found.front();
    if (found.size() > 1) {
      fail(place.element->where, path, several(words, found));
      return nullptr;
    }
    calc::Names allowed;
    for (const calc::AttributeRow& row : place.row->attributes) {
      if (refusal(place.element->name, row.name).empty() &&
          row.name != key_attribute(place.element->name)) {
        allowed.push_back(row.name);
      }
    }
    if (is_among(allowed, attribute)) return &place;
    const bool is_known = is_among(calc::attribute_names(*place.row), attribute);
    std::string why = is_known ? fmt::format("'{}' of {} cannot be set", attribute, tag(place))
                               : fmt::format("{} has no attribute '{}'", tag(place), attribute);
    if (is_known) {
      const std::string_view reason = refusal(place.element->name, attribute);
      why += fmt::format(": {}", reason.empty() ? "it says which element this is" : reason);
    }
    fail(place.element->where, path,
         fmt::format("{}; allowed: {}{}", why,
                     allowed.empty() ? "none" : calc::join_choices(allowed),
                     is_known ? "" : calc::suggestion(attribute, allowed)));
    return nullptr;
  }

  void fail(const calc::SourceLocation& where, const std::string& path, const std::string& why) {
    diagnostics_.report(calc::DiagnosticId::value_not_set, where, option_, calc::printable(path),
                        why);
  }

 private:
  void fail_unknown(const std::string& path, std::string_view words) {
    std::set<std::string_view> known;
    for (const Place& place : places_.all()) {
      if (places_.is_to_be_made(place)) continue;
      known.insert(place.key.empty() ? std::string_view(place.element->name) : place.key);
    }
    std::vector<std::string> names(known.begin(), known.end());
    std::vector<std::string_view> choices(known.begin(), known.end());
    const std::size_t dot = words.rfind('.');
    std::string hint = calc::suggestion(words, choices);
    if (hint.empty() && dot != words.npos) hint = calc::suggestion(words.substr(dot + 1), choices);
    fail({file_}, path,
         fmt::format("the project has no element '{}'; it has {}{}", calc::printable(words),
                     calc::list_names(names, 3 * kMostNamed), hint));
  }

  std::string several(std::string_view words, const std::vector<const Place*>& found) const {
    std::vector<std::string> names;
    for (const Place* place : found) {
      names.push_back(fmt::format("{} (line {})", own_path(*place), place->element->where.line));
    }
    return fmt::format("'{}' means {} elements: {}; one path must mean one", words, found.size(),
                       calc::list_names(names, kMostNamed));
  }

  // That means this one alone, where there is one.
  std::string own_path(const Place& place) const {
    const std::string by_ids = places_.path_of(place), &name = place.element->name;
    const std::string by_name = name + "." + std::string(place.key);
    for (const std::string& path : {by_ids, by_name, name + "." + by_ids}) {
      const std::vector<const Place*> meant = places_.find(path);
      if (meant.size() == 1 && meant.front() == &place) return path;
    }
    return by_name;
  }

  const Places& places_;
  const std::string& file_;
  const std::string_view option_;
  calc::Diagnostics& diagnostics_;
};

std::optional<std::string> changed_text(std::string text, const XmlElement& root,
                                        const std::string& file,
                                        const std::vector<SetValue>& values,
                                        std::string_view option, calc::Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const Places places(root);
  Resolver resolver(places, file, option, diagnostics);
  TextChange change(std::move(text));
  std::map<std::pair<const XmlElement*, std::string_view>, const std::string*> taken;
  for (const SetValue& value : values) {
    std::string_view attribute;
    const Place* place = resolver.resolve(value.path, attribute);
    if (place == nullptr) continue;
    const std::string problem = value_problem(value.value);
    const auto [other, is_new] =
        taken.try_emplace(std::pair(place->element, attribute), &value.path);
    if (!problem.empty()) {
      resolver.fail(place->element->where, value.path, problem);
    } else if (!is_new) {
      resolver.fail(place->element->where, value.path,
                    fmt::format("'{}' of {} is set twice, also as '{}'", attribute, tag(*place),
                                *other->second));
    } else if (places.is_to_be_made(*place)) {
      change.set_in_new(root, *place->element, attribute, value.value);
    } else {
      change.set(*place->element, attribute, value.value);
    }
  }
  if (diagnostics.error_count() != errors_before) return std::nullopt;
  return change.apply();
}

// The element tree, and the text that its places are about.
std::optional<XmlElement> parsed(const std::string& bytes, const std::string& file,
                                 std::string& text, calc::Diagnostics& diagnostics) {
  std::optional<std::string> decoded = calc::decoded_xml(bytes, file, diagnostics);
  if (!decoded) return std::nullopt;
  text = *std::move(decoded);
  std::optional<XmlElement> root = calc::parse_xml(bytes, file, diagnostics);
  if (root && root->name != calc::kProjectRoot.name) {
    diagnostics.report(calc::DiagnosticId::wrong_root_element, root->where, root->name,
                       calc::kProjectRoot.name);
    return std::nullopt;
  }
  return root;
}

}  // namespace

bool is_about_project(const SetValue& value) {
  std::string_view path = value.path;
  const std::string of_root = std::string(calc::kProjectRoot.name) + ".";
  if (path.starts_with(of_root)) path.remove_prefix(of_root.size());
  const std::string of_about = std::string(calc::kAboutName) + ".";
  return path.starts_with(of_about) &&
         is_among(calc::attribute_names(calc::kAboutElement), path.substr(of_about.size()));
}

std::string value_problem(const std::string& value) {
  if (calc::first_invalid_utf8(value)) return "the value is not UTF-8";
  if (calc::printable(value) != value) {
    return "the value holds a control character or '##['";
  }
  return "";
}

std::optional<std::string> with_values(const std::string& bytes, const std::string& file,
                                       const std::vector<SetValue>& values, std::string_view option,
                                       calc::Diagnostics& diagnostics) {
  std::string text;
  const std::optional<XmlElement> root = parsed(bytes, file, text, diagnostics);
  if (!root) return std::nullopt;
  return changed_text(std::move(text), *root, file, values, option, diagnostics);
}

void check_values(const std::vector<std::string>& projects, const std::vector<SetValue>& values,
                  std::string_view option, const calc::FileReader& files,
                  calc::Diagnostics& diagnostics) {
  for (const std::string& project : projects) {
    const calc::FileContent content = files.read(project);
    if (!content.ok()) continue;
    calc::Diagnostics unreadable;  // told by who reads it
    std::string text;
    if (const auto root = parsed(content.bytes, project, text, unreadable)) {
      changed_text(std::move(text), *root, project, values, option, diagnostics);
    }
  }
}

calc::FileContent SetReader::read_within(const std::string& folder, const std::string& path) const {
  calc::FileContent content = files_.read_within(folder, path);
  if (!content.ok() || values_.empty() || !projects_.contains(path)) return content;
  calc::Diagnostics unreadable, diagnostics;
  std::string text;
  const auto root = parsed(content.bytes, path, text, unreadable);
  if (!root) return content;
  auto changed = changed_text(std::move(text), *root, path, values_, "set", diagnostics);
  if (!changed) return {"", diagnostics.all().front().message};
  content.bytes = *std::move(changed);
  return content;
}

}  // namespace check
