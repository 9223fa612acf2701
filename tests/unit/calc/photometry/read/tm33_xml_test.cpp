#include "calc/photometry/read/tm33_xml.h"
#include "calc/photometry/read/photometry_file.h"
#include "tests/support/parsed_photometry.h"
#include "tests/support/tm33_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace calc::tm33_xml_test {
namespace {

using test_support::angle_steps;
using test_support::cos_deg;
using test_support::sin_deg;
using test_support::tm33_emitter;
using test_support::tm33_points;
using test_support::tm33_text;
using test_support::Tm33Emitter;
using testing::HasSubstr;

using Parsed = test_support::ParsedPhotometry;

Parsed parse(const std::string& text, const std::string& emitter = "") {
  PhotometryOptions options;
  options.emitter = emitter;
  return test_support::parse_with_messages(text, "a.xml", options);
}

PhotometricWeb read(const std::string& text) {
  Parsed parsed = parse(text);
  EXPECT_EQ(parsed.messages, "");
  if (!parsed.web) throw std::runtime_error(parsed.messages);
  return *parsed.web;
}

using Change = std::function<void(Tm33Emitter&)>;

std::string messages(const Change& change) {
  Tm33Emitter emitter;
  change(emitter);
  return parse(tm33_text(emitter)).messages;
}

double at(const PhotometricWeb& web, double c_deg, double gamma_deg) {
  return web.intensity_cd(radians_from_degrees(c_deg), radians_from_degrees(gamma_deg));
}

// Different in every direction.
double lopsided(double c_deg, double gamma_deg) {
  if (gamma_deg >= 90.0) return 0.0;
  return 100.0 * cos_deg(gamma_deg) *
         (1.0 + sin_deg(gamma_deg) *
                    (0.2 * cos_deg(c_deg) + 0.3 * sin_deg(c_deg) + 0.07 * cos_deg(2.0 * c_deg)));
}

TEST(Tm33, SourceOpeningAndLightAreRead) {
  const PhotometricWeb web = read(tm33_text(Tm33Emitter{}));
  EXPECT_EQ(web.source().format, "TM-33 (IESTM33-22)");
  EXPECT_EQ(web.source().manufacturer, "luxgate examples");
  EXPECT_EQ(web.source().luminaire_name, "formula");
  EXPECT_EQ(web.source().rated_lamp_flux_lm, 320.0);
  EXPECT_EQ(web.source().input_power_w, 3.0);
  EXPECT_EQ(web.source().applied_factors, "TM-33 multiplier 1 x quantity 1");
  EXPECT_EQ(web.opening().shape, OpeningShape::rectangle);
  EXPECT_DOUBLE_EQ(web.opening().along_c90_m, 0.6);
  EXPECT_DOUBLE_EQ(web.opening().along_c0_m, 0.3);
  EXPECT_NEAR(web.flux_lm(), 100.0 * kPi, 0.3);
}

TEST(Tm33, ThePublishedSchemaIsReadAsWell) {
  Tm33Emitter emitter;
  emitter.cd = lopsided;
  std::string points = tm33_points(emitter);
  for (const auto& [from, to] :
       {std::pair{"IntensityData", "IntData"}, {"horz", "h"}, {"vert", "v"}}) {
    for (std::size_t i = points.find(from); i != std::string::npos; i = points.find(from, i))
      points.replace(i, std::string(from).size(), to);
  }
  const std::string text =
      "<t:IESTM33 xmlns:t='urn:t'><t:Luminaire><t:Dimensions><t:Length>0</t:Length></t:Dimensions>"
      "</t:Luminaire><t:Equipment><t:Gonioradiometer><t:Type>IES_C</t:Type></t:Gonioradiometer>"
      "</t:Equipment><t:Emitter><t:InputWattage>5</t:InputWattage><t:LuminousData>"
      "<t:LuminousIntensity><t:AbsolutePhotometry>true</t:AbsolutePhotometry>"
      "<t:NumberMeasured>456</t:NumberMeasured><t:NumberHorz>24</t:NumberHorz>"
      "<t:NumberVert>19</t:NumberVert>" +
      points + "</t:LuminousIntensity><t:LuminousFlux>315</t:LuminousFlux></t:LuminousData>" +
      "<t:EmissionAreas><t:BottomFace><t:BottomArea><t:Length>90</t:Length><t:Width>90</t:Width>"
      "<t:Circular>true</t:Circular></t:BottomArea></t:BottomFace></t:EmissionAreas></t:Emitter>"
      "</t:IESTM33>";
  const PhotometricWeb web = read(text);
  EXPECT_EQ(web.source().format, "TM-33 (IESTM33)");
  EXPECT_EQ(web.opening().shape, OpeningShape::disk);
  EXPECT_DOUBLE_EQ(web.opening().along_c0_m, 0.09);
  for (const double c : angle_steps(0, 345, 15)) EXPECT_NEAR(at(web, c, 45), lopsided(c, 45), 1e-9);
}

TEST(Tm33, AtlaFilesAreRead) {
  Tm33Emitter emitter;
  emitter.c_deg = {0, 90};
  emitter.cd = [](double c, double gamma) {
    return gamma < 90 ? 100.0 * cos_deg(gamma) * (c == 0 ? 1.0 : 1.0 - 0.4 * sin_deg(gamma)) : 0.0;
  };
  const std::string text =
      "<LuminaireOpticalData version='1.0'><Luminaire><LuminousOpening><Shape>Point</Shape>"
      "</LuminousOpening></Luminaire><Emitter><InputWatts>5</InputWatts><IntensityDistribution>"
      "<PhotometryType>TypeC</PhotometryType><Units>cd</Units>" +
      tm33_points(emitter) + "</IntensityDistribution></Emitter></LuminaireOpticalData>";
  const PhotometricWeb web = read(text);  // 0 to 90: a quadrant, as in LM-63
  EXPECT_EQ(web.opening().shape, OpeningShape::point);
  EXPECT_NEAR(at(web, 270, 30), 80.0 * cos_deg(30), 1e-9);
  EXPECT_NEAR(at(web, 180, 60), 50.0, 1e-9);
}

TEST(Tm33, PointsMayComeInAnyOrder) {
  Tm33Emitter emitter;
  emitter.cd = lopsided;
  const std::string in_order = tm33_text(emitter);
  std::reverse(emitter.c_deg.begin(), emitter.c_deg.end());
  std::swap(emitter.gamma_deg[3], emitter.gamma_deg[17]);
  const PhotometricWeb a = read(in_order);
  const PhotometricWeb b = read(tm33_text(emitter));
  for (double c = 0; c < 360; c += 7) {
    for (double gamma = 0; gamma < 90; gamma += 3) EXPECT_EQ(at(a, c, gamma), at(b, c, gamma));
  }
}

// A sum without the watts of one emitter would be too little.
TEST(Tm33, PowerIsStatedOnlyIfEveryEmitterStatesIt) {
  const auto power_with = [](const std::string& head) {
    Tm33Emitter one, two;
    one.head = "<ID>one</ID><InputWattage>20</InputWattage>";
    two.head = "<ID>two</ID>" + head;
    const Parsed parsed = parse(tm33_text(tm33_emitter(one) + tm33_emitter(two)));
    return parsed.web ? parsed.web->source().input_power_w : -1.0;
  };
  EXPECT_EQ(power_with("<InputWattage>5</InputWattage>"), 25.0);
  EXPECT_EQ(power_with(""), 0.0);
}

TEST(Tm33, MultiplierAndQuantityMultiply) {
  Tm33Emitter emitter;
  emitter.head = "<Quantity>3</Quantity><RatedLumens>700</RatedLumens><InputWatts>7</InputWatts>";
  emitter.before_points += "<Multiplier>2</Multiplier>";
  const Parsed parsed = parse(tm33_text(emitter));
  EXPECT_EQ(parsed.messages,
            "a.xml:2:10: warning[photometry-quantity]: the quantity 3 multiplies the emitter's "
            "intensities, rated lumens and watts\n");
  EXPECT_NEAR(at(*parsed.web, 0, 0), 600.0, 1e-9);
  EXPECT_EQ(parsed.web->source().rated_lamp_flux_lm, 2100.0);
  EXPECT_EQ(parsed.web->source().input_power_w, 21.0);
  EXPECT_EQ(parsed.web->source().applied_factors, "TM-33 multiplier 2 x quantity 3");
}

struct SymmetryCase {
  const char* name;
  const char* symmetry;
  std::vector<double> c_deg;
  std::function<double(double)> stored;  // the plane that stands for C

