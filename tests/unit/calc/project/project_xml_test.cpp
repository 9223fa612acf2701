#include "calc/project/project_xml.h"

#include "calc/base/file_hash.h"
#include "calc/scene/installed_price.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace calc::tests::project_xml_test {
namespace {

TEST(ProjectXml, ReportsAMissingProjectFile) {
  Diagnostics diagnostics;
  EXPECT_FALSE(load_project(MemoryFileReader(), "dir/p.xml", diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(format_diagnostic(diagnostics.all()[0]),
            "dir/p.xml: error[file-not-readable]: cannot read 'dir/p.xml': "
            "No such file or directory");
}

TEST(ProjectXml, ReadsNameMaterialsAndTypes) {
  const Loaded loaded = load(
      "<luxgate version='1' name='Office &amp; hall'>"
      "<material id='white' reflectance='0.7'/><material id='dark' reflectance='5e-2'/>"
      "<luminaire-type id='t' photometry='spot.ies' llmf='0.9' rsmf='0.5'/>"
      "<luminaire-type id='s' photometry='spot.ies' maintenance-factor='0.8' power-w='7'/>"
      "</luxgate>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const Project& project = *loaded.project;
  EXPECT_EQ(project.path, "dir/p.xml");
  EXPECT_EQ(project.name, "Office & hall");
  ASSERT_EQ(project.materials.size(), 2u);
  EXPECT_EQ(project.materials[1].id, "dark");
  EXPECT_DOUBLE_EQ(project.materials[1].reflectance, 0.05);
  ASSERT_EQ(project.luminaire_types.size(), 2u);
  const LuminaireType& parts = project.luminaire_types[0];
  EXPECT_DOUBLE_EQ(parts.maintenance.product, 0.45);
  EXPECT_EQ(parts.maintenance.llmf, 0.9);
  EXPECT_FALSE(parts.maintenance.lsf);
  EXPECT_DOUBLE_EQ(parts.power_w, 12.0);  // of the file
  EXPECT_DOUBLE_EQ(parts.flux_scale, 1.0);
  const LuminaireType& single = project.luminaire_types[1];
  EXPECT_DOUBLE_EQ(single.maintenance.product, 0.8);
  EXPECT_FALSE(single.maintenance.llmf);
  EXPECT_DOUBLE_EQ(single.power_w, 7.0);
}

// The file's watts are those of the file's light.
TEST(ProjectXml, OtherLightNeedsItsOwnPower) {
  const auto power_with = [](const std::string& attributes) {
    const Loaded loaded =
        load("<luxgate version='1'><luminaire-type id='t' photometry='spot.ies' " + attributes +
             "/><luminaire id='l' type='t' position='0 0 3'/><plane id='p' origin='0 0 0' u='1 0 "
             "0' v='0 "
             "1 0'/></luxgate>");
    EXPECT_TRUE(loaded.project) << loaded.messages;
    return loaded.project ? loaded.project->luminaire_types.at(0).power_w : -1.0;
  };
  EXPECT_EQ(power_with(""), 12.0);
  EXPECT_EQ(power_with("flux-lm='8000'"), 0.0);
  EXPECT_EQ(power_with("flux-lm='8000' power-w='30'"), 30.0);
}

// What is not stated is no price of 0.
TEST(ProjectXml, SumsThePricesOfLuminaires) {
  const Loaded loaded = load(
      "<luxgate version='1'><material id='m' reflectance='0.7'/>"
      "<luminaire-type id='a' photometry='spot.ies' price='89.9'/>"
      "<luminaire-type id='b' photometry='spot.ies'/>"
      "<luminaire-type id='c' photometry='spot.ies' price='0'/>"
      "<luminaire id='1' type='a' position='0 0 3'/><luminaire id='2' type='a' position='1 0 3'/>"
      "<luminaire id='3' type='b' position='2 0 3'/><luminaire id='4' type='c' position='3 0 3'/>"
      "<quad id='5' origin='0 0 3' u='0 1 0' v='1 0 0' material='m' luminous-exitance='800' "
      "price='700'/><plane id='p' origin='0 0 0' u='1 0 0' v='0 1 0'/></luxgate>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const InstalledPrice sum = installed_price(*loaded.project, loaded.project->spaces.at(0));
  EXPECT_DOUBLE_EQ(sum.price, 2 * 89.9 + 700);
  EXPECT_EQ(sum.luminaires, 5);
  EXPECT_EQ(sum.without_price, 1);
  EXPECT_NE(load(in_project("<luminaire-type id='t' photometry='spot.ies' price='-1'/>"))
                .messages.find("attribute 'price' of <luminaire-type>: -1 is not allowed; expected "
                               "a number from 0 to 1e9"),
            std::string::npos);
}

TEST(ProjectXml, MaintenanceIsOneIfNotGiven) {
  const Loaded loaded = load(in_room(""));
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_DOUBLE_EQ(loaded.project->luminaire_types[0].maintenance.product, 1.0);
}

TEST(ProjectXml, FluxOverrideScalesTheWeb) {
  const Loaded loaded =
      load(in_project("<luminaire-type id='t' photometry='spot.ies' flux-lm='250'/>"));
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const Project& project = *loaded.project;
  const LuminaireType& type = project.luminaire_types[1];
  EXPECT_NEAR(type.flux_scale * project.webs[type.web].flux_lm(), 250.0, 1.0e-9);
}

TEST(ProjectXml, ReadsEachPhotometryFileOnce) {
  const MemoryFileReader files =
      project_files(in_project("<luminaire-type id='t' photometry='./spot.ies'/>"));
  const Loaded loaded = load(files);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_EQ(loaded.project->webs.size(), 1u);
  EXPECT_EQ(loaded.project->luminaire_types[1].web, 0u);
  EXPECT_EQ(files.reads("dir/spot.ies"), 1);
}

TEST(ProjectXml, OneFileMayGiveSeveralLights) {
  const Loaded loaded = load(
      in_project("<luminaire-type id='a' photometry='two.ldt' lamp-set='2'/>"
                 "<luminaire-type id='b' photometry='two.ldt' lamp-set='1'/>"
                 "<luminaire-type id='c' photometry='two.ldt' lamp-set='2' opening='point'/>"
                 "<luminaire-type id='d' photometry='two.ldt' lamp-set='2'/>"
                 "<luminaire-type id='e' photometry='two.xml' emitter='led'/>"
                 "<luminaire-type id='f' photometry='two.gldf' variant='up'/>"
                 "<luminaire-type id='g' photometry='two.gldf' variant='down' emitter='e1'/>"));
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_EQ(loaded.messages.find("photometry-lamp-sets"), std::string::npos) << loaded.messages;
  const Project& project = *loaded.project;
  const auto flux_lm = [&](std::size_t type) {
    return project.webs[project.luminaire_types[type].web].flux_lm();
  };
  EXPECT_NEAR(flux_lm(1), 1200.0, 1.5);
  EXPECT_NEAR(flux_lm(2), 1000.0, 1.5);
  EXPECT_EQ(flux_lm(3), flux_lm(1));
  EXPECT_EQ(project.luminaire_types[4].web, project.luminaire_types[1].web);
  EXPECT_NE(project.luminaire_types[3].web, project.luminaire_types[1].web);
  EXPECT_EQ(project.webs[project.luminaire_types[3].web].opening().shape, OpeningShape::point);
  EXPECT_NEAR(flux_lm(5), 100.0 * kPi, 0.5);
  EXPECT_NEAR(flux_lm(6), 100.0 * kPi, 0.5);
  EXPECT_NEAR(flux_lm(7), 1000.0, 1.5);
  EXPECT_EQ(project.inputs.size(), 5u);  // the project, spot.ies and each of the three once
}

TEST(ProjectXml, OpeningPointDropsTheOpeningButNotTheLight) {
  std::string ies = kSpotIes;
  ies.replace(ies.find("2 0 0 0"), 7, "2 .5 1 0");  // metres: 0.5 wide, 1 long
  for (const bool point_first : {true, false}) {
    const std::string point = "<luminaire-type id='p' photometry='a.ies' opening='point'/>";
    const std::string file = "<luminaire-type id='f' photometry='a.ies' opening='file'/>";
    MemoryFileReader files = project_files(
        "<luxgate version='1'>" + (point_first ? point + file : file + point) + "</luxgate>");
    files.add("dir/a.ies", ies);
    const Loaded loaded = load(files);
    ASSERT_TRUE(loaded.project) << loaded.messages;
    const Project& project = *loaded.project;
    const std::size_t p = project.luminaire_types[point_first ? 0 : 1].web;
    const std::size_t f = project.luminaire_types[point_first ? 1 : 0].web;
    EXPECT_EQ(project.webs[p].opening().shape, OpeningShape::point);
    EXPECT_EQ(project.webs[f].opening().shape, OpeningShape::rectangle);
    EXPECT_DOUBLE_EQ(project.webs[p].flux_lm(), project.webs[f].flux_lm());
    EXPECT_EQ(project.inputs.size(), 2u);
  }
}

TEST(ProjectXml, RecordsEveryFileOnceWithItsHash) {
  const std::string xml = in_room(
      "<mesh id='m' file='table.obj' units='m' up='z' material='white'/>"
      "<mesh id='n' file='table.obj' units='m' up='z' position='1 1 0' material='white'/>"
      "<plane id='p' file='points.csv'/>");
  const Loaded loaded = load(xml);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const std::vector<InputFile>& inputs = loaded.project->inputs;
  ASSERT_EQ(inputs.size(), 4u);
  EXPECT_EQ(inputs[0].path, "dir/p.xml");
  EXPECT_EQ(inputs[0].sha256, sha256_hex(xml));
  EXPECT_EQ(inputs[1].path, "spot.ies");
  EXPECT_EQ(inputs[1].sha256, sha256_hex(kSpotIes));
  EXPECT_EQ(inputs[2].path, "table.obj");
  EXPECT_EQ(inputs[3].path, "points.csv");
}

TEST(ProjectXml, ReadsScenes) {
  const Loaded loaded =
      load(in_room("").insert(22,
                              "<scene id='night'><dim group='row' level='0.25'/></scene>"
                              "<scene id='full'/>"));
  ASSERT_TRUE(loaded.project) << loaded.messages;
  ASSERT_EQ(loaded.project->scenes.size(), 2u);
  const LightScene& night = loaded.project->scenes[0];
  EXPECT_EQ(night.id, "night");
  ASSERT_EQ(night.level_of_group.size(), 1u);
  EXPECT_EQ(night.level_of_group[0].first, "row");
  EXPECT_DOUBLE_EQ(night.level_of_group[0].second, 0.25);
}

TEST(ProjectXml, ConvertsAllUnits) {
  const struct {
    const char* name;
    double metres;
  } units[] = {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}};
  for (const auto& unit : units) {
    const Loaded loaded = load("<luxgate version='1' units='" + std::string(unit.name) +
                               "'><material id='m' reflectance='0.5'/>"
                               "<quad id='q' origin='1 2 3' u='4 0 0' v='0 5 0' material='m'/>"
                               "</luxgate>");
    ASSERT_TRUE(loaded.project) << loaded.messages;
    const glm::dvec3 corner = loaded.project->spaces.at(0).bodies.at(0).vertex_m.at(2);
    EXPECT_DOUBLE_EQ(corner.x, 5.0 * unit.metres) << unit.name;
    EXPECT_DOUBLE_EQ(corner.y, 7.0 * unit.metres) << unit.name;
    EXPECT_DOUBLE_EQ(corner.z, 3.0 * unit.metres) << unit.name;
  }
}

TEST(ProjectXml, ReportsAllProblemsInOneRun) {
  const Loaded loaded = load(in_project(
      "<material id='a' reflectance='2'/>\n<box id='b' size='1 1 -1' material='c'/>\n<plane/>"));
  EXPECT_FALSE(loaded.project);
  EXPECT_EQ(std::count(loaded.messages.begin(), loaded.messages.end(), '\n') + 1, 5)
      << loaded.messages;  // reflectance, size, material c, plane without id, plane without form
}

TEST(ProjectXml, DoesNotReportWhatFollowsFromAnEarlierError) {
  const Loaded loaded = load(
      in_project("<material id='a' reflectance='2'/>\n<box id='b' size='1 1 0' material='a'/>\n"
                 "<luminaire-type id='t' photometry='none.ies'/>\n<luminaire-type id='s' "
                 "photometry='none.ies'/>\n"
                 "<luminaire id='l' type='t' position='0 0 0' axis='0 0 0' group='g'/>\n"
                 "<scene id='s'><dim group='g' level='1'/></scene>\n"
                 "<plane id='p' on-top-of='b'/>"));
  EXPECT_EQ(std::count(loaded.messages.begin(), loaded.messages.end(), '\n') + 1, 4)
      << loaded.messages;  // reflectance, none.ies once, size, axis
}

// Any prefix of a project is not a project; nothing may crash on the way.
TEST(ProjectXml, RefusesEveryTruncation) {
  const std::string xml = in_room("<box id='b' size='1 1 1' material='white'/>");
  const std::size_t end = xml.find("</luxgate>") + 10;
  for (std::size_t length = 0; length < end; ++length) {
    EXPECT_FALSE(load(xml.substr(0, length)).project) << length;
  }
}

}  // namespace
}  // namespace calc::tests::project_xml_test
