#include "calc/photometry/read/photometry_file.h"

#include "tests/support/parsed_photometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace calc::ies_lm63_test {
namespace {

using test_support::angle_steps;
using test_support::cos_deg;
using test_support::ies_text;
using test_support::IesSample;
using test_support::sin_deg;
using testing::HasSubstr;

using Parsed = test_support::ParsedPhotometry;

Parsed parse(const std::string& text) { return test_support::parse_with_messages(text, "a.ies"); }

PhotometricWeb read(const IesSample& sample) {
  return test_support::read_silently(ies_text(sample), "a.ies");
}

double at(const PhotometricWeb& web, double c_deg, double gamma_deg) {
  return web.intensity_cd(radians_from_degrees(c_deg), radians_from_degrees(gamma_deg));
}

// Different in every direction, the same at the poles.
double lopsided(double c_deg, double gamma_deg) {
  return 100.0 + sin_deg(gamma_deg) *
                     (20.0 * cos_deg(c_deg) + 30.0 * sin_deg(c_deg) + 7.0 * cos_deg(2.0 * c_deg));
}

TEST(Lm63, SourceIsKept) {
  const PhotometricWeb web = read({});
  EXPECT_EQ(web.source().format, "IESNA:LM-63-2002");
  EXPECT_EQ(web.source().luminaire_name, "formula");
  EXPECT_EQ(web.source().manufacturer, "luxgate examples");
  EXPECT_EQ(web.source().rated_lamp_flux_lm, 0.0);
  EXPECT_EQ(web.source().input_power_w, 10.0);
  EXPECT_EQ(web.source().applied_factors, "multiplier 1 x ballast 1");
  EXPECT_TRUE(web.is_axial());
  EXPECT_EQ(web.opening().shape, OpeningShape::point);
}

TEST(Lm63, TableTimesMultiplierTimesBallastFactorAndNeverLampLumens) {
  IesSample sample;
  sample.lamps = "2 100";
  sample.multiplier = "0.5";
  sample.factors = "0.9 1 20";
  const PhotometricWeb web = read(sample);
  EXPECT_NEAR(at(web, 0, 0), 45.0, 1e-12);
  EXPECT_EQ(web.source().rated_lamp_flux_lm, 200.0);
}

TEST(Lm63, Field12ScalesIn1986And1991Only) {
  for (const auto& [tag, expected, warned] : {std::tuple{"a maker's own first line", 80.0, false},
                                              {"IESNA91", 80.0, false},
                                              {"IESNA:LM-63-1995", 100.0, true},
                                              {"IESNA:LM-63-2002", 100.0, true},
                                              {"IES:LM-63-2019", 100.0, false}}) {
    IesSample sample;
    sample.tag = tag;
    sample.factors = "1 0.8 10";
    const Parsed parsed = parse(ies_text(sample));
    ASSERT_TRUE(parsed.web) << tag;
    EXPECT_NEAR(at(*parsed.web, 0, 0), expected, 1e-12) << tag;
    EXPECT_EQ(parsed.messages.find("photometry-field12") != std::string::npos, warned)
        << parsed.messages;
  }
}

TEST(Lm63, VersionTagsOfPracticeAreKnown) {
  for (const char* tag : {"  IESNA:LM-63-2002", "IESNA: LM-63-2002", "iesna:lm-63-1995", "IESNA95",
                          "IESNA:LM-63-1986"}) {
    IesSample sample;
    sample.tag = tag;
    EXPECT_EQ(parse(ies_text(sample)).messages, "") << tag;
  }
  IesSample sample;
  sample.tag = "IESNA:LM-63-2042";
  EXPECT_THAT(
      parse(ies_text(sample)).messages,
      HasSubstr(
          "a.ies:1: warning[photometry-version]: 'IESNA:LM-63-2042' is not a known LM-63 version"));
}

TEST(Lm63, MissingKeywordsAreNamed) {
  IesSample sample;
  sample.keywords = "[test] lower case counts\n[OTHER] x\n[MORE] y\n";
  EXPECT_EQ(parse(ies_text(sample)).messages,
            "a.ies:1: warning[photometry-keywords]: keywords that this LM-63 version requires are "
            "missing: "
            "TESTLAB, ISSUEDATE, MANUFAC\n");
}

TEST(Lm63, ContinuedKeywordsAreJoinedAndCodePagesConverted) {
  IesSample sample;
  sample.keywords += "[LUMCAT] x\n";
  std::string text = ies_text(sample);
  text.replace(text.find("[LUMINAIRE] formula"), 19, "[LUMINAIRE] B\xFCro\n[MORE] 2");
  EXPECT_EQ(parse(text).web->source().luminaire_name, "B\xC3\xBCro 2");
}

TEST(Lm63, AnyLineEndDelimiterAndTokenFormIsRead) {
  const std::string text = ies_text({});
  const double expected = read({}).flux_lm();
  const auto replaced = [&](std::string from, const std::string& to) {
    std::string result;
    for (const char c : text) result += std::string(1, c) == from ? to : std::string(1, c);
    return result;
  };
  EXPECT_EQ(parse(replaced("\n", "\r\n")).messages, "");
  EXPECT_EQ(parse(replaced("\n", "\r")).messages, "");
  EXPECT_EQ(parse("\xEF\xBB\xBF" + text).messages, "");
  const std::size_t numbers = text.find("TILT=NONE\n") + 10;
  std::string commas = text;
  for (std::size_t i = numbers; i < commas.size(); ++i) {
    if (commas[i] == ' ') commas[i] = ',';
    if (commas[i] == '\n') commas[i] = ' ';
  }
  EXPECT_DOUBLE_EQ(parse(commas).web->flux_lm(), expected);
  std::string one_per_line = text;
  for (std::size_t i = numbers; i < one_per_line.size(); ++i) {
    if (one_per_line[i] == ' ') one_per_line[i] = '\n';
  }
  EXPECT_DOUBLE_EQ(parse(one_per_line).web->flux_lm(), expected);
  IesSample floats;
  floats.lamps = "1.0 -1.0";
  floats.type = "1.0";
  floats.tilt = "  tilt = none \n";
  floats.multiplier = "1D0";
  EXPECT_DOUBLE_EQ(read(floats).flux_lm(), expected);
}

TEST(Lm63, QuadrantHalfAndFullFilesDescribeTheSameSymmetricLight) {
  const auto quadrant_light = [](double c, double gamma) {
    return 100.0 + 20.0 * sin_deg(gamma) * cos_deg(2.0 * c);
  };
  IesSample sample;
  sample.gamma_deg = angle_steps(0, 180, 10);
  sample.cd = quadrant_light;
  for (const double last : {90.0, 180.0, 360.0}) {
    sample.c_deg = angle_steps(0, last, 15);
    const PhotometricWeb web = read(sample);
    EXPECT_EQ(web.c_rad().size(), 25U);
    for (const double c : angle_steps(0, 360, 15)) {
      EXPECT_NEAR(at(web, c, 50), quadrant_light(c, 50), 1e-10) << last << " " << c;
    }
  }
}

TEST(Lm63, HalfFrom0To180IsMirroredAtTheC0Plane) {
  IesSample sample;
  sample.gamma_deg = angle_steps(0, 180, 10);
  sample.c_deg = angle_steps(0, 180, 30);
  sample.cd = lopsided;
  const PhotometricWeb web = read(sample);
  for (const double c : {30.0, 90.0, 150.0}) {
    EXPECT_NEAR(at(web, c, 90), lopsided(c, 90), 1e-10);
    EXPECT_NEAR(at(web, 360 - c, 90), lopsided(c, 90), 1e-10);
  }
}

TEST(Lm63, HalfFrom90To270IsMirroredAtTheC90Plane) {
  IesSample sample;
  sample.tag = "IESNA:LM-63-1995";
  sample.gamma_deg = angle_steps(0, 180, 10);
  sample.c_deg = angle_steps(90, 270, 30);
  sample.cd = lopsided;
  const PhotometricWeb web = read(sample);
  for (const double c : {90.0, 120.0, 180.0, 210.0, 270.0}) {
    EXPECT_NEAR(at(web, c, 90), lopsided(c, 90), 1e-10) << c;
    EXPECT_NEAR(at(web, 180 - c, 90), lopsided(c, 90), 1e-10) << c;
  }
  sample.tag = "IESNA:LM-63-2002";
  EXPECT_THAT(parse(ies_text(sample)).messages, HasSubstr("warning[photometry-range-90-270]"));
}

TEST(Lm63, FullCircleKeepsEveryPlaneWhereItIs) {
  IesSample sample;
  sample.gamma_deg = angle_steps(0, 180, 10);
  sample.c_deg = angle_steps(0, 360, 15);
  sample.cd = lopsided;
  const PhotometricWeb web = read(sample);
  for (const double c : angle_steps(0, 360, 15))
    EXPECT_NEAR(at(web, c, 70), lopsided(c, 70), 1e-10);
  sample.c_deg.pop_back();
  const Parsed closed = parse(ies_text(sample));
  EXPECT_THAT(closed.messages,
              HasSubstr("warning[photometry-circle-closed]: the C-planes run from 0 to 345"));
  EXPECT_DOUBLE_EQ(closed.web->flux_lm(), web.flux_lm());
  sample.c_deg = angle_steps(0, 300, 15);
  EXPECT_THAT(parse(ies_text(sample)).messages,
              HasSubstr("error[photometry-planes]: the C-planes from 0 to 300"));
}

TEST(Lm63, Planes0And360ThatDifferAreAveragedAndReported) {
  IesSample sample;
  sample.gamma_deg = {0, 90, 180};
  sample.c_deg = {0, 180, 360};
  sample.cd = [](double c, double gamma) { return c == 360.0 && gamma == 90.0 ? 110.0 : 100.0; };
  const Parsed parsed = parse(ies_text(sample));
  EXPECT_THAT(
      parsed.messages,
      HasSubstr("warning[photometry-circle-differs]: C 0 and C 360 differ by up to 10 cd (9.1 %"));
  EXPECT_NEAR(at(*parsed.web, 0, 90), 105.0, 1e-12);
  EXPECT_NEAR(at(*parsed.web, 360, 90), 105.0, 1e-12);
}

TEST(Lm63, OpeningComesInMetresWithLengthAlongC0) {
  IesSample sample;
  sample.opening = "1 1 4 0";  // feet: width 1, length 4
  const LuminousOpening feet = read(sample).opening();
  EXPECT_EQ(feet.shape, OpeningShape::rectangle);
  EXPECT_DOUBLE_EQ(feet.along_c0_m, 1.2192);
  EXPECT_DOUBLE_EQ(feet.along_c90_m, 0.3048);
  sample.opening = "2 -0.2 -0.2 0";
  EXPECT_EQ(read(sample).opening().shape, OpeningShape::disk);
  sample.opening = "1 300 1200 0";
  EXPECT_THAT(parse(ies_text(sample)).messages,
              HasSubstr("warning[photometry-opening-size]: an opening of 365.8 m is unusual; is "
                        "the unit right (the "
                        "file says feet)?"));
  sample.opening = "2 -0.3 -0.3 -0.3";
  EXPECT_EQ(read(sample).opening().shape, OpeningShape::ellipsoid);
  sample.opening = "2 0.3 0.3 -0.3";
  EXPECT_THAT(parse(ies_text(sample)).messages,
              HasSubstr("warning[photometry-opening-shape]: the opening '0.3 0.3 -0.3' is no shape "
                        "of the code tables; its bounding box is used"));
  sample.opening = "2 1e9 0 0";
  EXPECT_THAT(parse(ies_text(sample)).messages,
              HasSubstr("error[photometry-value]: the opening's size in metres"));
}

TEST(Lm63, CountsAreCheckedAgainstTheFileBeforeAllocating) {
  std::string text = ies_text({});
  const std::size_t counts = text.find(" 19 1 1 2 0 0 0");
  ASSERT_NE(counts, std::string::npos);
  EXPECT_THAT(parse(std::string(text).replace(counts, 5, " 900000000 900000000")).messages,
              HasSubstr("error[photometry-count]: the angles and candela values need "
                        "810000001800000000 numbers, but "
                        "only 39 are left in the file"));
  EXPECT_THAT(
      parse(std::string(text).replace(counts, 5, " -5 1")).messages,
      HasSubstr(
          "the number of vertical angles is -5; allowed: a whole number from 2 to 1000000000"));
  EXPECT_THAT(parse(std::string(text).replace(counts, 5, " 19 0")).messages,
              HasSubstr("the number of horizontal angles is 0; allowed: a whole number from 1"));
}

TEST(Lm63, TruncationAnywhereIsAnError) {
  const std::string text = ies_text({});
  const std::size_t last_number = text.find_last_of(' ');
  for (std::size_t length = 0; length <= last_number; ++length) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_photometry(std::string_view(text).substr(0, length), "cut.ies", diagnostics))
        << length;
    EXPECT_TRUE(diagnostics.has_errors()) << length;
  }
}

