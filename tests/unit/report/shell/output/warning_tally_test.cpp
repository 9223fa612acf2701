#include "report/shell/output/warning_tally.h"

#include "calc/base/diagnostic_ids.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace cli::warning_tally_test {
namespace {

using calc::DiagnosticId;
using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<calc::Diagnostic> kThree{{DiagnosticId::luminaires_coincide, {}, "a"},
                                           {DiagnosticId::light_leaves_room, {}, "b"},
                                           {DiagnosticId::light_leaves_room, {}, "c"},
                                           {DiagnosticId::internal_error, {}, "no warning"}};

TEST(WarningTally, QuietNamesThemInOneLineAndOtherwiseTheyWerePrinted) {
  WarningTally tally({});
  EXPECT_THAT(tally.add(kThree), IsEmpty());
  EXPECT_EQ(tally.outcome(), rules::Outcome::nothing_asked);
  EXPECT_EQ(tally.words(false), "");
  EXPECT_EQ(tally.words(true),
            "luxgate: 3 warnings (luminaires-coincide, light-leaves-room (2)); exit code "
            "unaffected, --strict makes them count\n");
}

// --strict alone does not ask for what is a note where nobody names it.
TEST(WarningTally, NamesAreThoseThatSomebodyGave) {
  EXPECT_FALSE((StrictWarnings{true, {}}.names(DiagnosticId::one_source)));
  EXPECT_TRUE((StrictWarnings{true, {}}.has(DiagnosticId::one_source)));
  const StrictWarnings named{false, {DiagnosticId::one_source}};
  EXPECT_TRUE(named.names(DiagnosticId::one_source));
  EXPECT_TRUE(named.has(DiagnosticId::one_source));
  EXPECT_FALSE(named.names(DiagnosticId::luminaires_coincide));
}

TEST(WarningTally, NothingToSayIsNothing) {
  WarningTally tally({true, {}});
  EXPECT_THAT(tally.add({}), IsEmpty());
  EXPECT_EQ(tally.words(true), "");
  EXPECT_EQ(tally.outcome(), rules::Outcome::nothing_asked);
}

TEST(WarningTally, StrictSaysWhyTheExitCodeIsTwo) {
  WarningTally tally({true, {}});
  EXPECT_THAT(tally.add(kThree),
              ElementsAre(DiagnosticId::luminaires_coincide, DiagnosticId::light_leaves_room));
  EXPECT_EQ(tally.outcome(), rules::Outcome::warned);
  const char* words =
      "luxgate: exit code 2: 3 warnings count because of --strict: luminaires-coincide, "
      "light-leaves-room (2)\n";
  EXPECT_EQ(tally.words(false), words);
  EXPECT_EQ(tally.words(true), words);
}

TEST(WarningTally, StrictWithIdsLeavesTheOthersAlone) {
  WarningTally tally({false, {DiagnosticId::luminaires_coincide}});
  EXPECT_THAT(tally.add(kThree), ElementsAre(DiagnosticId::luminaires_coincide));
  EXPECT_EQ(tally.words(false),
            "luxgate: exit code 2: 1 warning counts because of --strict: luminaires-coincide\n");
  EXPECT_EQ(tally.words(true),
            "luxgate: 2 warnings (light-leaves-room (2)); exit code unaffected, --strict makes "
            "them count\nluxgate: exit code 2: 1 warning counts because of --strict: "
            "luminaires-coincide\n");
}

TEST(WarningTally, APolicyIsNotCalledStrict) {
  WarningTally tally({false, {DiagnosticId::luminaires_coincide}, true});
  tally.add(kThree);
  EXPECT_EQ(tally.words(false),
            "luxgate: exit code 2: 1 warning counts because of the policy or --strict: "
            "luminaires-coincide\n");
}

}  // namespace
}  // namespace cli::warning_tally_test
