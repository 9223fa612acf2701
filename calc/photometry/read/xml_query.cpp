#include "calc/photometry/read/xml_query.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/photometry/read/text_encoding.h"

namespace calc {
namespace {

std::string single_blanks(std::string_view text) {
  std::string joined;
  for (const std::string_view word : split_words(text)) {
    if (!joined.empty()) joined += ' ';
    joined += word;
  }
  return joined;
}

}  // namespace

std::string_view local_name(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

const XmlElement* child_of(const XmlElement& parent, std::string_view name) {
  for (const XmlElement& child : parent.children) {
    if (local_name(child.name) == name) return &child;
  }
  return nullptr;
}

const XmlElement* child_of(const XmlElement& parent,
                           std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    if (const XmlElement* found = child_of(parent, name)) return found;
  }
  return nullptr;
}

const XmlElement* descend(const XmlElement& from, std::initializer_list<std::string_view> path) {
  const XmlElement* at = &from;
  for (const std::string_view name : path) {
    at = child_of(*at, name);
    if (at == nullptr) return nullptr;
  }
  return at;
}

std::vector<const XmlElement*> children_of(const XmlElement& parent, std::string_view name) {
  std::vector<const XmlElement*> found;
  for (const XmlElement& child : parent.children) {
    if (local_name(child.name) == name) found.push_back(&child);
  }
  return found;
}

std::string text_of(const XmlElement* element) {
  return element == nullptr ? std::string() : single_blanks(element->text);
}

std::string attribute_of(const XmlElement& element, std::string_view name) {
  for (const XmlAttribute& attribute : element.attributes) {
    if (local_name(attribute.name) == name) return single_blanks(attribute.value);
  }
  return "";
}

std::optional<double> number_in(const XmlElement* element, Diagnostics& diagnostics) {
  if (element == nullptr) return std::nullopt;
  const std::optional<double> value = parse_number(trim(element->text));
  if (!value) {
    diagnostics.report(DiagnosticId::photometry_number, element->where,
                       fmt::format("<{}>", local_name(element->name)),
                       quotable(trim(element->text)));
  }
  return value;
}

std::optional<bool> flag_in(const XmlElement* element) {
  const std::string text = text_of(element);
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  return std::nullopt;
}

std::string letters_of(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c + 32);
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) letters += c;
  }
  return letters;
}

}  // namespace calc
