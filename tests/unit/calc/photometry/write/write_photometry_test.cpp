// Writers and readers against each other: what is written reads back as the same light.

#include "calc/photometry/read/photometry_file.h"
#include "calc/photometry/write/stored_table.h"
#include "calc/photometry/write/write_eulumdat.h"
#include "calc/photometry/write/write_lm63.h"
#include "tests/support/web_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace calc::write_photometry_test {
namespace {

using test_support::angle_steps;
using test_support::crooked_light;
using test_support::diagnostics_text;
using test_support::make_web;
using test_support::with_opening;
using test_support::with_source;
using ::testing::HasSubstr;
using ::testing::Not;

using Writer = std::optional<std::string> (*)(const PhotometricWeb&, const std::string&,
                                              Diagnostics&);

std::string written(Writer writer, const PhotometricWeb& web, Diagnostics& diagnostics) {
  const std::optional<std::string> text = writer(web, "new", diagnostics);
  EXPECT_TRUE(text.has_value()) << diagnostics_text(diagnostics);
  return text.value_or("");
}

// Without any message on either way, and with the same light, flux and opening.
std::string expect_round_trip(Writer writer, const PhotometricWeb& web) {
  Diagnostics diagnostics;
  const std::string text = written(writer, web, diagnostics);
  EXPECT_EQ(diagnostics_text(diagnostics), "");
  const std::optional<PhotometricWeb> read = parse_photometry(text, "new", diagnostics);
  EXPECT_TRUE(read.has_value()) << diagnostics_text(diagnostics);
  if (!read) return text;
  EXPECT_NEAR(read->flux_lm() / web.flux_lm(), 1.0, 1e-6);
  for (double c = 0.0; c < 6.3; c += 0.0873) {
    for (double gamma = 0.0; gamma <= kPi; gamma += 0.0291) {
      EXPECT_NEAR(read->intensity_cd(c, gamma), web.intensity_cd(c, gamma),
                  5.01e-7 * web.max_intensity_cd())  // half of the seventh digit
          << c << " " << gamma;
    }
  }
  EXPECT_EQ(read->opening().shape, web.opening().shape);
  EXPECT_NEAR(read->opening().along_c0_m, web.opening().along_c0_m, 1e-6);
  EXPECT_NEAR(read->opening().along_c90_m, web.opening().along_c90_m, 1e-6);
  EXPECT_NEAR(read->opening().height_m, web.opening().height_m, 1e-6);
  EXPECT_EQ(read->source().luminaire_name, web.source().luminaire_name);
  EXPECT_EQ(read->source().manufacturer, web.source().manufacturer);
  EXPECT_EQ(read->source().input_power_w, web.source().input_power_w);
  EXPECT_EQ(read->source().rated_lamp_flux_lm, web.source().rated_lamp_flux_lm);
  return text;
}

PhotometrySource some_source(double rated_lm) {
  return {"EULUMDAT", "Gr\xC3\xBCn 5", "maker", rated_lm, 41.5, "", "factor 2"};
}

struct Case {
  const char* name;
  test_support::Light light;
  std::vector<double> c_deg;
  std::vector<double> lm63_c;  // first and last horizontal angle and their number
  std::string isym;
};

std::vector<Case> cases() {
  const std::vector<double> even = angle_steps(0, 360, 15);
  const auto c0 = test_support::symmetric_about_c0(crooked_light);
  const auto c90 = test_support::symmetric_about_c90(crooked_light);
  // no planes at 90 and 180, none mirrored: the missing ones are put in
  const std::vector<double> uneven = {0, 20, 50, 100, 170, 230, 300, 360};
  return {{"none", crooked_light, even, {0, 360, 25}, "0"},
          {"C0-C180", c0, even, {0, 180, 13}, "2"},
          {"C90-C270", c90, even, {0, 360, 25}, "3"},
          {"quadrant", test_support::batwing, even, {0, 90, 7}, "4"},
          {"axial", test_support::narrow_spot, even, {0, 0, 1}, "1"},
          {"axial plane", test_support::narrow_spot, {0}, {0, 0, 1}, "1"},
          {"uneven", crooked_light, uneven, {0, 360, 8}, "0"}};
}

TEST(WritePhotometry, RoundTripsEverySymmetry) {
  const LuminousOpening opening{OpeningShape::rectangle, 1.2, 0.3048, 0.02};
  for (const Case& one : cases()) {
    for (const double rated_lm : {0.0, 12345.678}) {
      SCOPED_TRACE(one.name);
      const PhotometricWeb web = with_source(make_web(one.c_deg, angle_steps(0, 90, 5), one.light),
                                             opening, some_source(rated_lm));
      const std::string ies = expect_round_trip(write_lm63, web);
      const std::string ldt = expect_round_trip(write_eulumdat, web);
      EXPECT_THAT(ldt, HasSubstr("maker\r\n" + std::string(one.isym == "1" ? "1" : "2") + "\r\n" +
                                 one.isym + "\r\n"));
      EXPECT_THAT(ies, HasSubstr("\r\n0 5 10"));
      EXPECT_THAT(ies, HasSubstr(rated_lm > 0 ? "\r\n1 12345.678 1 19 " : "\r\n1 -1 1 19 "));
      EXPECT_THAT(ies, HasSubstr(" 1 2 0.3048 1.2 0.02\r\n1 1 41.5\r\n"));
    }
  }
}

TEST(WritePhotometry, StoresOnlyWhatTheSymmetryLeavesFree) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    Diagnostics diagnostics;
    const std::string ies =
        written(write_lm63, make_web(one.c_deg, angle_steps(0, 90, 5), one.light), diagnostics);
    EXPECT_THAT(ies, HasSubstr(fmt::format("1 -1 1 19 {} 1 2 0 0 0\r\n", one.lm63_c[2])));
    const std::size_t gammas_end = ies.find(" 90\r\n") + 5;
    const std::string planes = ies.substr(gammas_end, ies.find("\r\n", gammas_end) - gammas_end);
    const std::string last = fmt::format("{}", one.lm63_c[1]);
    EXPECT_TRUE(planes.ends_with(last)) << planes;
  }
}

