// Emitters of a GLDF product that shine together.

#include "calc/photometry/read/gldf.h"
#include "calc/photometry/read/l3d_model.h"
#include "calc/photometry/read/photometry_file.h"
#include "calc/project/project_xml.h"
#include "calc/scene/installed_power.h"
#include "calc/scene/installed_price.h"
#include "calc/scene/luminaire_sums.h"
#include "tests/support/gldf_samples.h"
#include "tests/support/memory_file_reader.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace calc::gldf_together_test {
namespace {

using test_support::GldfSample;
using test_support::zip_bytes;
using ::testing::HasSubstr;
using ::testing::Not;

std::string object(const std::string& name, const std::string& position,
                   const std::string& rotation) {
  return "<LightEmittingObjects><LightEmittingObject partName='" + name + "'><Position " +
         position + "/><Rotation " + rotation +
         "/><Circle diameter='0.1'/></LightEmittingObject></LightEmittingObjects>";
}

const std::string kZero = "x='0' y='0' z='0'";

// "down" at (1, 0, 2) and "up" at (1, 0, 3), turned over about x; the latter behind a joint.
std::string structure_xml(const std::string& up_name) {
  const std::string joint =
      "<Joints><Joint partName='j'><Position x='0' y='0' z='1'/><Rotation " + kZero +
      "/><DefaultRotation x='180' y='0' z='0'/><Geometries><Geometry partName='head'><Position " +
      kZero + "/><Rotation " + kZero + "/>" + object(up_name, kZero, kZero) +
      "</Geometry></Geometries></Joint></Joints>";
  return "<Luminaire><Structure><Geometry partName='base'><Position x='1' y='0' z='2'/>"
         "<Rotation " +
         kZero + "/>" + object("down", kZero, "x='0' y='0' z='90'") + joint +
         "</Geometry></Structure></Luminaire>";
}

std::string l3d(const std::string& up_name = "up") {
  return zip_bytes({{"structure.xml", structure_xml(up_name)}});
}

GldfSample two_emitters() {
  GldfSample sample;
  sample.files += "<File id='g' contentType='geo/l3d' type='localFileName'>body.l3d</File>";
  sample.light_sources =
      "<FixedLightSource id='s1'><RatedInputPower>10</RatedInputPower></FixedLightSource>"
      "<FixedLightSource id='s2'><RatedInputPower>30</RatedInputPower></FixedLightSource>";
  const auto emitter = [](const std::string& id, const std::string& source) {
    return "<Emitter id='" + id +
           "'><FixedLightEmitter><PhotometryReference photometryId='p1'/><LightSourceReference "
           "fixedLightSourceId='" +
           source + "'/></FixedLightEmitter></Emitter>";
  };
  sample.emitters = emitter("e1", "s1") + emitter("e2", "s2");
  sample.variants =
      "<Variant id='v1'><Geometry><ModelGeometryReference geometryId='body'><EmitterReference "
      "emitterId='e1'><EmitterObjectExternalName>down</EmitterObjectExternalName>"
      "</EmitterReference><EmitterReference emitterId='e2'><EmitterObjectExternalName>up"
      "</EmitterObjectExternalName></EmitterReference></ModelGeometryReference></Geometry>"
      "</Variant>";
  return sample;
}

const std::string kGeometries =
    "<Geometries><ModelGeometry id='body'><GeometryFileReference fileId='g'/></ModelGeometry>"
    "</Geometries>";

std::string gldf(const GldfSample& sample, const std::string& body = l3d()) {
  std::string product = product_xml(sample);
  product.insert(product.find("</GeneralDefinitions>"), kGeometries);
  return zip_bytes({{"product.xml", product},
                    {"ldc/a.ldt", test_support::ldt_text({})},
                    {"geo/body.l3d", body}});
}

struct Together {
  std::optional<LuminaireLight> light;
  std::string messages;
};

Together together(const std::string& bytes, const std::string& emitter = "all") {
  Diagnostics diagnostics;
  PhotometryOptions options;
  options.emitter = emitter;
  Together read;
  read.light = parse_luminaire_light(bytes, "a.gldf", diagnostics, options);
  read.messages = test_support::diagnostics_text(diagnostics);
  return read;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-12) << a.x << " " << a.y << " " << a.z;
}