TEST(Lm63, BadValuesAreRefusedWithTheirLine) {
  const auto messages = [](auto change) {
    IesSample sample;
    change(sample);
    return parse(ies_text(sample)).messages;
  };
  EXPECT_EQ(messages([](IesSample& s) { s.opening = "2 0 0 0-5"; }),
            "a.ies:8: error[photometry-number]: the height of the opening: '0-5' is not a number; "
            "allowed: digits with "
            "a decimal point and an exponent\n");
  EXPECT_EQ(messages([](IesSample& s) { s.multiplier = "0"; }),
            "a.ies:8: error[photometry-value]: the candela multiplier is 0; allowed: > 0\n");
  EXPECT_THAT(messages([](IesSample& s) { s.multiplier = "nan"; }),
              HasSubstr("'nan' is not a number"));
  EXPECT_THAT(messages([](IesSample& s) { s.multiplier = "1e300"; }),
              HasSubstr("allowed: up to 1e12"));
  EXPECT_THAT(messages([](IesSample& s) { s.type = "4"; }), HasSubstr("the photometric type is 4"));
  EXPECT_THAT(messages([](IesSample& s) { s.opening = "3 0 0 0"; }),
              HasSubstr("the units type (1 feet, 2 metres) is 3"));
  EXPECT_THAT(messages([](IesSample& s) { s.lamps = "1 -2"; }),
              HasSubstr("or -1 for absolute photometry"));
  EXPECT_THAT(messages([](IesSample& s) { s.lamps = "1 1e308"; }),
              HasSubstr("the flux of all lamps (lm) is 1e+308; allowed: 0 or 1e-06 to 1e+12"));
  EXPECT_THAT(messages([](IesSample& s) { s.factors = "1 1 1e300"; }),
              HasSubstr("the input power (W) is 1e+300"));
  EXPECT_THAT(messages([](IesSample& s) { s.lamps = "0 100"; }),
              HasSubstr("the number of lamps is 0"));
  EXPECT_THAT(messages([](IesSample& s) { s.factors = "0 1 10"; }),
              HasSubstr("the ballast factor is 0"));
  EXPECT_THAT(messages([](IesSample& s) { s.factors = "1 1 -10"; }),
              HasSubstr("the input watts is -10"));
  EXPECT_EQ(messages([](IesSample& s) {
              s.gamma_deg = {0, 20, 20, 90};
            }),
            "a.ies:10: error[photometry-angle-order]: vertical angles must ascend by at least 1e-6 "
            "degrees; 20 comes "
            "after 20\n");
  EXPECT_THAT(messages([](IesSample& s) {
                s.gamma_deg = {-10, 90};
              }),
              HasSubstr("vertical angle is -10; allowed: 0 to 180"));
  EXPECT_THAT(messages([](IesSample& s) {
                s.c_deg = {0, 400};
              }),
              HasSubstr("horizontal angle is 400; allowed: 0 to 360"));
  EXPECT_THAT(messages([](IesSample& s) { s.cd = [](double, double) { return 0.0; }; }),
              HasSubstr("a.ies:12: error[photometry-no-light]: all intensities are zero"));
}

