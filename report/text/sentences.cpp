#include "report/text/sentences.h"

#include "calc/base/sentences.h"
#include "report/text/clause_words.h"
#include "report/text/markup.h"
#include "report/text/words.h"

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

std::string part_words(const Texts& t, const calc::MessagePart& part);

// Remarks of the rule packs that come with luxgate, in the order of Language.
using PackNote = std::array<std::string_view, kLanguages.size()>;
#define PACK_NOTE(english, german, french) PackNote{english, german, french},
constexpr auto kPackNotes = std::to_array<PackNote>({
#include "report/text/pack_notes.def"
});
#undef PACK_NOTE

// Arguments that name roles of rule packs: "surround", "wall.2".
struct RoleArgument {
  calc::Sentence id;
  std::size_t argument;
};
constexpr std::array kRoleArguments{RoleArgument{calc::Sentence::made_by, 2},
                                    RoleArgument{calc::Sentence::left_out, 0},
                                    RoleArgument{calc::Sentence::not_made, 0},
                                    RoleArgument{calc::Sentence::zone_band, 1},
                                    RoleArgument{calc::Sentence::zone_face_band, 1},
                                    RoleArgument{calc::Sentence::whole_zone_and_band, 0},
                                    RoleArgument{calc::Sentence::whole_zone, 0}};

bool names_roles(calc::Sentence id, std::size_t argument) {
  return std::any_of(kRoleArguments.begin(), kRoleArguments.end(), [&](const RoleArgument& known) {
    return known.id == id && known.argument == argument;
  });
}

// "surround (the task is the whole room), wall.3 (...)" of an argument that names roles.
std::string role_list(const Texts& t, const calc::Message& roles) {
  std::string text;
  for (const calc::MessagePart& part : roles.parts())
    text += part.kind == calc::PartKind::words ? role_words(t, part.text) : part_words(t, part);
  return text;
}

std::string part_words(const Texts& t, const calc::MessagePart& part) {
  if (part.kind == calc::PartKind::number) return t.number(part.text);
  if (part.kind == calc::PartKind::words) return pack_note_words(t, part.text).value_or(part.text);
  if (part.kind != calc::PartKind::sentence) return part.text;
  const calc::SentenceTemplate& own = template_of(t.language(), part.id);
  std::string text(own.literals.front());
  for (std::size_t i = 0; i < own.placeholders.size(); ++i) {
    const std::size_t argument = own.placeholders[i].argument;
    const calc::Message& of = part.arguments[argument];
    text += names_roles(part.id, argument) ? role_list(t, of)
            : part.id == calc::Sentence::level_because && argument == 0
                ? level_words(t, of.english())
                : sentence(t, of);
    text += own.literals[i + 1];
  }
  return text;
}

}  // namespace

std::optional<std::string> pack_note_words(const Texts& t, std::string_view english) {
  const auto* const known = std::find_if(kPackNotes.begin(), kPackNotes.end(),
                                         [&](const PackNote& note) { return note[0] == english; });
  if (known == kPackNotes.end()) return {};
  return std::string((*known)[static_cast<std::size_t>(t.language())]);
}

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
    const bool is_english =
        part.kind == calc::PartKind::words && !pack_note_words(t, part.text).has_value();
    html += is_english ? t.english_html(words) : words;
  }
  return html;
}

}  // namespace report
