#include "report/tools/rules/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

namespace cli::explain_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// Its lines as one.
std::string explained(const std::string& id) {
  std::string text = explain_message(id).value_or("nothing");
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

TEST(Explain, WarningOfThePolicyAlwaysCounts) {
  EXPECT_THAT(explained("policy-not-met"), HasSubstr("exit code is 2"));
  EXPECT_THAT(explained("policy-not-met"), Not(HasSubstr("only with --strict")));
  EXPECT_THAT(explained("luminaires-coincide"), HasSubstr("only with --strict"));
}

TEST(Explain, StrictCountsWarningsOfProjectsOnly) {
  for (const char* id : {"backend-is-software", "store-not-written", "rule-unused"}) {
    EXPECT_THAT(explained(id), HasSubstr("It changes no result and no exit code.")) << id;
  }
  EXPECT_THAT(explained("light-leaves-room"), Not(HasSubstr("no exit code")));
}

TEST(Explain, LinesFitATerminalAndExamplesStayWhole) {
  EXPECT_EQ(explain_message("rule-circle"),
            "rule-circle: error\n\n"
            "    check '{}' depends on its own limit or result: {}; remove one of these\n"
            "    references\n\n"
            "{} stands for what was found. luxgate judges nothing that depends on it, and the\n"
            "exit code is 2.\n");
  EXPECT_THAT(*explain_message("rule-needs-scene"),
              HasSubstr("\n  <scene id=\"emergency\"><dim group=\"battery\" level=\"0.6\"/><dim "
                        "group=\"mains\" level=\"0\"/></scene>\n"));
}

TEST(Explain, UnknownIdIsNotExplained) {
  EXPECT_EQ(explain_message("luminaires"), std::nullopt);
  EXPECT_EQ(explain_message(""), std::nullopt);
}

TEST(Explain, MessagesAreFoundByTheirWords) {
  EXPECT_THAT(messages_with_word("Maintenance"), ElementsAre("maintenance-not-stated"));
  EXPECT_THAT(messages_with_word("luminaires"), Contains("space-without-luminaires"));
  EXPECT_THAT(messages_with_word("luminaires"), Contains("luminaires-coincide"));
  EXPECT_THAT(messages_with_word("aintenance"), IsEmpty());
  EXPECT_THAT(messages_with_word(""), IsEmpty());
}

TEST(Explain, MisspeltIdHasNearOnes) {
  EXPECT_THAT(near_messages("light-leaves-rom"), ElementsAre("light-leaves-room"));
  EXPECT_THAT(near_messages("Policy-Not-Mett"), Contains("policy-not-met"));
  EXPECT_THAT(near_messages("xyz"), IsEmpty());
}

}  // namespace
}  // namespace cli::explain_test