TEST(Lm63, NegativeIntensitiesAreAnErrorUnlessNoise) {
  IesSample sample;
  sample.cd = [](double, double gamma) {
    return gamma == 85.0 ? -5.0 : gamma == 90.0 ? 0.0 : 100.0;
  };
  EXPECT_THAT(parse(ies_text(sample)).messages,
              HasSubstr("a.ies:12: error[photometry-negative]: an intensity of -5 cd is negative"));
  sample.cd = [](double, double gamma) { return gamma >= 85.0 ? -0.05 : 100.0; };
  const Parsed noise = parse(ies_text(sample));
  EXPECT_THAT(
      noise.messages,
      HasSubstr("warning[photometry-noise]: 2 slightly negative intensities, down to -0.05 cd"));
  EXPECT_EQ(at(*noise.web, 0, 85), 0.0);
}

TEST(Lm63, LeftOverTextIsReported) {
  IesSample sample;
  sample.tail = "END\n";
  EXPECT_EQ(parse(ies_text(sample)).messages,
            "a.ies:13: warning[photometry-trailing]: 1 more values than the counts say were not "
            "used; the first is "
            "'END'\n");
  sample.tail = "\x1A junk";
  EXPECT_THAT(parse(ies_text(sample)).messages,
              HasSubstr("warning[photometry-end-mark]: the text ends at a DOS "
                        "end-of-file mark; 5 bytes behind it"));
}