TEST(WritePhotometry, PutsMissingPlanesOfASymmetryIn) {
  // Planes 0 40 140 220 320: symmetric to both axes, none at 90, 180, 270.
  const PhotometricWeb web =
      make_web({0, 40, 140, 180, 220, 320, 360}, angle_steps(0, 90, 5), [](double c, double gamma) {
        const bool on_axis = c == 0 || c == 180;
        return (on_axis ? 50.0 : 80.0) * (90.0 - gamma);
      });
  EXPECT_THAT(expect_round_trip(write_lm63, web), HasSubstr("\r\n0 40 90\r\n"));
  EXPECT_THAT(expect_round_trip(write_eulumdat, web),
              HasSubstr("\r\n0\r\n40\r\n90\r\n140\r\n180\r\n220\r\n270\r\n320\r\n"));
}

TEST(WritePhotometry, WritesAnIsym3OnlyWherePlanesStandByCount) {
  // Symmetric to C90-C270, but three planes between C0 and C90 and one between C270 and C360.
  const std::vector<double> c = {0, 20, 40, 60, 90, 120, 140, 160, 180, 225, 270, 315, 360};
  const PhotometricWeb web =
      make_web(c, angle_steps(0, 90, 5), test_support::symmetric_about_c90(crooked_light));
  EXPECT_THAT(expect_round_trip(write_eulumdat, web), HasSubstr("\r\n3\r\n0\r\n12\r\n0\r\n19"));
}

