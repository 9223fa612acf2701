#include "calc/project/reading/logo.h"

#include "calc/base/diagnostics.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/base/xml_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace calc {
namespace {

// --- PNG ----------------------------------------------------------------------------------------

std::uint32_t big_endian(std::string_view four) {
  std::uint32_t value = 0;
  for (const char c : four) value = (value << 8U) | static_cast<unsigned char>(c);
  return value;
}

bool is_known_colour(unsigned depth, unsigned type) {
  switch (type) {
    case 0:
      return depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;
    case 3:
      return depth == 1 || depth == 2 || depth == 4 || depth == 8;
    case 2:
    case 4:
    case 6:
      return depth == 8 || depth == 16;
    default:
      return false;
  }
}

std::string header_problem(std::string_view header) {
  const std::uint32_t width = big_endian(header.substr(0, 4)),
                      height = big_endian(header.substr(4, 4));
  if (width < 1 || height < 1 || width > kMostLogoPixels || height > kMostLogoPixels) {
    return fmt::format("it has {} x {} pixels; allowed: 1 to {} each way", width, height,
                       kMostLogoPixels);
  }
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(header[i]); };
  const bool is_known = is_known_colour(byte(8), byte(9)) && byte(10) == 0 && byte(11) == 0;
  return is_known && byte(12) <= 1 ? "" : "its PNG header is not valid";
}

std::string png_problem(std::string_view bytes) {
  constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
  constexpr std::size_t kHeader = 13, kAround = 12;  // length, name and checksum of a chunk
  if (!bytes.starts_with(kSignature)) return "its name ends with .png, but it is not a PNG file";
  bytes.remove_prefix(kSignature.size());
  bool is_first = true, has_pixels = false;
  while (bytes.size() >= kAround) {
    const std::size_t length = big_endian(bytes.substr(0, 4));
    const std::string_view name = bytes.substr(4, 4);
    if (length > bytes.size() - kAround) break;
    if (is_first != (name == "IHDR") || (is_first && length != kHeader)) break;
    if (is_first) {
      if (std::string problem = header_problem(bytes.substr(8, kHeader)); !problem.empty()) {
        return problem;
      }
    }
    is_first = false;
    has_pixels = has_pixels || name == "IDAT";
    bytes.remove_prefix(length + kAround);
    if (name == "IEND") return bytes.empty() && has_pixels ? "" : "it is not a complete PNG file";
  }
  return "it is not a complete PNG file";
}

// --- SVG ----------------------------------------------------------------------------------------

constexpr std::string_view kSvgNamespace = "http://www.w3.org/2000/svg";

// What draws, and what says how. Nothing else is let in: no script, no link, no animation, no
// filter, no other file, no foreign markup.
constexpr std::array<std::string_view, 26> kSvgElements{
    "svg",     "g",        "defs",   "symbol", "use",      "title",          "desc",
    "path",    "rect",     "circle", "line",   "polyline", "polygon",        "ellipse",
    "text",    "tspan",    "style",  "switch", "stop",     "linearGradient", "radialGradient",
    "pattern", "clipPath", "mask",   "marker", "metadata"};

// Shapes that are drawn in the end, counting what is used again and again.
constexpr double kMostDrawn = 200'000.0;

std::string_view without_prefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

class SvgCheck {
 public:
  // "" or what is wrong.
  std::string problem(const XmlElement& root) {
    const XmlAttribute* space = root.find("xmlns");
    if (root.name != "svg" || space == nullptr || space->value != kSvgNamespace) {
      return fmt::format("its first element must be <svg xmlns=\"{}\">", kSvgNamespace);
    }
    walk(root);
    if (problem_.empty() && drawn_by(root) > kMostDrawn) {
      problem_ = fmt::format("its parts use each other and draw more than {} shapes",
                             static_cast<int>(kMostDrawn));
    }
    return problem_;
  }

 private:
  void fail(const XmlElement& element, const std::string& what) {
    if (problem_.empty()) problem_ = fmt::format("line {}: {}", element.where.line, what);
  }

  // Of a value or a style sheet: only parts of the same file.
  void check_text(const XmlElement& element, std::string_view text, bool is_style) {
    const std::string lower = ascii_lowered(text);
    for (std::size_t at = lower.find("url("); at != lower.npos; at = lower.find("url(", at + 1)) {
      const std::size_t target = lower.find_first_not_of(" '\"", at + 4);
      if (target == lower.npos || lower[target] != '#') {
        fail(element, "'url(' may refer to the same file only, as url(#id)");
        return;
      }
      const std::size_t end = lower.find_first_of(" '\")", target);
      uses_[&element].emplace_back(text.substr(target + 1, end - target - 1));
    }
    if (!is_style) return;
    for (const std::string_view word : {"\\", "@", "image(", "image-set(", "expression("}) {
      if (lower.find(word) != lower.npos) {
        fail(element, fmt::format("'{}' is not allowed in a style", word));
      }
    }
  }