TEST(Lm63, DecimalCommasAreRefused) {
  IesSample sample;
  sample.cd = [](double, double gamma) { return 100.5 - gamma; };
  sample.gamma_deg = angle_steps(0, 90, 10);
  std::string text = ies_text(sample);
  for (std::size_t i = text.find("100.5"); i < text.size(); ++i) {
    if (text[i] == '.') text[i] = ',';
  }
  EXPECT_THAT(parse(text).messages,
              HasSubstr("error[photometry-decimal-comma]: 10 more values than the counts say"));
}

TEST(Lm63, OddButReadableFilesAreWarnedOf) {
  const auto messages = [](auto change) {
    IesSample sample;
    change(sample);
    const Parsed parsed = parse(ies_text(sample));
    EXPECT_TRUE(parsed.web);
    return parsed.messages;
  };
  EXPECT_THAT(messages([](IesSample& s) { s.factors = "1 1 0"; }),
              HasSubstr("warning[photometry-no-power]"));
  EXPECT_THAT(messages([](IesSample& s) { s.lamps = "1 0"; }),
              HasSubstr("warning[photometry-no-lumens]"));
  EXPECT_THAT(messages([](IesSample& s) { s.lamps = "1 100"; }),
              HasSubstr("warning[photometry-flux-over-lamps]: the luminaire gives 314 lm, more "
                        "than its lamps' 100 lm"));
  EXPECT_THAT(
      messages([](IesSample& s) { s.gamma_deg = angle_steps(0, 60, 10); }),
      HasSubstr(
          "warning[photometry-gamma-range]: the table covers gamma 0 to 60 degrees, up to 50 cd"));
  EXPECT_THAT(messages([](IesSample& s) {
                s.c_deg = {0, 90};
                s.cd = [](double c, double gamma) { return gamma < 90 ? 100.0 - c / 9.0 : 0.0; };
              }),
              HasSubstr("warning[photometry-pole-spread]: at gamma 0 all C-planes should agree, "
                        "but they range from 90 to 100 cd"));
}