TEST(WritePhotometry, KeepsEveryOpeningThatTheFormatsKnow) {
  const PhotometricWeb web = make_web({0}, angle_steps(0, 90, 5), test_support::narrow_spot);
  const LuminousOpening both[] = {
      {OpeningShape::point, 0, 0, 0},         {OpeningShape::rectangle, 0.1, 1.5, 0},
      {OpeningShape::rectangle, 1.5, 0, 0},   {OpeningShape::rectangle, 1.5, 0.2, 0.15},
      {OpeningShape::disk, 0.08, 0.08, 0},    {OpeningShape::disk, 0.2, 0.2, 0.02},
      {OpeningShape::box, 0.1, 1.5, 0.2},     {OpeningShape::box, 0.3, 0.3, 0.3},
      {OpeningShape::cylinder, 0.2, 0.2, 0.3}};
  for (const LuminousOpening& opening : both) {
    expect_round_trip(write_lm63, with_opening(web, opening));
    expect_round_trip(write_eulumdat, with_opening(web, opening));
  }
}

struct CodedOpening {
  LuminousOpening opening;
  const char* code;  // width (C90), length (C0), height
};

TEST(WriteLm63, CodesEveryShapeBySignsAsIn2002) {
  const PhotometricWeb web = make_web({0}, angle_steps(0, 90, 5), test_support::narrow_spot);
  const CodedOpening cases[] = {{{OpeningShape::rectangle, 0, 0.3, 0}, "0.3 0 0"},
                                {{OpeningShape::disk, 0.2, 0.3, 0.03}, "-0.3 -0.2 0.03"},
                                {{OpeningShape::box, 1.2, 0.3, 0.2}, "0.3 1.2 0.2"},
                                {{OpeningShape::cylinder, 0.2, 0.3, 0.4}, "-0.3 -0.2 0.4"},
                                {{OpeningShape::cylinder_c0, 1.2, 0.04, 0.04}, "-0.04 1.2 -0.04"},
                                {{OpeningShape::cylinder_c0, 1.2, 0.04, 0.05}, "-0.04 1.2 -0.05"},
                                {{OpeningShape::cylinder_c0, 0, 0.3, 0.3}, "-0.3 0 -0.3"},
                                {{OpeningShape::cylinder_c90, 0.04, 1.2, 0.05}, "1.2 -0.04 -0.05"},
                                {{OpeningShape::ellipsoid, 0.3, 0.3, 0.3}, "-0.3 -0.3 -0.3"},
                                {{OpeningShape::ellipsoid, 0.2, 0.3, 0.4}, "-0.3 -0.2 -0.4"}};
  for (const CodedOpening& one : cases) {
    SCOPED_TRACE(one.code);
    EXPECT_THAT(expect_round_trip(write_lm63, with_opening(web, one.opening)),
                HasSubstr(fmt::format(" 1 2 {}\r\n", one.code)));
  }
}

// What is written of an opening reads back as `read`, and `warning` says why.
struct ChangedOpening {
  Writer writer;
  LuminousOpening opening, read;
  const char* warning;
};

