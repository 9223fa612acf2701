#include "report/text/sentences.h"

#include "calc/base/sentences.h"
#include "rules/pack/rule_pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace report::sentences_test {
namespace {

using calc::Message;
using calc::say;
using calc::Sentence;

const Texts kGerman(Language::german, true), kFrench(Language::french, true);

// The argument of each placeholder, sorted.
std::vector<std::size_t> arguments(std::string_view text) {
  std::vector<std::size_t> found;
  for (const auto& placeholder : calc::sentence_template(text).placeholders)
    found.push_back(placeholder.argument);
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Sentences, HoldTheSameInAllLanguages) {
  const auto english = sentences_of(Language::english);
  for (const LanguageRow& row : kLanguages) {
    const auto own = sentences_of(row.language);
    ASSERT_EQ(own.size(), english.size());
    for (std::size_t i = 0; i < english.size(); ++i)
      EXPECT_EQ(arguments(own[i].text), arguments(english[i].text)) << row.tag << own[i].id;
  }
}

// What is punctuation and placeholders alone is the same everywhere.
bool has_letters(std::string_view text) {
  for (const std::string_view literal : calc::sentence_template(text).literals) {
    if (std::any_of(literal.begin(), literal.end(),
                    [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }))
      return true;
  }
  return false;
}

TEST(Sentences, AreOfTheirLanguage) {
  for (const LanguageRow& row : kLanguages) {
    if (row.language == Language::english) continue;
    const auto own = sentences_of(row.language);
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (has_letters(own[i].text)) {
        EXPECT_NE(own[i].text, calc::kSentences[i]) << row.tag << " " << own[i].id;
      }
    }
  }
}

std::string sources() {
  std::string all;
  for (const char* folder : {"/calc", "/rules", "/report"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(LUXGATE_SOURCE_DIR) + folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      std::ifstream file(entry.path());
      all.append(std::istreambuf_iterator<char>(file), {});
    }
  }
  return all;
}

TEST(Sentences, AreAllSaid) {
  const std::string text = sources();
  for (const SentenceEntry& one : sentences_of(Language::english)) {
    bool is_said = false;
    for (const char* scope : {"say<", "say<Sentence::", "say<calc::Sentence::"})
      is_said = is_said || text.find(scope + std::string(one.id) + ">") != text.npos;
    EXPECT_TRUE(is_said) << one.id;
  }
}

// Who wants to know what a message says asks for the sentence, see calc::says().
TEST(Sentences, AreNeverComparedOrCut) {
  const std::string text = sources();
  const std::regex pattern(
      R"(english\(\)\s*(==|!=|\.(find|rfind|substr|starts_with|ends_with|compare)\b))");
  for (auto i = std::sregex_iterator(text.begin(), text.end(), pattern);
       i != std::sregex_iterator(); ++i)
    ADD_FAILURE() << text.substr(std::max<std::ptrdiff_t>(0, i->position() - 60), 120);
}

Message number(const char* text) { return Message::number(text); }

TEST(Sentences, HaveNumbersOfTheLanguage) {
  EXPECT_EQ(sentence(kGerman, say<Sentence::undecided>(number("353.7"), number("353.9 lx"),
                                                       number("353.8 lx")) +
                                  "; " + say<Sentence::more_paths>(8.0)),
            "das Intervall 353,7 bis 353,9 lx enthält den Grenzwert 353,8 lx; etwa 8-mal so viele "
            "Lichtpfade würden zur Entscheidung reichen (--max-paths)");
  EXPECT_EQ(
      sentence(Texts(Language::german, false), say<Sentence::zone_off_edges>(number("0.5 m"))),
      "ohne 0.5 m an ihren Rändern");
  EXPECT_EQ(
      sentence(Texts(Language::english, true), say<Sentence::zone_off_edges>(number("0.5 m"))),
      "without 0.5 m along its edges");
  EXPECT_EQ(
      sentence(kFrench,
               say<Sentence::glare_too_large>(number("(1.000, -2.500, 2.900)"), 3, 0.10712, 0.1)),
      "le luminaire au point (1,000; -2,500; 2,900) m, vu par l’observateur 3, occupe 0,107 sr. "
      "L’UGR est défini pour des sources d’au plus 0,1 sr et trop indulgent pour lui. L’UGR "
      "donne la borne inférieure, la formule d’Einhorn pour plafonds lumineux la borne supérieure");
}

