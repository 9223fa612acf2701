#include "calc/base/xml_document.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_encoding.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <regex>
#include <utility>

namespace calc {
namespace {

// Values stay as they are in the buffer, so that every pointer tells its place; references are
// resolved here.
constexpr unsigned int kParseFlags = pugi::parse_cdata | pugi::parse_comments |
                                     pugi::parse_declaration | pugi::parse_doctype |
                                     pugi::parse_fragment;

// Lines and columns of a buffer in which pugixml may overwrite single ASCII characters later, ends
// of lines, too. Takes an eighth of it, however many lines there are: some files are nothing else.
class Locator {
 public:
  Locator(std::string_view bytes, std::string file)
      : bytes_(bytes),
        file_(std::move(file)),
        begin_(bytes.size() - without_byte_order_mark(bytes).size()),
        line_ends_(bytes.size() / kWord + 1),
        at_(begin_) {
    int lines = 1;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      if (i % kBlock == 0) line_of_block_.push_back(lines);
      if (bytes[i] != '\n') continue;
      line_ends_[i / kWord] |= std::uint64_t{1} << (i % kWord);
      ++lines;
    }
  }

  // Places come mostly in file order: counting goes on from the last one, so that long lines cost
  // no more.
  SourceLocation at(std::size_t offset) {
    offset = std::min(offset, bytes_.size());
    if (offset < at_ || offset - at_ > 2 * kBlock) go_to_line_of(offset);
    for (; at_ < offset; ++at_) {
      if (is_line_end(at_)) {
        ++line_;
        column_ = 1;
      } else if (!is_utf8_continuation(bytes_[at_])) {
        ++column_;
      }
    }
    return {file_, line_, column_};
  }
  SourceLocation at(const char* place) {
    const std::less<const char*> before;
    if (before(place, bytes_.data()) || before(bytes_.data() + bytes_.size(), place))
      return {file_};
    return at(static_cast<std::size_t>(place - bytes_.data()));
  }

 private:
  static constexpr std::size_t kWord = 64, kBlock = 64 * kWord;

  bool is_line_end(std::size_t i) const { return (line_ends_[i / kWord] >> (i % kWord) & 1u) != 0; }

  void go_to_line_of(std::size_t offset) {
    std::size_t start = offset;
    while (start > begin_ && !is_line_end(start - 1)) {
      const bool is_word_empty = start % kWord == 0 && line_ends_[start / kWord - 1] == 0;
      start -= is_word_empty && start >= begin_ + kWord ? kWord : 1;
    }
    start = std::max(start, begin_);
    // Of a long line that has been counted in part the rest is enough.
    if (start <= at_ && at_ <= offset) return;
    at_ = start;
    column_ = 1;
    const std::size_t block = start / kBlock;
    line_ = block < line_of_block_.size() ? line_of_block_[block] : 1;
    for (std::size_t i = block * kBlock; i < start; ++i) line_ += is_line_end(i) ? 1 : 0;
  }