TEST(WritePhotometry, WarnsOfOpeningsThatAFormatCannotHold) {
  const PhotometricWeb web = make_web({0}, angle_steps(0, 90, 5), test_support::narrow_spot);
  const ChangedOpening cases[] = {
      {write_lm63,
       {OpeningShape::disk, 0.2, 0.2, 0.05},
       {OpeningShape::disk, 0.2, 0.2, 0},
       "LM-63 cannot hold an opening of this kind: a flat opening with a height of more than a "
       "tenth"},
      {write_eulumdat,
       {OpeningShape::disk, 0.2, 0.2, 0.05},
       {OpeningShape::disk, 0.2, 0.2, 0},
       "EULUMDAT cannot hold an opening of this kind: a flat opening with a height"},
      {write_lm63,
       {OpeningShape::rectangle, 1.2, 0.3, 0.2},
       {OpeningShape::rectangle, 1.2, 0.3, 0},
       "the height is left out"},
      {write_lm63,
       {OpeningShape::cylinder_c90, 0.3, 0, 0.3},
       {OpeningShape::box, 0.3, 0, 0.3},
       "a vertical disk that faces C 90"},
      {write_eulumdat,
       {OpeningShape::disk, 0.2, 0.3, 0},
       {OpeningShape::rectangle, 0.2, 0.3, 0},
       "an ellipse: it is written as the rectangle around it"},
      {write_eulumdat,
       {OpeningShape::rectangle, 0, 0.3, 0},
       {OpeningShape::rectangle, 0, 0.3, 0},
       "a width of 0, which would mean a circle: it is written as 0.001 mm"},
      {write_eulumdat,
       {OpeningShape::cylinder, 0.2, 0.3, 0.4},
       {OpeningShape::box, 0.2, 0.3, 0.4},
       "an elliptical cylinder: it is written as the box around it"},
      {write_eulumdat,
       {OpeningShape::cylinder_c0, 1.2, 0.2, 0.2},
       {OpeningShape::box, 1.2, 0.2, 0.2},
       "a lying cylinder: it is written as the box around it"},
      {write_eulumdat,
       {OpeningShape::cylinder_c90, 0.2, 1.2, 0.2},
       {OpeningShape::box, 0.2, 1.2, 0.2},
       "a lying cylinder: it is written as the box around it"},
      {write_eulumdat,
       {OpeningShape::ellipsoid, 0.3, 0.3, 0.4},
       {OpeningShape::cylinder, 0.3, 0.3, 0.4},
       "a sphere or ellipsoid: it is written as the upright cylinder around it"},
      {write_eulumdat,
       {OpeningShape::ellipsoid, 0.2, 0.3, 0.4},
       {OpeningShape::box, 0.2, 0.3, 0.4},
       "an ellipsoid: it is written as the box around it"}};
  for (const ChangedOpening& one : cases) {
    SCOPED_TRACE(one.warning);
    Diagnostics diagnostics;
    const std::string text = written(one.writer, with_opening(web, one.opening), diagnostics);
    EXPECT_EQ(diagnostics.all().size(), 1u);
    EXPECT_THAT(diagnostics_text(diagnostics), HasSubstr("new: warning[photometry-write-opening]"));
    EXPECT_THAT(diagnostics_text(diagnostics), HasSubstr(one.warning));
    const LuminousOpening read = parse_photometry(text, "new", diagnostics)->opening();
    EXPECT_EQ(read.shape, one.read.shape);
    EXPECT_NEAR(read.along_c0_m, one.read.along_c0_m, 2e-6);
    EXPECT_NEAR(read.along_c90_m, one.read.along_c90_m, 2e-6);
    EXPECT_NEAR(read.height_m, one.read.height_m, 2e-6);
  }
}

TEST(WritePhotometry, LeadsDarkEndsOnAndWarnsOfEndsInTheLight) {
  const auto dark = make_web({0}, {5, 20, 65}, [](double, double g) { return g == 20; });
  const std::string ies = expect_round_trip(write_lm63, dark);
  EXPECT_THAT(ies, HasSubstr("\r\n0 5 20 65 90\r\n0\r\n0 0 1 0 0\r\n"));
  expect_round_trip(write_eulumdat, dark);

  const auto up = make_web({0}, {100, 120, 170}, [](double, double g) { return g == 120; });
  EXPECT_THAT(expect_round_trip(write_lm63, up), HasSubstr("\r\n90 100 120 170 180\r\n"));
  EXPECT_THAT(expect_round_trip(write_eulumdat, up),
              HasSubstr("\r\n0\r\n100\r\n120\r\n170\r\n180"));

  Diagnostics diagnostics;
  written(write_lm63, make_web({0}, {0, 65}, [](double, double) { return 1.0; }), diagnostics);
  written(write_lm63, make_web({0}, {90, 180}, [](double, double) { return 1.0; }), diagnostics);
  written(write_eulumdat, make_web({0}, {90, 180}, [](double, double) { return 1.0; }),
          diagnostics);
  EXPECT_EQ(diagnostics_text(diagnostics),
            "new: warning[photometry-write-range]: the table ends in the light and is written as "
            "it is, from gamma 0 to 65; LM-63 requires it from 0 or 90 to 90 or 180, and other "
            "readers may refuse it\n"
            "new: warning[photometry-write-range]: the table ends in the light and is written as "
            "it is, from gamma 90 to 180; EULUMDAT requires it from 0 to 90 or 180, and other "
            "readers may refuse it\n");
}