TEST(L3dModel, JointsAndTurnsAddUp) {
  std::string problem;
  const auto places = read_l3d_places(l3d(), problem);
  ASSERT_TRUE(places) << problem;
  expect_near(places->at("down").position_m, {1, 0, 2});
  expect_near(places->at("down").turn[0], {0, 1, 0});
  expect_near(places->at("up").position_m, {1, 0, 3});
  expect_near(-places->at("up").turn[2], {0, 0, 1});
}

// Z, then X, then Y, each about the axes as they are then.
TEST(L3dModel, TheOrderOfTurnsIsZXY) {
  const std::string bytes =
      zip_bytes({{"structure.xml", "<Luminaire><Structure><Geometry partName='a'><Position " +
                                       kZero + "/><Rotation x='90' y='0' z='90'/>" +
                                       object("o", "x='0' y='0' z='1'", "x='0' y='90' z='0'") +
                                       "</Geometry></Structure></Luminaire>"}});
  std::string problem;
  const auto places = read_l3d_places(bytes, problem);
  ASSERT_TRUE(places);
  // About x the z axis goes to -y, about z that goes to +x.
  expect_near(places->at("o").position_m, {1, 0, 0});
  // About y the x axis goes to -z, as z is where +x was.
  expect_near(places->at("o").turn[0], {-1, 0, 0});
}

TEST(L3dModel, WhatIsNoneHasAReason) {
  const auto problem_of = [](const std::string& bytes) {
    std::string problem;
    EXPECT_FALSE(read_l3d_places(bytes, problem));
    return problem;
  };
  EXPECT_THAT(problem_of("nothing"), HasSubstr("ZIP"));
  EXPECT_THAT(problem_of(zip_bytes({{"a.xml", "<a/>"}})), HasSubstr("structure.xml"));
  EXPECT_THAT(problem_of(zip_bytes({{"structure.xml", "<a/>"}})), HasSubstr("<Structure>"));
  EXPECT_THAT(problem_of(l3d("down")), HasSubstr("two emitting objects 'down'"));
  EXPECT_THAT(problem_of(zip_bytes({{"structure.xml",
                                     "<L><Structure><Geometry><Position x='1e9' y='0' z='0'/>"
                                     "</Geometry></Structure></L>"}})),
              HasSubstr("x=\"1e9\" of <Position>"));
}

TEST(GldfTogether, EachEmitterIsWhereTheModelHasIt) {
  const Together read = together(gldf(two_emitters()));
  ASSERT_TRUE(read.light) << read.messages;
  const std::vector<EmitterLight>& emitters = read.light->emitters;
  ASSERT_EQ(emitters.size(), 2u);
  EXPECT_EQ(emitters[0].id, "e1");
  EXPECT_EQ(emitters[1].id, "e2");
  // Half a metre below and above the middle.
  expect_near(emitters[0].place.position_m, {0, 0, -0.5});
  expect_near(emitters[1].place.position_m, {0, 0, 0.5});
  expect_near(emitters[0].place.turn[0], {0, 1, 0});
  expect_near(-emitters[1].place.turn[2], {0, 0, 1});
  EXPECT_NEAR(read.light->flux_lm(), 2000.0, 3.0);
  EXPECT_EQ(read.light->power_w(), 40.0);
}

TEST(GldfTogether, PlacesThatAreNotKnownAreSaid) {
  const auto reason = [](const GldfSample& sample, const std::string& body) {
    const Together read = together(gldf(sample, body));
    EXPECT_TRUE(read.light) << read.messages;
    for (const EmitterLight& emitter : read.light->emitters) {
      expect_near(emitter.place.position_m, {0, 0, 0});
      expect_near(emitter.place.turn[2], {0, 0, 1});
    }
    return read.messages;
  };
  EXPECT_THAT(reason(two_emitters(), "nothing"), HasSubstr("the luminaire's model cannot be read"));
  EXPECT_THAT(reason(two_emitters(), l3d("over")), HasSubstr("no emitting object 'up'"));
  GldfSample sample = two_emitters();
  sample.files.replace(sample.files.find("geo/l3d"), 7, "geo/r3d");
  EXPECT_THAT(reason(sample, l3d()), HasSubstr("the luminaire's model is not an L3D file"));
  sample.variants =
      "<Variant id='v1'><EmitterReference emitterId='e1'/><EmitterReference emitterId='e2'/>"
      "</Variant>";
  EXPECT_THAT(
      reason(sample, l3d()),
      HasSubstr("warning[gldf-places]: the places of the emitters 'e1', 'e2' are not known: "
                "product.xml names no model"));
}

