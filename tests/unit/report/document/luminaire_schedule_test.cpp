#include "report/document/luminaire_schedule.h"
#include "report/text/schedule_words.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <limits>
#include <vector>

namespace report::luminaire_schedule_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

LuminaireRow type(const std::string& id, int count, double flux_lm, double power_w) {
  LuminaireRow row;
  row.type_id = id;
  row.count = count;
  row.flux_lm = flux_lm;
  row.power_w = power_w;
  return row;
}

// Rooms 1 to 5 with a luminaire 'a' each, at heights of 2.5 m and more; 'b' at 8 m over a road.
ProjectPart project() {
  ProjectPart part = small_document().projects[0];
  part.luminaires = {type("a", 5, 1000, 10), type("idle", 0, 1, 0), type("b", 3, 5000, 50)};
  SpacePart room = part.spaces[0], road = room;
  room.footprint_m = {{0, 0}, {4, 0}, {4, 4}};
  room.floor_z_m = 1.0;
  part.spaces.clear();
  for (int i = 1; i <= 5; ++i) {
    room.name = fmt::format("room {}", i);
    room.luminaires = {{{1, 1, 3.5 + 0.1 * i}, "a"}};
    part.spaces.push_back(room);
  }
  road.footprint_m.clear();
  road.name = "Road";
  road.luminaires.assign(3, {{0, 0, 8}, "b"});
  road.power = {50.0, 0.0, 1, 0};
  part.spaces.push_back(road);
  return part;
}

TEST(LuminaireSchedule, HasWhatIsUsedAndNamesTheRest) {
  const ProjectPart part = project();
  const LuminaireSchedule schedule = schedule_of(part);
  ASSERT_EQ(schedule.used.size(), 2u);
  EXPECT_EQ(schedule.used[0].position, "A");
  EXPECT_EQ(schedule.used[1].position, "C");  // as plans call it, which may show the others
  EXPECT_EQ(schedule.used[0].spaces.size(), 5u);
  EXPECT_EQ(rooms_words({}, schedule.used[0]), "room 1, room 2 and 3 more");
  EXPECT_EQ(mounting_words({}, schedule.used[0]), "2.60 m to 3.00 m");
  EXPECT_EQ(mounting_words({}, schedule.used[1]), "8.00 m above z = 0");
  EXPECT_EQ(schedule.totals.count, 8);
  EXPECT_EQ(schedule.totals.flux_lm, 20000);
  EXPECT_EQ(schedule.totals.power_w, 200);
  EXPECT_TRUE(schedule.totals.is_power_known);
  EXPECT_THAT(schedule_remarks({}, schedule),
              ElementsAre("In the project but not used, therefore not counted: B (idle).",
                          "Road: the calculation uses the 3 luminaires counted here. "
                          "The number for the road follows from its length: 1 for each spacing."));
}

// Readers compare the schedule with the makers' lists, and add up what they read.
TEST(LuminaireSchedule, TellsTheFluxThatTheFileStates) {
  LuminaireRow row = type("a", 33, 2632.16, 19.5);
  row.file_flux_lm = row.flux_lm;
  EXPECT_EQ(row.told_lm(), 2632.16);
  row.stated_flux_lm = 2630;
  EXPECT_EQ(row.told_lm(), 2630);
  EXPECT_EQ(totals_of(std::vector<LuminaireRow>{row}).flux_lm, 33 * 2630);
  row.flux_lm = 1500;  // by the project
  EXPECT_EQ(row.told_lm(), 1500);
  EXPECT_EQ(row.told_file_lm(), 2630);
  row.flux_lm = row.file_flux_lm;
  row.stated_flux_lm = 2900;  // no light that was calculated with
  EXPECT_EQ(row.told_lm(), 2632.16);
}

