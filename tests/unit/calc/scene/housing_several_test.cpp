// One housing around the openings of a luminaire with several emitters.

#include "calc/scene/housing.h"
#include "calc/scene/solids.h"
#include "tests/support/mesh_rooms.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace calc::tests::housing_several_test {
namespace {

using test_support::zip_bytes;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

struct Place {
  double x, y, z, about_x = 0.0, about_y = 0.0;  // m, degrees
};

// Emitters e1, e2 ... with the photometry a.ldt at these places.
std::string gldf(const std::vector<Place>& places, const std::string& ldt) {
  test_support::GldfSample sample;
  sample.files += "<File id='g' contentType='geo/l3d' type='localFileName'>body.l3d</File>";
  sample.light_sources =
      "<FixedLightSource id='s'><RatedInputPower>10</RatedInputPower></FixedLightSource>";
  sample.emitters.clear();
  std::string objects, references;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& at = places[i];
    const std::string id = fmt::format("e{}", i + 1);
    sample.emitters += fmt::format(
        "<Emitter id='{}'><FixedLightEmitter><PhotometryReference photometryId='p1'/>"
        "<LightSourceReference fixedLightSourceId='s'/></FixedLightEmitter></Emitter>",
        id);
    references += fmt::format(
        "<EmitterReference emitterId='{0}'><EmitterObjectExternalName>{0}"
        "</EmitterObjectExternalName></EmitterReference>",
        id);
    objects += fmt::format(
        "<LightEmittingObject partName='{}'><Position x='{}' y='{}' z='{}'/><Rotation x='{}' "
        "y='{}' z='0'/><Circle diameter='0.1'/></LightEmittingObject>",
        id, at.x, at.y, at.z, at.about_x, at.about_y);
  }
  sample.variants = "<Variant id='v1'><Geometry><ModelGeometryReference geometryId='body'>" +
                    references + "</ModelGeometryReference></Geometry></Variant>";
  std::string product = product_xml(sample);
  product.insert(product.find("</GeneralDefinitions>"),
                 "<Geometries><ModelGeometry id='body'><GeometryFileReference fileId='g'/>"
                 "</ModelGeometry></Geometries>");
  const std::string zero = "x='0' y='0' z='0'";
  const std::string model = "<Luminaire><Structure><Geometry partName='base'><Position " + zero +
                            "/><Rotation " + zero + "/><LightEmittingObjects>" + objects +
                            "</LightEmittingObjects></Geometry></Structure></Luminaire>";
  return zip_bytes({{"product.xml", product},
                    {"ldc/a.ldt", ldt},
                    {"geo/body.l3d", zip_bytes({{"structure.xml", model}})}});
}

const std::string kHanging = R"(<luminaire id="L" type="t" position="2 1.5 2"/>)";

// Openings of 0.3 m along C0 and 1.2 m along C90, if `ldt` does not say otherwise.
Loaded room_with(const std::vector<Place>& places, const std::string& housing,
                 const std::string& luminaires = kHanging, const std::string& of_type = "",
                 const std::string& ldt = test_support::ldt_text({})) {
  MemoryFileReader files = project_files(in_project(
      R"(<luminaire-type id="t" photometry="lamp.gldf" emitter="all" )" + of_type +
      "><housing material=\"white\" " + housing +
      R"(/></luminaire-type><room id="r" size="4 3 2.5" ceiling="white" walls="white" floor="white">)" +
      luminaires + R"(<plane id="task" height="0.75"/></room>)"));
  files.add("dir/lamp.gldf", gldf(places, ldt));
  files.add("dir/body.obj",
            test_support::ObjText().box("b", {-0.6, -0.6, 0}, {0.6, 0.6, 0.08}, false).text());
  return load(files);
}

const std::vector<Place> kBeside{{-0.4, 0, 0}, {0.4, 0, 0}};
// 0.1 m apart, the second one shines up.
const std::vector<Place> kDownAndUp{{0, 0, 0}, {0, 0, 0.1, 180}};

std::vector<std::string> ids(const Loaded& loaded) {
  std::vector<std::string> found;
  for (const Body& body : loaded.project->spaces[0].bodies) {
    if (!body.housing_of.empty()) found.push_back(body.id);
  }
  return found;
}

const Body& body(const Loaded& loaded, std::string_view id) {
  for (const Body& one : loaded.project->spaces[0].bodies) {
    if (one.id == id) return one;
  }
  throw std::runtime_error("no body " + std::string(id));
}

void expect_box(const Body& one, const glm::dvec3& lower_m, const glm::dvec3& upper_m) {
  SCOPED_TRACE(one.id);
  const BoundingBox box = bounding_box(one.vertex_m);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(box.lower[i], lower_m[i], 1e-12) << i;
    EXPECT_NEAR(box.upper[i], upper_m[i], 1e-12) << i;
  }
}