TEST(GldfTogether, WhatNobodySaysIsRefused) {
  GldfSample sample = two_emitters();
  std::string& emitters = sample.emitters;
  emitters.insert(emitters.find("<PhotometryReference"), "<Rotation><Z>90</Z></Rotation>");
  EXPECT_THAT(
      together(gldf(sample)).messages,
      HasSubstr("'e1' is turned in product.xml, which is not applied; write a luminaire for "
                "each: emitter=\"e1\", emitter=\"e2\""));
  sample = two_emitters();
  std::string& variants = sample.variants;
  variants.insert(variants.find("<EmitterReference emitterId='e2'"),
                  "<EmitterReference emitterId='e1'><EmitterObjectExternalName>side"
                  "</EmitterObjectExternalName></EmitterReference>");
  EXPECT_THAT(together(gldf(sample)).messages, HasSubstr("'e1' is at 2 places (down, side)"));
  const Together one = together(gldf(sample), "e1");
  EXPECT_TRUE(one.light);
  sample = two_emitters();
  sample.equipment = "<Equipment id='q'><RatedInputPower>9</RatedInputPower></Equipment>";
  const auto changeable = [](const std::string& id) {
    return "<Emitter id='" + id +
           "'><ChangeableLightEmitter><PhotometryReference photometryId='p1'/><EquipmentReference "
           "equipmentId='q'/></ChangeableLightEmitter></Emitter>";
  };
  sample.emitters = changeable("e1") + changeable("e2");
  EXPECT_THAT(together(gldf(sample)).messages,
              HasSubstr("shares its equipment 'q' with another emitter"));
}

TEST(GldfTogether, OneLightIsWantedByOthers) {
  Diagnostics diagnostics;
  PhotometryOptions options;
  options.emitter = "all";
  EXPECT_FALSE(parse_photometry(gldf(two_emitters()), "a.gldf", diagnostics, options));
  EXPECT_THAT(test_support::diagnostics_text(diagnostics),
              HasSubstr("of which only one can be used here"));
}

Project project_with(const std::string& type, const std::string& luminaire) {
  Diagnostics diagnostics;
  const std::string xml =
      "<luxgate version='1'><material id='m' reflectance='0.5'/>"
      "<luminaire-type id='t' photometry='a.gldf' emitter='all' maintenance-factor='0.8' " +
      type + "/><room id='r' size='4 4 4' floor='m' ceiling='m' walls='m'>" + luminaire +
      "<plane id='p' height='0.8'/></room></luxgate>";
  const MemoryFileReader files({{"p.xml", xml}, {"a.gldf", gldf(two_emitters())}});
  const std::optional<Project> project = load_project(files, "p.xml", diagnostics);
  if (!project) throw std::runtime_error(test_support::diagnostics_text(diagnostics));
  return *project;
}

