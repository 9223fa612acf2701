#pragma once
// Messages in the reader's language, see calc/base/message.h. Names, paths and what people have
// written stay as they are.

#include "calc/base/message.h"
#include "report/text/texts.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace report {

// A remark of a rule pack that comes with luxgate, word for word, in the reader's language; nothing
// of all other words.
std::optional<std::string> pack_note_words(const Texts& t, std::string_view english);

// All of a language, in the order of calc::Sentence; English: their templates.
struct SentenceEntry {
  std::string_view id;
  std::string_view text;
};
std::span<const SentenceEntry> sentences_of(Language language);

std::string sentence(const Texts& t, const calc::Message& message);
// The same as finished HTML; what is not of the table is marked as English where the report is not.
std::string sentence_html(const Texts& t, const calc::Message& message);

}  // namespace report