// Symmetric but for the values at nadir, which a web averages: they must not be lost.
// Tables of type A end in a step to darkness within 1e-5 degrees.
TEST(WritePhotometry, KeepsTheStepToDarknessAtItsSideOfAPlane) {
  const std::string type_a =
      "IESNA:LM-63-2002\n[TEST] a\n[TESTLAB] b\n[ISSUEDATE] c\n[MANUFAC] d\nTILT=NONE\n"
      "1 -1 1 3 3 3 2 0 0 0\n1 1 10\n-90 0 90\n-90 0 90\n15 60 15\n45 90 45\n15 60 15\n";
  Diagnostics diagnostics;
  const std::optional<PhotometricWeb> web = parse_photometry(type_a, "a", diagnostics);
  ASSERT_TRUE(web) << diagnostics_text(diagnostics);
  for (const Writer writer : {write_lm63, write_eulumdat}) {
    const std::string text = written(writer, *web, diagnostics);
    const std::optional<PhotometricWeb> read = parse_photometry(text, "new", diagnostics);
    ASSERT_TRUE(read) << diagnostics_text(diagnostics);
    EXPECT_NEAR(read->flux_lm(), web->flux_lm(), 1e-5 * web->flux_lm());
  }
}

// Another angle of 90 degrees beside one of 89.9999995 would be refused by every reader, ours too.
TEST(WritePhotometry, AnglesNextToTheUsualEndsBecomeThese) {
  const auto from_to = [](double first_deg, double last_deg) {
    return make_web({0}, {first_deg, first_deg + 20.0, last_deg - 20.0, last_deg},
                    [](double, double gamma_deg) {
                      return gamma_deg < 1.0 || std::abs(gamma_deg - 90.0) < 1.0 ? 0.0 : 100.0;
                    });
  };
  for (const auto& [first_deg, last_deg] :
       {std::pair{5e-7, 90.0}, {0.0, 89.9999995}, {0.0, 179.9999995}, {90.0000005, 180.0}}) {
    const PhotometricWeb web = from_to(first_deg, last_deg);
    for (const Writer writer : {write_lm63, write_eulumdat}) {
      Diagnostics diagnostics;
      const std::string text = written(writer, web, diagnostics);
      const std::optional<PhotometricWeb> read = parse_photometry(text, "new", diagnostics);
      ASSERT_TRUE(read) << diagnostics_text(diagnostics);
      EXPECT_NEAR(read->flux_lm(), web.flux_lm(), 1e-6 * web.flux_lm()) << first_deg << last_deg;
    }
  }
}

// In the code page of the file these letters are the byte order marks of UTF-16 and UTF-8.
TEST(WriteEulumdat, MakersDoNotLookLikeByteOrderMarks) {
  for (const char* maker : {"\u00FF\u00FEa", "\u00FE\u00FFa", "\u00EF\u00BB\u00BFa"}) {
    PhotometrySource source;
    source.manufacturer = maker;
    const auto web =
        with_source(make_web({0}, angle_steps(0, 90, 5), test_support::narrow_spot), {}, source);
    Diagnostics diagnostics;
    const std::string text = written(write_eulumdat, web, diagnostics);
    const std::optional<PhotometricWeb> read = parse_photometry(text, "new", diagnostics);
    ASSERT_TRUE(read) << diagnostics_text(diagnostics);
    EXPECT_THAT(read->source().manufacturer, ::testing::StartsWith("_"));
  }
}