  friend void PrintTo(const SymmetryCase& symmetry, std::ostream* out) { *out << symmetry.name; }
};

class Tm33Symmetry : public testing::TestWithParam<SymmetryCase> {};

TEST_P(Tm33Symmetry, ExpandsToTheFullCircle) {
  Tm33Emitter emitter;
  emitter.symmetry = GetParam().symmetry;
  emitter.c_deg = GetParam().c_deg;
  emitter.cd = lopsided;
  const Parsed parsed = parse(tm33_text(emitter));
  ASSERT_TRUE(parsed.web) << parsed.messages;
  for (const double c : angle_steps(0, 345, 15))
    EXPECT_NEAR(at(*parsed.web, c, 45), lopsided(GetParam().stored(c), 45), 1e-9) << c;
}

std::vector<double> around_zero() {
  std::vector<double> angles = angle_steps(270, 345, 15);
  for (const double c : angle_steps(0, 90, 15)) angles.push_back(c);
  return angles;
}

INSTANTIATE_TEST_SUITE_P(
    Types, Tm33Symmetry,
    testing::Values(
        SymmetryCase{"None", "Symm _ None", angle_steps(0, 345, 15), [](double c) { return c; }},
        SymmetryCase{"Arbitrary", "Symm_Arbitrary", angle_steps(0, 345, 15),
                     [](double c) { return c; }},
        SymmetryCase{"NoneWith360", "None", angle_steps(0, 360, 15), [](double c) { return c; }},
        SymmetryCase{"Full", "Symm _ Full", {0}, [](double) { return 0.0; }},
        SymmetryCase{"FullElsewhere", "Symm_Full", {30}, [](double) { return 30.0; }},
        SymmetryCase{"Bi0", "Symm _ Bi _ 0", angle_steps(0, 180, 15),
                     [](double c) { return c > 180 ? 360 - c : c; }},
        SymmetryCase{"Bi0WithAllPlanes", "Symm _ Bi _ 0", angle_steps(0, 345, 15),
                     [](double c) { return c; }},
        SymmetryCase{"Bi90", "Symm _ Bi _90", angle_steps(90, 270, 15),
                     [](double c) { return c < 90    ? 180 - c
                                           : c > 270 ? 540 - c
                                                     : c; }},
        SymmetryCase{"Bi90OverZero", "Symm_Bi_90", around_zero(),
                     [](double c) { return c > 90 && c < 270 ? 180 - c : c; }},
        SymmetryCase{"Quad", "Symm _ Quad", angle_steps(0, 90, 15),
                     [](double c) {
                       const double half = c > 180 ? 360 - c : c;
                       return half > 90 ? 180 - half : half;
                     }},
        SymmetryCase{"NotStated", "", angle_steps(0, 180, 15),
                     [](double c) { return c > 180 ? 360 - c : c; }}),
    [](const auto& param) { return param.param.name; });

TEST(Tm33, AnglesMustFitTheSymmetry) {
  EXPECT_EQ(messages([](Tm33Emitter& e) {
              e.symmetry = "Symm _ Quad";
              e.c_deg = {0, 40, 80};
            }),
            "a.xml:2:183: error[photometry-symmetry-range]: the symmetry 'Symm _ Quad' needs "
            "horizontal angles from 0 to 90, but the file has 3 from 0 to 80\n");
  EXPECT_THAT(messages([](Tm33Emitter& e) {
                e.symmetry = "Symm _ Bi _ 0";
                e.c_deg = {0, 45, 90};
              }),
              HasSubstr("from 0 to 180, but the file has 3 from 0 to 90"));
  EXPECT_THAT(messages([](Tm33Emitter& e) {
                e.symmetry = "Symm _ Bi _90";
                e.c_deg = {0, 90, 180};
              }),
              HasSubstr("from 90 to 270, or from 270 over 0 to 90"));
  EXPECT_THAT(messages([](Tm33Emitter& e) {
                e.c_deg = {0, 90, 180};
              }),
              HasSubstr("error[photometry-planes]"));
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.symmetry = "Symm _ Odd"; }),
              HasSubstr("not supported yet: the symmetry 'Symm _ Odd'"));
}

