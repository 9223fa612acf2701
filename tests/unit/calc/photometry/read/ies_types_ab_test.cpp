#include "calc/photometry/read/ies_types_ab.h"

#include "calc/photometry/web_sampling.h"
#include "tests/support/parsed_photometry.h"
#include "tests/support/web_inversion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace calc::ies_types_ab_test {
namespace {

using test_support::angle_steps;
using test_support::cos_deg;
using test_support::ies_text;
using test_support::IesSample;
using test_support::make_web;
using test_support::sin_deg;
using testing::HasSubstr;

using Direction = std::array<double, 3>;

// The directions of LM-63's angles, by the words of LM-63-2002, 3.
Direction type_a(double h, double v) {
  return {cos_deg(v) * cos_deg(h), -cos_deg(v) * sin_deg(h), sin_deg(v)};
}
Direction type_b(double h, double v) {
  return {cos_deg(h) * sin_deg(v), -sin_deg(h), -cos_deg(h) * cos_deg(v)};
}
Direction type_c(double c, double gamma) {
  return {sin_deg(gamma) * cos_deg(c), sin_deg(gamma) * sin_deg(c), -cos_deg(gamma)};
}

// cos^20 about C 40 and some gamma.
double power_lobe(const Direction& d, double gamma) {
  const Direction axis = type_c(40.0, gamma);
  const double along = d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
  return along > 0.0 ? 1000.0 * std::pow(along, 20) : 0.0;
}

// A lobe without any symmetry about the axes of either type, dark where their tables end: above and
// behind.
double lobe(const Direction& d) {
  return power_lobe(d, 60.0) * std::max(0.0, 2.0 * d[0]) * std::max(0.0, -2.0 * d[2]);
}

using Parsed = test_support::ParsedPhotometry;

Parsed parse(const IesSample& sample) {
  return test_support::parse_with_messages(ies_text(sample), "a.ies");
}

IesSample sample_of(char type, double first_deg, double step_deg,
                    const std::function<double(const Direction&)>& light) {
  IesSample sample;
  sample.type = type == 'a' ? "3" : "2";
  sample.gamma_deg = sample.c_deg = angle_steps(first_deg, 90, step_deg);
  sample.cd = [type, light](double h, double v) {
    return light(type == 'a' ? type_a(h, v) : type_b(h, v));
  };
  return sample;
}

TEST(Lm63TypesAB, EveryTabulatedDirectionHasItsValue) {
  for (const char type : {'a', 'b'}) {
    const PhotometricWeb web = parse(sample_of(type, -90, 5, lobe)).web.value();
    for (const double h : angle_steps(-85, 85, 5)) {
      for (const double v : angle_steps(-90, 90, 5)) {
        const Direction d = type == 'a' ? type_a(h, v) : type_b(h, v);
        EXPECT_NEAR(web.intensity_cd(d), lobe(d), 1e-7) << type << " H " << h << " V " << v;
      }
    }
  }
}

TEST(Lm63TypesAB, AgreeWithTypeCOfTheSameLight) {
  const PhotometricWeb c = make_web(angle_steps(0, 360, 1), angle_steps(0, 180, 1),
                                    [](double h, double v) { return lobe(type_c(h, v)); });
  for (const char type : {'a', 'b'}) {
    const PhotometricWeb web = parse(sample_of(type, -90, 1, lobe)).web.value();
    EXPECT_NEAR(web.flux_lm() / c.flux_lm(), 1.0, 1e-4);  // two interpolations of one lobe
    for (int i = 0; i < 2000; ++i) {
      const Direction d = type_c(i * 137.508, std::acos(1.0 - (i + 0.5) / 1000.0) / kPi * 180.0);
      EXPECT_NEAR(web.intensity_cd(d), c.intensity_cd(d), 1.5) << type << " " << i;
    }
    EXPECT_NEAR(web.zonal_flux_lm(0.0, kPi) / web.flux_lm(), 1.0, 1e-4);
    EXPECT_NEAR(web.zonal_flux_lm(0.3, 1.2) / c.zonal_flux_lm(0.3, 1.2), 1.0, 1e-3);
  }
}

// A table that turns the horizontal angle the other way round would mirror the lobe.
TEST(Lm63TypesAB, HorizontalAnglesRunClockwise) {
  for (const char type : {'a', 'b'}) {
    const PhotometricWeb web = parse(sample_of(type, -90, 5, lobe)).web.value();
    EXPECT_GT(web.intensity_cd(type_c(40, 60)), 900.0);
    EXPECT_LT(web.intensity_cd(type_c(-40, 60)), 30.0);
  }
}

TEST(Lm63TypesAB, ListsFromZeroAreMirrored) {
  const auto symmetric = [](const Direction& d) {
    return 100.0 * std::abs(d[2]) + 30.0 * d[1] * d[1] + 10.0 * d[0] * d[0];
  };
  for (const char type : {'a', 'b'}) {
    const PhotometricWeb half = parse(sample_of(type, 0, 5, symmetric)).web.value();
    const PhotometricWeb full = parse(sample_of(type, -90, 5, symmetric)).web.value();
    EXPECT_NEAR(half.flux_lm(), full.flux_lm(), 1e-9 * full.flux_lm());
    for (int i = 0; i < 500; ++i) {
      const Direction d = type_c(i * 137.508, std::acos(1.0 - (i + 0.5) / 250.0) / kPi * 180.0);
      EXPECT_NEAR(half.intensity_cd(d), full.intensity_cd(d), 1e-9);
    }
  }
}

TEST(Lm63TypesAB, DarkBeyondTheListedAngles) {
  const auto even = [](const Direction&) { return 100.0; };
  const PhotometricWeb b = parse(sample_of('b', -90, 30, even)).web.value();
  EXPECT_EQ(b.intensity_cd(type_b(10, 89.99)), 100.0);
  EXPECT_EQ(b.intensity_cd(type_c(30, 91)), 0.0);  // above the luminaire
  EXPECT_NEAR(b.flux_lm(), 100.0 * 2.0 * kPi, 1e-4);
  const PhotometricWeb a = parse(sample_of('a', -90, 30, even)).web.value();
  EXPECT_EQ(a.intensity_cd(type_c(45, 100)), 100.0);
  EXPECT_EQ(a.intensity_cd(type_c(180, 100)), 0.0);  // behind it
  EXPECT_NEAR(a.flux_lm(), 100.0 * 2.0 * kPi, 1e-4);
  IesSample narrow = sample_of('b', -90, 30, even);
  narrow.gamma_deg = {-20, 15};
  narrow.c_deg = {-10, 0, 10};
  const PhotometricWeb window = parse(narrow).web.value();
  EXPECT_EQ(window.intensity_cd(type_b(9.9, 14.9)), 100.0);
  EXPECT_EQ(window.intensity_cd(type_b(0, 0)), 100.0);  // not listed: between -20 and 15
  EXPECT_EQ(window.intensity_cd(type_b(9.9, 15.1)), 0.0);
  EXPECT_EQ(window.intensity_cd(type_b(10.1, 0)), 0.0);
  const double window_lm = 100.0 * 35.0 * kPi / 180.0 * 2.0 * sin_deg(10.0);
  EXPECT_NEAR(window.flux_lm(), window_lm, 1e-5 * window_lm);
}

TEST(Lm63TypesAB, SampledDirectionsFollowTheLight) {
  const auto below = [](const Direction& d) { return power_lobe(d, 30.0); };
  const PhotometricWeb web = parse(sample_of('b', -90, 1, below)).web.value();
  const WebSampler sampler(web);
  const WebInversion inverted(sampler);
  EXPECT_NEAR(sampler.c_prefix().back(), web.flux_lm(), 1e-9 * web.flux_lm());
  glm::dvec3 mean(0.0);
  constexpr int kSide = 400;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double u0 = (i % kSide + 0.5) / kSide, u1 = (i / kSide + 0.5) / kSide;
    const Direction d = sampler.sample(u0, u1);
    const auto back = inverted(d);
    EXPECT_NEAR(back[0], u0, 1e-7);
    EXPECT_NEAR(back[1], u1, 1e-7);
    EXPECT_GT(web.intensity_cd(d), 0.0);
    mean += glm::dvec3(d[0], d[1], d[2]) / static_cast<double>(kSide * kSide);
  }
  const Direction axis = type_c(40, 30);  // cos^20: mean cosine 21 / 22
  EXPECT_NEAR(glm::length(mean - 21.0 / 22.0 * glm::dvec3(axis[0], axis[1], axis[2])), 0.0, 3e-3);
}