// A table of candelas per 1000 lm, whose multiplier was forgotten: too dark by as much as the lamps
// have more than 1000 lm. It sums to about 1000 lm, or to little of what is rated.
TEST(Lm63, CandelasPerKilolumenAreSuspected) {
  const auto messages = [](const std::string& lamps, double peak_cd) {
    IesSample sample;
    sample.lamps = lamps;
    sample.cd = [peak_cd](double, double gamma) {
      return gamma < 90.0 ? peak_cd * cos_deg(gamma) : 0.0;
    };
    return parse(ies_text(sample)).messages;
  };
  const std::string id = "warning[photometry-low-flux]";
  const double peak_of_980_lm = 980.0 / 3.14;  // about: pi lm for 1 cd
  EXPECT_THAT(messages("1 50000", peak_of_980_lm), HasSubstr(id));
  EXPECT_THAT(messages("1 4000", peak_of_980_lm), HasSubstr(id + ": the intensities add up to 97"));
  EXPECT_THAT(messages("1 1500", peak_of_980_lm), HasSubstr(id));
  EXPECT_THAT(messages("1 900", 50.0), HasSubstr(id)) << "17 % of what is rated";
  EXPECT_EQ(messages("1 980", peak_of_980_lm), "");
  EXPECT_EQ(messages("1 -1", peak_of_980_lm), "") << "nothing is rated";
  EXPECT_EQ(messages("1 1800", 280.0), "") << "half of what is rated, as of many old luminaires";
}

