#include "report/tools/import/dxf_pairs.h"

#include "calc/base/encoding.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"

#include <fmt/format.h>

#include <iconv.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>

namespace cli {
namespace {

constexpr std::string_view kBinaryMark{"AutoCAD Binary DXF\r\n\x1a\0", 22};
constexpr int kHighestCode = 1071;

enum class ValueKind { text, real, whole16, whole32, whole64, byte, chunk, unknown };

struct CodeRange {
  int first, last;
  ValueKind kind;
};
// What stands behind a code in binary files.
constexpr std::array kCodes = {
    CodeRange{0, 9, ValueKind::text},         CodeRange{10, 59, ValueKind::real},
    CodeRange{60, 79, ValueKind::whole16},    CodeRange{90, 99, ValueKind::whole32},
    CodeRange{100, 105, ValueKind::text},     CodeRange{110, 149, ValueKind::real},
    CodeRange{160, 169, ValueKind::whole64},  CodeRange{170, 179, ValueKind::whole16},
    CodeRange{210, 239, ValueKind::real},     CodeRange{270, 289, ValueKind::whole16},
    CodeRange{290, 299, ValueKind::byte},     CodeRange{300, 309, ValueKind::text},
    CodeRange{310, 319, ValueKind::chunk},    CodeRange{320, 369, ValueKind::text},
    CodeRange{370, 389, ValueKind::whole16},  CodeRange{390, 399, ValueKind::text},
    CodeRange{400, 409, ValueKind::whole16},  CodeRange{410, 419, ValueKind::text},
    CodeRange{420, 429, ValueKind::whole32},  CodeRange{430, 439, ValueKind::text},
    CodeRange{440, 459, ValueKind::whole32},  CodeRange{460, 469, ValueKind::real},
    CodeRange{470, 481, ValueKind::text},     CodeRange{999, 1003, ValueKind::text},
    CodeRange{1004, 1004, ValueKind::chunk},  CodeRange{1005, 1009, ValueKind::text},
    CodeRange{1010, 1059, ValueKind::real},   CodeRange{1060, 1070, ValueKind::whole16},
    CodeRange{1071, 1071, ValueKind::whole32}};

ValueKind kind_of(int code) {
  for (const CodeRange& range : kCodes) {
    if (code >= range.first && code <= range.last) return range.kind;
  }
  return ValueKind::unknown;
}

bool starts_like_dwg(std::string_view bytes) {
  return bytes.size() > 6 && bytes.substr(0, 4) == "AC10" && calc::is_digit(bytes[4]) &&
         calc::is_digit(bytes[5]) && bytes[6] == '\0';
}

// Blanks and line ends as single blanks, none at the ends.
std::string on_one_line(const std::string& text) {
  std::string line;
  for (const std::string_view word : calc::split_words(text)) {
    if (!line.empty()) line += ' ';
    line += word;
  }
  return line;
}

// \U+XXXX as characters; what is no such escape stays.
std::string without_escapes(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto escaped_at = [&](std::size_t at) -> std::optional<char32_t> {
      if (text.size() < at + 7 || text[at] != '\\' ||
          (text[at + 1] != 'U' && text[at + 1] != 'u') || text[at + 2] != '+') {
        return std::nullopt;
      }
      char32_t code = 0;
      for (std::size_t k = at + 3; k < at + 7; ++k) {
        if (std::isxdigit(static_cast<unsigned char>(text[k])) == 0) return std::nullopt;
        const char low = static_cast<char>(text[k] | 0x20);
        code = code * 16 + static_cast<char32_t>(low > '9' ? low - 'a' + 10 : text[k] - '0');
      }
      return code;
    };
    std::optional<char32_t> code = escaped_at(i);
    if (!code || *code == 0) {
      out += text[i];
      continue;
    }
    i += 6;
    if (*code >= 0xD800 && *code < 0xDC00) {  // half a character, the other half follows
      const std::optional<char32_t> low = escaped_at(i + 1);
      if (low && *low >= 0xDC00 && *low < 0xE000) {
        code = 0x10000 + ((*code - 0xD800) << 10) + (*low - 0xDC00);
        i += 7;
      }
    }
    const bool is_half = *code >= 0xD800 && *code < 0xE000;
    out += calc::utf8_from_code_point(is_half ? U'\uFFFD' : *code);
  }
  return out;
}

// "ANSI_1251" -> "CP1251", "" = not known.
std::string iconv_name(const std::string& code_page) {
  for (const std::string_view start : {"ansi_", "dos", "cp"}) {
    if (code_page.compare(0, start.size(), start) != 0) continue;
    const std::string number = code_page.substr(start.size());
    if (number.empty() || number.size() > 5 ||
        number.find_first_not_of("0123456789") != number.npos) {
      return "";
    }
    return "CP" + number;
  }
  return "";
}

// By the C library's tables. Empty: it has none of that name, or the bytes are none of it.
std::optional<std::string> converted(std::string_view bytes, const std::string& from) {
  const iconv_t way = iconv_open("UTF-8", from.c_str());
  if (way == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string in(bytes), out(bytes.size() * 4 + 16, '\0');
  char* source = in.data();
  char* target = out.data();
  std::size_t left = in.size(), room = out.size();
  const bool is_done = iconv(way, &source, &left, &target, &room) != static_cast<std::size_t>(-1);
  iconv_close(way);
  if (!is_done) return std::nullopt;
  out.resize(out.size() - room);
  return out;
}

bool is_ascii(std::string_view bytes) {
  for (const char byte : bytes) {
    if ((static_cast<unsigned char>(byte) & 0x80u) != 0) return false;
  }
  return true;
}

}  // namespace

DxfPairs::DxfPairs(std::string_view bytes) : bytes_(calc::without_byte_order_mark(bytes)) {
  if (bytes_.substr(0, kBinaryMark.size()) == kBinaryMark) {
    is_binary_ = true;
    at_ = kBinaryMark.size();
    // The first pair is 0 SECTION: of wide codes both bytes are 0.
    has_wide_codes_ = bytes_.size() > at_ + 1 && bytes_[at_ + 1] == '\0';
    return;
  }
  if (starts_like_dwg(bytes_)) {
    fail(1, "this is a DWG file; have the CAD program save it as DXF");
  } else if (calc::has_utf16_mark(bytes_)) {
    fail(1, "this is text in UTF-16; DXF files are not");
  } else if (calc::trim(bytes_.substr(0, 4096)).empty()) {
    fail(1, bytes_.empty() ? "the file is empty" : "there is no group code here");
  }
}

std::string DxfPairs::place_words(std::size_t place) const {
  return fmt::format("{} {}", is_binary_ ? "byte" : "line", place);
}

bool DxfPairs::fail(std::size_t place, const std::string& why) {
  problem_ = fmt::format("{}: {}", place_words(place), why);
  is_over_ = true;
  return false;
}

bool DxfPairs::next(DxfPair& pair) {
  while (!is_over_) {
    if (!(is_binary_ ? next_of_binary(pair) : next_of_text(pair))) return false;
    if (pair.code == 999) {
      if (first_comment_.empty()) first_comment_ = pair.text;
      continue;
    }
    if (pair.code == 0 && calc::trim(pair.text) == "EOF") {
      is_over_ = true;
      return false;
    }
    return true;
  }
  return false;
}

std::optional<std::string_view> DxfPairs::line() {
  if (at_ >= bytes_.size()) return std::nullopt;
  ++line_;
  const std::size_t end = std::min(bytes_.find_first_of("\r\n", at_), bytes_.size());
  const std::string_view text = bytes_.substr(at_, end - at_);
  at_ = end + 1;
  if (end + 1 < bytes_.size() && bytes_[end] == '\r' && bytes_[end + 1] == '\n') ++at_;
  return text;
}

bool DxfPairs::next_of_text(DxfPair& pair) {
  constexpr const char* kCut =
      "the file ends here without its last pair, 0 EOF: it is cut off; save it again";
  const std::optional<std::string_view> code = line();
  pair.place = line_;
  if (!code) {
    is_cut_ = true;
    return fail(line_, kCut);
  }
  const std::optional<int> number = calc::parse_integer(calc::trim(*code));
  if (!number || *number < -5 || *number > kHighestCode) {
    return fail(line_, fmt::format("a group code from 0 to {} is needed, not '{}'", kHighestCode,
                                   calc::printable(calc::shorten_utf8(calc::trim(*code), 40))));
  }
  const std::optional<std::string_view> value = line();
  if (!value) return fail(line_, kCut);
  pair.code = *number;
  pair.text = *value;
  pair.number.reset();
  return true;
}

std::optional<std::uint64_t> DxfPairs::read_unsigned(std::size_t count) {
  if (bytes_.size() - at_ < count) return std::nullopt;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(bytes_[at_ + i])} << (8 * i);
  }
  at_ += count;
  return value;
}

