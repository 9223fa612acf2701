// What projects make of photometry beyond its table: TILT data and the interpolation.

#include "calc/base/units.h"
#include "calc/scene/installed_power.h"
#include "calc/scene/prepared_scene.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace calc::project_photometry_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::load;

std::string ies_with(const std::string& tilt) {
  std::string text = tests::kSpotIes;
  return text.replace(text.find("TILT=NONE"), 9, tilt);
}

// A metal halide lamp, upright in a luminaire that points down: less light where it is tilted.
const std::string kTiltFile = "1\n3\n0 45 90\n1 0.8 0.5\n";

MemoryFileReader project_with_lamp(const std::string& tilt, const std::string& luminaires) {
  MemoryFileReader files = tests::project_files(tests::in_project(
      "<luminaire-type id=\"lamp\" photometry=\"ies/lamp.ies\"/>\n"
      "<room id=\"r\" size=\"4 3 2.5\" ceiling=\"white\" walls=\"white\" floor=\"white\">\n" +
      luminaires + "<plane id=\"task\" height=\"0.75\"/></room>"));
  files.add("dir/ies/lamp.ies", ies_with(tilt));
  return files;
}

const std::string kLuminaires =
    "<luminaire id=\"down\" type=\"lamp\" position=\"1 1.5 2\"/>\n"
    "<luminaire id=\"tilted\" type=\"lamp\" position=\"2 1.5 2\" axis=\"1 0 -1\"/>\n"
    "<luminaire id=\"level\" type=\"lamp\" position=\"3 1.5 2\" axis=\"0 1 0\"/>\n";

TEST(ProjectPhotometry, ATiltFileBesideThePhotometryDimsTiltedLuminaires) {
  MemoryFileReader files = project_with_lamp("TILT=MH.TLT", kLuminaires);
  files.add("dir/ies/MH.TLT", kTiltFile);
  const tests::Loaded loaded = load(files);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_EQ(loaded.messages, "");
  std::vector<std::string> inputs;
  for (const InputFile& input : loaded.project->inputs) inputs.push_back(input.path);
  EXPECT_THAT(inputs, Contains("ies/MH.TLT")) << "hashed like any other input";
  const PreparedScene scene = prepare_scene(*loaded.project, loaded.project->spaces[0]);
  ASSERT_EQ(scene.luminaires.size(), 3u);
  EXPECT_NEAR(scene.luminaires[0].flux_scale, 1.0, 1e-12);
  EXPECT_NEAR(scene.luminaires[1].flux_scale, 0.8, 1e-12);
  EXPECT_NEAR(scene.luminaires[2].flux_scale, 0.5, 1e-12);
}

// The table holds the factor of tilt 0, which must not count twice.
TEST(ProjectPhotometry, TheFactorIsRelativeToThatOfTheTable) {
  MemoryFileReader files = project_with_lamp("TILT=MH.TLT", kLuminaires);
  files.add("dir/ies/MH.TLT", "1\n3\n0 45 90\n0.5 0.8 1\n");
  const tests::Loaded loaded = load(files);
  const PreparedScene scene = prepare_scene(*loaded.project, loaded.project->spaces[0]);
  EXPECT_NEAR(scene.luminaires[1].flux_scale, 1.6, 1e-12);
  const double nadir_cd = scene.luminaires[1].web->intensity_cd(0.0, 0.0);
  EXPECT_NEAR(nadir_cd * scene.luminaires[1].flux_scale, 80.0, 1e-9);
}

TEST(ProjectPhotometry, AMissingTiltFileIsAnErrorWithItsName) {
  const tests::Loaded loaded = load(project_with_lamp("TILT=MH.TLT", kLuminaires));
  EXPECT_FALSE(loaded.project);
  EXPECT_THAT(loaded.messages, HasSubstr("error[file-not-readable]"));
  EXPECT_THAT(loaded.messages, HasSubstr("dir/ies/MH.TLT"));
  EXPECT_THAT(loaded.messages, HasSubstr("dir/ies/lamp.ies:6: error[photometry-tilt-file]"));
}

TEST(ProjectPhotometry, ATiltFileElsewhereIsNotLookedFor) {
  MemoryFileReader files = project_with_lamp("TILT=../MH.TLT", kLuminaires);
  files.add("dir/MH.TLT", kTiltFile);
  const tests::Loaded loaded = load(files);
  EXPECT_FALSE(loaded.project);
  EXPECT_THAT(loaded.messages, HasSubstr("error[photometry-tilt-file-name]"));
  EXPECT_EQ(files.reads("dir/MH.TLT"), 0);
}