  void check_attribute(const XmlElement& element, const XmlAttribute& attribute) {
    const std::string name = ascii_lowered(without_prefix(attribute.name));
    if (name.starts_with("on")) {
      fail(element, fmt::format("'{}' is not allowed: a logo must not react to events",
                                printable(attribute.name)));
    } else if (name == "href" || name == "src" || attribute.name == "xml:base") {
      if (!attribute.value.starts_with('#') || name != "href") {
        fail(element, fmt::format("'{}' may refer to the same file only, as #id",
                                  printable(attribute.name)));
      }
      uses_[&element].push_back(
          attribute.value.substr(std::min<std::size_t>(1, attribute.value.size())));
    } else if (attribute.name.starts_with("xmlns:")) {
      const bool is_foreign = attribute.value.find("xhtml") != std::string::npos ||
                              attribute.value.find("MathML") != std::string::npos ||
                              attribute.value == kSvgNamespace;
      if (is_foreign) drawing_prefixes_.insert(attribute.name.substr(6));
    } else if (attribute.name == "xmlns" && attribute.value != kSvgNamespace) {
      fail(element, fmt::format("'xmlns' must be \"{}\"", kSvgNamespace));
    }
    check_text(element, attribute.value, name == "style");
  }

  // Elements of editors, with a prefix, draw nothing; they go if the prefix is one that draws.
  void walk(const XmlElement& element) {
    for (const XmlAttribute& attribute : element.attributes) check_attribute(element, attribute);
    const std::size_t colon = element.name.find(':');
    const bool is_known = colon == std::string::npos
                              ? std::find(kSvgElements.begin(), kSvgElements.end(), element.name) !=
                                    kSvgElements.end()
                              : !drawing_prefixes_.contains(element.name.substr(0, colon));
    if (!is_known) fail(element, fmt::format("<{}> is not allowed", printable(element.name)));
    if (element.name == "style") check_text(element, element.text, true);
    if (const XmlAttribute* id = element.find("id")) by_id_.emplace(id->value, &element);
    for (const XmlElement& child : element.children) walk(child);
  }

  // With all that it uses; what uses itself is endless.
  double drawn_by(const XmlElement& element) {
    const auto [found, is_new] = drawn_.try_emplace(&element, 2.0 * kMostDrawn);
    if (!is_new) return found->second;
    double sum = 1.0;
    for (const XmlElement& child : element.children) sum += drawn_by(child);
    if (const auto uses = uses_.find(&element); uses != uses_.end()) {
      for (const std::string& id : uses->second) {
        if (const auto used = by_id_.find(id); used != by_id_.end()) sum += drawn_by(*used->second);
      }
    }
    return drawn_[&element] = std::min(sum, 2.0 * kMostDrawn);
  }

  std::string problem_;  // the first one
  std::set<std::string, std::less<>> drawing_prefixes_;
  std::map<std::string, const XmlElement*, std::less<>> by_id_;
  std::map<const XmlElement*, std::vector<std::string>> uses_;  // ids
  std::map<const XmlElement*, double> drawn_;
};

std::string svg_problem(std::string_view bytes) {
  // Every reader must see the same characters.
  if (first_invalid_utf8(bytes) || bytes.find('\0') != bytes.npos) return "it is not UTF-8";
  const std::string_view text = without_byte_order_mark(bytes);
  if (text.rfind("<?") != text.npos && (text.rfind("<?") > 0 || !text.starts_with("<?xml "))) {
    return "'<?' is allowed at the start of the file only, as '<?xml ...?>'";
  }
  Diagnostics diagnostics;
  const std::optional<XmlElement> root =
      parse_xml(std::string(bytes), "", diagnostics, XmlText::keep);
  if (!root) {
    const Diagnostic& first = diagnostics.all().front();
    return fmt::format("line {}: {}", first.where.line, first.message);
  }
  return SvgCheck().problem(*root);
}

}  // namespace

bool is_logo_name(std::string_view file, LogoFormat& format) {
  const std::string lower = ascii_lowered(file);
  format = lower.ends_with(".svg") ? LogoFormat::svg : LogoFormat::png;
  return format == LogoFormat::svg || lower.ends_with(".png");
}

std::string logo_problem(std::string_view bytes, LogoFormat format) {
  if (bytes.size() > kMostLogoBytes) {
    return fmt::format("it has {} bytes; at most {} are allowed", bytes.size(), kMostLogoBytes);
  }
  return format == LogoFormat::png ? png_problem(bytes) : svg_problem(bytes);
}

}  // namespace calc