bool DxfPairs::read_code(int& code) {
  std::optional<std::uint64_t> read = read_unsigned(has_wide_codes_ ? 2 : 1);
  if (read && !has_wide_codes_ && *read == 255) read = read_unsigned(2);
  if (!read) return false;
  code = static_cast<std::int16_t>(*read);
  return true;
}

bool DxfPairs::next_of_binary(DxfPair& pair) {
  pair.place = at_;
  pair.text = {};
  pair.number.reset();
  const auto is_cut = [&] { return fail(pair.place, "the file ends here: it is cut off"); };
  if (!read_code(pair.code)) return is_cut();
  const auto whole = [&](std::size_t bytes) {
    const std::optional<std::uint64_t> read = read_unsigned(bytes);
    if (!read) return is_cut();
    const std::size_t unused = 64 - 8 * bytes;  // shifts carry the sign
    pair.number = static_cast<double>(static_cast<std::int64_t>(*read << unused) >> unused);
    return true;
  };
  switch (kind_of(pair.code)) {
    case ValueKind::text: {
      const std::size_t end = bytes_.find('\0', at_);
      if (end == bytes_.npos) return is_cut();
      pair.text = bytes_.substr(at_, end - at_);
      at_ = end + 1;
      return true;
    }
    case ValueKind::real: {
      const std::optional<std::uint64_t> read = read_unsigned(8);
      if (!read) return is_cut();
      pair.number = std::bit_cast<double>(*read);
      return true;
    }
    case ValueKind::whole16:
      return whole(2);
    case ValueKind::whole32:
      return whole(4);
    case ValueKind::whole64:
      return whole(8);
    case ValueKind::byte:
      return whole(1);
    case ValueKind::chunk: {
      const std::optional<std::uint64_t> length = read_unsigned(1);
      if (!length || bytes_.size() - at_ < *length) return is_cut();
      at_ += static_cast<std::size_t>(*length);
      return true;
    }
    case ValueKind::unknown:
      break;
  }
  return fail(pair.place, fmt::format("{} is not a group code of binary files", pair.code));
}

