#include "report/text/sentences.h"

#include "calc/base/sentences.h"
#include "report/text/markup.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace report {
namespace {

#define SENTENCE(id, text) SentenceEntry{#id, text},
constexpr auto kEnglish = std::to_array<SentenceEntry>({
#include "calc/base/sentences.def"
});
constexpr auto kGerman = std::to_array<SentenceEntry>({
#include "report/text/german_sentences.def"
});
constexpr auto kFrench = std::to_array<SentenceEntry>({
#include "report/text/french_sentences.def"
});
#undef SENTENCE

constexpr bool has_all_sentences(std::span<const SentenceEntry> sentences) {
  return std::equal(sentences.begin(), sentences.end(), kEnglish.begin(), kEnglish.end(),
                    [](const SentenceEntry& a, const SentenceEntry& b) { return a.id == b.id; });
}
// In the order of Language.
constexpr std::array<std::span<const SentenceEntry>, kLanguages.size()> kAllSentences{
    kEnglish, kGerman, kFrench};
static_assert(std::all_of(kAllSentences.begin(), kAllSentences.end(), has_all_sentences),
              "a file of sentences has not the ids of sentences.def in their order");

const calc::SentenceTemplate& template_of(Language language, calc::Sentence id) {
  static const auto kTemplates = [] {
    std::array<std::vector<calc::SentenceTemplate>, kLanguages.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const SentenceEntry& entry : kAllSentences[i])
        all[i].push_back(calc::sentence_template(entry.text));
    }
    return all;
  }();
  return kTemplates[static_cast<std::size_t>(language)][static_cast<std::size_t>(id)];
}

std::string part_words(const Texts& t, const calc::MessagePart& part) {
  if (part.kind == calc::PartKind::number) return t.number(part.text);
  if (part.kind != calc::PartKind::sentence) return part.text;
  const calc::SentenceTemplate& own = template_of(t.language(), part.id);
  std::string text(own.literals.front());
  for (std::size_t i = 0; i < own.placeholders.size(); ++i) {
    text += sentence(t, part.arguments[own.placeholders[i].argument]);
    text += own.literals[i + 1];
  }
  return text;
}

}  // namespace

std::span<const SentenceEntry> sentences_of(Language language) {
  return kAllSentences[static_cast<std::size_t>(language)];
}

std::string sentence(const Texts& t, const calc::Message& message) {
  if (t.language() == Language::english) return message.english();
  std::string text;
  for (const calc::MessagePart& part : message.parts()) text += part_words(t, part);
  return text;
}

std::string sentence_html(const Texts& t, const calc::Message& message) {
  if (t.language() == Language::english) return escape_html(message.english());
  std::string html;
  for (const calc::MessagePart& part : message.parts()) {
    const std::string words = escape_html(part_words(t, part));
    html += part.kind == calc::PartKind::words ? t.english_html(words) : words;
  }
  return html;
}

}  // namespace report
