// <building>: which rooms it is about.

#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::tests::building_xml_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string room(const std::string& id) {
  return "<room id='" + id + "' size='4 3 2.5' floor='m' ceiling='m' walls='m'/>";
}

Loaded load_building(const std::string& buildings) {
  return load("<luxgate version='1'><material id='m' reflectance='0.5'/>" + room("a-1") +
              room("a-2") + room("b-10") +
              "<luminaire-type id='s' photometry='spot.ies'/><road id='r' width='7' lanes='2' "
              "spacing='30' surface='R3'><luminaire-row id='h' type='s' side='right' "
              "height='9'/></road>" +
              buildings + "<plane id='outside' origin='0 -9 0' u='1 0 0' v='0 1 0'/></luxgate>");
}

std::vector<std::size_t> rooms_like(const std::string& patterns) {
  const Loaded loaded =
      load_building("<building id='B' rooms='" + patterns + "'><require/></building>");
  EXPECT_TRUE(loaded.project) << loaded.messages;
  return loaded.project ? loaded.project->buildings.at(0).rooms : std::vector<std::size_t>{};
}

TEST(Building, HasRoomsThatAreLikeItsPatternsEachOnce) {
  EXPECT_THAT(rooms_like("a-1"), ElementsAre(0));
  EXPECT_THAT(rooms_like("b-10 a-1 a-1"), ElementsAre(0, 2));
  EXPECT_THAT(rooms_like("a-*"), ElementsAre(0, 1));
  EXPECT_THAT(rooms_like("?-1 *2"), ElementsAre(0, 1));
  EXPECT_THAT(rooms_like("*-1*"), ElementsAre(0, 2));
  EXPECT_THAT(rooms_like("**"), ElementsAre(0, 1, 2));
}

// Neither a road nor what is outside.
TEST(Building, WithoutPatternsIsAllRooms) {
  const Loaded loaded =
      load_building("<building id='B' was='A' name='House'><require/></building>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const Building& building = loaded.project->buildings.at(0);
  EXPECT_THAT(building.rooms, ElementsAre(0, 1, 2));
  EXPECT_EQ(building.id, "B");
  EXPECT_EQ(building.was, "A");
  EXPECT_EQ(building.name, "House");
}

// What is misspelt must not make the question easier.
TEST(Building, RefusesWhatIsLikeNoRoom) {
  for (const char* wrong : {"c-*", "a-?0", "a-1 A-2", "r", "site", "a-1,a-2", "[a]-1"}) {
    const Loaded loaded = load_building("<building id='B' rooms='" + std::string(wrong) + "'/>");
    EXPECT_FALSE(loaded.project) << wrong;
    EXPECT_THAT(loaded.messages, HasSubstr("attribute 'rooms' of <building>: there is no room '"));
  }
  EXPECT_THAT(load_building("<building id='B' rooms=' '/>").messages,
              HasSubstr("the id of a room in 'rooms'"));
  EXPECT_THAT(load_building("<building id='B'/><building id='B'/>").messages,
              HasSubstr("the building 'B' is given twice"));
  EXPECT_THAT(load_building("<building id='B'/><building id='C' was='B'/>").messages,
              HasSubstr("'B'"));
}

TEST(Building, NeedsARoom) {
  const Loaded loaded = load(
      "<luxgate version='1'><building id='B'/><plane id='p' origin='0 0 0' u='1 0 0' v='0 1 "
      "0'/></luxgate>");
  EXPECT_THAT(loaded.messages, HasSubstr("at least one room in the project"));
}

// A line for each room in each finding: of what a file of this size asks for, too much.
TEST(Building, RoomsTimesRequirementsAreWithinTheBudget) {
  std::string requires_many;
  for (int i = 0; i < 200; ++i) requires_many += "<require/>";
  const std::string xml = "<luxgate version='1'><material id='m' reflectance='0.5'/>" +
                          room("a-1") + room("a-2") + room("b-10") + "<building id='B'>" +
                          requires_many + "</building></luxgate>";
  const auto read_within = [&](double bytes) {
    Diagnostics diagnostics;
    Budget budget;
    budget[BudgetOf::memory] = bytes;
    const auto read = read_project(project_files(xml), "dir/p.xml", diagnostics, budget);
    return read && read->is_good;
  };
  EXPECT_TRUE(read_within(4.0e6));
  EXPECT_FALSE(read_within(2.0e6));
}

// Many stars, for which some matchers would not end.
TEST(Building, PatternsOfStrangersEnd) {
  std::string hostile;
  for (int i = 0; i < 400; ++i) hostile += "*a";
  const Loaded loaded = load("<luxgate version='1'><material id='m' reflectance='0.5'/>" +
                             room(std::string(60, 'a') + "b") + "<building id='B' rooms='" +
                             hostile + "c'/></luxgate>");
  EXPECT_FALSE(loaded.project);
}

}  // namespace
}  // namespace calc::tests::building_xml_test