TEST(Tm33, MissingAndRepeatedPointsAreNamed) {
  std::string text = tm33_text(Tm33Emitter{});
  const std::string point = "<IntensityData horz=\"15\" vert=\"45\">";
  const std::size_t line = text.find(point);
  const std::size_t end = text.find('\n', line);
  std::string without = text;
  without.erase(line, end + 1 - line);
  EXPECT_THAT(parse(without).messages,
              HasSubstr("error[photometry-point-missing]: the point at horizontal 15, vertical 45 "
                        "is missing: 24 horizontal by 19 vertical angles need as many points, and "
                        "the file has 455"));
  std::string twice = text;
  twice.insert(end + 1, text.substr(line, end + 1 - line));
  EXPECT_THAT(parse(twice).messages,
              HasSubstr("a.xml:32:1: error[photometry-point-twice]: the point at horizontal 15, "
                        "vertical 45 was given before, in line 31"));
  std::string apart = text;
  apart.replace(line, point.size(), "<IntensityData horz=\"15\" vert=\"45.0000001\">");
  EXPECT_THAT(parse(apart).messages, HasSubstr("error[photometry-point-missing]"));
}

// Every angle alone: a full grid of them would need n x n values.
TEST(Tm33, ScatteredPointsDoNotCostMemory) {
  std::string points;
  for (int i = 0; i < 20'000; ++i)
    points += fmt::format("<IntensityData horz='{0}' vert='{0}'>1</IntensityData>", i * 1e-3);
  EXPECT_THAT(
      parse(tm33_text("<Emitter><LuminousData>" + points + "</LuminousData></Emitter>")).messages,
      HasSubstr("error[photometry-point-missing]: the point at horizontal 0, vertical 0.001"));
}

TEST(Tm33, OtherQuantitiesAreRefusedByName) {
  for (const char* metric : {"Radiant", "Photon", "Spectral"}) {
    EXPECT_THAT(messages([&](Tm33Emitter& e) {
                  e.before_points = "<Metric>" + std::string(metric) + "</Metric>";
                }),
                HasSubstr(fmt::format("not supported yet: the metric '{}'", metric)));
  }
  EXPECT_THAT(parse(tm33_text("<Emitter><RadiantData/></Emitter>")).messages,
              HasSubstr("a.xml:2:10: error[photometry-unsupported]: not supported yet: radiant "
                        "intensity (<RadiantData>); supported: luminous intensity (cd)"));
  EXPECT_THAT(parse(tm33_text("<Emitter/>")).messages,
              HasSubstr("<Emitter> has no luminous intensities (<LuminousData>)"));
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.before_points = "<Units>W/sr</Units>"; }),
              HasSubstr("the unit 'W/sr'"));
  for (const char* type : {"CIE _ A", "CIE_B", "TypeB", "IES _ A", "CUSTOM"}) {
    EXPECT_THAT(messages([&](Tm33Emitter& e) {
                  e.before_points = "<PhotometryType>" + std::string(type) + "</PhotometryType>";
                }),
                HasSubstr(fmt::format("photometry of type '{}'", type)));
  }
}

