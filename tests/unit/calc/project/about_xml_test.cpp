// <about>: project data, and that nothing hangs on them.

#include "calc/project/reading/project_elements.h"
#include "calc/scene/about_project.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace calc::tests::about_xml_test {
namespace {

constexpr const char* kSvg =
    "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0h1v1z\"/></svg>";

Loaded load_about(const std::string& lines) {
  MemoryFileReader files = project_files(in_project(lines));
  files.add("dir/logo.svg", kSvg);
  files.add("dir/logo.png", "GIF89a");
  return load(files);
}

void expect_messages(const std::string& lines, const std::string& messages) {
  const Loaded loaded = load_about(lines);
  EXPECT_FALSE(loaded.project);
  EXPECT_EQ(loaded.messages, messages);
}

TEST(AboutXml, EveryAttributeIsRead) {
  const Loaded loaded = load_about(
      "<about client=' A. Meier ' number='4711' revision='b' date='2026-03-31' author='Z' "
      "company='Office &amp; Sons' address='Way 1' note='draft' logo='logo.svg'/>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const AboutProject& about = loaded.project->about;
  EXPECT_EQ(about.client, "A. Meier");
  EXPECT_EQ(about.number, "4711");
  EXPECT_EQ(about.revision, "b");
  EXPECT_EQ(about.date, "2026-03-31");
  EXPECT_EQ(about.author, "Z");
  EXPECT_EQ(about.company, "Office & Sons");
  EXPECT_EQ(about.address, "Way 1");
  EXPECT_EQ(about.note, "draft");
  EXPECT_EQ(about.logo.file, "logo.svg");
  EXPECT_EQ(about.logo.format, LogoFormat::svg);
  EXPECT_EQ(about.logo.bytes, kSvg);
  EXPECT_EQ(loaded.project->inputs.at(1).path, "logo.svg");  // after the project
}

TEST(AboutXml, NothingOfItIsNeeded) {
  for (const char* lines : {"", "<about/>", "<about client=' '/>"}) {
    const Loaded loaded = load_about(lines);
    ASSERT_TRUE(loaded.project) << loaded.messages;
    EXPECT_TRUE(loaded.project->about.is_empty());
  }
}

TEST(AboutXml, MistakesAreNamed) {
  expect_messages("<about date='31.03.2026'/>",
                  "dir/p.xml:4:8: error[not-a-day]: attribute 'date' of <about>: '31.03.2026' is "
                  "not a day; expected YYYY-MM-DD, such as 2026-03-31");
  expect_messages("<about/>\n<about/>",
                  "dir/p.xml:5:1: error[duplicate-id]: the element 'about' is given twice, also in "
                  "line 4");
  expect_messages(
      "<about customer='A'/>",
      "dir/p.xml:4:8: error[unknown-attribute]: unknown attribute 'customer' of <about>; "
      "allowed: client, number, revision, date, author, company, address, note or logo");
  expect_messages("<about logo='logo.gif'/>",
                  "dir/p.xml:4:8: error[logo-not-usable]: the logo 'logo.gif' cannot be used in a "
                  "report: its name must end with .png or .svg");
  expect_messages("<about logo='logo.png'/>",
                  "dir/p.xml:4:8: error[logo-not-usable]: the logo 'logo.png' cannot be used in a "
                  "report: its name ends with .png, but it is not a PNG file");
  expect_messages("<about logo='../logo.png'/>",
                  "dir/p.xml:4:8: error[file-outside-project]: '../logo.png' leaves the project's "
                  "folder; files are read from that folder and below it only");
  expect_messages(
      "<about logo='none.png'/>",
      "dir/p.xml:4:8: error[file-not-readable]: cannot read 'dir/none.png': No such file "
      "or directory");
}

// The table of texts and the rows of the schema name the same.
TEST(AboutXml, TextsAreTheAttributes) {
  std::set<std::string_view> names{"logo"};
  for (const AboutText& one : kAboutTexts) names.insert(one.name);
  const Names rows = attribute_names(kAboutElement);
  EXPECT_EQ(std::set<std::string_view>(rows.begin(), rows.end()), names);
}

}  // namespace
}  // namespace calc::tests::about_xml_test
