#include "calc/base/diagnostic_ids.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace calc::diagnostics_test {
namespace {

using testing::SizeIs;
using testing::StartsWith;

std::size_t count_of(const Diagnostics& diagnostics, DiagnosticId id) {
  return static_cast<std::size_t>(
      std::count_if(diagnostics.all().begin(), diagnostics.all().end(),
                    [id](const Diagnostic& diagnostic) { return diagnostic.id == id; }));
}

TEST(Diagnostics, AreOneLineWhateverTheyQuote) {
  Diagnostics diagnostics;
  diagnostics.report(DiagnosticId::file_not_readable, {"d\n::error::x", 3, 0}, "a\r\nb", "c");
  EXPECT_EQ(format_diagnostic(diagnostics.all().front()),
            "d ::error::x:3: error[file-not-readable]: cannot read 'a  b': c");
}

TEST(Diagnostics, BeginNoCommandOfACiRunner) {
  Diagnostics diagnostics;
  diagnostics.report(DiagnosticId::file_not_readable, {"::error::x", 0, 0}, "##[group]", "c");
  EXPECT_EQ(format_diagnostic(diagnostics.all().front()),
            "./::error::x: error[file-not-readable]: cannot read '## [group]': c");
}

TEST(Diagnostics, AreShort) {
  Diagnostics diagnostics;
  diagnostics.report(DiagnosticId::file_not_readable, {}, std::string(40'000'000, 'x'), "c");
  EXPECT_THAT(diagnostics.all().front().message, SizeIs(kLongestMessage + 3));
}

TEST(Diagnostics, OfAnIdHaveAnEnd) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < 3 * kMostMessagesOfAnId; ++i) {
    diagnostics.report(DiagnosticId::xml_too_many_attributes, {"a.xml", 1, 0}, "b", 3);
  }
  EXPECT_EQ(diagnostics.error_count(), 3 * kMostMessagesOfAnId);
  ASSERT_THAT(diagnostics.all(), SizeIs(kMostMessagesOfAnId + 1));
  EXPECT_EQ(format_diagnostic(diagnostics.all().back()),
            "a.xml: warning[messages-left-out]: 2000 more messages xml-too-many-attributes are "
            "omitted, after the first 1000");
}

// A warning that --strict makes count must not be hidden behind others.
TEST(Diagnostics, OfOneIdHideNoneOfAnother) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < 2 * kMostMessagesOfAnId; ++i) {
    diagnostics.report(DiagnosticId::light_leaves_room, {}, 1.0, "room");
  }
  diagnostics.report(DiagnosticId::file_not_readable, {}, "a", "b");
  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.all().back().id, DiagnosticId::file_not_readable);
}

TEST(Diagnostics, AreCountedWhenTheyComeTogether) {
  Diagnostics one, other;
  for (std::size_t i = 0; i < kMostMessagesOfAnId - 1; ++i) {
    one.report(DiagnosticId::file_not_readable, {}, "a", "b");
  }
  for (std::size_t i = 0; i < kMostMessagesOfAnId + 5; ++i) {
    other.report(DiagnosticId::file_not_readable, {}, "a", "b");
  }
  one.add(other);
  EXPECT_EQ(one.error_count(), 2 * kMostMessagesOfAnId + 4);
  EXPECT_EQ(count_of(one, DiagnosticId::file_not_readable), kMostMessagesOfAnId);
  ASSERT_EQ(count_of(one, DiagnosticId::messages_left_out), 1U);
  EXPECT_THAT(one.all().back().message, StartsWith("1004 more messages file-not-readable"));
}

// What counts them is found again after the others have changed their places.
TEST(Diagnostics, OfAnIdAreCountedAfterTheyAreSorted) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < kMostMessagesOfAnId + 1; ++i) {
    const int line = static_cast<int>(kMostMessagesOfAnId + 1 - i);
    diagnostics.report(DiagnosticId::file_not_readable, {"a.xml", line, 1}, "a", "b");
  }
  diagnostics.sort_by_line("a.xml", 0);
  diagnostics.report(DiagnosticId::file_not_readable, {"a.xml", 1, 1}, "a", "b");
  EXPECT_EQ(diagnostics.all().front().where.line, 2);
  EXPECT_THAT(diagnostics.all().back().message, StartsWith("2 more messages file-not-readable"));
}

}  // namespace
}  // namespace calc::diagnostics_test
