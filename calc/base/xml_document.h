#pragma once
// Parses bytes to a tree of XML elements with source locations. Only this uses pugixml. It refuses
// everything an XML parser must refuse, and what our files never need (DOCTYPE, and text between
// tags unless `text` is XmlText::keep).

#include "calc/base/diagnostics.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace calc {

struct XmlAttribute {
  std::string name;
  std::string value;  // references like &amp; resolved, line ends and tabs as blanks
  SourceLocation where;
};

struct XmlElement {
  std::string name;
  std::vector<XmlAttribute> attributes;  // in file order, no name twice
  std::vector<XmlElement> children;      // in file order
  SourceLocation where;                  // of its '<'
  std::string text{};  // own text, references resolved, line ends as blanks; XmlText::keep only

  // Returns the attribute; null if there is none.
  const XmlAttribute* find(std::string_view attribute) const;
};

inline constexpr int kXmlDepthLimit = 64;
inline constexpr std::size_t kXmlAttributeLimit = 100;

// Text between tags: an error in our own formats, data in foreign ones.
enum class XmlText { refuse, keep };

// Returns the root element of a file in an encoding that decoded_xml() reads (xml_encoding.h; CRLF
// is fine, columns count characters). name: the path used in messages. Comments and processing
// instructions are skipped. Empty if and only if an error was reported.
std::optional<XmlElement> parse_xml(std::string bytes, const std::string& name,
                                    Diagnostics& diagnostics, XmlText text = XmlText::refuse);

}  // namespace calc
