#include "report/check/set_values.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/element_table.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_document.h"
#include "calc/base/xml_encoding.h"
#include "calc/project/reading/project_elements.h"
#include "report/check/project_places.h"
#include "report/check/text_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace check {
namespace {

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
  if (is_among(kSignedElements, element)) return "a signed statement must be in the file";
  if (is_among(kNaming, attribute)) return "it identifies the element";
  if (attribute == "version") return "it says how the file is to be read";
  if (is_among(kFiles, attribute)) return "it names a file; vary the type instead";
  if (attribute == "logo") return "it names a file";
  if (attribute.ends_with("because") || is_among(kSignatures, attribute)) {
    return "a signed statement must be in the file";
  }
  return "";
}

std::string tag(const Place& place) { return "<" + place.element->name + ">"; }

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
      fail(
          {file_}, path,
          "a path is ID.attribute, or ID.ID.attribute with the ids of enclosing elements where one "
          "id is not enough; the root is 'luxgate'");
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
      why += fmt::format(": {}", reason.empty() ? "it identifies the element" : reason);
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
    return fmt::format("'{}' matches {} elements: {}; a path must match exactly one", words,
                       found.size(), calc::list_names(names, kMostNamed));
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
  // Unless somebody sets both, which the reader refuses.
  for (const auto& [set, path] : taken) {
    if (set.second != calc::kPackageName) continue;
    for (const std::string_view replaced : calc::kReplacedByPackage) {
      if (!taken.contains({set.first, replaced})) change.unset(*set.first, replaced);
    }
  }
  if (diagnostics.error_count() != errors_before) return std::nullopt;
  return change.apply();
}

// The element tree, and the text that its places are about.
std::optional<XmlElement> parsed(const std::string& bytes, const std::string& file,
                                 std::string& text) {
  calc::Diagnostics diagnostics;
  std::optional<std::string> decoded = calc::decoded_xml(bytes, file, diagnostics);
  if (!decoded) return std::nullopt;
  text = *std::move(decoded);
  std::optional<XmlElement> root = calc::parse_xml(bytes, file, diagnostics);
  if (root && root->name != calc::kProjectRoot.name) return std::nullopt;
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
    return "the value contains a control character or '##['";
  }
  return "";
}

void check_values(const std::vector<std::string>& projects, const std::vector<SetValue>& values,
                  std::string_view option, const calc::FileReader& files,
                  calc::Diagnostics& diagnostics) {
  for (const std::string& project : projects) {
    const calc::FileContent content = files.read(project);
    if (!content.ok()) continue;
    std::string text;
    if (const auto root = parsed(content.bytes, project, text)) {
      changed_text(std::move(text), *root, project, values, option, diagnostics);
    }
  }
}

calc::FileContent SetReader::read_within(const std::string& folder, const std::string& path) const {
  calc::FileContent content = files_.read_within(folder, path);
  if (!content.ok() || values_.empty() || !projects_.contains(path)) return content;
  std::string text;
  const auto root = parsed(content.bytes, path, text);
  if (!root) return content;
  calc::Diagnostics diagnostics;
  auto changed = changed_text(std::move(text), *root, path, values_, "set", diagnostics);
  if (!changed) return {"", diagnostics.all().front().message};
  content.bytes = *std::move(changed);
  return content;
}

}  // namespace check
