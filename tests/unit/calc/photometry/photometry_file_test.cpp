#include "calc/photometry/photometry_file.h"

#include "calc/file_reader.h"
#include "tests/support/photometry_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace calc {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

std::string messages(const std::string& bytes) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_photometry(bytes, "x", diagnostics));
  return test_support::diagnostics_text(diagnostics);
}

TEST(PhotometryFile, FormatIsToldByContent) {
  Diagnostics diagnostics;
  EXPECT_EQ(parse_photometry(test_support::ies_text({}), "a.ldt", diagnostics)->source().format,
            "IESNA:LM-63-2002");
  EXPECT_EQ(parse_photometry(test_support::ldt_text({}), "a.ies", diagnostics)->source().format,
            "EULUMDAT");
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(PhotometryFile, OtherContentIsRefusedWithAGuess) {
  EXPECT_EQ(messages(""),
            "x: error[photometry-format]: not a photometry file that luxgate reads: the file is "
            "empty; readable: LM-63 "
            "(.ies) and EULUMDAT (.ldt)\n");
  EXPECT_THAT(messages("<?xml version='1.0'?><IESTM33-22/>"), HasSubstr("it is XML (TM-33?)"));
  EXPECT_THAT(messages("PK\x03\x04"), HasSubstr("it is a ZIP archive (GLDF?)"));
  EXPECT_THAT(messages("a\nb\nc\nd\n"),
              HasSubstr("no TILT= line, and lines 2 to 4 are not the three counts"));
  EXPECT_THAT(messages("IESNA:LM-63-2002\n1 2 3\n"), HasSubstr("error[photometry-no-tilt-line]"));
}

TEST(PhotometryFile, Utf16IsNamed) {
  std::string wide = "\xFF\xFE";
  for (const char c : test_support::ies_text({})) wide += std::string(1, c) + "\0"s;
  EXPECT_EQ(
      messages(wide),
      "x: error[photometry-encoding]: the text is UTF-16; allowed: ASCII, Windows-1252 or UTF-8\n");
  EXPECT_THAT(messages(wide.substr(2)), HasSubstr("error[photometry-encoding]"));
}

struct Example {
  const char* file;
  double flux_lm;
  OpeningShape shape;
  double along_c0_m, along_c90_m;
};

TEST(PhotometryFile, ExampleFilesHoldTheLightTheyState) {
  const Example examples[] = {
      {"lambert_panel_600.ies", 3600.0, OpeningShape::rectangle, 0.6, 0.6},
      {"batwing_1200.ies", 4000.0, OpeningShape::rectangle, 1.2, 0.3},
      {"spot_8deg.ies", 900.0, OpeningShape::disk, 0.08, 0.08},
      {"wallwasher.ies", 2000.0, OpeningShape::point, 0.0, 0.0},
      {"pendant_direct_indirect.ldt", 5400.0, OpeningShape::rectangle, 0.1, 1.5},
      {"isotropic_point.ies", 400.0 * kPi, OpeningShape::point, 0.0, 0.0},
  };
  for (const Example& example : examples) {
    const FileContent content = DiskFileReader().read(std::string(LUXGATE_SOURCE_DIR) +
                                                      "/examples/photometry/" + example.file);
    ASSERT_TRUE(content.ok()) << example.file << ": " << content.error;
    Diagnostics diagnostics;
    const auto web = parse_photometry(content.bytes, example.file, diagnostics);
    EXPECT_EQ(test_support::diagnostics_text(diagnostics), "");
    ASSERT_TRUE(web);
    EXPECT_NEAR(web->flux_lm() / example.flux_lm, 1.0, 1e-3) << example.file;
    EXPECT_EQ(web->opening().shape, example.shape) << example.file;
    EXPECT_NEAR(web->opening().along_c0_m, example.along_c0_m, 1e-9) << example.file;
    EXPECT_NEAR(web->opening().along_c90_m, example.along_c90_m, 1e-9) << example.file;
    EXPECT_EQ(web->source().manufacturer, "luxgate examples");
  }
}

}  // namespace
}  // namespace calc
