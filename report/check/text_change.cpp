#include "report/check/text_change.h"

#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_encoding.h"

#include <fmt/format.h>

#include <algorithm>

namespace check {

using calc::XmlAttribute;
using calc::XmlElement;

TextChange::TextChange(std::string text) : text_(std::move(text)) {
  line_start_.push_back(text_.size() - calc::without_byte_order_mark(text_).size());
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_start_.push_back(i + 1);
  }
}

void TextChange::set(const XmlElement& element, std::string_view name, std::string_view value) {
  if (const XmlAttribute* attribute = element.find(name)) {
    const auto [begin, end] = value_of(*attribute);
    const std::string_view old(text_.data() + begin, end - begin);
    // Later lines keep their numbers, whatever lines the old value had.
    const auto lines = static_cast<std::size_t>(std::count(old.begin(), old.end(), '\n'));
    edits_.push_back({begin, end - begin, escaped_attribute(value)});
    if (lines > 0) edits_.push_back({end + 1, 0, std::string(lines, '\n')});
    return;
  }
  edits_.push_back(
      {end_of_attributes(element), 0, fmt::format(" {}=\"{}\"", name, escaped_attribute(value))});
}

void TextChange::unset(const XmlElement& element, std::string_view name) {
  const XmlAttribute* attribute = element.find(name);
  if (attribute == nullptr) return;
  std::size_t begin = offset_of(attribute->where);
  const std::size_t end = value_of(*attribute).second + 1;
  const std::string_view old(text_.data() + begin, end - begin);
  const auto lines = static_cast<std::size_t>(std::count(old.begin(), old.end(), '\n'));
  // One of the blanks about it goes with it, unless they keep others apart or are a line's indent.
  if (text_[begin - 1] == ' ') --begin;
  edits_.push_back({begin, end - begin, std::string(lines, '\n')});
}

void TextChange::set_in_new(const XmlElement& parent, const XmlElement& child,
                            std::string_view name, std::string_view value) {
  new_parent_ = &parent;
  new_child_ = child.name;
  new_attributes_ += fmt::format(" {}=\"{}\"", name, escaped_attribute(value));
}

void TextChange::add_children(const XmlElement& parent, const std::string& xml) {
  const std::size_t tag_end = text_.find('>', end_of_attributes(parent));
  if (text_[tag_end - 1] == '/') {
    edits_.push_back({tag_end - 1, 1, ""});
    edits_.push_back({tag_end + 1, 0, fmt::format("{}</{}>", xml, parent.name)});
  } else {
    edits_.push_back({tag_end + 1, 0, xml});
  }
}

void TextChange::remove(const XmlElement& element) {
  const std::size_t begin = offset_of(element.where);
  std::size_t last = text_.find('>', end_of_attributes(element));
  if (text_[last - 1] != '/') {
    const std::size_t inside =
        element.children.empty() ? last : end_of_attributes(element.children.back());
    last = text_.find('>', text_.find("</" + element.name, inside));
  }
  const std::string_view old(text_.data() + begin, last + 1 - begin);
  const auto lines = static_cast<std::size_t>(std::count(old.begin(), old.end(), '\n'));
  edits_.push_back({begin, old.size(), std::string(lines, '\n')});
  gone_.emplace_back(begin, begin + old.size());
}

std::string TextChange::apply() {
  if (new_parent_ != nullptr) {
    add_children(*new_parent_, fmt::format("<{}{}/>", new_child_, new_attributes_));
  }
  std::stable_sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) {
    // What comes in stands before what goes at the same place.
    return a.begin != b.begin ? a.begin < b.begin : a.length == 0 && b.length > 0;
  });
  std::string changed;
  std::size_t done = 0;
  const auto [begin, end] = declared_encoding();
  if (end > begin) {
    changed = text_.substr(0, begin) + "UTF-8";
    done = end;
  }
  for (const Edit& edit : edits_) {
    const bool has_gone = std::any_of(gone_.begin(), gone_.end(), [&](const auto& gone) {
      return edit.begin > gone.first && edit.begin < gone.second;
    });
    if (has_gone) continue;
    changed.append(text_, done, edit.begin - done);
    changed += edit.text;
    done = edit.begin + edit.length;
  }
  return changed.append(text_, done);
}

std::size_t TextChange::offset_of(const calc::SourceLocation& where) const {
  std::size_t offset = line_start_[static_cast<std::size_t>(where.line) - 1];
  for (int column = 1; column < where.column; ++column) {
    ++offset;
    while (offset < text_.size() && calc::is_utf8_continuation(text_[offset])) ++offset;
  }
  return offset;
}

std::size_t TextChange::end_of_attributes(const XmlElement& element) const {
  return element.attributes.empty() ? offset_of(element.where) + 1 + element.name.size()
                                    : value_of(element.attributes.back()).second + 1;
}

std::pair<std::size_t, std::size_t> TextChange::value_of(const XmlAttribute& attribute) const {
  const std::size_t quote = text_.find_first_of("\"'", offset_of(attribute.where));
  return {quote + 1, text_.find(text_[quote], quote + 1)};
}

std::pair<std::size_t, std::size_t> TextChange::declared_encoding() const {
  constexpr std::string_view kWord = "encoding";
  const std::string_view content = std::string_view(text_).substr(line_start_[0]);
  if (!content.starts_with("<?xml") || content.find_first_of(" \t\r\n", 5) != 5) return {0, 0};
  const std::size_t word = text_.find(kWord), end = text_.find("?>");
  if (word == text_.npos || word > end) return {0, 0};
  const std::size_t quote = text_.find_first_of("\"'", word);
  return {quote + 1, text_.find(text_[quote], quote + 1)};
}

std::string escaped_attribute(std::string_view value) {
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
      // As they are, they would be read as blanks.
      case '\n':
        text += "&#10;";
        break;
      case '\r':
        text += "&#13;";
        break;
      case '\t':
        text += "&#9;";
        break;
      default:
        text += c;
    }
  }
  return text;
}

}  // namespace check