TEST(Tm33, AssumptionsAreWarnedOf) {
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.before_points = ""; }),
              HasSubstr("warning[photometry-assumed]: the photometry type is not stated; type C is "
                        "assumed"));
  Tm33Emitter emitter;
  EXPECT_THAT(parse(tm33_text("<Emitter><IntensityDistribution><PhotometryType>C</PhotometryType>" +
                              tm33_points(emitter) + "</IntensityDistribution></Emitter>"))
                  .messages,
              HasSubstr("the metric is not stated; luminous intensity (cd) is assumed"));
}

TEST(Tm33, BadNumbersAreNamed) {
  const auto with_point = [](const std::string& point) {
    return parse(tm33_text("<Emitter><LuminousData>" + point + "</LuminousData></Emitter>"))
        .messages;
  };
  EXPECT_THAT(with_point("<IntData h='0' v='0'>1,5</IntData>"),
              HasSubstr("error[photometry-number]: <IntData>: '1,5' is not a number"));
  EXPECT_THAT(with_point("<IntData h='0' v='0'>nan</IntData>"), HasSubstr("'nan'"));
  EXPECT_THAT(with_point("<IntData h='x' v='0'>1</IntData>"), HasSubstr("h: 'x' is not a number"));
  EXPECT_THAT(with_point("<IntData v='0'>1</IntData>"), HasSubstr("<IntData> has no angle 'horz'"));
  EXPECT_THAT(with_point("<IntData h='0' v='181'>1</IntData>"),
              HasSubstr("vertical angle is 181; allowed: 0 to 180 degrees"));
  EXPECT_THAT(with_point("<IntData h='-5' v='0'>1</IntData>"), HasSubstr("horizontal angle is -5"));
  EXPECT_THAT(with_point("<IntData h='0' v='0'>1</IntData>"),
              HasSubstr("the number of vertical angles is 1; allowed: at least 2"));
  EXPECT_THAT(with_point(""), HasSubstr("<LuminousData> has no points"));
  for (const char* quantity : {"0", "-1", "1.5", "1e9", "two"}) {
    EXPECT_THAT(messages([&](Tm33Emitter& e) {
                  e.head = "<Quantity>" + std::string(quantity) + "</Quantity>";
                }),
                HasSubstr("error[photometry-"));
  }
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.before_points += "<Multiplier>0</Multiplier>"; }),
              HasSubstr("the multiplier is 0; allowed: > 0"));
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.before_points += "<Multiplier>1e300</Multiplier>"; }),
              HasSubstr("error[photometry-value]: the highest intensity (cd)"));
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.head = "<RatedLumens>-5</RatedLumens>"; }),
              HasSubstr("<RatedLumens> is -5; allowed: >= 0"));
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.cd = [](double, double) { return -1.0; }; }),
              HasSubstr("a.xml:3:1: error[photometry-negative]"));
}

