#include "report/text/sentences.h"

#include "calc/base/sentences.h"
#include "report/text/markup.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <utility>

namespace report {
namespace {

#define SENTENCE(id, text) SentenceEntry{#id, text, false},
#define PHRASE(id, text) SentenceEntry{#id, text, true},
constexpr auto kEnglish = std::to_array<SentenceEntry>({
#include "calc/base/sentences.def"
});
#define PHRASE(id, text) SentenceEntry{#id, text, true},
constexpr auto kGerman = std::to_array<SentenceEntry>({
#include "report/text/german_sentences.def"
});
#define PHRASE(id, text) SentenceEntry{#id, text, true},
constexpr auto kFrench = std::to_array<SentenceEntry>({
#include "report/text/french_sentences.def"
});
#undef SENTENCE

constexpr bool has_all_sentences(std::span<const SentenceEntry> sentences) {
  return std::equal(sentences.begin(), sentences.end(), kEnglish.begin(), kEnglish.end(),
                    [](const SentenceEntry& a, const SentenceEntry& b) {
                      return a.id == b.id && a.is_phrase == b.is_phrase;
                    });
}
// In the order of Language.
constexpr std::array<std::span<const SentenceEntry>, kLanguages.size()> kAllSentences{
    kEnglish, kGerman, kFrench};
static_assert(std::all_of(kAllSentences.begin(), kAllSentences.end(), has_all_sentences),
              "a file of sentences has not the ids of sentences.def in their order");

// {}: numbers and sentences, in the reader's language; {:l} a list of them. {:s}: a name. {:*}:
// what people have written. Only {:l} and {:*} hold "; " or ", " outside of brackets.
enum class Holds { sentence, list, name, own_words };

struct Placeholder {
  std::size_t argument = 0;
  Holds holds = Holds::sentence;
};

// Text between placeholders, one more than there are of these.
struct Template {
  std::vector<std::string_view> literals;
  std::vector<Placeholder> placeholders;
};

Template template_of(std::string_view text) {
  Template parts;
  for (std::size_t open = text.find('{'); open != text.npos; open = text.find('{')) {
    const std::size_t close = text.find('}', open);
    const std::string_view inside = text.substr(open + 1, close - open - 1);
    Placeholder one{parts.placeholders.size(), inside.ends_with(":s")   ? Holds::name
                                               : inside.ends_with(":*") ? Holds::own_words
                                               : inside.ends_with(":l") ? Holds::list
                                                                        : Holds::sentence};
    if (!inside.empty() && inside.front() >= '0' && inside.front() <= '9')
      one.argument = static_cast<std::size_t>(inside.front() - '0');
    parts.literals.push_back(text.substr(0, open));
    parts.placeholders.push_back(one);
    text.remove_prefix(close + 1);
  }
  parts.literals.push_back(text);
  return parts;
}

std::vector<Template> templates_of(std::span<const SentenceEntry> sentences) {
  std::vector<Template> all;
  for (const SentenceEntry& entry : sentences) all.push_back(template_of(entry.text));
  return all;
}

const std::vector<Template>& templates_of(Language language) {
  static const auto kTemplates = [] {
    std::array<std::vector<Template>, kLanguages.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = templates_of(kAllSentences[i]);
    return all;
  }();
  return kTemplates[static_cast<std::size_t>(language)];
}

// At the separator, outside of brackets: "looking to (0, 1)" and 'rack[0,1]' stay whole.
std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == ']') --depth;
    if (depth != 0 || !text.substr(i).starts_with(separator)) continue;
    parts.push_back(text.substr(begin, i - begin));
    begin = i + separator.size();
    i = begin - 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

bool is_list(std::string_view text) {
  return split(text, "; ").size() > 1 || split(text, ", ").size() > 1;
}

// What stands for the placeholders.
std::optional<std::vector<std::string_view>> match(const Template& sentence,
                                                   std::string_view text) {
  const std::vector<std::string_view>& literals = sentence.literals;
  if (!text.starts_with(literals.front())) return std::nullopt;
  if (literals.size() == 1) {
    return text == literals.front() ? std::optional(std::vector<std::string_view>()) : std::nullopt;
  }
  text.remove_prefix(literals.front().size());
  std::vector<std::string_view> arguments;
  for (std::size_t i = 1; i + 1 < literals.size(); ++i) {
    const std::size_t end = text.find(literals[i]);
    if (end == text.npos) return std::nullopt;
    arguments.push_back(text.substr(0, end));
    text.remove_prefix(end + literals[i].size());
  }
  if (!text.ends_with(literals.back())) return std::nullopt;
  arguments.push_back(text.substr(0, text.size() - literals.back().size()));
  return arguments;
}

// Numbers with their units and signs, such as "(4.20, 1.10, 0.80) m".
bool is_number(std::string_view text) {
  constexpr std::array<std::string_view, 11> kUnits{"m", "m2", "lx", "x",  "sr", "W",
                                                    "e", "cd", "Fc", "Fo", "FD"};
  constexpr std::string_view kSigns = " .,+-()%";
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  bool has_digit = false;
  for (std::size_t i = 0; i < text.size();) {
    if (is_digit(text[i]) || kSigns.find(text[i]) != kSigns.npos) {
      has_digit = has_digit || is_digit(text[i]);
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && !is_digit(text[end]) && kSigns.find(text[end]) == kSigns.npos)
      ++end;
    if (text.substr(i, end - i) == "m" && text.substr(end).starts_with('2')) ++end;
    if (std::find(kUnits.begin(), kUnits.end(), text.substr(i, end - i)) == kUnits.end())
      return false;
    i = end;
  }
  return has_digit;
}

struct Piece {
  std::string text;
  bool is_translated = false;
};

using Known = std::span<const KnownWords>;

class Translator {
 public:
  Translator(const Texts& t, Known known) : t_(t), known_(known) {}

