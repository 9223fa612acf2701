#pragma once
// Our own texts in the reader's language. A language is a file of texts (english.def is the first
// of them) with its include in texts.cpp, one of sentences with that in sentences.cpp, and its row
// in kLanguages. Data formats and everything that comes from files stay as they are.

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

// With the placeholders of fmt.
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

// All of a language, in the order of Text.
std::span<const TextEntry> texts_of(Language language);

// How a report is worded: a value that renderers hand on.
class Texts {
 public:
  Texts() = default;  // English, decimal points
  Texts(Language language, bool has_decimal_comma)
      : language_(language), has_decimal_comma_(has_decimal_comma) {}

  Language language() const { return language_; }
  std::string_view language_tag() const { return language_row(language_).tag; }

  // As it is in the table.
  const char* operator[](Text id) const;

  // With its placeholders filled in. The compiler holds the English text against the arguments, a
  // test those of other languages against the English one.
  template <Text id, class... Args>
  std::string say(const Args&... args) const {
    static_cast<void>(fmt::format_string<const Args&...>(english_text(id)));
    return fmt::vformat((*this)[id], fmt::make_format_args(args...));
  }

  // Numbers as number_format.h makes them, for prose: with decimal comma "(4.20, 1.10, 0.80)"
  // becomes "(4,20; 1,10; 0,80)". text: nothing but numbers, units and signs.
  std::string number(std::string text) const;

  // Finished HTML of text that is English in every report: marked where the report is not.
  std::string english_html(const std::string& html) const;

 private:
  Language language_ = Language::english;
  bool has_decimal_comma_ = false;
};

}  // namespace report