// By LM-63 a table begins at 0 or 90 and ends at 90 or 180, and beyond that there is no light. One
// that ends elsewhere has left something out, unless it is dark there.
TEST(Lm63, ATableThatEndsInTheLightLeavesTheRestOpen) {
  const auto open_share = [](double first, double last, double at_end) {
    IesSample sample;
    sample.gamma_deg = angle_steps(first, last, 10);
    sample.cd = [=](double, double gamma) {
      return gamma == first || gamma == last ? std::max(at_end, gamma == 0.0 ? 100.0 : 0.0) : 100.0;
    };
    const Parsed parsed = parse(ies_text(sample));
    const double share = parsed.web.value().source().open_end_share;
    EXPECT_EQ(share > 0.0, parsed.messages.find("[photometry-open-end]") != std::string::npos);
    return share;
  };
  EXPECT_DOUBLE_EQ(open_share(0, 60, 30.0), 0.3);
  EXPECT_DOUBLE_EQ(open_share(0, 140, 2.0), 0.02);
  EXPECT_DOUBLE_EQ(open_share(30, 180, 40.0), 0.4);
  EXPECT_EQ(open_share(0, 60, 0.05), 0.0);  // noise
  EXPECT_EQ(open_share(0, 90, 30.0), 0.0);
  EXPECT_EQ(open_share(90, 180, 30.0), 0.0);
  EXPECT_EQ(open_share(0, 180, 30.0), 0.0);
}

TEST(Lm63, MutilatedFilesNeverCrash) {
  const std::string text = ies_text({});
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char c : {'\0', '-', '9', 'e', ',', '\n', '.', '\xFF'}) {
      std::string changed = text;
      changed[i] = c;
      Diagnostics diagnostics;
      const auto web = parse_photometry(changed, "m.ies", diagnostics);
      EXPECT_EQ(!web, diagnostics.has_errors());
      EXPECT_TRUE(!web || web->flux_lm() > 0.0);
    }
  }
}

}  // namespace
}  // namespace calc::ies_lm63_test