TEST(Tm33, SeveralEmittersAddUpOnTheSameAngles) {
  Tm33Emitter one, two;
  one.cd = lopsided;
  two.head =
      "<ID>two</ID><Quantity>2</Quantity><RatedLumens>320</RatedLumens>"
      "<InputWattage>3</InputWattage>";
  const Parsed parsed = parse(tm33_text(tm33_emitter(one) + tm33_emitter(two)));
  ASSERT_TRUE(parsed.web) << parsed.messages;
  EXPECT_NEAR(at(*parsed.web, 30, 45), lopsided(30, 45) + 200.0 * cos_deg(45), 1e-9);
  EXPECT_EQ(parsed.web->source().rated_lamp_flux_lm, 960.0);
  EXPECT_EQ(parsed.web->source().input_power_w, 9.0);
  EXPECT_EQ(parsed.web->source().applied_factors,
            "TM-33 multiplier 1 x quantity 1 + TM-33 multiplier 1 x quantity 2");
  two.gamma_deg = angle_steps(0, 90, 10);
  EXPECT_THAT(parse(tm33_text(tm33_emitter(one) + tm33_emitter(two))).messages,
              HasSubstr("error[photometry-emitters-differ]: the 2 emitters have different angles "
                        "and cannot be added; choose one with 'emitter': led, two"));
}