// In the order of the language, with what is in them in its words.
TEST(Sentences, HoldOtherMessages) {
  const Message name = say<Sentence::one_source_of>("EN 12464-1:2021");
  EXPECT_EQ(
      sentence(kGerman, say<Sentence::grid_formula>(
                            name, 0.2, 5.0, 1.6, say<Sentence::longer_side>(), number("0.278 m"),
                            5.76, 5.04, say<Sentence::rounded_nearest>(), 6.0, 5.0)),
      "EN 12464-1:2021 [eine öffentliche Quelle] (p = 0,2 · 5^log10 d): d = 1,6 m, die "
      "längere Seite; p = 0,278 m; 5,76 x 5,04 Zellen, auf die nächste ganze Zahl gerundet: "
      "6 x 5");
  EXPECT_EQ(sentence(kGerman, say<Sentence::height_of_row>(say<Sentence::role_of>("task", "p:1"),
                                                           number("0.7 m"), "34.2", number("1 m"))),
            "Flächen mit Rolle „task“ aus p:1 liegen in Zeile 34.2 0,7 m über dem Boden; diese "
            "liegt 1 m darüber");
  EXPECT_EQ(
      sentence(kGerman, say<Sentence::of_workplaces>(
                            calc::names_message({"a", "b", "c"}, 2), "EN 1 34.2",
                            say<Sentence::not_made>(Message::words("lamp") + " (" +
                                                    say<Sentence::not_on_planes>("Ra") + ")"))),
      "Arbeitsplätze a, b und 1 weitere, EN 1 34.2: keine Fläche: Lampe (Ra wird nicht auf "
      "Flächen gemessen)");
}

// Whatever it looks like, and wherever it ends.
TEST(Sentences, LeaveWhatPeopleHaveWritten) {
  const std::string reason = "shelf of 1.5 m; the ceiling";
  const std::string owner = "Control, by letter until 2020-01-01: x";
  const Message waived = say<Sentence::waived_by>(owner, "2031-12-31", reason);
  EXPECT_EQ(
      sentence(kGerman, say<Sentence::area_unknown>() + "; " + waived),
      "eine Fläche ist nicht bekannt; ausgenommen durch " + owner + " bis 2031-12-31: " + reason);
  EXPECT_EQ(sentence(kGerman, Message::words("wall 2; 1.5; the ceiling")),
            "wall 2; 1.5; the ceiling");
  // A title that reads like a scene.
  EXPECT_EQ(sentence(kGerman, say<Sentence::clause_in_scene>("Theatre, scene dock:1 4", "night")),
            "Theatre, scene dock:1 4, Lichtszene night");
  EXPECT_EQ(sentence(kGerman, {}), "");
}

TEST(Sentences, NameRolesInTheLanguageOfTheReader) {
  const Message made =
      say<Sentence::made_by>("desk", "EN 1 34.2", "wall.2", say<Sentence::zone_ceiling>());
  EXPECT_EQ(sentence(kGerman, made), "Arbeitsplatz desk, EN 1 34.2, Wand 2: die Decke");
  // A workplace that is called like a role stays.
  EXPECT_EQ(sentence(kGerman, say<Sentence::made_by>("wall.2", "EN 1 34.2", "ta",
                                                     say<Sentence::zone_ceiling>())),
            "Arbeitsplatz wall.2, EN 1 34.2, ta: die Decke");
}

// What checks of our own packs remark stands in reports for clients.
TEST(Sentences, HaveTheRemarksOfAllChecks) {
  std::size_t notes = 0;
  const auto expect_known = [&](const std::string& note) {
    if (note.empty()) return;
    ++notes;
    for (const Texts& t : {kGerman, kFrench}) {
      const auto words = pack_note_words(t, note);
      ASSERT_TRUE(words.has_value()) << note;
      EXPECT_NE(*words, note);
    }
  };
  for (const rules::RulePack& pack : rules::builtin_rule_packs()) {
    for (const rules::RuleCheck& check : pack.checks) expect_known(check.note);
    for (const rules::RuleAggregate& aggregate : pack.aggregates) expect_known(aggregate.note);
  }
  EXPECT_GT(notes, 20U);
  EXPECT_EQ(sentence(kGerman, Message::words("in plan")), "im Grundriss");
  EXPECT_EQ(sentence_html(kGerman, Message::words("in plan")), "im Grundriss");
  EXPECT_FALSE(pack_note_words(kGerman, "in plan view").has_value());
}

TEST(Sentences, AreMarkedInHtmlWhereTheyAreNotOfTheTable) {
  EXPECT_EQ(sentence_html(kGerman,
                          Message::words("own <words> 2.5") + "; " + say<Sentence::area_unknown>()),
            "<span lang=\"en\">own &lt;words&gt; 2.5</span>; eine Fläche ist nicht bekannt");
  EXPECT_EQ(sentence_html(Texts(), Message::words("own <words> 2.5")), "own &lt;words&gt; 2.5");
}

}  // namespace
}  // namespace report::sentences_test
