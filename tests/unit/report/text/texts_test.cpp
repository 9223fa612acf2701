#include "report/text/texts.h"

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
#include <string>
#include <vector>

namespace report {
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

TEST(Texts, EveryEntryHasBothLanguagesWithTheSamePlaceholders) {
  for (const TextEntry& entry : kTexts) {
    EXPECT_STRNE(entry.english, "") << entry.id;
    EXPECT_STRNE(entry.german, "") << entry.id;
    EXPECT_EQ(placeholders(entry.english), placeholders(entry.german)) << entry.id;
    const std::string both = std::string(entry.english) + entry.german;
    EXPECT_EQ(both.find_first_of("<>&\""), std::string::npos)
        << entry.id << ": would have to be escaped";
  }
}

// Words that are the same in both languages.
TEST(Texts, NoGermanTextIsEnglishUnlessItIsALoanword) {
  const std::set<std::string> loanwords{"in_lx",      "statistic_minimum", "statistic_ud",
                                        "about_logo", "about_revision",    "statistic_maximum"};
  for (const TextEntry& entry : kTexts) {
    const bool is_same = std::string(entry.english) == entry.german;
    EXPECT_EQ(is_same, loanwords.contains(entry.id)) << entry.id << ": " << entry.german;
  }
}

TEST(Texts, EveryEntryIsUsed) {
  const std::string text = sources();
  const std::regex name(R"(\bText::(\w+))");
  // Those of statistics by their rows, which the compiler checks.
  std::set<std::string> used{
#define TEXT(id, english, german)
#define METRIC_TEXT(id, english, german) #id,
#include "report/text/texts.def"
#undef TEXT
  };
  for (auto i = std::sregex_iterator(text.begin(), text.end(), name); i != std::sregex_iterator();
       ++i) {
    used.insert((*i)[1]);
  }
  for (const TextEntry& entry : kTexts) EXPECT_TRUE(used.contains(entry.id)) << entry.id;
}

TEST(Texts, AreFilledInInTheirLanguage) {
  EXPECT_EQ(kEnglish.say<Text::looks_of_planned>(3, 9), "3 of 9 planned");
  EXPECT_EQ(kGerman.say<Text::looks_of_planned>(3, 9), "3 von 9 geplanten");
  EXPECT_STREQ(kEnglish[Text::verdict_fail], "fail");
  EXPECT_STREQ(kGerman[Text::verdict_fail], "nicht erfüllt");
  EXPECT_EQ(kEnglish.language_tag(), "en");
  EXPECT_EQ(kGerman.language_tag(), "de");
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
}  // namespace report