TEST(Lm63TypesAB, OneHorizontalAngleOfTypeBIsABeamRoundNadir) {
  IesSample sample;
  sample.type = "2";
  const PhotometricWeb web = parse(sample).web.value();
  EXPECT_TRUE(web.is_axial());
  EXPECT_THAT(parse(sample).messages,
              HasSubstr("warning[photometry-assumed]: the light beside the single horizontal angle "
                        "of photometric type B is not stated; the same light all round straight "
                        "down is assumed"));
  EXPECT_NEAR(web.intensity_cd(type_c(77, 60)), 50.0, 1e-9);
  sample.gamma_deg = angle_steps(-90, 90, 5);
  EXPECT_NEAR(parse(sample).web.value().intensity_cd(type_c(200, 60)), 50.0, 1e-9);
  sample.cd = [](double, double v) { return 100.0 + v; };
  EXPECT_THAT(parse(sample).messages, HasSubstr("error[photometry-type-ab]: photometric type B: a "
                                                "single horizontal angle"));
}

// Lists of types A and B end at 90 degrees, or in the dark; one that starts at 0 goes on mirrored.
TEST(Lm63TypesAB, ListsThatEndInTheLightLeaveTheRestOpen) {
  const auto open_share = [](char type, double first, double last, bool is_dark_at_ends) {
    IesSample sample;
    sample.type = type == 'a' ? "3" : "2";
    sample.gamma_deg = sample.c_deg = angle_steps(first, last, 10);
    sample.cd = [=](double h, double v) {
      const bool is_end = std::max(std::abs(h), std::abs(v)) == last;
      return is_end ? (is_dark_at_ends ? 0.0 : 25.0) : 100.0;
    };
    return parse(sample).web.value().source().open_end_share;
  };
  for (const char type : {'a', 'b'}) {
    EXPECT_DOUBLE_EQ(open_share(type, -40, 40, false), 0.25) << type;
    EXPECT_DOUBLE_EQ(open_share(type, 0, 40, false), 0.25) << type;
    EXPECT_EQ(open_share(type, -40, 40, true), 0.0) << type;
    EXPECT_EQ(open_share(type, -90, 90, false), 0.0) << type;
    EXPECT_EQ(open_share(type, 0, 90, false), 0.0) << type;
  }
}

TEST(Lm63TypesAB, WhatMakesNoSenseIsRefused) {
  IesSample sample = sample_of('a', -90, 5, lobe);
  sample.c_deg = {0};
  EXPECT_THAT(parse(sample).messages, HasSubstr("type A with a single horizontal angle"));
  sample.c_deg = {10, 20};
  EXPECT_THAT(parse(sample).messages, HasSubstr("angles that do not include 0"));
  sample.c_deg = {0, 95};
  EXPECT_THAT(parse(sample).messages, HasSubstr("horizontal angle is 95; allowed: -90 to 90"));
}

}  // namespace
}  // namespace calc::ies_types_ab_test