TEST(LuminaireTotals, SpacesAddUpToTheProject) {
  ProjectPart part = project();
  LuminaireTotals sum;
  for (const SpacePart& space : part.spaces) {
    const LuminaireTotals own = totals_in(part, space);
    sum.count += own.count;
    sum.flux_lm += own.flux_lm;
    sum.power_w += own.power_w;
  }
  EXPECT_EQ(sum.count, totals_of(part.luminaires).count);
  EXPECT_EQ(sum.flux_lm, totals_of(part.luminaires).flux_lm);
  EXPECT_EQ(sum.power_w, totals_of(part.luminaires).power_w);
  EXPECT_EQ(totals_elsewhere(part).count, 0);
  part.spaces.pop_back();
  EXPECT_EQ(totals_elsewhere(part).count, 3);
  EXPECT_EQ(totals_elsewhere(part).power_w, 150);
}

// Which scene is of emergencies is known by what is judged in it, not by its name.
TEST(LuminaireTotals, OfEmergencyAreThoseThatAllOtherScenesSwitchOff) {
  ProjectPart part = project();
  SpacePart& room = part.spaces[0];
  const std::size_t all = room.luminaires.size();
  for (LuminaireMark& mark : room.luminaires) mark.group = "em";
  part.scenes = {{"day", {{"em", 0.0}}}, {"battery", {{"em", 0.8}}}};
  EXPECT_EQ(totals_of_emergency(part, room).count, 0);  // nothing is judged in it
  rules::Finding finding;
  finding.requirement.scene = "battery";
  finding.requirement.state = rules::LightState::end_of_duration;
  room.planes.emplace_back().findings = {finding};
  EXPECT_EQ(totals_of_emergency(part, room).count, static_cast<std::int64_t>(all));
  part.scenes.push_back({"night", {}});  // lights them, too
  EXPECT_EQ(totals_of_emergency(part, room).count, 0);
  part.scenes = {{"battery", {{"em", 0.8}}}};  // nobody says that they are off
  EXPECT_EQ(totals_of_emergency(part, room).count, 0);
}

TEST(LuminaireTotals, HoldMoreThanAType) {
  LuminaireRow row;
  row.count = std::numeric_limits<int>::max();
  EXPECT_EQ(totals_of(std::vector<LuminaireRow>{row, row}).count, 2LL * row.count);
}

TEST(ScheduleWords, ColoursAreThoseThatFilesState) {
  LuminaireRow row;
  EXPECT_THAT(colour_temperature_words({}, row), IsEmpty());
  row.colour_temperature = "Unknown";
  EXPECT_THAT(colour_temperature_words({}, row), IsEmpty());
  row.colour_temperature = "5700";
  EXPECT_EQ(colour_temperature_words({}, row), "5700");
  row.colour_temperature = "2700-6500";
  EXPECT_EQ(colour_temperature_words({}, row), "2700-6500");
  row.colour_rendering = ">90";
  EXPECT_EQ(colour_rendering_words({}, row), "≥ 90");
  row.colour_rendering = "1B";
  EXPECT_EQ(colour_rendering_words({}, row), "80–89");
}

// The project's flux may be that of another lamp.
TEST(ScheduleWords, ColoursOfAnotherLightAreThoseOfTheFile) {
  LuminaireRow row;
  row.colour_rendering = "80";
  row.colour_temperature = "3000";
  row.file_flux_lm = 1800;
  row.flux_lm = 1801;
  EXPECT_EQ(colour_rendering_words({}, row), "80");
  EXPECT_FALSE(calc::is_other_flux(row.flux_lm, row.file_flux_lm));
  row.flux_lm = 1500;
  EXPECT_TRUE(calc::is_other_flux(row.flux_lm, row.file_flux_lm));
  EXPECT_TRUE(calc::is_other_flux(2100, row.file_flux_lm));
  EXPECT_EQ(colour_rendering_words({}, row), "80 (of the file)");
  EXPECT_EQ(colour_temperature_words({}, row), "3000 (of the file)");
  row.colour_rendering = "";
  EXPECT_EQ(colour_rendering_words({}, row), "");
  row.flux_lm = row.file_flux_lm;
  row.package = "L-930";
  EXPECT_EQ(colour_temperature_words({}, row), "3000 (of the file)");
}

}  // namespace
}  // namespace report::luminaire_schedule_test
