#include "report/text/ifc_guid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace ifc_guid_test {
namespace {

TEST(IfcGuid, IdsSayTheGlobalId) {
  EXPECT_EQ(report::key_of_id("room-0BTBFw6f90Nfh9rP1dl:3P", "room-"), "0BTBFw6f90Nfh9rP1dl$3P");
  EXPECT_EQ(report::key_of_id("L-1F", "room-"), "");
  EXPECT_EQ(report::key_of_id("hall", "room-"), "");
}

// Ends of the range, and a value whose letters were worked out by hand.
TEST(IfcGuid, LettersAreTheBitsFromTheTop) {
  report::Guid guid{};
  EXPECT_EQ(report::ifc_letters(guid), "0000000000000000000000");
  guid.fill(0xFF);
  EXPECT_EQ(report::ifc_letters(guid), "3$$$$$$$$$$$$$$$$$$$$$");
  guid.fill(0);
  guid[0] = 0x41;   // 01 000001
  guid[1] = 0x04;   // 000001 00
  guid[15] = 0x3E;  // 00 111110
  EXPECT_EQ(report::ifc_letters(guid), "111000000000000000000_");
}

TEST(IfcGuid, NamesDecideAndNothingElse) {
  const std::set<std::string> all = {
      report::ifc_letters(report::guid_of_names({"a", "b"})),
      report::ifc_letters(report::guid_of_names({"ab"})),
      report::ifc_letters(report::guid_of_names({"a", "b", ""})),
      report::ifc_letters(report::guid_of_names({"b", "a"})),
  };
  EXPECT_EQ(all.size(), 4u);
  for (const std::string& one : all)
    EXPECT_THAT(one, testing::MatchesRegex("[0-3][0-9A-Za-z_$]{21}"));
  EXPECT_EQ(report::guid_of_names({"a", "b"}), report::guid_of_names({"a", "b"}));
  EXPECT_EQ(report::guid_of_names({"a"})[6] >> 4, 8);  // the version
}

}  // namespace
}  // namespace ifc_guid_test
