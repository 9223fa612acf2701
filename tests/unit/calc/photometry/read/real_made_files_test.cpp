// Optional: files made for testing readers, from a collection outside the repository that
// LUXGATE_SHARED_DATA names, against what its notes expect of each.

#include "calc/base/file_reader.h"
#include "calc/base/units.h"
#include "calc/photometry/read/photometry_file.h"
#include "tests/support/photometry_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

namespace calc::real_made_files_test {
namespace {

using testing::HasSubstr;

struct Made {
  std::string name, messages;
  std::optional<PhotometricWeb> web;

  double cd(double c_deg, double gamma_deg) const {
    return web->intensity_cd(radians_from_degrees(c_deg), radians_from_degrees(gamma_deg));
  }
};

class RealMadeFiles : public testing::Test {
 protected:
  void SetUp() override {
    const char* shared = std::getenv("LUXGATE_SHARED_DATA");
    if (shared == nullptr) GTEST_SKIP() << "LUXGATE_SHARED_DATA is not set";
    folder_ = std::string(shared) + "/photometry/made/";
    if (!DiskFileReader().read(folder_ + "iso_100cd_0-180.ies").ok()) {
      GTEST_SKIP() << "no files in " << folder_;
    }
  }

  Made read(const std::string& name) const {
    Diagnostics diagnostics;
    PhotometryOptions options;
    options.read_companion = [&](const std::string& other) -> std::optional<std::string> {
      const FileContent content = DiskFileReader().read(folder_ + other);
      return content.ok() ? std::optional(content.bytes) : std::nullopt;
    };
    const FileContent content = DiskFileReader().read(folder_ + name);
    EXPECT_TRUE(content.ok()) << name;
    Made made{name, "", parse_photometry(content.bytes, name, diagnostics, options)};
    made.messages = test_support::diagnostics_text(diagnostics);
    return made;
  }

