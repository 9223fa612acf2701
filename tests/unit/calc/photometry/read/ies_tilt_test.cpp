#include "calc/photometry/read/ies_tilt.h"

#include "calc/photometry/read/ies_lm63.h"
#include "tests/support/parsed_photometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace calc::ies_tilt_test {
namespace {

using test_support::ies_text;
using test_support::IesSample;
using testing::HasSubstr;

constexpr double kDegree = kPi / 180.0;

using Parsed = test_support::ParsedPhotometry;

Parsed parse(const std::string& tilt, const CompanionReader& read_companion = {}) {
  IesSample sample;
  sample.tilt = tilt;
  PhotometryOptions options;
  options.read_companion = read_companion;
  return test_support::parse_with_messages(ies_text(sample), "lamps/a.ies", options);
}

// Turned about world x by the angle: the C90 line and the vertical tilt.
glm::dmat3 turned_about_c0(double rad) {
  return {{1, 0, 0}, {0, std::cos(rad), std::sin(rad)}, {0, -std::sin(rad), std::cos(rad)}};
}
glm::dmat3 turned_about_c90(double rad) {
  return {{std::cos(rad), 0, std::sin(rad)}, {0, 1, 0}, {-std::sin(rad), 0, std::cos(rad)}};
}

TEST(Lm63Tilt, TableHoldsTheFactorOfTiltZero) {
  const Parsed parsed = parse("TILT=INCLUDE\n1\n3\n-30 10\n40 0.8 1.2 1\n");
  ASSERT_TRUE(parsed.web);
  EXPECT_EQ(parsed.messages, "");
  EXPECT_NEAR(parsed.web->intensity_cd(0.0, 0.0), 100.0 * (0.8 + 0.4 * 30.0 / 40.0), 1e-10);
  const LampTilt& tilt = *parsed.web->source().lamp_tilt;
  EXPECT_EQ(tilt.geometry, 1);
  EXPECT_NEAR(tilt_factor(tilt, 25.0 * kDegree), 1.1, 1e-12);
  EXPECT_EQ(tilt_factor(tilt, 80.0 * kDegree), 1.0);
  EXPECT_TRUE(covers(tilt, 40.0 * kDegree));
  EXPECT_FALSE(covers(tilt, 41.0 * kDegree));
}

// The factor belongs to the installed lamp, not to the direction of the light.
TEST(Lm63Tilt, LampTiltFollowsTheGeometry) {
  const double a = 30.0 * kDegree;
  for (const int geometry : {1, 3}) {
    const LampTilt tilt{geometry, {0.0, kPi}, {1.0, 0.5}};
    EXPECT_EQ(lamp_tilt_rad(tilt, glm::dmat3(1.0)), 0.0);
    EXPECT_NEAR(lamp_tilt_rad(tilt, turned_about_c0(a)), a, 1e-12);
    EXPECT_NEAR(lamp_tilt_rad(tilt, turned_about_c90(-a)), a, 1e-12);
    EXPECT_NEAR(lamp_tilt_rad(tilt, turned_about_c0(kPi)), kPi, 1e-12);  // uplight
  }
  const LampTilt lying{2, {0.0, kPi}, {1.0, 0.5}};
  EXPECT_NEAR(lamp_tilt_rad(lying, turned_about_c0(a)), 0.0, 1e-12);
  EXPECT_NEAR(lamp_tilt_rad(lying, turned_about_c90(a)), a, 1e-12);
}

TEST(Lm63Tilt, DataMayComeFromAFileBeside) {
  const auto read = [](const std::string& name) -> std::optional<std::string> {
    if (name != "lamp.tlt") return std::nullopt;
    return "1\n3\n0 45 90\n1 .9 .8\n";
  };
  const Parsed parsed = parse("TILT=lamp.tlt\n", read);
  ASSERT_TRUE(parsed.web) << parsed.messages;
  EXPECT_NEAR(tilt_factor(*parsed.web->source().lamp_tilt, 45.0 * kDegree), 0.9, 1e-12);
  EXPECT_THAT(parse("TILT=other.tlt\n", read).messages,
              HasSubstr("lamps/a.ies:7: error[photometry-tilt-file]: TILT=other.tlt: this file is "
                        "not in the same folder"));
  EXPECT_THAT(parse("TILT=lamp.tlt\n").messages, HasSubstr("error[photometry-tilt-file]"));
  for (const char* name : {"../lamp.tlt", "/etc/passwd", "C:\\lamp.tlt", "sub/lamp.tlt", ".."}) {
    EXPECT_THAT(parse(std::string("TILT=") + name + "\n", read).messages,
                HasSubstr("error[photometry-tilt-file-name]"))
        << name;
  }
  const auto broken = [](const std::string&) { return std::optional<std::string>("1\n3\n0 45\n"); };
  EXPECT_THAT(parse("TILT=lamp.tlt\n", broken).messages,
              HasSubstr("lamps/lamp.tlt:2: error[photometry-count]: the tilt data need 6 numbers"));
}

TEST(Lm63Tilt, BadDataAreRefused) {
  EXPECT_THAT(parse("TILT=INCLUDE\n4 1 0 1\n").messages,
              HasSubstr("allowed: a whole number from 1 to 3"));
  EXPECT_THAT(parse("TILT=INCLUDE\n1 900000\n").messages,
              HasSubstr("the tilt data need 1800000 numbers, but only"));
  EXPECT_THAT(parse("TILT=INCLUDE\n1 2 10 90 1 1\n").messages,
              HasSubstr("the first tilt angle is 10"));
  EXPECT_THAT(parse("TILT=INCLUDE\n1 2 0 90 1 0\n").messages,
              HasSubstr("tilt factor is 0; allowed: > 0"));
}

}  // namespace
}  // namespace calc::ies_tilt_test
