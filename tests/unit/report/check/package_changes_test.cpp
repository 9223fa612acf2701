#include "report/check/package_changes.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace package_changes_test {
namespace {

// Of a project's text with these packages.
std::string with(const std::string& text, const std::map<std::string, std::string>& articles) {
  calc::Diagnostics diagnostics;
  const auto changed = check::with_packages(text, "p.xml", articles, diagnostics);
  EXPECT_TRUE(changed) << (diagnostics.all().empty() ? "" : diagnostics.all().front().message);
  return changed.value_or("");
}

std::string project(const std::string& attributes) {
  return "<luxgate version=\"1\"><!-- <luminaire-type id=\"t\" flux-lm=\"1\"/> -->\n"
         "<luminaire-type id=\"other\" flux-lm=\"7\" photometry=\"o.ies\"/>\n<luminaire-type " +
         attributes +
         ">\n<package article=\"A\" flux-lm=\"3\" power-w=\"4\"/></luminaire-type></luxgate>";
}

TEST(PackageChanges, TakesThePlaceOfFluxAndPower) {
  EXPECT_EQ(with(project("id=\"t\" photometry=\"a.ies\""), {{"t", "A"}}),
            project("id=\"t\" photometry=\"a.ies\" package=\"A\""));
  EXPECT_EQ(
      with(project("id=\"t\" flux-lm=\"900\" photometry=\"a.ies\" power-w='9'"), {{"t", "A"}}),
      project("id=\"t\" photometry=\"a.ies\" package=\"A\""));
  EXPECT_EQ(with(project("flux-lm=\"900\" id=\"t\" photometry=\"a.ies\""), {{"t", "A"}}),
            project("id=\"t\" photometry=\"a.ies\" package=\"A\""));
  EXPECT_EQ(with(project("id=\"t\" package=\"old\" photometry=\"a.ies\""), {{"t", "A & \"B\""}}),
            project("id=\"t\" package=\"A &amp; &quot;B&quot;\" photometry=\"a.ies\""));
}

TEST(PackageChanges, BlanksInAnArticleStayWhatTheyAre) {
  EXPECT_EQ(with(project("id=\"t\" photometry=\"a.ies\""), {{"t", "P\n1\t2"}}),
            project("id=\"t\" photometry=\"a.ies\" package=\"P&#10;1&#9;2\""));
}

// Numbers of lines are what messages name.
TEST(PackageChanges, LaterLinesKeepTheirNumbers) {
  EXPECT_EQ(with(project("id=\"t\"\n  flux-lm=\"900\"\n  power-w=\n\"9\"\n  photometry=\"a.ies\""),
                 {{"t", "A"}}),
            project("id=\"t\"\n \n \n\n  photometry=\"a.ies\" package=\"A\""));
}

TEST(PackageChanges, LeavesAllElse) {
  const std::string text = project("id=\"t\" flux-lm=\"900\" photometry=\"a.ies\"");
  EXPECT_EQ(with(text, {}), text);
  EXPECT_EQ(with(text, {{"nobody", "A"}}), text);
  calc::Diagnostics diagnostics;
  EXPECT_FALSE(check::with_packages("<luxgate", "p.xml", {}, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace package_changes_test
