#include "report/text/texts.h"

namespace report {
namespace {

#define TEXT(id, text) TextEntry{#id, text},
constexpr auto kGermanTexts = std::to_array<TextEntry>({
#include "report/text/german.def"
});
constexpr auto kFrenchTexts = std::to_array<TextEntry>({
#include "report/text/french.def"
});
#undef TEXT

constexpr bool has_all_ids(std::span<const TextEntry> texts) {
  return std::equal(texts.begin(), texts.end(), kEnglishTexts.begin(), kEnglishTexts.end(),
                    [](const TextEntry& a, const TextEntry& b) { return a.id == b.id; });
}
// In the order of Language.
constexpr std::array<std::span<const TextEntry>, kLanguages.size()> kAllTexts{
    kEnglishTexts, kGermanTexts, kFrenchTexts};
static_assert(std::all_of(kAllTexts.begin(), kAllTexts.end(), has_all_ids),
              "a file of texts has not the ids of english.def in their order");

}  // namespace

std::span<const TextEntry> texts_of(Language language) {
  return kAllTexts[static_cast<std::size_t>(language)];
}

const char* Texts::operator[](Text id) const {
  return texts_of(language_)[static_cast<std::size_t>(id)].text;
}

std::string Texts::number(std::string text) const {
  if (!has_decimal_comma_) return text;
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto is_digit = [&text](std::size_t at) {
      return at < text.size() && text[at] >= '0' && text[at] <= '9';
    };
    if (text[i] == '.' && i > 0 && is_digit(i - 1) && is_digit(i + 1)) {
      shown += ',';
    } else if (text[i] == ',') {
      shown += ';';
    } else {
      shown += text[i];
    }
  }
  return shown;
}

std::string Texts::english_html(const std::string& html) const {
  if (language_ == Language::english || html.empty()) return html;
  return "<span lang=\"en\">" + html + "</span>";
}

}  // namespace report
