#include "calc/photometry/read/photometry_file.h"

#include "tests/support/parsed_photometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace calc::eulumdat_test {
namespace {

using test_support::angle_steps;
using test_support::cos_deg;
using test_support::ldt_text;
using test_support::LdtSample;
using test_support::sin_deg;
using testing::HasSubstr;

using Parsed = test_support::ParsedPhotometry;

Parsed parse(const std::string& text, int lamp_set = 0) {
  PhotometryOptions options;
  options.lamp_set = lamp_set;
  return test_support::parse_with_messages(text, "a.ldt", options);
}

PhotometricWeb read(const LdtSample& sample) {
  return test_support::read_silently(ldt_text(sample), "a.ldt");
}

double at(const PhotometricWeb& web, double c_deg, double gamma_deg) {
  return web.intensity_cd(radians_from_degrees(c_deg), radians_from_degrees(gamma_deg));
}

// Different in every direction; about 1000 lm per klm downwards.
double lopsided(double c_deg, double gamma_deg) {
  if (gamma_deg >= 90.0) return 0.0;
  return 1000.0 / kPi * cos_deg(gamma_deg) *
         (1.0 + sin_deg(gamma_deg) *
                    (0.2 * cos_deg(c_deg) + 0.3 * sin_deg(c_deg) + 0.07 * cos_deg(2.0 * c_deg)));
}

TEST(Eulumdat, SourceAndOpeningAreKept) {
  const PhotometricWeb web = read({});
  EXPECT_EQ(web.source().format, "EULUMDAT");
  EXPECT_EQ(web.source().manufacturer, "luxgate examples");
  EXPECT_EQ(web.source().luminaire_name, "formula");
  EXPECT_EQ(web.source().rated_lamp_flux_lm, 1000.0);
  EXPECT_EQ(web.source().input_power_w, 10.0);
  EXPECT_EQ(web.source().applied_factors, "LDT conversion 1 x 1000 lm / 1000");
  EXPECT_EQ(web.opening().shape, OpeningShape::rectangle);
  EXPECT_DOUBLE_EQ(web.opening().along_c90_m, 1.2);  // length lies along C90
  EXPECT_DOUBLE_EQ(web.opening().along_c0_m, 0.3);
}

TEST(Eulumdat, WidthZeroIsACircle) {
  LdtSample sample;
  sample.luminous_length_mm = "250";
  sample.luminous_width_mm = "0";
  const LuminousOpening opening = read(sample).opening();
  EXPECT_EQ(opening.shape, OpeningShape::disk);
  EXPECT_DOUBLE_EQ(opening.along_c0_m, 0.25);
  EXPECT_DOUBLE_EQ(opening.along_c90_m, 0.25);
  sample.luminous_length_mm = "0";
  EXPECT_THAT(parse(ldt_text(sample)).messages, HasSubstr("warning[photometry-no-area]"));
}

TEST(Eulumdat, IntensityIsTableTimesConversionTimesSetFlux) {
  LdtSample sample;
  sample.lamp_set_lines = {"2", "T16", "3000", "840", "1B", "62.5"};
  sample.conversion = "1.5";
  sample.cd_per_klm = [](double, double gamma) {
    return gamma < 90 ? 200.0 * cos_deg(gamma) : 0.0;
  };
  sample.output_ratio = "94.2";
  const PhotometricWeb web = read(sample);
  EXPECT_NEAR(web.source().stated_flux_lm, 0.942 * 3000.0, 1e-9);
  EXPECT_NEAR(at(web, 0, 0), 900.0, 1e-10);  // not times the number of lamps
  EXPECT_EQ(web.source().applied_factors, "LDT conversion 1.5 x 3000 lm / 1000");
}

TEST(Eulumdat, NegativeLampCountMarksAbsolutePhotometry) {
  LdtSample sample;
  sample.lamp_set_lines[0] = "-1";
  sample.lamp_set_lines[2] = "4321";
  const PhotometricWeb web = read(sample);
  EXPECT_EQ(web.source().rated_lamp_flux_lm, 0.0);
  EXPECT_EQ(web.source().stated_flux_lm, 4321.0);
  EXPECT_NEAR(at(web, 0, 0), 4321.0 / kPi, 1e-9);
}

LdtSample with_three_lamp_sets() {
  LdtSample sample;
  sample.lamp_set_lines = {"1",  "LED110", "1000", "4000", "80", "10",  //
                           "-1", "LED120", "1200", "4000", "80", "12",  //
                           "2",  "broken", "none", "4000", "80", "?"};
  return sample;
}

TEST(Eulumdat, TheFirstOfSeveralLampSetsIsUsed) {
  const Parsed parsed = parse(ldt_text(with_three_lamp_sets()));
  EXPECT_EQ(parsed.messages,
            "a.ldt:26: warning[photometry-lamp-sets]: 3 lamp sets are stated; they are "
            "alternatives, the first one is used; choose with lamp-set: 1 (LED110, 1000 lm), 2 "
            "(LED120, 1200 lm), 3 (broken, none lm)\n");
  EXPECT_EQ(parsed.web->source().rated_lamp_flux_lm, 1000.0);
  EXPECT_NEAR(at(*parsed.web, 0, 0), 1000.0 / kPi, 1e-10);
}

TEST(Eulumdat, AChosenLampSetGivesTheLightAndThePower) {
  const Parsed parsed = parse(ldt_text(with_three_lamp_sets()), 2);
  EXPECT_EQ(parsed.messages, "");
  EXPECT_NEAR(at(*parsed.web, 0, 0), 1200.0 / kPi, 1e-10);
  EXPECT_EQ(parsed.web->source().input_power_w, 12.0);
  EXPECT_EQ(parsed.web->source().rated_lamp_flux_lm, 0.0);  // -1 lamps: absolute
  EXPECT_EQ(parsed.web->source().applied_factors,
            "LDT conversion 1 x 1200 lm / 1000 (lamp set 2 of 3)");
  EXPECT_EQ(parse(ldt_text(with_three_lamp_sets()), 1).messages, "");
  EXPECT_EQ(parse(ldt_text(with_three_lamp_sets()), 3).messages,
            "a.ldt:41: error[photometry-number]: the flux of the lamp set (lm): 'none' is not a "
            "number; allowed: digits with a decimal point and an exponent\n");
}

// Both numbers of lamps, then both types, and so on: the second set would have 80 lm.
TEST(Eulumdat, LampSetsInAnotherOrderAreRefusedWhicheverIsChosen) {
  LdtSample sample;
  sample.lamp_set_lines = {"1",   "1",   "LED", "LED", "1000", "2000",
                           "840", "840", "80",  "80",  "10",   "20"};
  for (const int chosen : {0, 1, 2}) {
    EXPECT_THAT(
        parse(ldt_text(sample), chosen).messages,
        HasSubstr("a.ldt:29: error[photometry-number]: the flux of the lamp set (lm): 'LED' "
                  "is not a number"))
        << chosen;
  }
}

TEST(Eulumdat, AnAbsentLampSetIsAnErrorThatListsTheOthers) {
  EXPECT_EQ(parse(ldt_text(with_three_lamp_sets()), 4).messages,
            "a.ldt: error[photometry-choice]: a.ldt has no lamp set '4'; allowed: 1 (LED110, 1000 "
            "lm), 2 (LED120, 1200 lm), 3 (broken, none lm)\n");
  EXPECT_THAT(parse(ldt_text({}), 2).messages, HasSubstr("allowed: 1 (LED, 1000 lm)"));
  EXPECT_THAT(parse(ldt_text({}), -1).messages, HasSubstr("has no lamp set '-1'"));
  EXPECT_EQ(parse(ldt_text({}), 1).messages, "");
}

TEST(Eulumdat, ABlankNumberOfLampsIsWarnedOf) {
  LdtSample sample;
  sample.lamp_set_lines[0] = "";
  const Parsed parsed = parse(ldt_text(sample));
  EXPECT_EQ(parsed.messages,
            "a.ldt:27: warning[photometry-blank]: the number of lamps is blank and counts as 0\n");
  EXPECT_EQ(parsed.web->source().rated_lamp_flux_lm, 1000.0);
}

TEST(Eulumdat, TheLargestLuminousHeightIsKept) {
  for (int side = 0; side < 4; ++side) {
    std::string text = ldt_text({});
    std::size_t line = 0;
    for (int i = 0; i < 17 + side; ++i) line = text.find('\n', line) + 1;  // to lines 18 to 21
    ASSERT_EQ(text[line], '0');
    text.replace(line, 1, "45,5");
    const Parsed parsed = parse(text);
    ASSERT_TRUE(parsed.web) << parsed.messages;
    EXPECT_DOUBLE_EQ(parsed.web->opening().height_m, 0.0455) << side;
  }
}

TEST(Eulumdat, SymmetryNoneStoresAllPlanes) {
  LdtSample sample;
  sample.cd_per_klm = lopsided;
  const PhotometricWeb web = read(sample);
  for (const double c : angle_steps(0, 345, 15))
    EXPECT_NEAR(at(web, c, 45), lopsided(c, 45), 1e-10) << c;
}

TEST(Eulumdat, SymmetryOneStoresOnePlaneWhateverTheCount) {
  LdtSample sample;
  sample.symmetry = "1";
  sample.stored_c_deg = {0};
  EXPECT_TRUE(read(sample).is_axial());
  sample.all_c_deg = {0};
  EXPECT_TRUE(read(sample).is_axial());
}

TEST(Eulumdat, SymmetryTwoIsMirroredAtC0C180) {
  LdtSample sample;
  sample.symmetry = "2";
  sample.stored_c_deg = angle_steps(0, 180, 15);
  sample.cd_per_klm = lopsided;
  sample.output_ratio = "112";  // the sine term does not cancel
  const PhotometricWeb web = *parse(ldt_text(sample)).web;
  for (const double c : angle_steps(0, 180, 15)) {
    EXPECT_NEAR(at(web, c, 45), lopsided(c, 45), 1e-10) << c;
    EXPECT_NEAR(at(web, 360 - c, 45), lopsided(c, 45), 1e-10) << c;
  }
}

TEST(Eulumdat, SymmetryThreeStartsAtC270) {
  LdtSample sample;
  sample.symmetry = "3";
  sample.stored_c_deg = angle_steps(270, 345, 15);
  for (const double c : angle_steps(0, 90, 15)) sample.stored_c_deg.push_back(c);
  sample.cd_per_klm = lopsided;
  const PhotometricWeb web = *parse(ldt_text(sample)).web;
  for (const double c : sample.stored_c_deg) {
    EXPECT_NEAR(at(web, c, 45), lopsided(c, 45), 1e-10) << c;
    EXPECT_NEAR(at(web, 180 - c, 45), lopsided(c, 45), 1e-10) << c;
  }
  EXPECT_GT(at(web, 90, 45), 1.3 * at(web, 270, 45));
}

TEST(Eulumdat, SymmetryFourStoresAQuadrant) {
  LdtSample sample;
  sample.symmetry = "4";
  sample.stored_c_deg = angle_steps(0, 90, 15);
  sample.cd_per_klm = lopsided;
  const PhotometricWeb web = *parse(ldt_text(sample)).web;
  for (const double c : sample.stored_c_deg) {
    for (const double image : {c, 180 - c, 180 + c, 360 - c}) {
      EXPECT_NEAR(at(web, image, 45), lopsided(c, 45), 1e-10) << image;
    }
  }
}

TEST(Eulumdat, IrregularPlanesAreFoundByTheirAngles) {
  LdtSample sample;
  sample.symmetry = "3";
  sample.all_c_deg = {0, 10, 40, 90, 135, 180, 230, 270, 300, 350};
  sample.stored_c_deg = {270, 300, 350, 0, 10, 40, 90};
  sample.cd_per_klm = lopsided;
  const PhotometricWeb web = *parse(ldt_text(sample)).web;
  for (const double c : sample.stored_c_deg)
    EXPECT_NEAR(at(web, c, 30), lopsided(c, 30), 1e-10) << c;
  sample.all_c_deg = {0, 10, 40, 135, 180, 270};
  sample.stored_c_deg = {0};
  EXPECT_THAT(
      parse(ldt_text(sample)).messages,
      HasSubstr("error[photometry-symmetry-plane]: symmetry Isym 3 needs a C-plane at 90 degrees"));
}

TEST(Eulumdat, DecimalCommasExponentsAndLineEndsAreRead) {
  const double expected = read({}).flux_lm();
  std::string commas = ldt_text({});
  for (char& c : commas) c = c == '.' ? ',' : c;
  EXPECT_DOUBLE_EQ(parse(commas).web->flux_lm(), expected);
  std::string crlf;
  for (const char c : ldt_text({})) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(parse(crlf + "\r\n\r\n").messages, "");
  std::string no_end = ldt_text({});
  no_end.pop_back();
  EXPECT_EQ(parse(no_end).messages, "");
  EXPECT_EQ(parse("\xEF\xBB\xBF" + ldt_text({})).messages, "");
}

TEST(Eulumdat, TextBehindNumbersIsReportedOnce) {
  LdtSample sample;
  sample.lamp_set_lines[2] = "1000 lm";
  sample.lamp_set_lines[5] = "10 W";
  EXPECT_EQ(parse(ldt_text(sample)).messages,
            "a.ldt:29: warning[photometry-text-after-number]: text after a number was not used: "
            "'1000 lm'; further "
            "cases are not listed\n");
}

TEST(Eulumdat, BlankDimensionsCountAsZeroAndAreReported) {
  LdtSample sample;
  sample.luminous_width_mm = "";
  const Parsed parsed = parse(ldt_text(sample));
  EXPECT_EQ(
      parsed.messages,
      "a.ldt:17: warning[photometry-blank]: the luminous width (mm) is blank and counts as 0\n");
  EXPECT_EQ(parsed.web->opening().shape, OpeningShape::disk);
}

TEST(Eulumdat, StatedRatiosAreCompared) {
  LdtSample sample;
  sample.output_ratio = "60";
  EXPECT_EQ(parse(ldt_text(sample)).messages,
            "a.ldt: warning[photometry-output-ratio]: the light output ratio is stated as 60 %, "
            "but the intensities add "
            "up to 99.94 %\n");
  sample.output_ratio = "100";
  sample.downward = "40";
  EXPECT_THAT(parse(ldt_text(sample)).messages,
              HasSubstr("warning[photometry-downward-share]: the downward flux fraction is stated "
                        "as 40 %, but the "
                        "intensities give 100 %"));
  sample.downward = "100";
  sample.measured_tilt = "15";
  EXPECT_THAT(
      parse(ldt_text(sample)).messages,
      HasSubstr("warning[photometry-measured-tilt]: measured with the luminaire tilted by 15"));
}

TEST(Eulumdat, LuminousHeightsBeyondReasonAreRefused) {
  std::string text = ldt_text({});
  text.replace(text.find("\n0\n0\n0\n0\n"), 3, "\n1e9\n");
  EXPECT_THAT(parse(text).messages,
              HasSubstr("the luminous opening's largest side (m) is 1000000; allowed: 0 or 1e-06 "
                        "to 10000"));
}

TEST(Eulumdat, BadValuesAreRefusedWithTheirLine) {
  const auto messages = [](auto change) {
    LdtSample sample;
    change(sample);
    const Parsed parsed = parse(ldt_text(sample));
    EXPECT_FALSE(parsed.web);
    return parsed.messages;
  };
  EXPECT_EQ(messages([](LdtSample& s) { s.symmetry = "5"; }),
            "a.ldt:3: error[photometry-value]: the symmetry (Isym) is 5; allowed: a whole number "
            "from 0 to 4\n");
  EXPECT_THAT(messages([](LdtSample& s) { s.lamp_set_lines.clear(); }),
              HasSubstr("a.ldt:26: error[photometry-value]: the number of lamp sets is 0"));
  EXPECT_THAT(messages([](LdtSample& s) { s.lamp_set_lines[2] = "0"; }),
              HasSubstr("a.ldt:29: error[photometry-value]: the flux of the lamp set (lm) is 0"));
  EXPECT_THAT(messages([](LdtSample& s) { s.conversion = "0"; }),
              HasSubstr("the conversion factor for intensities is 0"));
  EXPECT_THAT(messages([](LdtSample& s) { s.conversion = "x"; }),
              HasSubstr("a.ldt:24: error[photometry-number]: the conversion factor for "
                        "intensities: 'x' is not a number"));
  EXPECT_THAT(messages([](LdtSample& s) { s.luminous_length_mm = "-3"; }),
              HasSubstr("the luminous length (mm) is -3"));
  EXPECT_THAT(messages([](LdtSample& s) {
                s.gamma_deg = {0, 50, 40};
              }),
              HasSubstr("gamma angles must ascend by at least 1e-6 degrees; 40 comes after 50"));
  EXPECT_THAT(messages([](LdtSample& s) { s.cd_per_klm = [](double, double) { return 0.0; }; }),
              HasSubstr("error[photometry-no-light]"));
  EXPECT_THAT(messages([](LdtSample& s) { s.cd_per_klm = [](double, double) { return -10.0; }; }),
              HasSubstr("error[photometry-negative]: an intensity of -10 cd is negative"));
}

TEST(Eulumdat, LineCountMustMatchTheCounts) {
  LdtSample sample;
  sample.symmetry = "4";  // seven planes, but all are written
  EXPECT_THAT(parse(ldt_text(sample)).messages,
              HasSubstr("error[photometry-lines]: the intensities need 259 lines by the counts and "
                        "the symmetry, but 888 "
                        "are left in the file"));
}

TEST(Eulumdat, HugeCountsFailWithoutAllocating) {
  std::string text = ldt_text({});
  const std::size_t count = text.find("\n24\n") + 1;
  EXPECT_THAT(parse(std::string(text).replace(count, 2, "999999999")).messages,
              HasSubstr("a.ldt:42: error[photometry-count]: the C and gamma angles need 1000000036 "
                        "numbers, but only "));
  EXPECT_THAT(parse(std::string(text).replace(count, 2, "1e99")).messages,
              HasSubstr("the number of C-planes (Mc) is 1e+99"));
}

TEST(Eulumdat, TruncationAnywhereIsAnError) {
  LdtSample sample;
  sample.symmetry = "1";
  sample.stored_c_deg = {0};
  const std::string text = ldt_text(sample);
  for (std::size_t length = 0; length + 2 < text.size(); ++length) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_photometry(std::string_view(text).substr(0, length), "cut.ldt", diagnostics))
        << length;
    EXPECT_TRUE(diagnostics.has_errors()) << length;
  }
}

TEST(Eulumdat, MutilatedFilesNeverCrash) {
  LdtSample sample;
  sample.symmetry = "4";
  sample.all_c_deg = angle_steps(0, 270, 90);
  sample.stored_c_deg = {0, 90};
  sample.gamma_deg = {0, 45, 90};
  const std::string text = ldt_text(sample);
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char c : {'\0', '-', '9', 'e', ',', '\n', '.', '\xFF'}) {
      std::string changed = text;
      changed[i] = c;
      Diagnostics diagnostics;
      const auto web = parse_photometry(changed, "m.ldt", diagnostics);
      EXPECT_EQ(!web, diagnostics.has_errors());
      EXPECT_TRUE(!web || web->flux_lm() > 0.0);
    }
  }
}

}  // namespace
}  // namespace calc::eulumdat_test
