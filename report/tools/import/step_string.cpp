// Strings of STEP text: escapes and alphabets.
#include "calc/base/encoding.h"
#include "calc/base/utf8.h"
#include "report/text/number_format.h"
#include "report/tools/import/step_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace cli {
namespace {

constexpr char32_t kUnknownLetter = 0xFFFD;

std::optional<char32_t> hex(std::string_view digits) {
  std::uint32_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

// Letters 0xA1 to 0xFF of the alphabets that no rule gives.
constexpr std::u16string_view kIso8859_2 =
    u"Ą˘Ł¤ĽŚ§¨ŠŞŤŹ\u00ADŽŻ°ą˛ł´ľśˇ¸šşťź˝žż"
    u"ŔÁÂĂÄĹĆÇČÉĘËĚÍÎĎĐŃŇÓÔŐÖ×ŘŮÚŰÜÝŢß"
    u"ŕáâăäĺćçčéęëěíîďđńňóôőö÷řůúűüýţ˙";
constexpr std::u16string_view kIso8859_3 =
    u"Ħ˘£¤\uFFFDĤ§¨İŞĞĴ\u00AD\uFFFDŻ°ħ²³´µĥ·¸ışğĵ½\uFFFDż"
    u"ÀÁÂ\uFFFDÄĊĈÇÈÉÊËÌÍÎÏ\uFFFDÑÒÓÔĠÖ×ĜÙÚÛÜŬŜß"
    u"àáâ\uFFFDäċĉçèéêëìíîï\uFFFDñòóôġö÷ĝùúûüŭŝ˙";
constexpr std::u16string_view kIso8859_4 =
    u"ĄĸŖ¤ĨĻ§¨ŠĒĢŦ\u00ADŽ¯°ą˛ŗ´ĩļˇ¸šēģŧŊžŋ"
    u"ĀÁÂÃÄÅÆĮČÉĘËĖÍÎĪĐŅŌĶÔÕÖ×ØŲÚÛÜŨŪß"
    u"āáâãäåæįčéęëėíîīđņōķôõö÷øųúûüũū˙";
static_assert(kIso8859_2.size() == 95 && kIso8859_3.size() == 95 && kIso8859_4.size() == 95);

// Greek, in the edition of 2003.
char32_t greek_letter(char32_t byte) {
  switch (byte) {
    case 0xA1:
      return 0x2018;
    case 0xA2:
      return 0x2019;
    case 0xA4:
      return 0x20AC;
    case 0xA5:
      return 0x20AF;
    case 0xAA:
      return 0x37A;
    case 0xAF:
      return 0x2015;
    case 0xAE:
    case 0xD2:
    case 0xFF:
      return kUnknownLetter;
    default:
      break;
  }
  const bool is_latin = byte < 0xB4 || byte == 0xB7 || byte == 0xBB || byte == 0xBD;
  return is_latin ? byte : byte - 0xB4 + 0x384;
}

char32_t arabic_letter(char32_t byte) {
  const bool is_letter = byte == 0xAC || byte == 0xBB || byte == 0xBF ||
                         (byte >= 0xC1 && byte <= 0xDA) || (byte >= 0xE0 && byte <= 0xF2);
  if (is_letter) return byte - 0xA0 + 0x600;
  return byte == 0xA4 ? byte : kUnknownLetter;
}

char32_t hebrew_letter(char32_t byte) {
  if (byte >= 0xE0 && byte <= 0xFA) return byte - 0xE0 + 0x5D0;
  if (byte == 0xAA) return 0xD7;
  if (byte == 0xBA) return 0xF7;
  if (byte == 0xDF) return 0x2017;
  if (byte == 0xFD || byte == 0xFE) return byte - 0xFD + 0x200E;
  return byte >= 0xA2 && byte <= 0xBE ? byte : kUnknownLetter;
}

char32_t turkish_letter(char32_t byte) {
  constexpr std::pair<char32_t, char32_t> kOther[] = {{0xD0, 0x11E}, {0xDD, 0x130}, {0xDE, 0x15E},
                                                      {0xF0, 0x11F}, {0xFD, 0x131}, {0xFE, 0x15F}};
  for (const auto& [of, letter] : kOther) {
    if (of == byte) return letter;
  }
  return byte;
}

char32_t cyrillic_letter(char32_t byte) {
  if (byte == 0xF0) return 0x2116;  // numero sign
  if (byte == 0xFD) return 0xA7;    // section sign
  return byte - 0xA0 + 0x400;
}

// Letter of the upper half of an ISO 8859 alphabet: page A is ISO 8859-1, I is ISO 8859-9.
char32_t letter_of_page(char page, char32_t byte) {
  if (page < 'A' || page > 'I') return kUnknownLetter;
  if (byte <= 0xA0 || byte == 0xAD) return byte;
  switch (page) {
    case 'B':
      return kIso8859_2[byte - 0xA1];
    case 'C':
      return kIso8859_3[byte - 0xA1];
    case 'D':
      return kIso8859_4[byte - 0xA1];
    case 'E':
      return cyrillic_letter(byte);
    case 'F':
      return arabic_letter(byte);
    case 'G':
      return greek_letter(byte);
    case 'H':
      return hebrew_letter(byte);
    case 'I':
      return turkish_letter(byte);
    default:
      return byte;
  }
}

class StringReader {
 public:
  explicit StringReader(std::string_view text) : rest_(text) {}

  std::string read() {
    while (!rest_.empty()) step();
    flush();
    return std::move(result_);
  }
  bool is_sure() const { return is_sure_; }

 private:
  void step() {
    const char c = rest_.front();
    if (c == '\'') {  // doubled: the text of a string holds no other
      raw_ += c;
      rest_.remove_prefix(rest_.starts_with("''") ? 2 : 1);
    } else if (c == '\r' || c == '\n') {
      rest_.remove_prefix(1);  // a long string goes on in the next line
    } else if (c == '\\') {
      escape();
    } else {
      raw_ += c;
      rest_.remove_prefix(1);
    }
  }

  void escape() {
    if (rest_.starts_with("\\\\")) {
      raw_ += '\\';
      rest_.remove_prefix(2);
    } else if (rest_.starts_with("\\X2\\")) {
      wide(4);
    } else if (rest_.starts_with("\\X4\\")) {
      wide(8);
    } else if (rest_.starts_with("\\X\\") && rest_.size() >= 5) {
      letter(hex(rest_.substr(3, 2)));
      rest_.remove_prefix(5);
    } else if (rest_.starts_with("\\S\\") && rest_.size() >= 4) {
      const auto byte = static_cast<unsigned char>(rest_[3]);
      letter(byte < 0x80 ? std::optional(letter_of_page(page_, byte + 0x80u)) : std::nullopt);
      rest_.remove_prefix(4);
    } else if (rest_.size() >= 4 && rest_[1] == 'P' && rest_[3] == '\\') {
      page_ = rest_[2];
      if (page_ < 'A' || page_ > 'I') {  // an alphabet that nobody knows
        is_sure_ = false;
        raw_ += rest_.substr(0, 4);
      }
      rest_.remove_prefix(4);
    } else {  // written by somebody who does not know that it must be doubled
      raw_ += '\\';
      rest_.remove_prefix(1);
    }
  }

  // Characters of 4 (UTF-16) or 8 digits up to \X0\.
  void wide(std::size_t digits) {
    rest_.remove_prefix(4);
    char32_t high = 0;  // first half of a pair that waits for its second
    while (!rest_.empty() && !rest_.starts_with("\\")) {
      const std::optional<char32_t> code = hex(rest_.substr(0, digits));
      rest_.remove_prefix(std::min(digits, rest_.size()));
      const bool is_low = code && digits == 4 && *code >= 0xDC00 && *code <= 0xDFFF;
      if (high != 0 && is_low) {
        letter(0x10000 + ((high - 0xD800) << 10) + (*code - 0xDC00));
        high = 0;
        continue;
      }
      if (high != 0) letter(std::nullopt);
      high = code && digits == 4 && *code >= 0xD800 && *code <= 0xDBFF ? *code : 0;
      if (high == 0) letter(code);
    }
    if (high != 0) letter(std::nullopt);
    if (rest_.starts_with("\\X0\\")) {
      rest_.remove_prefix(4);
    } else {
      is_sure_ = false;
    }
  }

  void letter(std::optional<char32_t> code) {
    flush();
    const bool is_known = code && *code != 0 && *code != kUnknownLetter && *code <= 0x10FFFF &&
                          (*code < 0xD800 || *code > 0xDFFF);
    if (!is_known) is_sure_ = false;
    result_ += calc::utf8_from_code_point(is_known ? *code : kUnknownLetter);
  }

  // What was written as plain bytes.
  void flush() {
    if (calc::first_invalid_utf8(raw_)) {
      is_sure_ = false;
      result_ += calc::utf8_from_windows_1252(raw_);
    } else {
      result_ += raw_;
    }
    raw_.clear();
  }

  std::string_view rest_;
  std::string raw_, result_;
  char page_ = 'A';
  bool is_sure_ = true;
};

}  // namespace

std::string step_string(std::string_view between_quotes, bool* is_sure) {
  StringReader reader(between_quotes);
  std::string text = reader.read();
  if (is_sure != nullptr && !reader.is_sure()) *is_sure = false;
  return text;
}

std::string step_literal(std::string_view utf8) {
  std::string text = "'";
  std::size_t digits = 0;  // of each character in the run that is open; 0: none is
  const auto open = [&](std::size_t wanted) {
    if (digits == wanted) return;
    if (digits != 0) text += "\\X0\\";
    if (wanted != 0) text += wanted == 4 ? "\\X2\\" : "\\X4\\";
    digits = wanted;
  };
  while (!utf8.empty()) {
    const calc::Utf8Character character = calc::first_character(utf8);
    const char32_t code = character.length == 0 ? kUnknownLetter : character.code;
    const bool begins_comment = utf8.starts_with("/*");
    utf8.remove_prefix(std::max<std::size_t>(character.length, 1));
    if (code >= 0x20 && code < 0x7F && !begins_comment) {
      open(0);
      if (code == '\'' || code == '\\') text += static_cast<char>(code);
      text += static_cast<char>(code);
    } else {
      open(code > 0xFFFF ? 8 : 4);
      text += fmt::format("{:0{}X}", static_cast<std::uint32_t>(code), digits);
    }
  }
  open(0);
  return text + "'";
}

std::string step_real(double value) {
  std::string text = report::format_shortest(value);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos) text[exponent] = 'E';
  if (text.find('.') == std::string::npos) text.insert(std::min(exponent, text.size()), ".");
  return text;
}

}  // namespace cli