TEST(WriteEulumdat, PutsAPlaneInBeforeC360WhereTheLastStepIsTheWidest) {
  const PhotometricWeb web = make_web({0, 50, 180, 210, 360}, angle_steps(0, 90, 5), crooked_light);
  EXPECT_THAT(expect_round_trip(write_eulumdat, web), HasSubstr("\r\n210\r\n270\r\n0\r\n5\r\n"));
  const PhotometricWeb thin = make_web({0, 1, 359, 360}, angle_steps(0, 90, 5), crooked_light);
  EXPECT_THAT(expect_round_trip(write_eulumdat, thin), HasSubstr("\r\n1\r\n359\r\n0\r\n5\r\n"));
}

TEST(WritePhotometry, TakesTheValuesAtThePolesIntoAccount) {
  const auto web =
      make_web(angle_steps(0, 360, 90), angle_steps(0, 90, 10),
               [](double c, double g) { return g == 0 ? 100.0 + c / 90.0 : 90.0 - g; });
  EXPECT_THAT(expect_round_trip(write_lm63, web), HasSubstr("\r\n0 90 180 270 360\r\n"));
  expect_round_trip(write_eulumdat, web);
}

TEST(WritePhotometry, ChangesTextsThatDoNotFitWithAWarning) {
  PhotometrySource source;
  source.luminaire_name = "\xE2\x82\xAC 5\nnew line";
  source.manufacturer = "TILT=NONE";
  const auto web =
      with_source(make_web({0}, angle_steps(0, 90, 5), test_support::narrow_spot), {}, source);
  Diagnostics diagnostics;
  EXPECT_THAT(written(write_lm63, web, diagnostics), HasSubstr("[LUMINAIRE] ? 5 new line\r\n"));
  const std::string ldt = written(write_eulumdat, web, diagnostics);
  EXPECT_THAT(ldt, ::testing::StartsWith("_TILT=NONE\r\n"));
  EXPECT_THAT(diagnostics_text(diagnostics),
              HasSubstr("was shortened or changed to fit into LM-63"));
  EXPECT_THAT(diagnostics_text(diagnostics), HasSubstr("'TILT=NONE' was shortened or changed"));
  EXPECT_TRUE(parse_photometry(ldt, "x", diagnostics).has_value());
}

TEST(WriteEulumdat, WarnsOfMoreAnglesThanTheFormatAllows) {
  Diagnostics diagnostics;
  written(write_eulumdat, make_web({0}, angle_steps(0, 180, 0.25), test_support::narrow_spot),
          diagnostics);
  EXPECT_THAT(diagnostics_text(diagnostics),
              HasSubstr("721 gamma angles are written, where EULUMDAT allows 361"));
}

TEST(WriteLm63, KeepsLinesShort) {
  Diagnostics diagnostics;
  const std::string text =
      written(write_lm63, make_web(angle_steps(0, 360, 5), angle_steps(0, 180, 1), crooked_light),
              diagnostics);
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find("\r\n", begin);
    ASSERT_LE(end - begin, 132u);
    begin = end + 2;
  }
}

TEST(DecimalText, HasSignificantDigitsWithoutExponent) {
  EXPECT_EQ(decimal_text(1234.56789, 7, 12), "1234.568");
  EXPECT_EQ(decimal_text(0.000123456789, 7, 12), "0.0001234568");
  EXPECT_EQ(decimal_text(0.000123456789, 7, 6), "0.000123");
  EXPECT_EQ(decimal_text(1.0e-9, 7, 6), "0");
  EXPECT_EQ(decimal_text(-1.0e-9, 7, 6), "0");
  EXPECT_EQ(decimal_text(123456789.0, 7, 6), "123456789");
  EXPECT_EQ(decimal_text(0.0, 7, 6), "0");
  EXPECT_EQ(decimal_text(100.0, 7, 6), "100");
}

}  // namespace
}  // namespace calc::write_photometry_test
