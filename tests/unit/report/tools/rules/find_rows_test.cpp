#include "report/tools/rules/find_rows.h"

#include "report/text/plain_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cli::find_rows_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

rules::RuleRow row(std::string ref, std::string name, std::string name_de = "") {
  rules::RuleRow made;
  made.ref = std::move(ref);
  made.name = std::move(name);
  made.name_de = std::move(name_de);
  return made;
}

std::vector<rules::RulePack> two_packs() {
  rules::RulePack indoor;
  indoor.id = "indoor";
  indoor.edition = "2021";
  indoor.rows = {row("9.1", "corridors and circulation areas", "Verkehrsflächen und Flure"),
                 row("9.3", "lifts", "Aufzüge"),
                 row("34.5", "conference and meeting rooms", "Konferenz- und Besprechungsräume"),
                 row("44.1", "classroom of a primary school", "Klassenraum der Grundschule"),
                 row("44.17", "school corridors", "Schulflure")};
  rules::RulePack own;
  own.id = "own";
  own.edition = "1";
  own.rows = {row("conference", "conference room"), row("car-park", "parking"),
              row("tills", "tills")};
  return {indoor, own};
}

std::vector<std::string> ids(std::string_view words) {
  const std::vector<rules::RulePack> packs = two_packs();
  std::vector<std::string> found;
  for (const FoundRow& one : find_rows(words, packs)) found.push_back(one.id());
  return found;
}

TEST(FindRows, NamesInBothLanguagesAreSearched) {
  EXPECT_THAT(ids("classroom"), ElementsAre("indoor:2021/44.1"));
  EXPECT_THAT(ids("Klassenraum"), ElementsAre("indoor:2021/44.1"));
  EXPECT_THAT(ids("primary SCHOOL"), ElementsAre("indoor:2021/44.1"));
  EXPECT_THAT(ids("school primary"), ElementsAre("indoor:2021/44.1"));
}

TEST(FindRows, UmlautsAreLikeTheTwoLettersThatReplaceThem) {
  for (const char* word :
       {"aufzüge", "Aufzuege", "AUFZÜGE", "AUFZUEGE", "Aufzu\u0308ge", "AUFZU\u0308GE"})
    EXPECT_THAT(ids(word), ElementsAre("indoor:2021/9.3")) << word;
  EXPECT_EQ(search_form("Straße, Öl und ÄRGER"), "strasse, oel und aerger");
}

TEST(FindRows, IdsAreSearchedFromTheirBeginning) {
  EXPECT_THAT(ids("44"), ElementsAre("indoor:2021/44.1", "indoor:2021/44.17"));
  EXPECT_THAT(ids("Car-Park"), ElementsAre("own:1/car-park"));
  EXPECT_THAT(ids("4.1"), IsEmpty());
}

TEST(FindRows, WordsWithTheSameMeaningFindTheRowAfterThoseWithTheWord) {
  EXPECT_THAT(ids("meeting"), ElementsAre("indoor:2021/34.5", "own:1/conference"));
  EXPECT_THAT(ids("Besprechung"), ElementsAre("indoor:2021/34.5", "own:1/conference"));
  EXPECT_THAT(ids("Klassenzimmer"), ElementsAre("indoor:2021/44.1"));
  EXPECT_THAT(ids("elevator"), ElementsAre("indoor:2021/9.3"));
  EXPECT_THAT(ids("Parkhaus"), ElementsAre("own:1/car-park"));
  EXPECT_THAT(ids("classrooms"), ElementsAre("indoor:2021/44.1"));
}

TEST(FindRows, BeginningsOfWordsComeBeforeTheirMiddle) {
  EXPECT_THAT(ids("flur"), ElementsAre("indoor:2021/9.1", "indoor:2021/44.17"));
  EXPECT_THAT(ids("ill"), ElementsAre("own:1/tills"));
}

TEST(FindRows, EveryWordIsNeeded) {
  EXPECT_THAT(ids("school corridor"), ElementsAre("indoor:2021/44.17"));
  EXPECT_THAT(ids("school swimming"), IsEmpty());
  EXPECT_THAT(ids(""), IsEmpty());
  EXPECT_THAT(ids("  "), IsEmpty());
}

TEST(FindRows, RowsOfThePacksThatComeAlongAreFound) {
  const std::vector<rules::RulePack>& packs = rules::builtin_rule_packs();
  const auto first_indoor_rows = [&](std::string_view word) {
    std::vector<std::string> refs;
    for (const FoundRow& found : find_rows(word, packs)) {
      if (found.pack->full_id() == "en12464-1:2021" && refs.size() < 4) {
        refs.push_back(found.row->ref);
      }
    }
    return refs;
  };
  for (const char* word : {"meeting", "Besprechung", "Konferenz"})
    EXPECT_THAT(first_indoor_rows(word), Contains("34.5.1")) << word;
  for (const char* word : {"entrance", "Eingang", "foyer"})
    EXPECT_THAT(first_indoor_rows(word), Contains("36.1")) << word;
  for (const char* word : {"classroom", "Klassenraum", "Klassenzimmer"})
    EXPECT_THAT(first_indoor_rows(word), AllOf(Contains("44.1"), Contains("44.2"))) << word;
  for (const char* word : {"restaurant", "dining", "Speiseraum", "Gaststätte"})
    EXPECT_THAT(first_indoor_rows(word), Contains("37.3")) << word;
  for (const char* word : {"shop", "sales", "Verkauf"})
    EXPECT_THAT(first_indoor_rows(word), Contains("35.1")) << word;
  for (const char* word : {"ward", "Krankenzimmer", "Bettenzimmer", "patient"})
    EXPECT_THAT(first_indoor_rows(word), Contains("47.1")) << word;
  for (const char* word : {"lecture", "auditorium", "Hörsaal", "Hörsäle"})
    EXPECT_THAT(first_indoor_rows(word), Contains("44.3.1")) << word;
  for (const char* word : {"clinic", "Krankenhaus", "Arztpraxis"})
    EXPECT_THAT(first_indoor_rows(word), Contains("45.1")) << word;
  for (const char* word : {"waiting", "Wartezimmer"})
    EXPECT_THAT(first_indoor_rows(word), Contains("45.1")) << word;
}

TEST(FindRows, ListHasIdsInAColumnAndFitsATerminal) {
  const std::vector<rules::RulePack> packs = two_packs();
  EXPECT_EQ(row_list(find_rows("conference", packs), 8),
            "indoor:2021/34.5  conference and meeting rooms / Konferenz- und\n"
            "                  Besprechungsräume\n"
            "own:1/conference  conference room\n");
  EXPECT_EQ(row_list(find_rows("44", packs), 1),
            "indoor:2021/44.1  classroom of a primary school / Klassenraum der Grundschule\n");
  EXPECT_EQ(row_list({}, 8), "");
}

TEST(FindRows, LinesOfLongNamesFitToo) {
  std::vector<rules::RulePack> packs(1);
  packs[0].id = std::string(60, 'p');
  packs[0].edition = "1";
  packs[0].rows = {row("1", std::string(200, 'n'), "kurz")};
  std::string text = row_list(find_rows("1", packs), 8);
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    EXPECT_LE(report::display_width(text.substr(0, end)), 80U);
    text.erase(0, end + 1);
  }
}

}  // namespace
}  // namespace cli::find_rows_test