  std::string_view bytes_;
  std::string file_;
  std::size_t begin_;                     // behind a byte order mark
  std::vector<std::uint64_t> line_ends_;  // a bit for each byte
  std::vector<int> line_of_block_;        // at the begin of every kBlock bytes
  std::size_t at_;
  int line_ = 1, column_ = 1;
};

bool is_xml_character(std::uint32_t code) {
  return code == '\t' || code == '\n' || code == '\r' || (code >= 0x20 && code <= 0xD7FF) ||
         (code >= 0xE000 && code <= 0xFFFD) || (code >= 0x10000 && code <= 0x10FFFF);
}

// "#65" or "#x41" to a character; empty if it is none.
std::optional<std::string> numeric_reference(std::string_view name) {
  name.remove_prefix(1);
  const bool is_hexadecimal = name.starts_with('x');
  if (is_hexadecimal) name.remove_prefix(1);
  std::uint32_t code = 0;
  const auto [end, error] =
      std::from_chars(name.data(), name.data() + name.size(), code, is_hexadecimal ? 16 : 10);
  if (error != std::errc{} || end != name.data() + name.size()) return std::nullopt;
  if (!is_xml_character(code)) return std::nullopt;
  return utf8_from_code_point(code);
}

std::optional<std::string> resolve_reference(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kNamed{
      {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};
  if (name.starts_with('#')) return numeric_reference(name);
  for (const auto& [known, character] : kNamed) {
    if (name == known) return std::string(1, character);
  }
  return std::nullopt;
}

class TreeBuilder {
 public:
  TreeBuilder(Locator& locator, Diagnostics& diagnostics, XmlText text)
      : locator_(locator), diagnostics_(diagnostics), text_(text) {}

  std::optional<XmlElement> build(const pugi::xml_document& document) {
    const std::size_t errors_before = diagnostics_.error_count();
    std::optional<XmlElement> root;
    for (const pugi::xml_node& node : document) {
      if (node.type() != pugi::node_element) {
        check_other(node, "");
      } else if (root) {
        diagnostics_.report(
            DiagnosticId::xml_syntax, locator_.at(node.name() - 1),
            fmt::format("<{}> follows the root element, which must be the only one", node.name()));
      } else {
        root = convert(node, 1);
      }
    }
    if (diagnostics_.error_count() != errors_before) return std::nullopt;
    if (!root) {
      diagnostics_.report(DiagnosticId::xml_syntax, locator_.at(std::size_t{0}),
                          "the file has no element");
    }
    return root;
  }

 private:
  XmlElement convert(const pugi::xml_node& node, int depth) {
    XmlElement element{node.name(), {}, {}, locator_.at(node.name() - 1), {}};
    if (depth > kXmlDepthLimit) {
      diagnostics_.report(DiagnosticId::xml_too_deep, element.where, kXmlDepthLimit);
      return element;
    }
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      if (element.attributes.size() == kXmlAttributeLimit) {
        diagnostics_.report(DiagnosticId::xml_too_many_attributes, element.where, element.name,
                            kXmlAttributeLimit);
        break;
      }
      add_attribute(attribute, element);
    }
    for (const pugi::xml_node& child : node) {
      if (child.type() == pugi::node_element) {
        element.children.push_back(convert(child, depth + 1));
      } else if (text_ == XmlText::keep && child.type() == pugi::node_pcdata) {
        element.text += decode(child.value());
      } else if (text_ == XmlText::keep && child.type() == pugi::node_cdata) {
        element.text += child.value();
      } else {
        check_other(child, element.name);
      }
    }
    return element;
  }

  void add_attribute(const pugi::xml_attribute& attribute, XmlElement& element) {
    SourceLocation where = locator_.at(attribute.name());
    if (element.find(attribute.name()) != nullptr) {
      diagnostics_.report(DiagnosticId::duplicate_attribute, where, element.name, attribute.name());
      return;
    }
    element.attributes.push_back({attribute.name(), decode(attribute.value()), std::move(where)});
  }

  // Resolves references; `raw` points into the buffer.
  std::string decode(std::string_view raw) {
    std::string text;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      const char c = raw[i];
      if (c == '<') syntax_error(raw.data() + i, "'<' in an attribute must be written &lt;");
      if (c != '&') {
        text += c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
        continue;
      }
      const std::size_t end = raw.find(';', i);
      const std::optional<std::string> resolved =
          end == raw.npos ? std::nullopt : resolve_reference(raw.substr(i + 1, end - i - 1));
      if (resolved) {
        text += *resolved;
        i = end;
      } else {
        syntax_error(
            raw.data() + i,
            "unknown reference after '&'; allowed: &amp; &lt; &gt; &quot; &apos; and &#number;. "
            "Write a plain '&' as &amp;");
      }
    }
    return text;
  }

  void check_other(const pugi::xml_node& node, const std::string& parent) {
    switch (node.type()) {
      case pugi::node_pcdata:
      case pugi::node_cdata:
        return check_text(node, parent);
      case pugi::node_comment:
        return check_comment(node);
      case pugi::node_declaration:
        return check_declaration(node);
      case pugi::node_doctype:
        return diagnostics_.report(DiagnosticId::xml_doctype, locator_.at(node.value()));
      default:
        return;
    }
  }

  void check_text(const pugi::xml_node& node, const std::string& parent) {
    const std::string_view raw = node.value();
    const std::string_view text = trim(raw);
    if (text.empty()) return;
    if (parent.empty()) {
      syntax_error(text.data(), "text outside the root element");
      return;
    }
    diagnostics_.report(DiagnosticId::xml_text, locator_.at(text.data()), shorten_utf8(text, 30),
                        parent);
  }