TEST(ProjectPhotometry, TiltsBeyondTheDataGetTheNearestFactorAndAWarning) {
  MemoryFileReader files = project_with_lamp("TILT=MH.TLT", kLuminaires);
  files.add("dir/ies/MH.TLT", "1\n2\n0 60\n1 0.7\n");
  const tests::Loaded loaded = load(files);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_THAT(loaded.messages,
              HasSubstr("warning[photometry-tilt-outside]: luminaire 'level': the lamp is tilted "
                        "by 90 degrees, but the tilt data of its photometry cover 0 to 60; the "
                        "nearest factor, 0.7, is used"));
  EXPECT_THAT(loaded.messages, Not(HasSubstr("'tilted'")));
  const PreparedScene scene = prepare_scene(*loaded.project, loaded.project->spaces[0]);
  EXPECT_NEAR(scene.luminaires[2].flux_scale, 0.7, 1e-12);
}

TEST(ProjectPhotometry, CubicInterpolationIsAChoiceOfTheType) {
  const MemoryFileReader files = tests::project_files(tests::in_project(
      "<luminaire-type id=\"cubic\" photometry=\"spot.ies\" interpolation=\"cubic\"/>"));
  const tests::Loaded loaded = load(files);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_EQ(files.reads("dir/spot.ies"), 1);
  const auto half_way_cd = [&](std::size_t type) {
    return loaded.project->webs[loaded.project->luminaire_types[type].web].intensity_cd(0.0,
                                                                                        0.25 * kPi);
  };
  EXPECT_DOUBLE_EQ(half_way_cd(0), 50.0);
  // From 100 cd with slope 0 at nadir to 0 with the secant's slope at 90 degrees.
  EXPECT_NEAR(half_way_cd(1), 62.5, 1e-9);
}

LuminaireType lamp_type(const std::string& attributes, const std::string& packages) {
  MemoryFileReader files = tests::project_files(tests::in_project(
      "<luminaire-type id=\"lamp\" photometry=\"ies/lamp.ies\"" + attributes + ">" + packages +
      "</luminaire-type>\n"
      "<room id=\"r\" size=\"4 3 2.5\" ceiling=\"white\" walls=\"white\" floor=\"white\">"
      "<luminaire id=\"a\" type=\"lamp\" position=\"1 1.5 2\"/>"
      "<plane id=\"task\" height=\"0.75\"/></room>"));
  files.add("dir/ies/lamp.ies", tests::kSpotIes);
  const tests::Loaded loaded = load(files);
  EXPECT_TRUE(loaded.project) << loaded.messages;
  return loaded.project ? loaded.project->luminaire_types.back() : LuminaireType{};
}

// The file of a shorter luminaire, by another flux: its 12 W are not those of this one.
TEST(ProjectPhotometry, AnotherFluxPutsThePowerOfTheFileAside) {
  Project project;
  project.luminaire_types.push_back(lamp_type(" flux-lm=\"150\"", ""));
  Space space;
  space.luminaires.resize(2);
  const InstalledPower power = installed_power(project, space);
  EXPECT_EQ(power.without_power, 2);
  EXPECT_EQ(power.of_other_flux, 2);
  EXPECT_EQ(power.problem(),
            "2 of 2 luminaires have no stated power. The photometry of 2 states it for another "
            "flux than the project's; state it in the project (power-w)");
}

// The chosen package has the say, and nothing hangs on the others.
TEST(ProjectPhotometry, APackageStandsForFluxPowerAndPrice) {
  const std::string packages =
      "<package article=\"low\" flux-lm=\"50\" power-w=\"5\"/>"
      "<package article=\"a &amp; b\" flux-lm=\"150\" power-w=\"15\" price=\"20\"/>";
  const LuminaireType plain = lamp_type(" price=\"8\"", "");
  const LuminaireType unchosen = lamp_type(" price=\"8\"", packages);
  EXPECT_EQ(unchosen.flux_scale, plain.flux_scale);
  EXPECT_EQ(unchosen.power_w, plain.power_w);
  EXPECT_EQ(unchosen.price, 8.0);
  ASSERT_EQ(unchosen.packages.size(), 2u);
  EXPECT_FALSE(unchosen.package);
  const LuminaireType chosen = lamp_type(" price=\"8\" package=\"a &amp; b\"", packages);
  const LuminaireType by_hand = lamp_type(" flux-lm=\"150\" power-w=\"15\"", "");
  EXPECT_EQ(chosen.flux_scale, by_hand.flux_scale);
  EXPECT_NE(chosen.flux_scale, plain.flux_scale);
  EXPECT_EQ(chosen.power_w, 15.0);
  EXPECT_EQ(chosen.file_power_w, plain.file_power_w);
  EXPECT_EQ(chosen.price, 20.0);
  EXPECT_EQ(chosen.package, 1u);
  EXPECT_EQ(lamp_type(" price=\"8\" package=\"low\"", packages).price, 8.0)
      << "without one of its own";
}

}  // namespace
}  // namespace calc::project_photometry_test
