#pragma once
// The program's texts in the reader's language. A language is a file of texts (english.def is the
// first) included in texts.cpp, a file of sentences included in sentences.cpp, and a row in
// kLanguages. Data formats and texts from files stay unchanged.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace report {

enum class Language : std::uint8_t { english, german, french };

struct LanguageRow {
  Language language;
  std::string_view tag;    // of BCP 47, as users choose it
  bool has_decimal_comma;  // unless somebody chooses otherwise
  bool has_long_words;     // that are to be broken in narrow columns
};
inline constexpr std::array kLanguages{LanguageRow{Language::english, "en", false, false},
                                       LanguageRow{Language::german, "de", true, true},
                                       LanguageRow{Language::french, "fr", true, true}};

constexpr const LanguageRow& language_row(Language language) {
  return *std::find_if(kLanguages.begin(), kLanguages.end(),
                       [language](const LanguageRow& row) { return row.language == language; });
}

enum class Text : std::uint16_t {
#define TEXT(id, text) id,
#include "report/text/english.def"
#undef TEXT
};

// A text with its fmt placeholders.
struct TextEntry {
  std::string_view id;
  const char* text;
};
// No std::array{...}: Clang 14 deduces the type of no more than 256 elements.
inline constexpr auto kEnglishTexts = std::to_array<TextEntry>({
#define TEXT(id, text) TextEntry{#id, text},
#include "report/text/english.def"
#undef TEXT
});

constexpr const char* english_text(Text id) {
  return kEnglishTexts[static_cast<std::size_t>(id)].text;
}

// Returns all texts of a language, in the order of Text.
std::span<const TextEntry> texts_of(Language language);

// The wording of a report: a value that renderers pass on.
class Texts {
 public:
  Texts() = default;  // English, decimal points
  Texts(Language language, bool has_decimal_comma)
      : language_(language), has_decimal_comma_(has_decimal_comma) {}

  Language language() const { return language_; }
  std::string_view language_tag() const { return language_row(language_).tag; }

  // Returns the text as it is in the table.
  const char* operator[](Text id) const;

  // Returns the text with its placeholders filled in. The compiler checks the arguments against the
  // English text, and a test checks other languages against the English text.
  template <Text id, class... Args>
  std::string say(const Args&... args) const {
    static_cast<void>(fmt::format_string<const Args&...>(english_text(id)));
    return fmt::vformat((*this)[id], fmt::make_format_args(args...));
  }

  // Returns numbers from number_format.h for prose: with decimal comma "(4.20, 1.10, 0.80)" becomes
  // "(4,20; 1,10; 0,80)". text: only numbers, units and signs.
  std::string number(std::string text) const;

  // Returns finished HTML of text that is English in every report, marked as such in other
  // languages.
  std::string english_html(const std::string& html) const;

 private:
  Language language_ = Language::english;
  bool has_decimal_comma_ = false;
};

}  // namespace report