TEST(HousingOfSeveral, EachOpeningHasItsFaceAndAllHaveOneBox) {
  const Loaded loaded = room_with(kBeside, "depth=\"0.1\"");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_THAT(ids(loaded), ElementsAre("L.face", "L.housing", "L/e2.face"));
  expect_box(body(loaded, "L.face"), {1.45, 0.9, 2.0}, {1.75, 2.1, 2.0});
  expect_box(body(loaded, "L/e2.face"), {2.25, 0.9, 2.0}, {2.55, 2.1, 2.0});
  const Body& box = body(loaded, "L.housing");
  expect_box(box, {1.45, 0.9, 2.0}, {2.55, 2.1, 2.1});
  EXPECT_TRUE(box.is_closed);
  EXPECT_TRUE(is_watertight(box));
  for (const Luminaire& emitter : loaded.project->spaces[0].luminaires) {
    EXPECT_TRUE(is_housing_of(box, emitter)) << emitter.id;
  }
  EXPECT_THAT(loaded.messages, Not(HasSubstr("in-solid")));
}

TEST(HousingOfSeveral, WithoutDepthThereAreTheFaces) {
  const Loaded loaded = room_with(kBeside, "");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_THAT(ids(loaded), ElementsAre("L.face", "L/e2.face"));
}

TEST(HousingOfSeveral, TheSizeIsThatOfTheBox) {
  const Loaded loaded = room_with(kBeside, R"(depth="0.1" size="1.5 1.3")");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  expect_box(body(loaded, "L.housing"), {1.25, 0.85, 2.0}, {2.75, 2.15, 2.1});
  expect_box(body(loaded, "L/e2.face"), {2.25, 0.9, 2.0}, {2.55, 2.1, 2.0});
}

// The place of a luminaire of several is the middle of their centres.
TEST(HousingOfSeveral, BetweenLightDownAndUpItFillsWhatIsBetween) {
  const Loaded loaded = room_with(kDownAndUp, "depth=\"0.1\"");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  expect_box(body(loaded, "L.housing"), {1.85, 0.9, 1.95}, {2.15, 2.1, 2.05});
  EXPECT_THAT(loaded.messages, Not(HasSubstr("in-solid")));
}

// The first emitter's own axes are turned, too: the box is in those of the luminaire.
TEST(HousingOfSeveral, ATurnedFirstEmitterDoesNotTurnTheBox) {
  const Loaded loaded = room_with({{0, 0, 0.1, 180}, {0.5, 0, 0}}, "depth=\"0.1\"");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  expect_box(body(loaded, "L.housing"), {1.6, 0.9, 1.95}, {2.4, 2.1, 2.05});
}

TEST(HousingOfSeveral, ATurnedLuminaireTakesItAlong) {
  const Loaded loaded =
      room_with(kBeside, "depth=\"0.1\"",
                R"(<luminaire id="L" type="t" position="2 1.5 1" axis="0 0 1" rotation="90"/>)");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  expect_box(body(loaded, "L.housing"), {1.4, 0.95, 0.9}, {2.6, 2.05, 1.0});
}

TEST(HousingOfSeveral, CopiesOfAnAssemblyHaveTheirOwn) {
  const Loaded loaded = room_with(kBeside, "depth=\"0.1\"",
                                  R"(<assembly id="a" repeat="2 1 1" step="1.5 0 0" )"
                                  R"(position="1 1 0"><luminaire id="L" type="t" )"
                                  R"(position="0 0.5 2"/></assembly>)");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_THAT(ids(loaded),
              ElementsAre("a[0,0,0].L.face", "a[0,0,0].L.housing", "a[0,0,0].L/e2.face",
                          "a[1,0,0].L.face", "a[1,0,0].L.housing", "a[1,0,0].L/e2.face"));
  EXPECT_THAT(loaded.messages, Not(HasSubstr("in-solid")));
}

TEST(HousingOfSeveral, TheHousingOfAnotherLuminaireIsASolid) {
  const Loaded loaded =
      room_with(kBeside, "depth=\"0.3\"",
                kHanging + R"(<luminaire id="M" type="t" position="2.5 1.5 1.85"/>)");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_THAT(loaded.messages, HasSubstr("inside the solid 'M.housing'"));
  for (const Luminaire& emitter : loaded.project->spaces[0].luminaires) {
    EXPECT_EQ(is_housing_of(body(loaded, "M.housing"), emitter), emitter.id[0] == 'M')
        << emitter.id;
  }
}

const std::string kMesh = R"(file="body.obj" units="m" up="z")";