TEST(Tm33, OneEmitterCanBeChosen) {
  Tm33Emitter one, two, three;
  two.head = "<Description>the second</Description><InputWattage>3</InputWattage>";
  two.gamma_deg = angle_steps(0, 90, 10);
  two.cd = [](double, double gamma) { return gamma < 90 ? 7.0 : 0.0; };
  three.head = "<ID>2</ID>" + two.head;
  three.cd = [](double, double gamma) { return gamma < 90 ? 9.0 : 0.0; };
  const std::string text = tm33_text(tm33_emitter(one) + tm33_emitter(two) + tm33_emitter(three));
  EXPECT_NEAR(at(*parse(text, "led").web, 0, 0), 100.0, 1e-9);
  EXPECT_NEAR(at(*parse(text, "1").web, 0, 0), 100.0, 1e-9);
  EXPECT_NEAR(at(*parse(text, "2").web, 0, 0), 9.0, 1e-9);  // the id, not the number
  EXPECT_THAT(parse(text, "the second").messages,
              HasSubstr("a.xml has no single emitter 'the second'; allowed: a number from 1 to 3"));
  EXPECT_EQ(parse(text, "4").messages,
            "a.xml: error[photometry-choice]: a.xml has no emitter '4'; allowed: led, 2 (the "
            "second), 2 (the second)\n");
}

TEST(Tm33, FluxIsComparedWithWhatIsStated) {
  EXPECT_THAT(
      messages([](Tm33Emitter& e) { e.before_points += "<LuminousFlux>500</LuminousFlux>"; }),
      HasSubstr("a.xml: warning[photometry-stated-flux]: the luminous flux is stated as 500 "
                "lm, but the intensities add up to 314 lm"));
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.head = "<RatedLumens>300</RatedLumens>"; }),
              HasSubstr("warning[photometry-flux-over-lamps]"));
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.head = "<RatedLumens>8000</RatedLumens>"; }),
              HasSubstr("only 3.9 % of the rated 8000 lm; are they in cd per 1000 lm?"));
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.head = ""; }),
              HasSubstr("warning[photometry-no-power]"));
}

TEST(Tm33, WhatIsNotAppliedIsWarnedOf) {
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.tail = "<BallastFactor>0.9</BallastFactor>"; }),
              HasSubstr("warning[photometry-not-applied]: the ballast factor 0.9 was not applied"));
  EXPECT_EQ(messages([](Tm33Emitter& e) { e.tail = "<BallastFactor>1.00</BallastFactor>"; }), "");
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.tail = "<TiltAngles/>"; }),
              HasSubstr("the table of tilts was not applied"));
  EXPECT_THAT(messages([](Tm33Emitter& e) { e.before_points += "<NumberHorz>36</NumberHorz>"; }),
              HasSubstr("warning[photometry-counts-differ]: <NumberHorz> states 36, but the data "
                        "have 24"));
}

TEST(Tm33, OtherRootsAreRefused) {
  EXPECT_EQ(parse("<lamp/>").messages,
            "a.xml:1:1: error[photometry-xml-root]: <lamp> is not photometry that luxgate reads; "
            "readable: IESTM33, IESTM33-18, IESTM33-22 or LuminaireOpticalData\n");
  EXPECT_EQ(parse("<IESTM33-22/>").messages,
            "a.xml:1:1: error[photometry-missing]: <IESTM33-22> has no <Emitter>\n");
}

TEST(Tm33, CutFilesAreErrors) {
  Tm33Emitter emitter;
  emitter.c_deg = {0};
  const std::string text = tm33_text(emitter);
  for (std::size_t length = 0; length < text.size() - 2; ++length) parse(text.substr(0, length));
}

}  // namespace
}  // namespace calc::tm33_xml_test
