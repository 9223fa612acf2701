#include "report/tools/import/project_merge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace project_merge_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string project(const std::string& inside) {
  return "<?xml version=\"1.0\"?>\n<luxgate version=\"1\">\n  <material id=\"m\" "
         "reflectance=\"0.5\"/>\n" +
         inside + "</luxgate>\n";
}
std::string room(const std::string& inside, const std::string& height = "2.8") {
  return "  <room id=\"r\" height=\"" + height + "\">\n" + inside + "  </room>\n";
}
std::string lamp(const std::string& id, const std::string& x) {
  return "    <luminaire id=\"" + id + "\" x=\"" + x + "\"/>\n";
}

cli::MergedProject merged(const std::string& base, const std::string& mine,
                          const std::string& next) {
  calc::Diagnostics diagnostics;
  auto result = cli::merge_projects({base, "base"}, {mine, "mine"}, next, diagnostics);
  EXPECT_TRUE(result);
  return result ? std::move(*result) : cli::MergedProject();
}

TEST(ProjectMerge, NothingNewChangesNoByte) {
  const std::string base = project(room(lamp("A", "1")));
  const std::string mine = project("<!-- hi -->\n" + room(lamp("A", "7") + "<plane id='p'/>"));
  const cli::MergedProject result = merged(base, mine, base);
  EXPECT_EQ(result.xml, mine);
  EXPECT_THAT(result.changes, IsEmpty());
  EXPECT_THAT(result.conflicts, IsEmpty());
}

// Whoever writes values between apostrophes gets names that have one.
TEST(ProjectMerge, QuotesOfTheProjectEndNoValue) {
  const std::string base = project("  <room id=\"r\" name=\"A\"/>\n");
  const std::string mine = project("  <room id='r' name='A'/>\n");
  const std::string next = project("  <room id=\"r\" name=\"B's\"/>\n");
  const cli::MergedProject result = merged(base, mine, next);
  EXPECT_EQ(result.xml, project("  <room id='r' name='B&apos;s'/>\n"));
  EXPECT_THAT(result.changes, ElementsAre("room r, name: A -> B's"));
}

TEST(ProjectMerge, WhatTheDrawingChangedIsTaken) {
  const std::string base = project(room(lamp("A", "1") + lamp("B", "2")));
  const std::string mine = project(
      room("    <!-- c -->\n" + lamp("A", "1") + lamp("B", "2") + "    <plane id=\"p\"/>\n"));
  const std::string next = project(room(lamp("A", "3") + lamp("C", "4"), "3.0"));
  const cli::MergedProject result = merged(base, mine, next);
  EXPECT_EQ(result.xml, project(room("    <!-- c -->\n" + lamp("A", "3") + lamp("C", "4") +
                                         "    <plane id=\"p\"/>\n",
                                     "3.0")));
  EXPECT_THAT(result.changes, ElementsAre("room r, height: 2.8 -> 3.0", "luminaire A, x: 1 -> 3",
                                          "came: luminaire C", "went: luminaire B"));
  EXPECT_THAT(result.conflicts, IsEmpty());
}

TEST(ProjectMerge, WhatWasChangedByHandIsKeptAndSaid) {
  const std::string base = project(room(lamp("A", "1") + lamp("B", "2") + lamp("D", "5")));
  const std::string mine = project(room(lamp("A", "7") + lamp("B", "8")));
  const std::string next = project(room(lamp("A", "3") + lamp("D", "6")));
  const cli::MergedProject result = merged(base, mine, next);
  EXPECT_EQ(result.xml, mine);
  EXPECT_THAT(result.conflicts,
              ElementsAre(HasSubstr("luminaire A, x: 1 -> 3 in the drawing, 7 by hand"),
                          HasSubstr("luminaire D, it was removed by hand"),
                          HasSubstr("luminaire B, it is no longer in the drawing")));
}

TEST(ProjectMerge, RoomsComeAndGoAsAWhole) {
  const std::string base = project(room(lamp("A", "1")));
  const std::string none = project("");
  const cli::MergedProject came = merged(none, none, base);
  EXPECT_EQ(came.xml, base);
  EXPECT_THAT(came.changes, ElementsAre("came: room r"));
  const cli::MergedProject went = merged(base, base, none);
  EXPECT_EQ(went.xml, none);
  EXPECT_THAT(went.changes, ElementsAre("went: room r"));
  // A plane that somebody put there keeps the room.
  const std::string mine = project(room(lamp("A", "1") + "    <plane id=\"p\"/>\n"));
  const cli::MergedProject kept = merged(base, mine, none);
  EXPECT_EQ(kept.xml, mine);
  EXPECT_THAT(kept.conflicts, ElementsAre(HasSubstr("room r, it is no longer in the drawing")));
}

TEST(ProjectMerge, EmptyRoomsAreOpenedForWhatComes) {
  const std::string base = project("  <room id=\"r\"/>\n");
  const std::string next = project("  <room id=\"r\">\n" + lamp("A", "1") + "  </room>\n");
  EXPECT_EQ(merged(base, base, next).xml, next);
}

TEST(ProjectMerge, TextsThatAreNoXmlAreErrors) {
  calc::Diagnostics diagnostics;
  EXPECT_FALSE(
      cli::merge_projects({project(""), "b"}, {"<luxgate", "m"}, project(""), diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace project_merge_test
