#include "report/text/texts.h"

#include "report/text/sentences.h"
#include "report/text/text_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace report::texts_test {
namespace {

const Texts kEnglish, kGerman(Language::german, true);

std::vector<std::string> placeholders(const std::string& text) {
  const std::regex pattern(R"(\{[^}]*\})");
  std::vector<std::string> found;
  for (auto i = std::sregex_iterator(text.begin(), text.end(), pattern);
       i != std::sregex_iterator(); ++i) {
    found.push_back(i->str());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// All sources of the report and of the program.
std::string sources() {
  std::string all;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(LUXGATE_SOURCE_DIR) + "/report")) {
    const std::string kind = entry.path().extension();
    if (kind != ".cpp" && kind != ".h" && kind != ".in") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    all.append(std::istreambuf_iterator<char>(file), {});
    all += '\n';
  }
  return all;
}

TEST(Texts, EveryLanguageHasARowAndItsTexts) {
  std::set<std::string_view> tags;
  for (const LanguageRow& row : kLanguages) {
    EXPECT_EQ(language_row(row.language).tag, row.tag);
    EXPECT_TRUE(tags.insert(row.tag).second) << row.tag;
    EXPECT_EQ(texts_of(row.language).size(), kEnglishTexts.size()) << row.tag;
  }
  EXPECT_EQ(kLanguages.front().language, Language::english);
}

TEST(Texts, EveryLanguageHasTheSamePlaceholders) {
  for (const LanguageRow& row : kLanguages) {
    const std::span<const TextEntry> texts = texts_of(row.language);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const std::string text = texts[i].text, english = kEnglishTexts[i].text;
      EXPECT_EQ(texts[i].id, kEnglishTexts[i].id) << row.tag;
      EXPECT_NE(text, "") << row.tag << " " << texts[i].id;
      EXPECT_EQ(placeholders(text), placeholders(english)) << row.tag << " " << texts[i].id;
      EXPECT_EQ(text.find_first_of("<>&\""), std::string::npos)
          << row.tag << " " << texts[i].id << ": would have to be escaped";
      EXPECT_EQ(text.front() == ' ', english.front() == ' ') << row.tag << " " << texts[i].id;
      EXPECT_EQ(text.back() == ' ', english.back() == ' ') << row.tag << " " << texts[i].id;
    }
  }
}

// Words that are the same as in English.
std::set<std::string_view> loanwords(Language language) {
  std::set<std::string_view> words{
      "in_lx",        "colon",      "count_of",          "statistic_minimum", "statistic_maximum",
      "statistic_ud", "about_logo", "clause_and_source", "road_surface_is",   "xlsx_minimum"};
  if (language == Language::german)
    words.insert({"about_revision", "schedule_position", "xlsx_name"});
  if (language == Language::french) {
    words.erase("colon");
    words.erase("count_of");
    words.erase("in_lx");
    words.insert({"about_client",
                  "about_date",
                  "page_on_paper",
                  "minimum",
                  "maximum",
                  "exact",
                  "luminaires",
                  "verdict",
                  "direct_share",
                  "indirect_share",
                  "direct",
                  "position",
                  "points",
                  "point",
                  "position_m",
                  "direct_light",
                  "indirect_light",
                  "one_point",
                  "many_points",
                  "key_minimum",
                  "key_luminaire",
                  "type",
                  "sheet_distance",
                  "llmf",
                  "lsf",
                  "lmf",
                  "rsmf",
                  "messages",
                  "triangles",
                  "time_verdicts",
                  "time_total",
                  "brief_extremes",
                  "head_verdict",
                  "class_possible",
                  "direct_lx",
                  "converge_points_head",
                  "converge_phase_direct",
                  "converge_scene_words",
                  "role_luminaire",
                  "footnotes",
                  "aspect_orientation",
                  "aspect_points",
                  "xlsx_sheet_luminaires",
                  "xlsx_sheet_positions",
                  "xlsx_sheet_points",
                  "xlsx_direct_lx",
                  "xlsx_message"});
  }
  return words;
}

