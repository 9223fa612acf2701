#include "calc/base/xml_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace calc {
namespace {

void add_once(std::string_view name, Names& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

// Lines become one, and a table keeps its columns.
std::string in_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (c == '\n') {
      if (!line.empty() && line.back() != ' ') line += ' ';
    } else {
      if (c == '|') line += '\\';
      line += c;
    }
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

std::string listed(const Names& names, std::string_view around) {
  std::string text;
  for (const std::string_view name : names) {
    text += (text.empty() ? "" : ", ") + fmt::format(fmt::runtime(around), name);
  }
  return text;
}

// What an attribute of this type may be, in words.
std::string value_words(const ValueType& type) {
  if (!type.words.empty()) return listed(type.words, "`{}`");
  if (!type.meaning.empty()) return in_line(type.meaning);
  if (type.range && !type.range->words.empty()) return in_line(type.range->words);
  if (type.item != nullptr) {
    const std::string count = type.least > 0 && type.least == type.most
                                  ? fmt::format("{} of: ", type.least)
                                  : "a list, blanks between: ";
    return count + value_words(*type.item);
  }
  if (type.base != nullptr) return value_words(*type.base);
  if (type.name == kAnyText.name) return "text";
  if (type.name == kAnyInt.name) return "a whole number";
  if (type.name == kAnyDouble.name) return "a number";
  return type.name == kAnyDate.name ? "a day, YYYY-MM-DD" : std::string(type.name);
}

struct Section {
  const ElementRow* row;
  Names names, parents, children;
};

class ReferenceMaker {
 public:
  explicit ReferenceMaker(const SchemaText& text) : text_(text) {}

  std::string run(std::string_view title, const SchemaText& text) {
    visit(text.root, "");
    std::string page = fmt::format("<!-- Written by {}: not to be edited. -->\n# {}\n\n{}\n",
                                   text.maker, title, in_line(text.meaning));
    for (const Section& section : sections_) page += section_text(section);
    return page;
  }

 private:
  // parent: its name, "" of the root.
  void visit(const ChildRow& child, std::string_view parent) {
    if (child.group != nullptr) {
      for (const ChildRow& member : child.group->children) visit(member, parent);
      return;
    }
    const ElementRow& row = text_.row_for(*child.row);
    const auto [found, is_new] = index_.emplace(row.type, sections_.size());
    const std::size_t at = found->second;
    if (is_new) sections_.push_back({&row, {}, {}, {}});
    add_once(child.name, sections_[at].names);
    if (!parent.empty()) add_once(parent, sections_[at].parents);
    if (!is_new) return;
    for (const ChildRow& inner : row.children) note(inner, sections_[at].children);
    for (const ChildRow& inner : row.children) visit(inner, child.name);
  }

  static void note(const ChildRow& child, Names& names) {
    if (child.group == nullptr) return add_once(child.name, names);
    for (const ChildRow& member : child.group->children) note(member, names);
  }

  static std::string section_text(const Section& section) {
    std::string text = fmt::format("\n## {}\n\n", listed(section.names, "`<{}>`"));
    if (!section.row->meaning.empty()) text += in_line(section.row->meaning) + "\n\n";
    if (!section.parents.empty())
      text += fmt::format("In {}.\n", listed(section.parents, "`<{}>`"));
    if (!section.children.empty()) {
      text += fmt::format("Holds {}{}.\n", section.row->needs_child ? "at least one of " : "",
                          listed(section.children, "`<{}>`"));
    }
    if (section.row->attributes.empty()) return text;
    text += "\n| attribute | value | meaning |\n|---|---|---|\n";
    for (const AttributeRow& attribute : section.row->attributes) {
      text += fmt::format(
          "| `{}`{} | {}{} | {} |\n", attribute.name,
          attribute.presence == Presence::required ? " (needed)" : "", value_words(*attribute.type),
          attribute.otherwise.empty() ? ""
                                      : fmt::format("; `{}` if not given", attribute.otherwise),
          in_line(attribute.meaning));
    }
    return text;
  }

  const SchemaText& text_;
  std::vector<Section> sections_;
  std::map<std::string_view, std::size_t> index_;  // by type
};

}  // namespace

std::string xml_reference(std::string_view title, const SchemaText& text) {
  return ReferenceMaker(text).run(title, text);
}

}  // namespace calc