// In the luminaire's axes, whatever those of the first emitter.
TEST(HousingOfSeveral, AMeshStandsOnce) {
  const Loaded loaded = room_with(kBeside, kMesh);
  ASSERT_TRUE(loaded.project) << loaded.messages;
  EXPECT_THAT(ids(loaded), ElementsAre("L.face", "L.housing", "L/e2.face"));
  expect_box(body(loaded, "L.housing"), {1.4, 0.9, 2.0}, {2.6, 2.1, 2.08});
  EXPECT_TRUE(body(loaded, "L.housing").is_closed);
  EXPECT_THAT(loaded.messages, Not(HasSubstr("in-solid")));
  const Loaded turned = room_with({{0, 0, 0.2, 180}, {0.5, 0, 0}}, kMesh);
  ASSERT_TRUE(turned.project) << turned.messages;
  expect_box(body(turned, "L.housing"), {1.4, 0.9, 2.0}, {2.6, 2.1, 2.08});
  EXPECT_NEAR(turned.project->luminaire_types.back().housing.value().depth_m, 0.18, 1e-12);
}

TEST(HousingOfSeveral, WhatWouldHideTheirLightIsRefused) {
  struct Refused {
    std::vector<Place> places;
    std::string housing, message;
  };
  const std::vector<Refused> cases{
      {kDownAndUp, "depth=\"0.12\"",
       "attribute 'depth' of <housing>: 0.12 is not allowed; expected no value, or a box around "
       "all openings that is in front of none of them; it would reach 0.02 m into the "
       "light of emitter 'e2'"},
      // Tilted by 30 degrees so that their light crosses: 0.8 sin 30 + 0.15 sin 60.
      {{{-0.4, 0, 0, 0, -30}, {0.4, 0, 0, 0, 30}},
       "",
       "would reach 0.53 m into the light of emitter"},
      {{{-0.4, 0, 0}, {0.4, 0, 0.02}},
       "",
       "<housing> needs luminous openings that do not block each other's light; the face of "
       "emitter 'e1' would reach 0.02 m into the light of emitter 'e2'"},
      {kDownAndUp, kMesh,
       "attribute 'file' of <housing>: body.obj is not allowed; expected a mesh with all of its "
       "parts behind all openings; it would reach 0.03 m into the light "
       "of emitter 'e2'"},
      {kBeside, R"(depth="0.1" size="1 1.2")",
       "attribute 'size' of <housing>: 1 1.2 is not allowed; expected at least the size of all "
       "luminous openings together, 1.1 x 1.2 m"},
      {kBeside, R"(size="1.2 1.3")", "<housing> needs 'depth' beside 'size'"},
      {kBeside, R"(dimensions="file")", "<housing> needs 'depth' instead of 'dimensions'"},
  };
  for (const Refused& one : cases) {
    SCOPED_TRACE(one.message);
    const Loaded loaded = room_with(one.places, one.housing);
    EXPECT_FALSE(loaded.project);
    EXPECT_THAT(loaded.messages, HasSubstr(one.message));
  }
}

// Tilted the other way their light goes apart.
TEST(HousingOfSeveral, OpeningsThatLookApartDoNotMeet) {
  const Loaded loaded = room_with({{-0.4, 0, 0, 0, 30}, {0.4, 0, 0, 0, -30}}, "");
  EXPECT_TRUE(loaded.project) << loaded.messages;
}

TEST(HousingOfSeveral, LightBackwardsAllowsFacesInOnePlaneOnly) {
  test_support::LdtSample both;
  both.cd_per_klm = [](double, double gamma) { return gamma < 90.0 ? 100.0 : 50.0; };
  EXPECT_TRUE(room_with(kBeside, "", kHanging, "", test_support::ldt_text(both)).project);
  const Loaded deep =
      room_with(kBeside, "depth=\"0.1\"", kHanging, "", test_support::ldt_text(both));
  EXPECT_FALSE(deep.project);
  EXPECT_THAT(deep.messages, HasSubstr("34 % of the light of emitter 'e1' goes backwards"));
  // Apart, each stands in the other's backward light.
  const std::vector<Place> apart{{-0.4, 0, 0, 0, 30}, {0.4, 0, 0, 0, -30}};
  EXPECT_THAT(room_with(apart, "", kHanging, "", test_support::ldt_text(both)).messages,
              HasSubstr("that do not block each other's light"));
}

TEST(HousingOfSeveral, OpeningsWithoutSizeOrWithSidesAreRefused) {
  EXPECT_THAT(room_with(kBeside, "", kHanging, "opening=\"point\"").messages,
              HasSubstr("<housing> needs photometry with a luminous opening; emitter 'e1' "
                        "has none, or opening=\"point\" leaves it out"));
  std::string ldt = test_support::ldt_text({});
  const std::string flat = "\n300\n0\n0\n0\n0\n";
  ldt.replace(ldt.find(flat), flat.size(), "\n300\n200\n200\n200\n200\n");
  EXPECT_THAT(room_with(kBeside, "", kHanging, "", ldt).messages,
              HasSubstr("<housing> needs flat luminous openings for a luminaire of several "
                        "emitters; the opening of emitter 'e1' is a body, 0.3 x 1.2 x 0.2 m"));
}

}  // namespace
}  // namespace calc::tests::housing_several_test
