#include "calc/base/xml_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

namespace calc {
namespace {

// Each line of `text` that is not empty, behind `indent`.
std::string indented(std::string_view indent, std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (end > 0) result += fmt::format("{}{}", indent, text.substr(0, end));
    result += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string documentation(std::string_view indent, std::string_view text) {
  if (text.empty()) return {};
  if (text.find('\n') == text.npos) {
    return fmt::format(
        "{0}<xs:annotation><xs:documentation>{1}</xs:documentation></xs:annotation>\n", indent,
        text);
  }
  return fmt::format(
      "{0}<xs:annotation>\n{0}  <xs:documentation>\n{1}{0}  </xs:documentation>\n"
      "{0}</xs:annotation>\n",
      indent, indented(fmt::format("{}    ", indent), text));
}

template <class Value>
std::string facet(std::string_view name, const Value& value) {
  return fmt::format("      <xs:{} value=\"{}\"/>\n", name, value);
}

std::string facets_of(const ValueType& type) {
  std::string text;
  for (const std::string_view word : type.words) text += facet("enumeration", word);
  if (!type.pattern.empty()) text += facet("pattern", type.pattern);
  if (type.range) {
    const NumberRange& range = *type.range;
    text += facet(range.is_open ? "minExclusive" : "minInclusive", range.low);
    if (std::isfinite(range.high)) text += facet("maxInclusive", range.high);
  }
  if (type.least > 0 && type.least == type.most) {
    text += facet("length", type.least);
  } else {
    if (type.least > 0) text += facet("minLength", type.least);
    if (type.most > 0) text += facet("maxLength", type.most);
  }
  return text;
}

class SchemaMaker {
 public:
  explicit SchemaMaker(const SchemaText& text) : text_(text) {}

  std::string run(const SchemaText& text) {
    const std::string root = element("  ", text.root);
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<!-- Written by {}: not to be edited. -->\n"
        "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\" version=\"1\">\n"
        "{}\n{}{}{}</xs:schema>\n",
        text.maker, documentation("  ", text.meaning), value_types_, element_types_, root);
  }

 private:
  // What `row` names is written before it, once.
  std::string element(std::string_view indent, const ChildRow& child) {
    if (child.group != nullptr) {
      add(*child.group);
      return fmt::format("{}<xs:group ref=\"{}\"/>\n", indent, child.group->name);
    }
    add(text_.row_for(*child.row));
    const std::string start =
        fmt::format("{}<xs:element name=\"{}\" type=\"{}\"", indent, child.name, child.row->type);
    if (child.constraints.empty()) return start + "/>\n";
    return fmt::format("{}>\n{}{}</xs:element>\n", start,
                       indented(fmt::format("{}  ", indent), child.constraints), indent);
  }

  void add(const ElementGroup& group) {
    if (!made_.insert(&group).second) return;
    std::string text;
    for (const ChildRow& child : group.children) text += element("      ", child);
    element_types_ += fmt::format(
        "  <xs:group name=\"{}\">\n    <xs:choice>\n{}    </xs:choice>\n  </xs:group>\n\n",
        group.name, text);
  }

  void add(const ElementRow& row) {
    if (!made_.insert(&row).second) return;
    std::string text = documentation("    ", row.meaning);
    if (!row.children.empty()) {
      text += fmt::format("    <xs:choice{} maxOccurs=\"unbounded\">\n",
                          row.needs_child ? "" : " minOccurs=\"0\"");
      for (const ChildRow& child : row.children) text += element("      ", child);
      text += "    </xs:choice>\n";
    }
    for (const AttributeRow& attribute : row.attributes) text += attribute_text(attribute);
    element_types_ +=
        fmt::format("  <xs:complexType name=\"{}\">\n{}  </xs:complexType>\n\n", row.type, text);
  }

  std::string attribute_text(const AttributeRow& attribute) {
    add(*attribute.type);
    std::string start = fmt::format("    <xs:attribute name=\"{}\" type=\"{}\"", attribute.name,
                                    attribute.type->name);
    if (attribute.presence == Presence::required) start += " use=\"required\"";
    if (!attribute.otherwise.empty()) {
      start += fmt::format(" default=\"{}\"", attribute.otherwise);
    }
    if (attribute.meaning.empty()) return start + "/>\n";
    return fmt::format("{}>\n{}    </xs:attribute>\n", start,
                       documentation("      ", attribute.meaning));
  }

  void add(const ValueType& type) {
    if (type.name.starts_with("xs:") || !made_.insert(&type).second) return;
    if (type.base != nullptr) add(*type.base);
    if (type.item != nullptr) add(*type.item);
    std::string contents = facets_of(type);
    if (!type.verbatim.empty()) {
      contents = indented("    ", type.verbatim);
    } else if (type.item != nullptr) {
      contents = fmt::format(
          "    <xs:restriction>\n"
          "      <xs:simpleType><xs:list itemType=\"{}\"/></xs:simpleType>\n{}"
          "    </xs:restriction>\n",
          type.item->name, contents);
    } else {
      contents = fmt::format("    <xs:restriction base=\"{}\">\n{}    </xs:restriction>\n",
                             type.base->name, contents);
    }
    value_types_ += fmt::format("  <xs:simpleType name=\"{}\">\n{}{}  </xs:simpleType>\n\n",
                                type.name, documentation("    ", type.meaning), contents);
  }

  const SchemaText& text_;
  std::set<const void*> made_;
  std::string value_types_, element_types_;
};

}  // namespace

std::string xml_schema(const SchemaText& text) { return SchemaMaker(text).run(text); }

}  // namespace calc