TEST(Texts, NoTextIsEnglishUnlessItIsALoanword) {
  for (const LanguageRow& row : kLanguages) {
    if (row.language == Language::english) continue;
    const std::set<std::string_view> same = loanwords(row.language);
    for (std::size_t i = 0; i < kEnglishTexts.size(); ++i) {
      const TextEntry& entry = texts_of(row.language)[i];
      EXPECT_EQ(std::string(entry.text) == kEnglishTexts[i].text, same.contains(entry.id))
          << row.tag << " " << entry.id << ": " << entry.text;
    }
  }
}

// An assessment by a program is no judgement of a court.
TEST(Texts, GermanHasNoUrteil) {
  for (const TextEntry& entry : texts_of(Language::german))
    EXPECT_EQ(std::string(entry.text).find("Urteil"), std::string::npos) << entry.id;
  for (const SentenceEntry& entry : sentences_of(Language::german))
    EXPECT_EQ(entry.text.find("Urteil"), std::string_view::npos) << entry.id;
}

TEST(Texts, EveryEntryIsUsed) {
  const std::string text = sources();
  const std::regex name(R"(\bText::(\w+))");
  // Those of statistics by their rows, which the compiler checks.
  std::set<std::string> used{
#define TEXT(id, text)
#define METRIC_TEXT(id, text) #id,
#include "report/text/english.def"
#undef TEXT
  };
  for (auto i = std::sregex_iterator(text.begin(), text.end(), name); i != std::sregex_iterator();
       ++i) {
    used.insert((*i)[1]);
  }
  for (const TextEntry& entry : kEnglishTexts)
    EXPECT_TRUE(used.contains(std::string(entry.id))) << entry.id;
}

TEST(Texts, AreFilledInInTheirLanguage) {
  EXPECT_EQ(kEnglish.say<Text::looks_of_planned>(3, 9), "3 of 9 planned");
  EXPECT_EQ(kGerman.say<Text::looks_of_planned>(3, 9), "3 von 9 geplanten");
  EXPECT_STREQ(kEnglish[Text::verdict_fail], "fail");
  EXPECT_STREQ(kGerman[Text::verdict_fail], "nicht erfüllt");
  EXPECT_EQ(kEnglish.language_tag(), "en");
  EXPECT_EQ(kGerman.language_tag(), "de");
  const Texts french(Language::french, true);
  EXPECT_STREQ(french[Text::verdict_fail], "non conforme");
  EXPECT_EQ(french.say<Text::count_of>(2, "conforme"), "conforme\u202f: 2");
}

TEST(Texts, DecimalSignsChangeAndListsStayReadable) {
  EXPECT_EQ(kEnglish.number("512.3 ± 4.1 lx"), "512.3 ± 4.1 lx");
  EXPECT_EQ(kGerman.number("512.3 ± 4.1 lx"), "512,3 ± 4,1 lx");
  EXPECT_EQ(kGerman.number("(4.20, -1.10, 0.80)"), "(4,20; -1,10; 0,80)");
  EXPECT_EQ(kGerman.number("–"), "–");
  EXPECT_EQ(kGerman.number("12."), "12.");
  // Both by themselves.
  EXPECT_EQ(Texts(Language::english, true).number("0.5"), "0,5");
  EXPECT_EQ(Texts(Language::german, false).number("0.5"), "0.5");
}

TEST(Texts, WordsAmongNumbersAreTranslated) {
  EXPECT_EQ(format_interval(kEnglish, {5, 5, 5}, "lx"), "exact");
  EXPECT_EQ(format_interval(kGerman, {5, 5, 5}, "lx"), "exakt");
  const Threshold unknown{std::nan(""), rules::Comparison::at_least};
  EXPECT_EQ(format_required(kEnglish, unknown, "lx"), "unknown limit");
  EXPECT_EQ(format_required(kGerman, unknown, "lx"), "Grenzwert unbekannt");
  EXPECT_EQ(format_required(kGerman, Threshold{0.6, rules::Comparison::at_least}, ""), "≥ 0,60");
}

TEST(Texts, EnglishIsMarkedWhereTheReportIsNot) {
  EXPECT_EQ(kEnglish.english_html("a note"), "a note");
  EXPECT_EQ(kGerman.english_html("a note"), "<span lang=\"en\">a note</span>");
  EXPECT_EQ(kGerman.english_html(""), "");
}

}  // namespace
}  // namespace report::texts_test
