#include "report/text/sentences.h"

#include "calc/base/sentences.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace report::sentences_test {
namespace {

using calc::say;
using calc::Sentence;

const Texts kGerman(Language::german, true), kFrench(Language::french, true);

// With a word of its own for each placeholder, that of the argument it names.
std::string filled(std::string_view text) {
  const std::string all(text);
  const std::regex pattern(R"(\{([0-9]?)[^}]*\})");
  std::string result;
  std::size_t number = 0, begin = 0;
  for (auto i = std::sregex_iterator(all.begin(), all.end(), pattern); i != std::sregex_iterator();
       ++i, ++number) {
    const std::string named = (*i)[1].str();
    const std::size_t argument = named.empty() ? number : std::stoul(named);
    const auto at = static_cast<std::size_t>(i->position());
    result += all.substr(begin, at - begin);
    result += "Name";
    result += static_cast<char>('A' + argument);
    begin = at + static_cast<std::size_t>(i->length());
  }
  return result + all.substr(begin);
}

// Each by its own template, and not by that of another one.
TEST(Sentences, AreRecognised) {
  for (const LanguageRow& row : kLanguages) {
    const Texts t(row.language, row.has_decimal_comma);
    for (std::size_t i = 0; i < calc::kSentences.size(); ++i) {
      const SentenceEntry& own = sentences_of(row.language)[i];
      const std::string english = filled(calc::kSentences[i]);
      EXPECT_EQ(own.is_phrase ? phrases(t, english) : sentence(t, english), filled(own.text))
          << row.tag << " " << own.id;
      if (own.is_phrase) {
        EXPECT_EQ(sentence(t, english), english) << row.tag << " " << own.id;
      }
    }
  }
}

// "2:*" of {:*} or {2:*}, in the order of the arguments.
std::vector<std::string> kinds(std::string_view text) {
  const std::string all(text);
  const std::regex pattern(R"(\{([0-9]?)([^}]*)\})");
  std::vector<std::string> found;
  for (auto i = std::sregex_iterator(all.begin(), all.end(), pattern); i != std::sregex_iterator();
       ++i) {
    const std::string named = (*i)[1].str();
    found.push_back((named.empty() ? std::to_string(found.size()) : named) + (*i)[2].str());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Names and what people have written are that in every language.
TEST(Sentences, HoldTheSameInAllLanguages) {
  const auto german = sentences_of(Language::german);
  for (const LanguageRow& row : kLanguages) {
    if (row.language == Language::english) continue;
    for (std::size_t i = 0; i < german.size(); ++i)
      EXPECT_EQ(kinds(sentences_of(row.language)[i].text), kinds(german[i].text)) << german[i].id;
  }
}

TEST(Sentences, AreOfTheirLanguage) {
  for (const LanguageRow& row : kLanguages) {
    const auto own = sentences_of(row.language);
    ASSERT_EQ(own.size(), calc::kSentences.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (row.language == Language::english) continue;
      EXPECT_NE(own[i].text, calc::kSentences[i]) << row.tag << " " << own[i].id;
      std::string words = filled(own[i].text), english = filled(calc::kSentences[i]);
      for (std::string* text : {&words, &english}) {
        std::vector<std::string> names;
        for (std::size_t at = text->find("Name"); at != text->npos; at = text->find("Name", at + 1))
          names.push_back(text->substr(at, 5));
        std::sort(names.begin(), names.end());
        *text = testing::PrintToString(names);
      }
      EXPECT_EQ(words, english) << row.tag << " " << own[i].id;
    }
  }
}

TEST(Sentences, GridsOfLongAreasAreOfTheReadersLanguage) {
  const Texts german(Language::german, true);
  const std::string english =
      "EN 1 (p = 0.2 * 5^log10 d): d = 2.2 m, the shorter side, as the longer one is at least 2 "
      "times as long; p = 0.347 m; 32.85 x 6.34 cells, rounded to the nearest number: 33 x 6; "
      "every cell in 3 x 3, as a narrow part of the area would have no point";
  const std::string words = phrases(german, english);
  EXPECT_NE(words.find("die kürzere Seite, da die längere mindestens 2-mal"), std::string::npos)
      << words;
  EXPECT_NE(words.find("jede Zelle in 3 x 3 geteilt"), std::string::npos) << words;
  EXPECT_EQ(words.find("cells"), std::string::npos) << words;
}

// Who says a sentence in other words than those of the table has it in English for ever.
TEST(Sentences, AreAllSaid) {
  std::string sources;
  for (const char* folder : {"/calc", "/rules", "/report"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(LUXGATE_SOURCE_DIR) + folder)) {
      if (entry.path().extension() != ".cpp") continue;
      std::ifstream file(entry.path());
      sources.append(std::istreambuf_iterator<char>(file), {});
    }
  }
  for (const SentenceEntry& one : sentences_of(Language::english)) {
    bool is_said = false;
    for (const char* scope : {"say<", "say<Sentence::", "say<calc::Sentence::"})
      is_said = is_said || sources.find(scope + std::string(one.id) + ">") != sources.npos;
    EXPECT_TRUE(is_said) << one.id;
  }
}

TEST(Sentences, HaveNumbersOfTheLanguage) {
  EXPECT_EQ(sentence(kGerman, say<Sentence::undecided>("353.7", "353.9 lx", "353.8 lx") + "; " +
                                  say<Sentence::more_paths>(8.0)),
            "das Intervall 353,7 bis 353,9 lx enthält den Grenzwert 353,8 lx; etwa 8-mal so viele "
            "Lichtpfade würden zur Entscheidung reichen (--max-paths)");
  EXPECT_EQ(phrases(Texts(Language::german, false), say<Sentence::zone_off_edges>("0.5 m")),
            "ohne 0.5 m an ihren Rändern");
  EXPECT_EQ(
      sentence(kFrench, say<Sentence::glare_too_large>("(1.000, -2.500, 2.900)", 3, 0.10712, 0.1)),
      "le luminaire au point (1,000; -2,500; 2,900) m, vu par l’observateur 3, occupe 0,107 sr, et "
      "l’UGR, défini pour des sources d’au plus 0,1 sr, est trop indulgent pour lui : il est la "
      "borne inférieure, et la formule d’Einhorn pour plafonds lumineux la borne supérieure");
}

TEST(Sentences, HoldOtherSentences) {
  EXPECT_EQ(sentence(kGerman,
                     "EN 12464-1:2021 [one public source] (p = 0.2 * 5^log10 d): d = 1.6 m, the "
                     "longer side; p = 0.278 m; 5.76 x 5.04 cells, rounded to the nearest number: "
                     "6 x 5"),
            "EN 12464-1:2021 [eine öffentliche Quelle] (p = 0,2 · 5^log10 d): d = 1,6 m, die "
            "längere Seite; p = 0,278 m; 5,76 x 5,04 Zellen, auf die nächste ganze Zahl gerundet: "
            "6 x 5");
  std::vector<KnownWords> known;
  add_known(kGerman, {"window wall: dark", "A. Meier", "2099-12-31"}, known);
  EXPECT_EQ(sentence(kGerman,
                     "workplace place[0,0], EN 12464-1:2021 34.2, observer.3: task and band of 0.5 "
                     "m around the task, without 0.5 m along the walls, 1.2 m above the floor, "
                     "looking to (0, 1); the same for place[1,0], place[2,0] and 4 more"),
            "Arbeitsplatz place[0,0], EN 12464-1:2021 34.2, observer.3: Bereich der Sehaufgabe und "
            "Streifen von 0,5 m darum, ohne 0,5 m entlang der Wände, 1,2 m über dem Boden, Blick "
            "nach (0; 1); dieselbe für place[1,0], place[2,0] und 4 weitere");
  EXPECT_EQ(
      sentence(kGerman,
               "workplaces a, b and 2 more, EN 12464-1:2021 34.2: left out: wall.1 (window "
               "wall: dark, by A. Meier until 2099-12-31); not made: lamp (Ra is not measured "
               "on planes)",
               known),
      "Arbeitsplätze a, b und 2 weitere, EN 12464-1:2021 34.2: weggelassen: wall.1 (window "
      "wall: dark, durch A. Meier bis 2099-12-31); nicht erzeugt: lamp (Ra wird nicht auf "
      "Flächen gemessen)");
  EXPECT_EQ(
      sentence(kGerman,
               "workplace w, EN 12464-1:2021 44.4.1: not made: background (the task is upright, "
               "and no source says where this zone of it is), wall (row 44.4.1 specifies nothing), "
               "lamp (Ra is not measured on planes)"),
      "Arbeitsplatz w, EN 12464-1:2021 44.4.1: nicht erzeugt: background (der Bereich der "
      "Sehaufgabe ist senkrecht, und keine Quelle sagt, wo diese Zone dann ist), wall (Zeile "
      "44.4.1 legt nichts fest), lamp (Ra wird nicht auf Flächen gemessen)");
  EXPECT_EQ(sentence(kGerman,
                     "98 of 408 points are left out: 49 inside 'rack[0,0,0]', 49 inside "
                     "'rack[0,1,0]'"),
            "98 von 408 Punkten sind ausgelassen: 49 in „rack[0,0,0]“, 49 in „rack[0,1,0]“");
  EXPECT_EQ(sentence(kGerman,
                     "planes of role 'task' of en12464-1:2021 are usually 0.7 to 0.8 m above the "
                     "floor, and this one is 1 m (a <deviation in=\"height\"> would state it)"),
            "Flächen mit Rolle „task“ aus en12464-1:2021 liegen meist 0,7 bis 0,8 m über dem "
            "Boden, und diese 1 m (ein <deviation in=\"height\"> würde sie angeben)");
}

// A list is ours as a whole or not at all: half of it in another language reads badly.
TEST(Sentences, DoNotMixLanguagesInAList) {
  EXPECT_EQ(sentence(kGerman, say<Sentence::points_lost>(3, 9, "2 outside the room, 1 elsewhere")),
            "3 von 9 Punkten sind ausgelassen: 2 outside the room, 1 elsewhere");
}

TEST(Sentences, LeaveWhatTheyDoNotKnow) {
  EXPECT_EQ(sentence(kGerman, ""), "");
  EXPECT_EQ(sentence(kGerman, "a rule pack's own words, 1.5 m above all"),
            "a rule pack's own words, 1.5 m above all");
  EXPECT_EQ(sentence_html(kGerman, "own <words> 2.5; " + say<Sentence::area_unknown>()),
            "<span lang=\"en\">own &lt;words&gt; 2.5</span>; eine Fläche ist nicht bekannt");
  EXPECT_EQ(sentence_html(Texts(), "own <words> 2.5"), "own &lt;words&gt; 2.5");
  EXPECT_EQ(phrases(Texts(Language::english, true), say<Sentence::zone_off_edges>("0.5 m")),
            "without 0.5 m along its edges");
}

// Several in a row, each as one of its own; what ends in a verb has it at its own end.
TEST(Sentences, StandInARow) {
  EXPECT_EQ(
      sentence(kGerman, say<Sentence::ugr_method>(0.8) + "; " + say<Sentence::ugr_background>() +
                            "; " + say<Sentence::observers_see_none>(10, 30)),
      "UGR der neuen Anlage nach CIE 117, mit dem Positionsindex nach Guth als Formel, von der die "
      "Tabelle der CIE 117 um bis zu 0,8 abweichen kann"
      "; Hintergrund: reflektiertes Licht am Auge; 10 von 30 Beobachtern sehen keine "
      "Blendquelle im Blickfeld");
  EXPECT_EQ(
      sentence(kGerman,
               "100 of 182 points are left out: 50 inside 'a', 50 inside 'b'; 8 of 82 points "
               "lie in a surface that stands on the plane, the first in 'a', and are measured "
               "just off it"),
      "100 von 182 Punkten sind ausgelassen: 50 in „a“, 50 in „b“; 8 von 82 Punkten liegen "
      "in einer Oberfläche, die auf der Fläche steht, der erste in „a“, und werden knapp "
      "daneben gemessen");
  const std::string role = say<Sentence::role_of>("task", "en12464-1:2021");
  EXPECT_EQ(
      sentence(kGerman, say<Sentence::grid_too_wide>(3, 3, role, 8, 6) + " (" +
                            say<Sentence::would_state>("grid") + "); " +
                            say<Sentence::wrong_way>(role, "vertical")),
      "3 x 3 Punkte, während Rolle „task“ aus en12464-1:2021 auf dieser Fläche 8 x 6 verlangt "
      "(ein <deviation in=\"grid\"> würde sie angeben); Rolle „task“ aus en12464-1:2021 meint "
      "eine Fläche mit der Lage vertical, und diese hat sie nicht");
}

// Whatever it looks like, and wherever it ends.
TEST(Sentences, LeaveWhatPeopleHaveWritten) {
  const calc::Waiver waiver{"shelf of 1.5 m; the ceiling", "Control, by letter until 2020-01-01: x",
                            "2031-12-31"};
  std::vector<KnownWords> known;
  add_known(kGerman, waiver, known);
  const std::string owner = waiver.owner;
  EXPECT_EQ(sentence(kGerman,
                     say<Sentence::area_unknown>() + "; " +
                         say<Sentence::waived_by>(owner, waiver.until, waiver.reason),
                     known),
            "eine Fläche ist nicht bekannt; ausgenommen durch Control, by letter until 2020-01-01: "
            "x bis 2031-12-31: shelf of 1.5 m; the ceiling");
  EXPECT_EQ(
      sentence(kGerman,
               say<Sentence::of_workplace>(
                   "a", "EN 12464-1:2021 34.2",
                   say<Sentence::left_out>("wall.1 (" + waiver.reason + ", " +
                                           say<Sentence::by_until>(owner, waiver.until) +
                                           "), wall.2 (" + waiver.reason + ", " +
                                           say<Sentence::by_until>(owner, waiver.until) + ")")),
               known),
      "Arbeitsplatz a, EN 12464-1:2021 34.2: weggelassen: wall.1 (shelf of 1.5 m; the "
      "ceiling, durch Control, by letter until 2020-01-01: x bis 2031-12-31), wall.2 (shelf "
      "of 1.5 m; the ceiling, durch Control, by letter until 2020-01-01: x bis 2031-12-31)");
  // Nobody knows them: English as they are.
  for (const std::string& text :
       {say<Sentence::waived_by>("A", "2030-01-01", "wall 2; the ceiling"),
        say<Sentence::left_out>("wall.1 (the ceiling; 1.5, by A until 2030-01-01)")})
    EXPECT_THAT(
        sentence(kGerman, text),
        testing::AnyOf(text, testing::HasSubstr("(the ceiling; 1.5, by A until 2030-01-01)")));
  EXPECT_EQ(
      sentence(kGerman, say<Sentence::one_source>() + "; " +
                            say<Sentence::level_because>("-1 step", "few; the ceiling; 1.5 h") +
                            "; " + say<Sentence::one_out>()),
      "eine öffentliche Quelle; Stufe -1 step: few; the ceiling; 1.5 h; any one luminaire out");
  EXPECT_EQ(sentence(kGerman, "wall 2; 1.5; the ceiling"), "wall 2; 1.5; the ceiling");
}

// Depth is bounded: a project may write anything.
TEST(Sentences, EndWhateverIsWritten) {
  std::string nested = "x";
  for (int i = 0; i < 200; ++i) nested = "with 'a' out: " + nested;
  EXPECT_THAT(sentence(kGerman, nested), testing::StartsWith("bei Ausfall von „a“: bei Ausfall"));
  std::string brackets(2000, '(');
  EXPECT_EQ(sentence(kGerman, brackets + " x" + std::string(2000, ')')),
            brackets + " x" + std::string(2000, ')'));
  EXPECT_EQ(sentence(kGerman, ")" + brackets), ")" + brackets);
  // Marks of our own in a file.
  const calc::Waiver strange{
      "\x01"
      "0\x02",
      "A", "2030-01-01"};
  std::vector<KnownWords> known;
  add_known(kGerman, strange, known);
  const std::string text = say<Sentence::waived_by>(strange.owner, strange.until, strange.reason);
  EXPECT_EQ(sentence(kGerman, text, known), text);
}

}  // namespace
}  // namespace report::sentences_test