TEST(GldfTogether, ALuminaireOfTwoEmittersCountsOnce) {
  const Project project = project_with(
      "", "<luminaire-grid id='L' type='t' origin='0 0 3' size='4 4' columns='2' rows='1'/>");
  const std::vector<Luminaire>& placed = project.spaces.at(0).luminaires;
  ASSERT_EQ(placed.size(), 4u);
  EXPECT_EQ(placed[0].id, "L[0,0]");
  EXPECT_EQ(placed[1].id, "L[0,0]/e2");
  expect_near(placed[0].position_m, {1, 2, 2.5});
  expect_near(placed[1].position_m, {1, 2, 3.5});
  expect_near(-placed[1].world_from_luminaire[2], {0, 0, 1});
  const InstalledPower power = installed_power(project, project.spaces[0]);
  EXPECT_EQ(power.luminaires, 2);
  EXPECT_EQ(power.without_power, 0);
  EXPECT_EQ(power.power_w, 80.0);
  ASSERT_EQ(project.luminaire_types.size(), 2u);
  EXPECT_EQ(luminaires_of_type(project, 0), 2);
  EXPECT_NEAR(luminaire_flux_lm(project, project.luminaire_types[0]), 2000.0, 3.0);
  EXPECT_FALSE(project.luminaire_types[1].counts_as_luminaire());
}

TEST(GldfTogether, EmittersAtOnePlaceAreNotALuminairePastedTwice) {
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  std::string same = structure_xml("up");
  same = replaced(same, "<Position x='0' y='0' z='1'/>", "<Position x='0' y='0' z='0'/>");
  same = replaced(same, "<DefaultRotation x='180'", "<DefaultRotation x='0'");
  const auto warnings = [&](const std::string& luminaires) {
    Diagnostics diagnostics;
    const std::string xml =
        "<luxgate version='1'><material id='m' reflectance='0.5'/>"
        "<luminaire-type id='t' photometry='a.gldf' emitter='all' maintenance-factor='0.8'/>"
        "<room id='r' size='4 4 4' floor='m' ceiling='m' walls='m'>" +
        luminaires + "<plane id='p' height='0.8'/></room></luxgate>";
    const MemoryFileReader files(
        {{"p.xml", xml}, {"a.gldf", gldf(two_emitters(), zip_bytes({{"structure.xml", same}}))}});
    EXPECT_TRUE(load_project(files, "p.xml", diagnostics));
    return test_support::diagnostics_text(diagnostics);
  };
  const std::string one = "<luminaire id='L' type='t' position='2 2 1.5'/>";
  EXPECT_THAT(warnings(one), Not(HasSubstr("luminaires-coincide")));
  EXPECT_THAT(warnings(one + "<luminaire id='M' type='t' position='2 2 1.5'/>"),
              HasSubstr("luminaires-coincide"));
}

TEST(GldfTogether, TheLuminaireTurnsAsAWhole) {
  const Project project =
      project_with("", "<luminaire id='L' type='t' position='2 2 2' axis='1 0 0'/>");
  const std::vector<Luminaire>& placed = project.spaces.at(0).luminaires;
  expect_near(placed[0].position_m, {2.5, 2, 2});
  expect_near(placed[1].position_m, {1.5, 2, 2});
  expect_near(-placed[0].world_from_luminaire[2], {1, 0, 0});
  expect_near(-placed[1].world_from_luminaire[2], {-1, 0, 0});
}

TEST(GldfTogether, OverridesAreOfTheWholeLuminaire) {
  const std::string luminaire = "<luminaire id='L' type='t' position='2 2 2'/>";
  const Project other = project_with("flux-lm='1000'", luminaire);
  const LuminaireType& type = other.luminaire_types[0];
  EXPECT_NEAR(luminaire_flux_lm(other, type), 1000.0, 1e-9);
  EXPECT_EQ(installed_power(other, other.spaces[0]).without_power, 1);
  const Project stated = project_with("flux-lm='1000' power-w='25' price='80'", luminaire);
  EXPECT_EQ(installed_power(stated, stated.spaces[0]).power_w, 25.0);
  EXPECT_EQ(installed_price(stated, stated.spaces[0]).price, 80.0);  // once, as the power
  EXPECT_EQ(installed_price(stated, stated.spaces[0]).without_price, 0);
  // Down and up give their light in opposite directions.
  const double down_cd = luminaire_intensity_cd(other, type, {0, 0, -1});
  EXPECT_NEAR(down_cd, luminaire_intensity_cd(other, type, {0, 0, 1}), 1e-9 * down_cd);
  EXPECT_NEAR(luminaire_peak_cd(other, type), down_cd, 1e-9 * down_cd);
}

}  // namespace
}  // namespace calc::gldf_together_test