  void check_comment(const pugi::xml_node& node) {
    const std::string_view text = node.value();
    if (text.find("--") == text.npos && !text.ends_with('-')) return;
    syntax_error(text.data(), "'--' is not allowed inside a comment");
  }

  void check_declaration(const pugi::xml_node& node) {
    const SourceLocation where = locator_.at(node.name() - 2);
    if (where.line != 1 || where.column != 1) {
      syntax_error(
          node.name() - 2,
          "the XML declaration is not at the start of the file; move it to line 1, column 1");
    }
  }

  void syntax_error(const char* place, std::string_view what) {
    diagnostics_.report(DiagnosticId::xml_syntax, locator_.at(place), what);
  }

  Locator& locator_;
  Diagnostics& diagnostics_;
  XmlText text_;
};

std::string_view syntax_problem(const pugi::xml_parse_result& result) {
  switch (result.status) {
    case pugi::status_end_element_mismatch:
      return "start and end tags do not match, or an element is not closed";
    case pugi::status_bad_attribute:
      return "malformed attribute; write it as name=\"value\"";
    case pugi::status_unrecognized_tag:
      return "'<' does not begin a tag here";
    default:
      return result.description();
  }
}

// No character that XML forbids.
bool check_characters(std::string_view bytes, Locator& locator, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto code = static_cast<unsigned char>(bytes[i]);
    if (code >= 0x20 || code == '\t' || code == '\n' || code == '\r') continue;
    diagnostics.report(DiagnosticId::xml_syntax, locator.at(i),
                       fmt::format("control character 0x{:02X} is not allowed; remove it", code));
    return false;
  }
  return true;
}

// pugixml skips most of what a declaration says.
bool check_beginning(std::string_view bytes, Locator& locator, Diagnostics& diagnostics) {
  const std::string_view content = without_byte_order_mark(bytes);
  const std::size_t begin = bytes.size() - content.size();
  if (!content.starts_with("<?xml") || content.find_first_of(" \t\r\n?", 5) != 5) return true;
  static const std::regex kDeclaration(
      R"re(<\?xml\s+version\s*=\s*["']1\.[0-9]["'](\s+encoding\s*=\s*["']([\w.-]+)["'])?)re"
      R"re((\s+standalone\s*=\s*["'](yes|no)["'])?\s*\?>)re");
  constexpr std::size_t kLongest = 200;
  const std::size_t end = content.substr(0, kLongest).find("?>");
  const std::string text(content.substr(0, end == content.npos ? kLongest : end + 2));
  if (std::regex_match(text, kDeclaration)) return true;
  diagnostics.report(DiagnosticId::xml_syntax, locator.at(begin),
                     "the declaration must be <?xml version=\"1.0\" encoding=\"UTF-8\"?>");
  return false;
}

}  // namespace

const XmlAttribute* XmlElement::find(std::string_view attribute) const {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(),
                   [&](const XmlAttribute& candidate) { return candidate.name == attribute; });
  return found == attributes.end() ? nullptr : &*found;
}

std::optional<XmlElement> parse_xml(std::string bytes, const std::string& name,
                                    Diagnostics& diagnostics, XmlText text) {
  std::optional<std::string> decoded = decoded_xml(std::move(bytes), name, diagnostics);
  if (!decoded) return std::nullopt;
  bytes = std::move(*decoded);
  bytes += '\n';  // pugixml overlooks a single character behind the root element at the very end
  Locator locator(bytes, name);
  if (!check_characters(bytes, locator, diagnostics)) return std::nullopt;
  if (trim(bytes).empty()) {
    diagnostics.report(DiagnosticId::xml_syntax, SourceLocation{name}, "the file is empty");
    return std::nullopt;
  }
  if (!check_beginning(bytes, locator, diagnostics)) return std::nullopt;
  pugi::xml_document document;
  const pugi::xml_parse_result result =
      document.load_buffer_inplace(bytes.data(), bytes.size(), kParseFlags, pugi::encoding_utf8);
  if (!result) {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, result.offset));
    diagnostics.report(DiagnosticId::xml_syntax, locator.at(offset), syntax_problem(result));
    return std::nullopt;
  }
  return TreeBuilder(locator, diagnostics, text).build(document);
}

}  // namespace calc