  std::string folder_;
};

struct Refused {
  const char* name;
  const char* id;
};

TEST_F(RealMadeFiles, BadOnesAreRefusedWithTheReason) {
  const Refused cases[] = {{"bad_H_unsorted.ies", "photometry-angle-order"},
                           {"bad_count_2e9.ies", "photometry-value"},
                           {"bad_count_zero.ies", "photometry-value"},
                           {"bad_descending_V.ies", "photometry-angle-order"},
                           {"bad_glued_minus.ies", "photometry-number"},
                           {"bad_negative_candela.ies", "photometry-negative"},
                           {"bad_no_tilt_line.ies", "photometry-no-tilt-line"},
                           {"bad_truncated_mid_number.ies", "photometry-count"},
                           {"bad_type_4.ies", "photometry-value"},
                           {"bad_zero_multiplier.ies", "photometry-value"},
                           {"empty.ies", "photometry-format"},
                           {"tilt_file_missing.ies", "photometry-tilt-file"},
                           {"ldt_bad_counts.ldt", "photometry-count"},
                           {"ldt_bad_isym4_full_data.ldt", "photometry-lines"},
                           {"ldt_bad_isym5.ldt", "photometry-value"},
                           {"ldt_bad_truncated.ldt", "photometry-lines"},
                           {"ldt_zero_sets.ldt", "photometry-value"}};
  for (const Refused& one : cases) {
    const Made made = read(one.name);
    EXPECT_FALSE(made.web) << one.name;
    EXPECT_THAT(made.messages, HasSubstr(std::string("error[") + one.id + "]")) << one.name;
  }
}

struct Valid {
  const char* name;
  double flux_lm;
  const char* warning = "";
};

TEST_F(RealMadeFiles, ValidOnesHaveTheFluxOfTheirFormula) {
  constexpr double kLinear_lm = 999.365;  // 1000 lm every 5 degrees, linear in the angle
  const Valid cases[] = {{"iso_100cd_0-180.ies", 1256.637},
                         {"lambert_1986_nolabel_blpf0.9.ies", 900},
                         {"lambert_1995_field12_0.8.ies", 1000, "photometry-field12"},
                         {"lambert_C_1deg.ies", 1000},
                         {"lambert_C_5deg_quadrant.ies", kLinear_lm},
                         {"lambert_relative_2x1000lm_mult0.5_bf0.9.ies", 900},
                         {"lobe20_g25_c40_typeC.ies", 299.199},
                         {"lobe20_g25_c40_typeB.ies", 299.199},
                         {"odd_comma_delimiters.ies", kLinear_lm},
                         {"odd_ctrl_z_tail.ies", kLinear_lm, "photometry-end-mark"},
                         {"odd_feet_flag_metre_values.ies", kLinear_lm, "photometry-opening-size"},
                         {"odd_lowercase_tilt.ies", kLinear_lm},
                         {"odd_single_long_line.ies", kLinear_lm},
                         {"sym90-270_1995.ies", 313.96},
                         {"tilt_file.ies", 1000},
                         {"tilt_include_geom1.ies", 1000},
                         {"tilt_include_geom2.ies", 1000},
                         {"tilt_include_geom3.ies", 1000},
                         {"ldt_absolute_neg_lamps.ldt", 4321.0 * kLinear_lm / 1000.0},
                         {"ldt_blank_direct_ratios.ldt", kLinear_lm},
                         {"ldt_conv_1.5.ldt", kLinear_lm},
                         {"ldt_dc0_irregular_c.ldt", kLinear_lm},
                         {"ldt_dg0_irregular.ldt", 995.108},
                         {"ldt_isym0.ldt", kLinear_lm},
                         {"ldt_isym1_mc1.ldt", kLinear_lm},
                         {"ldt_isym2.ldt", kLinear_lm},
                         {"ldt_isym3.ldt", kLinear_lm},
                         {"ldt_isym4.ldt", kLinear_lm},
                         {"ldt_lf_no_final_newline.ldt", kLinear_lm},
                         {"ldt_lorl_mismatch.ldt", kLinear_lm, "photometry-output-ratio"},
                         {"ldt_round_zero_width.ldt", kLinear_lm}};
  for (const Valid& one : cases) {
    const Made made = read(one.name);
    ASSERT_TRUE(made.web) << made.messages;
    EXPECT_NEAR(made.web->flux_lm() / one.flux_lm, 1.0, 5e-4) << one.name;
    EXPECT_THAT(made.messages, HasSubstr(one.warning)) << one.name;
  }
}

TEST_F(RealMadeFiles, LightGoesWhereTheNotesSay) {
  const Made lambert = read("lambert_C_1deg.ies");
  EXPECT_NEAR(lambert.cd(0, 0), 318.31, 0.01);  // lx 1 m below

  const Made half = read("sym90-270_1995.ies");
  EXPECT_NEAR(half.cd(90, 45), 110.7107, 1e-3);
  EXPECT_NEAR(half.cd(270, 45), 30.7107, 1e-3);
  EXPECT_NEAR(half.cd(0, 45), 70.7107, 1e-3);
  EXPECT_NEAR(half.cd(180, 45), 70.7107, 1e-3);

  const Made isym3 = read("ldt_isym3.ldt");
  EXPECT_NEAR(isym3.cd(90, 45), 352.40, 0.01);
  EXPECT_NEAR(isym3.cd(270, 45), 97.76, 0.01);
  EXPECT_NEAR(isym3.cd(0, 45), 225.08, 0.01);
  EXPECT_NEAR(isym3.cd(180, 45), 225.08, 0.01);

  const Made isym2 = read("ldt_isym2.ldt");
  EXPECT_GT(isym2.cd(0, 45), 1.5 * isym2.cd(180, 45));
  EXPECT_NEAR(isym2.cd(60, 45), isym2.cd(300, 45), 1e-9);
  const Made isym0 = read("ldt_isym0.ldt");
  EXPECT_GT(isym0.cd(90, 45), 1.5 * isym0.cd(270, 45));

  for (const char* name : {"lobe20_g25_c40_typeC.ies", "lobe20_g25_c40_typeB.ies"}) {
    const Made lobe = read(name);
    EXPECT_NEAR(lobe.cd(40, 25), 1000.0, 4.0) << name;
    EXPECT_NEAR(lobe.cd(40, 45), 1000.0 * std::pow(test_support::cos_deg(20), 20), 3.0) << name;
    EXPECT_LT(lobe.cd(320, 45), 60.0) << name << " is mirrored";
  }
}

TEST_F(RealMadeFiles, SourcesOpeningsAndTiltAreKept) {
  const Made relative = read("lambert_relative_2x1000lm_mult0.5_bf0.9.ies");
  EXPECT_EQ(relative.web->source().rated_lamp_flux_lm, 2000.0);
  EXPECT_NEAR(relative.web->flux_lm() / relative.web->source().rated_lamp_flux_lm, 0.45, 1e-4);
  const Made absolute = read("ldt_absolute_neg_lamps.ldt");
  EXPECT_EQ(absolute.web->source().rated_lamp_flux_lm, 0.0);
  EXPECT_EQ(absolute.web->source().stated_flux_lm, 4321.0);
  EXPECT_NEAR(absolute.web->max_intensity_cd(), 1375.4, 0.1);
  EXPECT_EQ(read("ldt_round_zero_width.ldt").web->opening().shape, OpeningShape::disk);
  EXPECT_EQ(read("iso_100cd_0-180.ies").web->opening().shape, OpeningShape::point);
  for (const char* name : {"tilt_include_geom1.ies", "tilt_include_geom2.ies",
                           "tilt_include_geom3.ies", "tilt_file.ies"}) {
    const Made made = read(name);
    const std::optional<LampTilt>& tilt = made.web.value().source().lamp_tilt;
    ASSERT_TRUE(tilt) << name;
    EXPECT_NEAR(tilt_factor(*tilt, radians_from_degrees(45)), 0.9, 1e-12) << name;
    EXPECT_EQ(tilt->geometry, std::string(name) == "tilt_file.ies" ? 1 : name[17] - '0') << name;
  }
}

}  // namespace
}  // namespace calc::real_made_files_test
