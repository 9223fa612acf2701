// Which planes share their colours.
#include "report/html/drawings/shared_scale.h"
#include "tests/support/sample_document.h"

#include <gtest/gtest.h>

#include <string>

namespace report::shared_scale_test {
namespace {

// Two points.
PlanePart plane_of(const std::string& id, double low_lx, double high_lx) {
  PlanePart plane = small_document().projects[0].spaces[0].planes[0];
  plane.id = id;
  plane.findings.clear();
  plane.points[0].measured = {low_lx, low_lx, low_lx};
  plane.points[1].measured = {high_lx, high_lx, high_lx};
  return plane;
}

ProjectPart project_of() {
  ProjectPart project;
  project.spaces.resize(2);
  project.spaces[0].id = "a";
  project.spaces[0].planes = {plane_of("desk", 400, 700), plane_of("wall", 100, 200)};
  project.spaces[1].id = "b";
  project.spaces[1].planes = {plane_of("hall", 150, 350), plane_of("escape", 0.5, 4.0)};
  return project;
}

bool is_same(const ColourScale& a, const ColourScale& b) {
  return a.low == b.low && a.step == b.step && a.bands == b.bands && a.classes == b.classes;
}

TEST(ColourScales, OfAProjectAreOneButForWhatIsFarBelow) {
  const ProjectPart project = project_of();
  const ColourScales scales(project, ScaleSharing::project);
  const auto of = [&](std::size_t s, std::size_t p) {
    return scales.of(project.spaces[s], project.spaces[s].planes[p]);
  };
  const ColourScale all = make_colour_scale(100, 700);
  EXPECT_TRUE(is_same(of(0, 0).scale, all));
  EXPECT_TRUE(is_same(of(0, 1).scale, all));
  EXPECT_TRUE(is_same(of(1, 0).scale, all));
  EXPECT_EQ(of(0, 1).among, ScaleSharing::project);
  EXPECT_EQ(of(1, 1).among, ScaleSharing::plane);
  EXPECT_TRUE(is_same(of(1, 1).scale, make_colour_scale(0.5, 4.0)));
}

TEST(ColourScales, OfARoomAreItsOwn) {
  const ProjectPart project = project_of();
  const ColourScales scales(project, ScaleSharing::room);
  EXPECT_TRUE(is_same(scales.of(project.spaces[0], project.spaces[0].planes[1]).scale,
                      make_colour_scale(100, 700)));
  // Beside the escape route's there is one plane.
  EXPECT_TRUE(is_same(scales.of(project.spaces[1], project.spaces[1].planes[0]).scale,
                      make_colour_scale(150, 350)));
}

TEST(ColourScales, HaveTheColoursAskedFor) {
  const ProjectPart project = project_of();
  for (const ScaleSharing sharing : {ScaleSharing::project, ScaleSharing::plane}) {
    const ColourScales scales(project, sharing, ColourMap::false_colour);
    for (const PlanePart& plane : project.spaces[1].planes) {
      EXPECT_EQ(scales.of(project.spaces[1], plane).scale.map, ColourMap::false_colour);
    }
    EXPECT_EQ(
        ColourScales(project, sharing).of(project.spaces[0], project.spaces[0].planes[0]).scale.map,
        ColourMap::cividis);
  }
}

TEST(ColourScales, SayAmongWhomTheyAreShared) {
  EXPECT_EQ(sharing_words({}, ScaleSharing::project),
            "One colour scale for all planes of the project.");
  EXPECT_EQ(sharing_words({}, ScaleSharing::room),
            "One colour scale for all planes of this room or area.");
  EXPECT_EQ(sharing_words({}, ScaleSharing::plane),
            "The colour scale belongs to this plane alone.");
}

TEST(ColourScales, OfPlanesAreTheirOwn) {
  const ProjectPart project = project_of();
  for (const ColourScales& scales : {ColourScales(), ColourScales(project, ScaleSharing::plane)}) {
    const PlaneScale scale = scales.of(project.spaces[0], project.spaces[0].planes[0]);
    EXPECT_EQ(scale.among, ScaleSharing::plane);
    EXPECT_TRUE(is_same(scale.scale, make_colour_scale(400, 700)));
  }
}

TEST(ColourScales, RatingsAreNoIlluminance) {
  ProjectPart project = project_of();
  PlanePart ugr = plane_of("ugr", 12, 650);
  ugr.derived = calc::DerivedQuantity::ugr;
  project.spaces[0].planes.push_back(ugr);
  const ColourScales scales(project, ScaleSharing::project);
  EXPECT_EQ(scales.of(project.spaces[0], project.spaces[0].planes[2]).among, ScaleSharing::plane);
  EXPECT_TRUE(is_same(scales.of(project.spaces[0], project.spaces[0].planes[0]).scale,
                      make_colour_scale(100, 700)));
}

// A corridor beside an office: of bands of 100 lx it would have one colour.
TEST(ColourScales, AreClassesWhereAPlaneWouldBeOfOneColour) {
  ProjectPart project = project_of();
  project.spaces[0].planes = {plane_of("desk", 520, 900)};
  project.spaces[1].planes = {plane_of("corridor", 102, 190)};
  const ColourScales scales(project, ScaleSharing::project);
  const PlaneScale desk = scales.of(project.spaces[0], project.spaces[0].planes[0]);
  const PlaneScale corridor = scales.of(project.spaces[1], project.spaces[1].planes[0]);
  EXPECT_NE(corridor.among, ScaleSharing::plane);
  EXPECT_TRUE(is_same(desk.scale, corridor.scale));
  EXPECT_TRUE(is_same(corridor.scale, make_class_scale(102, 900)));
  EXPECT_EQ(band_of(make_colour_scale(102, 900), 102), band_of(make_colour_scale(102, 900), 190));
  EXPECT_LT(band_of(corridor.scale, 102), band_of(corridor.scale, 190));
  EXPECT_LT(band_of(desk.scale, 520), band_of(desk.scale, 900));
}

// Beside a bright hall a corridor has one colour by equal bands and by the classes of standards.
TEST(ColourScales, AreFineClassesWhereOthersGiveOneColour) {
  ProjectPart project = project_of();
  project.spaces[0].planes = {plane_of("hall", 850, 1200)};
  project.spaces[1].planes = {plane_of("corridor", 122, 149)};
  const ColourScales scales(project, ScaleSharing::project);
  const PlaneScale hall = scales.of(project.spaces[0], project.spaces[0].planes[0]);
  EXPECT_TRUE(is_same(hall.scale, make_colour_scale(122, 1200))) << "nothing tells more apart";
  project.spaces[1].planes = {plane_of("corridor", 112, 149)};
  const ColourScales finer(project, ScaleSharing::project);
  const PlaneScale corridor = finer.of(project.spaces[1], project.spaces[1].planes[0]);
  EXPECT_NE(corridor.among, ScaleSharing::plane);
  EXPECT_TRUE(is_same(corridor.scale, make_class_scale(112, 1200, ClassSeries::fine)));
  EXPECT_EQ(band_of(make_class_scale(112, 1200), 112), band_of(make_class_scale(112, 1200), 149));
  EXPECT_LT(band_of(corridor.scale, 112), band_of(corridor.scale, 149));
  EXPECT_LT(band_of(corridor.scale, 850), band_of(corridor.scale, 1200));
}

TEST(ColourScales, ALimitWidensThem) {
  ProjectPart project = project_of();
  project.spaces[0].planes[0].findings = {
      sample_finding(rules::Metric::average, 750, {550, 540, 560})};
  const ColourScales scales(project, ScaleSharing::project);
  EXPECT_TRUE(is_same(scales.of(project.spaces[0], project.spaces[0].planes[1]).scale,
                      make_colour_scale(100, 750)));
}

}  // namespace
}  // namespace report::shared_scale_test