std::optional<double> dxf_number(const DxfPair& pair) {
  if (pair.number) return std::isfinite(*pair.number) ? pair.number : std::nullopt;
  return calc::parse_number(calc::trim(pair.text));
}

std::optional<int> dxf_integer(const DxfPair& pair) {
  if (!pair.number) return calc::parse_integer(calc::trim(pair.text));
  const double number = *pair.number;
  if (!(std::fabs(number) <= 2147483647.0) || number != std::floor(number)) return std::nullopt;
  return static_cast<int>(number);
}

void DxfTexts::set(std::string_view version, std::string_view code_page) {
  // AC1021 is 2007, the first with UTF-8.
  is_utf8_ = version.size() == 6 && version.substr(0, 2) == "AC" && version >= "AC1021";
  code_page_ = calc::ascii_lowered(calc::trim(code_page));
}

std::string DxfTexts::of_code_page(std::string_view bytes) {
  if (code_page_ == "ansi_1252") return calc::utf8_from_windows_1252(bytes);
  if (code_page_.empty() && !calc::first_invalid_utf8(bytes)) {
    doubt_ =
        "the file names no code page: its texts are read as UTF-8, because they are valid UTF-8";
    return std::string(bytes);
  }
  if (const std::string name = iconv_name(code_page_); !name.empty()) {
    if (const auto text = converted(bytes, name)) return *text;
  }
  doubt_ =
      code_page_.empty()
          ? "the file names no code page: its texts are read as Windows-1252"
          : fmt::format(
                "texts in the code page '{}' cannot be read here: they are read as Windows-1252",
                calc::printable(code_page_));
  return calc::utf8_from_windows_1252(bytes);
}

std::string DxfTexts::decoded(std::string_view bytes) {
  if (is_ascii(bytes)) return without_escapes(std::string(bytes));
  if (!is_utf8_) return without_escapes(of_code_page(bytes));
  if (!calc::first_invalid_utf8(bytes)) return without_escapes(std::string(bytes));
  const std::string text = of_code_page(bytes);
  doubt_ =
      "some texts are not UTF-8, as this version requires: they are read in the file's code page";
  return without_escapes(text);
}

std::string plain_dxf_text(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i, 2) != "%%" || i + 2 >= text.size()) {
      out += text[i];
      continue;
    }
    const char what = static_cast<char>(text[i + 2] | 0x20);
    if (calc::is_digit(text[i + 2]) && i + 4 < text.size()) {
      const std::optional<int> code = calc::parse_integer(text.substr(i + 2, 3));
      if (code && *code >= 32 && *code < 256) {
        out += calc::utf8_from_windows_1252(static_cast<unsigned char>(*code));
        i += 4;
        continue;
      }
    }
    if (what == 'd') {
      out += "°";
    } else if (what == 'c') {
      out += "⌀";
    } else if (what == 'p') {
      out += "±";
    } else if (text[i + 2] == '%') {
      out += '%';
    } else if (what != 'u' && what != 'o' && what != 'k') {
      out += text[i];
      continue;
    }
    i += 2;
  }
  return on_one_line(out);
}

std::string plain_dxf_mtext(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '{' || c == '}') continue;
    if (c == '^' && i + 1 < text.size() && (text[i + 1] == 'I' || text[i + 1] == 'J')) {
      out += ' ';
      ++i;
      continue;
    }
    if (c != '\\' || i + 1 >= text.size()) {
      out += c;
      continue;
    }
    const char what = text[++i];
    constexpr std::string_view kPlain = "\\{}", kSwitches = "LlOoKk", kBlanks = "P~XN";
    if (kPlain.find(what) != kPlain.npos) {
      out += what;
    } else if (kBlanks.find(what) != kBlanks.npos) {
      out += ' ';
    } else if (kSwitches.find(what) != kSwitches.npos) {
      continue;
    } else if (std::string_view("ACFHQTWcfpS").find(what) != std::string_view::npos) {
      // A format up to its ';'; of a stacked fraction the two numbers stay.
      const std::size_t end = text.find(';', i);
      if (end == text.npos) break;
      for (std::size_t k = i + 1; what == 'S' && k < end; ++k) {
        out += text[k] == '^' || text[k] == '#' ? '/' : text[k];
      }
      i = end;
    } else {
      out += '\\';
      out += what;
    }
  }
  return plain_dxf_text(out);
}

}  // namespace cli
