#include "calc/base/xml_encoding.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/encoding.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <regex>
#include <utility>

namespace calc {
namespace {

constexpr std::size_t kLongestDeclaration = 200;
constexpr std::size_t kStart = 4000;  // bytes in which the first tag begins

enum class Declared { nothing, utf8, utf16, latin1, windows_1252, unknown };

constexpr std::array<std::pair<std::string_view, Declared>, 16> kEncodings{
    {{"", Declared::nothing},
     {"utf-8", Declared::utf8},
     {"utf8", Declared::utf8},
     {"us-ascii", Declared::utf8},
     {"ascii", Declared::utf8},
     {"utf-16", Declared::utf16},
     {"utf-16le", Declared::utf16},
     {"utf-16be", Declared::utf16},
     {"ucs-2", Declared::utf16},
     {"iso-10646-ucs-2", Declared::utf16},
     {"unicode", Declared::utf16},
     {"iso-8859-1", Declared::latin1},
     {"latin1", Declared::latin1},
     {"latin-1", Declared::latin1},
     {"windows-1252", Declared::windows_1252},
     {"cp1252", Declared::windows_1252}}};

struct Declaration {
  std::string written;  // the name of the encoding
  Declared declared = Declared::nothing;
  int column = 0;  // of the name
};

Declaration read_declaration(std::string_view text) {
  const std::string_view content = without_byte_order_mark(text);
  if (!content.starts_with("<?xml")) return {};
  const std::string_view head = content.substr(0, kLongestDeclaration);
  const std::string declaration(head.substr(0, head.find("?>")));
  static const std::regex kEncoding(R"re(\sencoding\s*=\s*["']([^"']*)["'])re");
  std::smatch match;
  if (!std::regex_search(declaration, match, kEncoding)) return {};
  Declaration found{match[1], Declared::unknown, static_cast<int>(match.position(1)) + 1};
  std::string lower = found.written;
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  for (const auto& [known, meaning] : kEncodings) {
    if (known == lower) found.declared = meaning;
  }
  return found;
}

SourceLocation place_at(std::string_view text, std::size_t offset, const std::string& name) {
  const std::string_view before = without_byte_order_mark(text.substr(0, offset));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::string_view last = before.substr(before.rfind('\n') + 1);
  const auto column =
      std::count_if(last.begin(), last.end(), [](char c) { return !is_utf8_continuation(c); }) + 1;
  return {name, static_cast<int>(line), static_cast<int>(column)};
}

// "" = the declaration fits the bytes.
std::string contradiction(const Declaration& declaration, TextEncoding encoding, bool has_mark) {
  const bool is_utf16 = encoding != TextEncoding::utf8;
  const auto says = [&](std::string_view truth) {
    return fmt::format("the declaration says '{}', but {}; correct one of them",
                       declaration.written, truth);
  };
  switch (declaration.declared) {
    case Declared::nothing:
      return "";
    case Declared::unknown:
      return fmt::format("the declaration says '{}'", declaration.written);
    case Declared::utf16:
      return is_utf16 ? "" : says("the file is not UTF-16");
    case Declared::utf8:
      return is_utf16 ? says("the file is UTF-16") : "";
    default:
      if (is_utf16) return says("the file is UTF-16");
      return has_mark ? says("the file begins with the byte order mark of UTF-8") : "";
  }
}

}  // namespace

std::optional<std::string> decoded_xml(std::string bytes, const std::string& name,
                                       Diagnostics& diagnostics) {
  const auto refuse = [&](const SourceLocation& where, const std::string& what) {
    diagnostics.report(DiagnosticId::xml_encoding, where, what);
    return std::nullopt;
  };
  const TextEncoding encoding = encoding_of(bytes);
  DecodedText text = decoded_text(std::move(bytes));
  if (!text.problem.empty()) {
    return refuse(place_at(text.utf8, text.utf8.size(), name), text.problem);
  }
  const Declaration declaration = read_declaration(text.utf8);
  const bool has_mark = without_byte_order_mark(text.utf8).size() != text.utf8.size();
  if (const std::string problem = contradiction(declaration, encoding, has_mark);
      !problem.empty()) {
    return refuse({name, 1, declaration.column}, problem);
  }
  if (declaration.declared == Declared::latin1) return utf8_from_latin1(text.utf8);
  if (declaration.declared == Declared::windows_1252) return utf8_from_windows_1252(text.utf8);
  if (const auto bad = first_invalid_utf8(text.utf8)) {
    return refuse(place_at(text.utf8, *bad, name),
                  fmt::format("byte {} (0x{:02X}) is not valid UTF-8", *bad + 1,
                              static_cast<unsigned char>(text.utf8[*bad])));
  }
  return std::move(text.utf8);
}

bool looks_like_xml(std::string_view bytes) {
  const std::string head = start_of_text(bytes, kStart);
  const std::string_view start = trim(head);
  if (!start.starts_with('<') || start.size() < 2) return false;
  const char next = start[1];
  return next == '?' || next == '!' || next == '_' || (next >= 'A' && next <= 'Z') ||
         (next >= 'a' && next <= 'z');
}

std::string first_element_name(std::string_view text) {
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
    const std::string_view rest = text.substr(at + 1);
    if (rest.starts_with("!--")) {
      at = std::min(text.find("-->", at), text.size());
    } else if (rest.starts_with('?') || rest.starts_with('!')) {
      at = std::min(text.find('>', at), text.size());
    } else {
      const std::string_view name = rest.substr(0, rest.find_first_of(" \t\r\n>/"));
      return std::string(name.substr(name.rfind(':') + 1));
    }
  }
  return "";
}

bool has_first_element(std::string_view bytes, std::string_view name) {
  constexpr std::size_t kComments = 100'000;
  return first_element_name(start_of_text(bytes, kComments)) == name;
}

}  // namespace calc