  // Of what a result says: sentences, but no phrases and no numbers, which people write as well.
  std::vector<Piece> sentences(const std::string& english) const {
    // Ours have no control characters; a file may say anything.
    if (english.find(kBegin) != english.npos) return {{english}};
    std::string text = english;
    for (std::size_t i = 0; i < known_.size(); ++i) hide(text, known_[i].english, i);
    std::vector<Piece> pieces;
    const auto add = [&](Piece piece) {
      show(piece.text);
      pieces.push_back(std::move(piece));
    };
    if (std::optional<Found> all = whole(text, 0, false)) {
      add({std::move(all->text), true});
      return pieces;
    }
    const std::vector<std::string_view> parts = split(text, "; ");
    for (std::size_t i = 0; i < parts.size(); ++i) {
      std::optional<Found> one = whole(parts[i], 0, false);
      if (one && one->ends_in_own_words) {
        // Where these end nobody can tell: a reason may hold anything.
        const auto rest = static_cast<std::size_t>(parts[i].data() - text.data());
        one = whole(std::string_view(text).substr(rest), 0, false);
        add(one ? Piece{std::move(one->text), true} : Piece{text.substr(rest)});
        break;
      }
      add(one ? Piece{std::move(one->text), true} : with_remark(parts[i], 0, false));
    }
    return pieces;
  }

  // A list of phrases, with their numbers.
  std::string list(const std::string& english) const { return argument_words(english, 0); }

  // Its placeholders filled with these words as they are.
  std::string filled(calc::Sentence id, std::initializer_list<std::string_view> arguments) const {
    const Template& own = templates_of(t_.language())[static_cast<std::size_t>(id)];
    std::string text(own.literals.front());
    for (std::size_t i = 0; i < own.placeholders.size(); ++i) {
      text += arguments.begin()[own.placeholders[i].argument];
      text += own.literals[i + 1];
    }
    return text;
  }

 private:
  static constexpr int kDeepest = 8;  // sentences in sentences; projects may write anything
  static constexpr char kBegin = '\x01', kEnd = '\x02';  // around the number of known words

