#include "calc/photometry/read/tm33_opening.h"

#include "tests/support/photometry_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace calc::tm33_opening_test {
namespace {

using testing::HasSubstr;

struct Opening {
  std::optional<LuminousOpening> opening;
  std::string messages;
};

Opening read(const std::string& luminaire, const std::string& emission_areas = "") {
  Diagnostics diagnostics;
  const XmlElement root = parse_xml("<r>" + luminaire + "<e>" + emission_areas + "</e></r>",
                                    "f.xml", diagnostics, XmlText::keep)
                              .value();
  Opening result{read_tm33_opening(root, {&root.children.back()}, diagnostics), ""};
  result.messages = test_support::diagnostics_text(diagnostics);
  EXPECT_EQ(!result.opening, diagnostics.has_errors());
  return result;
}

std::string bottom(const std::string& areas) {
  return "<EmissionAreas><BottomFace>" + areas + "</BottomFace></EmissionAreas>";
}
std::string area(int length, int length_at, int width, int width_at) {
  return fmt::format(
      "<BottomArea><Length>{}</Length><Width>{}</Width><LengthOffset>{}</LengthOffset>"
      "<WidthOffset>{}</WidthOffset></BottomArea>",
      length, width, length_at, width_at);
}
const std::string kHousing =
    "<Luminaire><Dimensions><Length>1200</Length><Width>200</Width><Height>60</Height>"
    "</Dimensions></Luminaire>";

TEST(Tm33Opening, EmissionAreaGoesBeforeTheHousing) {
  const Opening found = read(kHousing, bottom(area(1000, 50, 100, 0)));
  EXPECT_EQ(found.messages, "");
  EXPECT_EQ(found.opening->shape, OpeningShape::rectangle);
  EXPECT_DOUBLE_EQ(found.opening->along_c90_m, 1.0);
  EXPECT_DOUBLE_EQ(found.opening->along_c0_m, 0.1);
}

TEST(Tm33Opening, SeveralAreasBecomeTheirBounds) {
  const Opening found = read("", bottom(area(100, -300, 100, 0) + area(100, 300, 100, 50)));
  EXPECT_THAT(found.messages, HasSubstr("the opening 'emission areas' is 2 areas, 0 of these on "
                                        "the sides; its bounding box is used"));
  EXPECT_DOUBLE_EQ(found.opening->along_c90_m, 0.7);
  EXPECT_DOUBLE_EQ(found.opening->along_c0_m, 0.15);
}

TEST(Tm33Opening, LuminousSidesGiveAHeight) {
  const Opening found = read(
      kHousing, "<EmissionAreas><BottomFace>" + area(500, 0, 100, 0) +
                    "</BottomFace><C90Face><C90Area><Width>100</Width><Height>40</Height></C90Area>"
                    "</C90Face></EmissionAreas>");
  EXPECT_THAT(found.messages, HasSubstr("2 areas, 1 of these on the sides"));
  EXPECT_DOUBLE_EQ(found.opening->height_m, 0.04);
  EXPECT_DOUBLE_EQ(found.opening->along_c90_m, 0.5);
}

TEST(Tm33Opening, ShapesOfLuminousOpenings) {
  const auto opening = [](const std::string& inside) {
    const Opening found =
        read("<Luminaire><LuminousOpening>" + inside + "</LuminousOpening></Luminaire>");
    EXPECT_EQ(found.messages, "");
    return found.opening.value_or(LuminousOpening{});
  };
  const LuminousOpening round = opening("<Shape>Circular</Shape><Diameter>80</Diameter>");
  EXPECT_EQ(round.shape, OpeningShape::disk);
  EXPECT_DOUBLE_EQ(round.along_c0_m, 0.08);
  EXPECT_DOUBLE_EQ(round.along_c90_m, 0.08);
  EXPECT_DOUBLE_EQ(opening("<Shape>Circular</Shape><Length>70</Length>").along_c0_m, 0.07);
  const LuminousOpening ellipse = opening(
      "<Shape>Elliptical</Shape><Dimensions><Length>90</Length><Width>40</Width></Dimensions>");
  EXPECT_EQ(ellipse.shape, OpeningShape::disk);
  EXPECT_DOUBLE_EQ(ellipse.along_c90_m, 0.09);
  EXPECT_DOUBLE_EQ(ellipse.along_c0_m, 0.04);
  EXPECT_EQ(opening("<Shape>Point</Shape>").shape, OpeningShape::point);
}

TEST(Tm33Opening, TheHousingIsTheLastResort) {
  const Opening found = read(kHousing);
  EXPECT_EQ(found.messages,
            "f.xml:1:15: warning[photometry-outer-size]: no luminous area is stated; the length "
            "and width of the whole luminaire are used\n");
  EXPECT_EQ(found.opening->shape, OpeningShape::rectangle);
  EXPECT_DOUBLE_EQ(found.opening->along_c90_m, 1.2);
  EXPECT_DOUBLE_EQ(found.opening->along_c0_m, 0.2);
  const Opening upright = read(
      "<Luminaire><Dimensions><Length>90</Length><Width>90</Width></Dimensions>"
      "<Shape>Align _Z</Shape></Luminaire>");
  EXPECT_EQ(upright.opening->shape, OpeningShape::disk);
  for (const char* nothing : {"", "<Luminaire/>", "<Luminaire><Dimensions/></Luminaire>"}) {
    EXPECT_THAT(read(nothing).messages, HasSubstr("warning[photometry-no-area]"));
    EXPECT_EQ(read(nothing).opening->shape, OpeningShape::point);
  }
}

TEST(Tm33Opening, BadSizesAreErrors) {
  for (const char* size : {"-1", "1e9", "wide"}) {
    const std::string luminaire =
        fmt::format("<Luminaire><Dimensions><Length>{}</Length></Dimensions></Luminaire>", size);
    EXPECT_THAT(read(luminaire).messages, HasSubstr("<Length>")) << size;
    EXPECT_FALSE(read(luminaire).opening) << size;
  }
}

}  // namespace
}  // namespace calc::tm33_opening_test
