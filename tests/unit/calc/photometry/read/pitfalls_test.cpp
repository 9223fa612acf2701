// Ten mistakes of public readers of photometry files, one test each: it fails for a reader that
// makes the mistake. All files are written here.

#include "calc/photometry/read/photometry_file.h"
#include "tests/support/photometry_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace calc::pitfalls_test {
namespace {

using test_support::angle_steps;
using test_support::cos_deg;
using test_support::diagnostics_text;
using test_support::ies_text;
using test_support::IesSample;
using test_support::ldt_text;
using test_support::LdtSample;
using test_support::sin_deg;

PhotometricWeb read(const std::string& text) {
  Diagnostics diagnostics;
  const std::optional<PhotometricWeb> web = parse_photometry(text, "file", diagnostics);
  if (!web) throw std::runtime_error(diagnostics_text(diagnostics));
  return *web;
}

double at(const PhotometricWeb& web, double c_deg, double gamma_deg) {
  return web.intensity_cd(radians_from_degrees(c_deg), radians_from_degrees(gamma_deg));
}

// In 1986 and 1991 the number after the ballast factor multiplies the table. Later it is a reserved
// field, and since 2019 it codes how the file was made: 1.111 would be 11 % too bright.
TEST(PhotometryPitfalls, Field12IsNotAFactorAfter1991) {
  const auto nadir_cd = [](const std::string& tag, const std::string& field12) {
    IesSample sample;
    sample.tag = tag;
    sample.factors = "1 " + field12 + " 10";
    return at(read(ies_text(sample)), 0, 0);
  };
  EXPECT_DOUBLE_EQ(nadir_cd("free text of 1986", "0.8"), 80.0);
  EXPECT_DOUBLE_EQ(nadir_cd("IESNA91", "0.8"), 80.0);
  EXPECT_DOUBLE_EQ(nadir_cd("IESNA:LM-63-1995", "0.8"), 100.0);
  EXPECT_DOUBLE_EQ(nadir_cd("IESNA:LM-63-2002", "0.8"), 100.0);
  EXPECT_DOUBLE_EQ(nadir_cd("IES:LM-63-2019", "1.111"), 100.0);
}

// The table holds candela already. -1 lumens say that nothing is known of lamps, however many.
TEST(PhotometryPitfalls, LampLumensNeverScaleAnIesTable) {
  for (const char* lamps : {"1 1000", "2 5200.5", "60 102.52", "1 -1", "6 -1"}) {
    IesSample sample;
    sample.lamps = lamps;
    EXPECT_DOUBLE_EQ(at(read(ies_text(sample)), 0, 0), 100.0) << lamps;
  }
}

// TILT data are about the tilt of the installed lamp, not about the direction of the light.
TEST(PhotometryPitfalls, TiltIsNotAppliedPerDirection) {
  IesSample sample;
  const PhotometricWeb plain = read(ies_text(sample));
  sample.tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9\n0.5\n";
  const PhotometricWeb tilted = read(ies_text(sample));
  for (double gamma = 0.0; gamma <= 90.0; gamma += 2.5) {
    EXPECT_DOUBLE_EQ(at(tilted, 30, gamma), at(plain, 30, gamma)) << gamma;
  }
}

// Symmetric to C90-C270, twice as bright on the side of C90.
double towards_c90(double c_deg, double gamma_deg) {
  return gamma_deg < 90.0
             ? 300.0 * cos_deg(gamma_deg) * (1.0 + 0.5 * sin_deg(gamma_deg) * sin_deg(c_deg))
             : 0.0;
}

// The stored planes are C270 ... C0 ... C90. From C0 or C90 on the light would be turned or
// reversed, which neither its flux nor its light output ratio shows.
TEST(PhotometryPitfalls, EulumdatIsym3StartsAtC270) {
  LdtSample sample;
  sample.symmetry = "3";
  sample.stored_c_deg = angle_steps(270, 345, 15);
  for (const double c : angle_steps(0, 90, 15)) sample.stored_c_deg.push_back(c);
  sample.cd_per_klm = towards_c90;
  const PhotometricWeb web = read(ldt_text(sample));
  for (const double c : angle_steps(0, 345, 15)) {
    EXPECT_NEAR(at(web, c, 45), towards_c90(c, 45), 1e-9) << c;
  }
}

TEST(PhotometryPitfalls, Isym1HasOnePlaneWhateverMcSays) {
  LdtSample sample;
  sample.symmetry = "1";
  sample.stored_c_deg = {0};
  ASSERT_EQ(sample.all_c_deg.size(), 24u);
  const PhotometricWeb web = read(ldt_text(sample));
  for (const double c : {0.0, 100.0, 345.0}) {
    EXPECT_NEAR(at(web, c, 60), 500.0 / kPi, 1e-9) << c;
  }
  EXPECT_NEAR(web.flux_lm(), 1000.0, 2.0);
}

// A luminaire for either of two lamps does not give the light of both.
TEST(PhotometryPitfalls, LampSetsAreAlternatives) {
  LdtSample sample;
  sample.lamp_set_lines = {"1", "LED110", "1000", "", "", "10",  //
                           "1", "LED120", "1200", "", "", "12"};
  EXPECT_NEAR(read(ldt_text(sample)).flux_lm(), 1000.0, 2.0);
}

// Planes of type B turn about a horizontal axis. The direction of H and V is that of LM-63-2002;
// exchanging rows and columns, or taking H for an angle in a projection, sends the beam elsewhere.
TEST(PhotometryPitfalls, TypeBIsConvertedNotTransposed) {
  constexpr double kH = -20.0, kV = 40.0;
  IesSample sample;
  sample.type = "2";
  sample.gamma_deg = sample.c_deg = angle_steps(-90, 90, 5);
  sample.cd = [](double h, double v) { return h == kH && v == kV ? 1000.0 : 1.0; };
  const PhotometricWeb web = read(ies_text(sample));
  EXPECT_NEAR(
      web.intensity_cd({cos_deg(kH) * sin_deg(kV), -sin_deg(kH), -cos_deg(kH) * cos_deg(kV)}),
      1000.0, 1e-6);
}

// Horizontal angles from 90 to 270 say which half is stored, not that C 0 lies elsewhere.
TEST(PhotometryPitfalls, Planes90To270AreNotTurned) {
  IesSample sample;
  sample.tag = "IESNA:LM-63-1995";
  sample.c_deg = angle_steps(90, 270, 15);
  sample.cd = towards_c90;
  const PhotometricWeb web = read(ies_text(sample));
  for (const double c : angle_steps(0, 345, 15)) {
    EXPECT_NEAR(at(web, c, 45), towards_c90(c, 45), 1e-9) << c;
  }
}

// Full light at C 0, 10, 20, none at 180: 5/9 of an even light, but 3/4 as a mean of the planes.
TEST(PhotometryPitfalls, FluxUsesTheActualCSteps) {
  IesSample sample;
  const double even_lm = read(ies_text(sample)).flux_lm();
  const auto light = [even = sample.cd](double c, double gamma) {
    return c <= 20.0 ? even(c, gamma) : 0.0;
  };
  sample.c_deg = {0, 10, 20, 180};
  sample.cd = light;
  EXPECT_NEAR(read(ies_text(sample)).flux_lm() / even_lm, 5.0 / 9.0, 1e-12);

  LdtSample ldt;
  const double even_ldt_lm = read(ldt_text(ldt)).flux_lm();
  ldt.symmetry = "2";
  ldt.all_c_deg = {0, 10, 20, 180, 340, 350};
  ldt.stored_c_deg = {0, 10, 20, 180};
  ldt.cd_per_klm = [even = ldt.cd_per_klm](double c, double gamma) {
    return c <= 20.0 ? even(c, gamma) : 0.0;
  };
  EXPECT_NEAR(read(ldt_text(ldt)).flux_lm() / even_ldt_lm, 5.0 / 9.0, 1e-12);
}

// Counts that no file can hold are an error with words, not an allocation.
TEST(PhotometryPitfalls, CountsAreCheckedBeforeAllocation) {
  const auto messages = [](const std::string& text) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_photometry(text, "file", diagnostics));
    return diagnostics_text(diagnostics);
  };
  const std::string ies = ies_text({});
  const auto with_counts = [&](const std::string& counts) {
    std::string text = ies;
    const std::string before = "1 -1 1 19 1 ";
    return text.replace(text.find(before), before.size(), "1 -1 1 " + counts + " ");
  };
  EXPECT_NE(messages(with_counts("1000000000 1000000000")).find("[photometry-count]"),
            std::string::npos);
  EXPECT_NE(messages(with_counts("65536 65536")).find("[photometry-count]"), std::string::npos);
  EXPECT_NE(messages(with_counts("2000000000 2")).find("[photometry-value]"), std::string::npos);
  EXPECT_NE(messages(with_counts("-19 1")).find("[photometry-value]"), std::string::npos);
  std::string ldt = ldt_text({});
  const std::string counts = "\n3\n0\n24\n0\n37\n";
  ldt.replace(ldt.find(counts), counts.size(), "\n3\n0\n1000000000\n0\n1000000000\n");
  EXPECT_NE(messages(ldt).find("[photometry-count]"), std::string::npos);
}

}  // namespace
}  // namespace calc::pitfalls_test
