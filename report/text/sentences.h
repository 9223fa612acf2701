#pragma once
// The sentences of calc/base/sentences.h in the reader's language. Results keep them in English, in
// files too; here they are recognised by their templates. What is no such sentence stays as it is:
// names, words of rule packs and of projects.

#include "calc/scene/waiver.h"
#include "report/text/texts.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// All of a language, in the order of calc::Sentence; English: their templates.
struct SentenceEntry {
  std::string_view id;
  std::string_view text;
  bool is_phrase = false;  // stands in sentences only
};
std::span<const SentenceEntry> sentences_of(Language language);

// What holds words of people, to the letter, and what it is in the reader's language: known from
// the result, so that nobody has to find their end in a text.
struct KnownWords {
  std::string english, own;
};
// All that results say with a waiver, or with a statement that a part is left out or deviates.
void add_known(const Texts& t, const calc::Waiver& waiver, std::vector<KnownWords>& known);

// A text of one or more sentences, "interval ...; about 8 times ...".
std::string sentence(const Texts& t, const std::string& english,
                     std::span<const KnownWords> known = {});
// The same as finished HTML; what stays English is marked where the report is not.
std::string sentence_html(const Texts& t, const std::string& english,
                          std::span<const KnownWords> known = {});
// "height 1 m instead of 0.75 m, an area of the project's own": phrases alone.
std::string phrases(const Texts& t, const std::string& english);

}  // namespace report
