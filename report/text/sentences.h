#pragma once
// Messages in the reader's language, see calc/base/message.h. Names, paths and texts by users stay
// unchanged.

#include "calc/base/message.h"
#include "report/text/texts.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace report {

// Returns a remark of a rule pack that comes with luxgate, word for word, in the reader's language;
// empty for all other words.
std::optional<std::string> pack_note_words(const Texts& t, std::string_view english);

// All sentences of a language, in the order of calc::Sentence; English: their templates.
struct SentenceEntry {
  std::string_view id;
  std::string_view text;
};
std::span<const SentenceEntry> sentences_of(Language language);

std::string sentence(const Texts& t, const calc::Message& message);
// Returns the message as finished HTML; parts outside the table are marked as English if the report
// is in another language.
std::string sentence_html(const Texts& t, const calc::Message& message);

}  // namespace report