  struct Found {
    std::string text;
    bool ends_in_own_words = false;
  };

  static std::string mark(std::size_t number) { return kBegin + std::to_string(number) + kEnd; }

  static void hide(std::string& text, const std::string& words, std::size_t number) {
    if (words.empty()) return;
    const std::string hidden = mark(number);
    for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at))
      text.replace(at, words.size(), hidden);
  }

  void show(std::string& text) const {
    for (std::size_t i = 0; i < known_.size(); ++i) {
      const std::string hidden = mark(i);
      for (std::size_t at = text.find(hidden); at != text.npos; at = text.find(hidden, at)) {
        text.replace(at, hidden.size(), known_[i].own);
        at += known_[i].own.size();
      }
    }
  }

  static bool is_known(std::string_view text) {
    return text.size() > 2 && text.front() == kBegin && text.find(kEnd) == text.size() - 1;
  }

  // has_phrases: whether a phrase alone will do.
  std::optional<Found> whole(std::string_view text, int depth, bool has_phrases) const {
    if (is_known(text)) return Found{std::string(text), false};
    if (depth > kDeepest) return std::nullopt;
    const std::vector<Template>& english = templates_of(Language::english);
    for (std::size_t i = 0; i < english.size(); ++i) {
      if (kEnglish[i].is_phrase && !has_phrases) continue;
      const auto found = match(english[i], text);
      const Template& own = templates_of(t_.language())[i];
      if (!found || !is_fit(own, *found)) continue;
      const bool is_open = std::any_of(
          own.placeholders.begin(), own.placeholders.end(), [&](const Placeholder& one) {
            return one.holds == Holds::own_words && one.argument + 1 == found->size();
          });
      return Found{filled(own, *found, depth), is_open && english[i].literals.back().empty()};
    }
    return std::nullopt;
  }

  static bool is_fit(const Template& own, const std::vector<std::string_view>& arguments) {
    return std::all_of(
        own.placeholders.begin(), own.placeholders.end(), [&](const Placeholder& one) {
          const std::string_view argument = arguments[one.argument];
          if (one.holds == Holds::list || one.holds == Holds::own_words) return true;
          // "wall (row 2 specifies nothing)" is a name with a remark, and no wall of that number.
          const bool is_remark = argument.starts_with('(') && argument.ends_with(')');
          if (is_remark && !is_number(argument)) return false;
          return !is_list(argument) && std::count(argument.begin(), argument.end(), '(') ==
                                           std::count(argument.begin(), argument.end(), ')');
        });
  }

  std::string filled(const Template& own, const std::vector<std::string_view>& arguments,
                     int depth) const {
    std::string text(own.literals.front());
    for (std::size_t i = 0; i < own.placeholders.size(); ++i) {
      const auto& [argument, holds] = own.placeholders[i];
      const bool is_ours = holds == Holds::sentence || holds == Holds::list;
      text += is_ours ? argument_words(arguments[argument], depth + 1)
                      : std::string(arguments[argument]);
      text += own.literals[i + 1];
    }
    return text;
  }

  std::string argument_words(std::string_view text, int depth) const {
    if (std::optional<Found> all = whole(text, depth, true)) return std::move(all->text);
    std::string words;
    for (const std::string_view part : split(text, "; "))
      words += (words.empty() ? "" : "; ") + item(part, depth).text;
    return words;
  }

  Piece item(std::string_view text, int depth) const {
    if (is_number(text)) return {t_.number(std::string(text)), true};
    if (std::optional<Found> all = whole(text, depth, true)) return {std::move(all->text), true};
    if (depth > kDeepest) return {std::string(text)};
    const std::vector<std::string_view> parts = split(text, ", ");
    // Of a list every part has its own remark.
    const bool is_alone = parts.size() < 2;
    if (Piece one = with_remark(text, depth, is_alone); one.is_translated) return one;
    if (is_alone) return {std::string(text)};
    // All of a list is ours, or names stand in it and how many there are more.
    Piece list{"", true}, names;
    bool has_remark = false;  // of ours: "wall (row 2 specifies nothing)"
    for (const std::string_view part : parts) {
      const Piece one = item(part, depth + 1);
      const bool is_end_of_names = one.is_translated && part.ends_with(" more");
      list.text += (list.text.empty() ? "" : ", ") + one.text;
      list.is_translated = list.is_translated && one.is_translated;
      has_remark = has_remark || (one.is_translated && part.ends_with(')'));
      names.text +=
          (names.text.empty() ? "" : ", ") + (is_end_of_names ? one.text : std::string(part));
      names.is_translated = names.is_translated || is_end_of_names;
    }
    if (list.is_translated || has_remark) return {list.text, true};
    return names.is_translated ? names : Piece{std::string(text)};
  }

  // "lamp (Ra is not measured on planes)", "1 m (a <deviation in="height"> would state it)".
  // has_phrases: whether what stands before the brackets may be a name.
  Piece with_remark(std::string_view text, int depth, bool has_phrases) const {
    if (!text.ends_with(')')) return {std::string(text)};
    std::size_t open = text.size() - 1;
    for (int level = 1; level > 0 && open > 0;) {
      --open;
      if (text[open] == ')') ++level;
      if (text[open] == '(') --level;
    }
    if (open == 0 || text[open - 1] != ' ') return {std::string(text)};
    const std::string_view inside = text.substr(open + 1, text.size() - open - 2);
    const std::optional<Found> remark = whole(inside, depth + 1, true);
    if (!remark) return {std::string(text)};
    const std::string_view before = text.substr(0, open - 1);
    if (!has_phrases) {
      const std::optional<Found> sentence = whole(before, depth + 1, false);
      if (!sentence) return {std::string(text)};
      return {sentence->text + " (" + remark->text + ")", true};
    }
    return {item(before, depth + 1).text + " (" + remark->text + ")", true};
  }

  const Texts& t_;
  Known known_;
};

