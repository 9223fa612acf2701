#include "report/text/folded_warnings.h"

#include "report/text/plain_text.h"
#include "tests/support/room_documents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace report::folded_warnings_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// Seven of one kind, and one of another.
ProjectPart warned() {
  ProjectPart project = many_rooms_document(21).projects[0];
  project.diagnostics.insert(project.diagnostics.begin() + 2,
                             {calc::DiagnosticId::nothing_required, {"office.xml", 9, 5}, "no"});
  return project;
}

TEST(FoldedWarnings, OfAKindShareALineAndOthersAreWhole) {
  EXPECT_THAT(
      folded_warnings(warned(), 0),
      ElementsAre("office.xml:3:5: warning[luminaire-partly-outside]: 7 times, first: luminaire "
                  "'G[0,0]': its luminous opening reaches 0.0729 m out of the room",
                  "office.xml:9:5: warning[nothing-required]: no",
                  "luxgate: 8 warnings of 2 kinds; --notes shows each of them"));
}

TEST(FoldedWarnings, AreCutWhereTheTerminalEnds) {
  ProjectPart project = warned();
  project.diagnostics[0].where.file = "/home/someone/with/a/long/path/to/the/office.xml";
  const std::vector<std::string> lines = folded_warnings(project, 80);
  EXPECT_LE(display_width(lines.at(0)), 80U);
  EXPECT_THAT(lines.at(0), HasSubstr("office.xml:3:5: warning[luminaire-partly-outside]: 7 times"));
}

TEST(FoldedWarnings, ErrorsAndWhatCountsAreAllThere) {
  ProjectPart project = warned();
  project.strict_warnings = {calc::DiagnosticId::luminaire_partly_outside};
  for (int k = 0; k < 2; ++k) {
    project.diagnostics.push_back({calc::DiagnosticId::plane_not_computed, {"a.xml", k, 1}, "no"});
  }
  const std::vector<std::string> lines = folded_warnings(project, 80);
  EXPECT_EQ(lines.size(), project.diagnostics.size());
  EXPECT_THAT(lines.back(), StartsWith("a.xml:1:1: error[plane-not-computed]: no"));
}

}  // namespace
}  // namespace report::folded_warnings_test
