#pragma once
// Our own texts in the reader's language. The table is texts.def; data formats and everything that
// comes from files stay as they are.

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace report {

enum class Language : std::uint8_t { english, german };

enum class Text : std::uint16_t {
#define TEXT(id, english, german) id,
#include "report/text/texts.def"
#undef TEXT
};

// With the placeholders of fmt.
struct TextEntry {
  const char* id;
  const char* english;
  const char* german;
};
// No std::array{...}: Clang 14 deduces the type of no more than 256 elements.
inline constexpr auto kTexts = std::to_array<TextEntry>({
#define TEXT(id, english, german) TextEntry{#id, english, german},
#include "report/text/texts.def"
#undef TEXT
});

constexpr const TextEntry& text_entry(Text id) { return kTexts[static_cast<std::size_t>(id)]; }

// How a report is worded: a value that renderers hand on.
class Texts {
 public:
  Texts() = default;  // English, decimal points
  Texts(Language language, bool has_decimal_comma)
      : language_(language), has_decimal_comma_(has_decimal_comma) {}

  Language language() const { return language_; }
  const char* language_tag() const { return language_ == Language::german ? "de" : "en"; }

  // As it is in the table.
  const char* operator[](Text id) const {
    const TextEntry& entry = text_entry(id);
    return language_ == Language::german ? entry.german : entry.english;
  }

  // With its placeholders filled in. The compiler holds the English text against the arguments, a
  // test the German one against the English one.
  template <Text id, class... Args>
  std::string say(const Args&... args) const {
    static_cast<void>(fmt::format_string<const Args&...>(text_entry(id).english));
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