std::string joined(const std::vector<Piece>& pieces) {
  std::string text;
  for (const Piece& one : pieces) text += (&one == &pieces.front() ? "" : "; ") + one.text;
  return text;
}

}  // namespace

std::span<const SentenceEntry> sentences_of(Language language) {
  return kAllSentences[static_cast<std::size_t>(language)];
}

std::string sentence(const Texts& t, const std::string& english, Known known) {
  if (t.language() == Language::english) return english;
  return joined(Translator(t, known).sentences(english));
}

std::string sentence_html(const Texts& t, const std::string& english, Known known) {
  if (t.language() == Language::english) return escape_html(english);
  std::string html;
  for (const Piece& one : Translator(t, known).sentences(english)) {
    html += (html.empty() ? "" : "; ");
    html += one.is_translated ? escape_html(one.text) : t.english_html(escape_html(one.text));
  }
  return html;
}

std::string phrases(const Texts& t, const std::string& english) {
  if (t.language() == Language::english) return english;
  return Translator(t, {}).list(english);
}

void add_known(const Texts& t, const calc::Waiver& waiver, std::vector<KnownWords>& known) {
  if (t.language() == Language::english) return;
  using enum calc::Sentence;
  const std::string &reason = waiver.reason, &owner = waiver.owner, &until = waiver.until;
  const Translator own(t, {});
  known.push_back(
      {calc::say<waived_by>(owner, until, reason), own.filled(waived_by, {owner, until, reason})});
  known.push_back({calc::say<waiver_ended>(owner, until, reason),
                   own.filled(waiver_ended, {owner, until, reason})});
  known.push_back({calc::say<left_out_ended>(until, owner, reason),
                   own.filled(left_out_ended, {until, owner, reason})});
  known.push_back({reason + ", " + calc::say<by_until>(owner, until),
                   reason + ", " + own.filled(by_until, {owner, until})});
  known.push_back(
      {calc::say<stated_until>(owner, until), own.filled(stated_until, {owner, until})});
}

}  // namespace report
