// <energy> and what it makes of installed power: LENI by hand.

#include "calc/scene/installed_power.h"
#include "calc/scene/lighting_energy.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <string>

namespace calc::tests::energy_xml_test {
namespace {

// A room of 4 x 3 m with luminaires of 12 W in the groups "row" (of in_room()) and "other" (two).
Loaded load_energy(const std::string& attributes, const std::string& parts = "") {
  return load(in_room("<energy " + attributes + ">" + parts +
                      "</energy><luminaire-line id='m' type='spot' from='0 1 2.4' to='4 1 2.4' "
                      "count='2' group='other'/>"));
}

LightingEnergy energy_of(const Loaded& loaded) {
  EXPECT_TRUE(loaded.project) << loaded.messages;
  if (!loaded.project) return {};
  const Space& space = loaded.project->spaces.at(0);
  return lighting_energy(*loaded.project, space, installed_power(*loaded.project, space));
}

void expect_message(const std::string& attributes, const std::string& parts,
                    const std::string& message) {
  const Loaded loaded = load_energy(attributes, parts);
  EXPECT_FALSE(loaded.project);
  EXPECT_NE(loaded.messages.find(message), std::string::npos) << loaded.messages;
}

TEST(LightingEnergy, IsPowerByHoursAndFactors) {
  // 36 W 0.9 (2000 h 0.8 0.75 + 500 h 0.8) = 36 W 1440 h = 51.84 kWh; / 12 m2 + 2.5 = 6.82.
  const LightingEnergy energy =
      energy_of(load_energy("day-hours='2000' night-hours='500' occupancy='0.8' daylight='0.75' "
                            "constant-illuminance='0.9' parasitic-kwh-m2='2.5'"));
  EXPECT_EQ(energy.problem, "");
  EXPECT_NEAR(energy.lighting_kwh, 51.84, 1e-12);
  EXPECT_NEAR(energy.leni_kwh_m2, 6.82, 1e-12);
  EXPECT_EQ(energy.words,
            "by EN 15193, stated, not calculated: 2000 h by day, 500 h by night, Fc 0.9, Fo 0.8, "
            "FD 0.75, parasitic energy 2.5 kWh/m²/a");
}

TEST(LightingEnergy, FactorsThatNobodyStatesAreOneAndNamed) {
  // 36 W 3000 h = 108 kWh; / 12 m2 = 9.
  const LightingEnergy energy =
      energy_of(load_energy("day-hours='2500' night-hours='500' parasitic-kwh-m2='0'"));
  EXPECT_NEAR(energy.leni_kwh_m2, 9.0, 1e-12);
  EXPECT_EQ(energy.words,
            "by EN 15193, stated, not calculated: 2500 h by day, 500 h by night, Fc 1 (not "
            "stated), Fo 1 (not stated), FD 1 (not stated), parasitic energy 0 kWh/m²/a");
}

TEST(LightingEnergy, GroupsHaveFactorsOfTheirOwn) {
  // row: 12 W (1000 h 0.5 0.4 + 1000 h 0.5) = 12 W 700 h = 8.4 kWh; other: 24 W 0.9 (1000 h 0.8 +
  // 1000 h) = 24 W 1620 h = 38.88 kWh; sum / 12 m2 = 3.94.
  const LightingEnergy energy = energy_of(
      load_energy("day-hours='1000' night-hours='1000' daylight='0.8' parasitic-kwh-m2='0'",
                  "<part group='row' occupancy='0.5' daylight='0.4'/>"
                  "<part group='other' constant-illuminance='0.9'/>"));
  EXPECT_NEAR(energy.leni_kwh_m2, 3.94, 1e-12);
  EXPECT_NE(energy.words.english().find(
                "FD 0.8, group row: Fo 0.5 FD 0.4, group other: Fc 0.9, parasitic"),
            std::string::npos)
      << energy.words;
}

TEST(LightingEnergy, IsOfTheRoomFirstAndThenOfTheProject) {
  const std::string room =
      "' size='2 2 2' ceiling='white' walls='white' floor='white'><luminaire id='l' type='spot' "
      "position='1 1 1.9'/><plane id='";
  const Loaded loaded = load(
      in_project("<energy day-hours='100' night-hours='0' parasitic-kwh-m2='0'/><room id='a" +
                 room + "p' height='1'/></room><room id='b" + room +
                 "q' height='1'/><energy day-hours='0' night-hours='300' parasitic-kwh-m2='1'/>"
                 "</room><luminaire id='o' type='spot' position='9 9 1'/>"));
  ASSERT_TRUE(loaded.project) << loaded.messages;
  ASSERT_EQ(loaded.project->spaces.size(), 3u);
  EXPECT_EQ(loaded.project->spaces[0].energy.value().day_h, 100.0);
  EXPECT_EQ(loaded.project->spaces[1].energy.value().night_h, 300.0);
  EXPECT_FALSE(loaded.project->spaces[2].energy);  // the open space has no floor area
  const Space& b = loaded.project->spaces[1];
  // 12 W 300 h / 4 m2 + 1
  EXPECT_NEAR(lighting_energy(*loaded.project, b, installed_power(*loaded.project, b)).leni_kwh_m2,
              1.9, 1e-12);
}

TEST(LightingEnergy, NeedsHoursAndPower) {
  const LightingEnergy without = energy_of(load(in_room("")));
  EXPECT_EQ(without.problem,
            "hours of use and parasitic energy are not stated; add an <energy> to the room or "
            "the project");
  EXPECT_EQ(without.leni_kwh_m2, 0.0);
  Loaded loaded = load_energy("day-hours='100' night-hours='0' parasitic-kwh-m2='0'");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  for (LuminaireType& type : loaded.project->luminaire_types) type.power_w = 0.0;
  const LightingEnergy dark = energy_of(loaded);
  EXPECT_NE(dark.problem.english().find("3 of 3 luminaires have no stated power"),
            std::string::npos);
  EXPECT_EQ(dark.words, "");
}

TEST(EnergyXml, NothingIsTakenForGranted) {
  expect_message("day-hours='100' night-hours='0'", "", "needs the attribute 'parasitic-kwh-m2'");
  expect_message("night-hours='0' parasitic-kwh-m2='0'", "", "needs the attribute 'day-hours'");
  expect_message("day-hours='100' night-hours='0' parasitic-kwh-m2='0' daylight='1.1'", "",
                 "a number above 0, up to 1");
}

TEST(EnergyXml, AYearHas8760Hours) {
  const std::string words = "more than 0 and at most 8760, one year";
  expect_message("day-hours='8000' night-hours='761' parasitic-kwh-m2='0'", "", words);
  expect_message("day-hours='0' night-hours='0' parasitic-kwh-m2='0'", "", words);
  expect_message("day-hours='9000' night-hours='0' parasitic-kwh-m2='0'", "",
                 "a number from 0 to 8760");
  EXPECT_TRUE(load_energy("day-hours='8000' night-hours='760' parasitic-kwh-m2='0'").project);
}

TEST(EnergyXml, PartsAreOfGroupsThatAreThere) {
  const std::string hours = "day-hours='1' night-hours='1' parasitic-kwh-m2='0'";
  expect_message(hours, "<part group='rows' daylight='0.5'/>",
                 "there is no luminaire with the dimming group 'rows'");
  expect_message(hours, "<part group='row' daylight='0.5'/><part group='row' occupancy='0.5'/>",
                 "the dimming group 'row' is given twice");
  expect_message(hours, "<part group='row'/>", "<part> needs 'occupancy', 'daylight' or");
}

TEST(EnergyXml, ThereIsOne) {
  const std::string one = "<energy day-hours='1' night-hours='1' parasitic-kwh-m2='0'/>";
  const Loaded room = load(in_room(one + "\n" + one));
  EXPECT_NE(room.messages.find("the energy of 'r' is given twice, also in line 5"),
            std::string::npos)
      << room.messages;
  const Loaded project = load(in_project(one + one));
  EXPECT_NE(project.messages.find("the energy of 'the project' is given twice"), std::string::npos)
      << project.messages;
}

}  // namespace
}  // namespace calc::tests::energy_xml_test
