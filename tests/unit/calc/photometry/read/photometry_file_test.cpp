#include "calc/photometry/read/photometry_file.h"
#include "calc/base/file_reader.h"
#include "tests/support/photometry_samples.h"
#include "tests/support/tm33_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace calc::photometry_file_test {
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
  std::string by_ies = test_support::ldt_text({});
  by_ies.replace(0, std::string("luxgate").size(), "IES");
  const auto web = parse_photometry(by_ies, "a.ldt", diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << test_support::diagnostics_text(diagnostics);
  EXPECT_EQ(web.value().source().format, "EULUMDAT");
}

std::string with_line(std::string text, int line, const std::string& words) {
  std::size_t begin = 0;
  for (int i = 1; i < line; ++i) begin = text.find('\n', begin) + 1;
  return text.replace(begin, text.find('\n', begin) - begin, words);
}

TEST(PhotometryFile, EulumdatTextsMayStartWithTilt) {
  for (const int line : {1, 8, 9, 12, 28}) {  // company, report, name, date, lamp
    const std::string words = line == 1 ? "TILT=5 GmbH" : "TILT=NONE";
    Diagnostics diagnostics;
    const auto web =
        parse_photometry(with_line(test_support::ldt_text({}), line, words), "a", diagnostics);
    ASSERT_TRUE(web) << line << ": " << test_support::diagnostics_text(diagnostics);
    EXPECT_EQ(web->source().format, "EULUMDAT") << line;
  }
}

TEST(PhotometryFile, Lm63WithOneNumberPerLineIsNotEulumdat) {
  const std::string numbers = "1\n0\n1\n2\n1\n1\n2\n0\n0\n0\n1\n1\n10\n0\n90\n0\n100\n0\n";
  for (const std::string head : {"TILT=NONE\n", "IESNA:LM-63-2002\nTILT=NONE\n"}) {
    Diagnostics diagnostics;
    const auto web = parse_photometry(head + numbers, "a", diagnostics);
    ASSERT_TRUE(web) << test_support::diagnostics_text(diagnostics);
    EXPECT_NE(web->source().format, "EULUMDAT");
    EXPECT_EQ(web->intensity_cd(0.0, 0.0), 100.0);
  }
}

TEST(PhotometryFile, OtherContentIsRefusedWithAGuess) {
  EXPECT_EQ(messages(""),
            "x: error[photometry-format]: not a photometry file that luxgate reads: the file is "
            "empty; readable: LM-63 (.ies), EULUMDAT (.ldt), TM-33 (.xml) and GLDF (.gldf)\n");
  EXPECT_THAT(messages("\n <?xml version='1.0'?><IESTM33-22/>"), HasSubstr("error[xml-syntax]"));
  EXPECT_THAT(messages("\xEF\xBB\xBF<IESTM33-22/>"), HasSubstr("has no <Emitter>"));
  EXPECT_THAT(messages("PK\x03\x04"), HasSubstr("error[archive-unreadable]"));
  EXPECT_THAT(messages("a\nb\nc\nd\n"),
              HasSubstr("no TILT= line, and lines 2 to 4 are not the three counts"));
  EXPECT_THAT(messages("IESNA:LM-63-2002\n1 2 3\n"), HasSubstr("error[photometry-no-tilt-line]"));
}

std::string messages(const std::string& bytes, const PhotometryOptions& options) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_photometry(bytes, "x", diagnostics, options));
  return test_support::diagnostics_text(diagnostics);
}

TEST(PhotometryFile, ChoicesThatAFormatDoesNotHaveAreErrors) {
  PhotometryOptions all{2, "v", "e", {"p.xml", 7, 3}};
  EXPECT_EQ(messages(test_support::ies_text({}), all),
            "p.xml:7:3: error[photometry-option-unused]: 'x' is an LM-63 file, which has no lamp "
            "sets to choose; leave out 'lamp-set'\n"
            "p.xml:7:3: error[photometry-option-unused]: 'x' is an LM-63 file, which has no "
            "variants to choose; leave out 'variant'\n"
            "p.xml:7:3: error[photometry-option-unused]: 'x' is an LM-63 file, which has no "
            "emitters to choose; leave out 'emitter'\n");
  all.where = {};
  const std::string ldt = messages(test_support::ldt_text({}), all);
  EXPECT_THAT(ldt, HasSubstr("x: error[photometry-option-unused]: 'x' is an EULUMDAT file, which "
                             "has no variants"));
  EXPECT_THAT(ldt, HasSubstr("no emitters"));
  EXPECT_THAT(ldt, testing::Not(HasSubstr("no lamp sets")));
  const std::string xml = messages("<IESTM33-22/>", all);
  EXPECT_THAT(xml, HasSubstr("a TM-33 file, which has no lamp sets"));
  EXPECT_THAT(xml, HasSubstr("no variants"));
  EXPECT_THAT(xml, testing::Not(HasSubstr("no emitters")));
}

TEST(PhotometryFile, ListsOfChoicesStopAtTen) {
  std::vector<PhotometryChoice> choices(12, {"id", "words"});
  choices[1].label.clear();
  const std::string text = list_choices(choices);
  EXPECT_TRUE(text.starts_with("id (words), id, id (words), ")) << text;
  EXPECT_TRUE(text.ends_with("id (words), ... (12 in all)")) << text;
  EXPECT_EQ(list_choices({}), "none");
}

std::string as_utf16(const std::string& text) {
  std::string wide = "\xFF\xFE";
  for (const char c : text) wide += std::string(1, c) + "\0"s;
  return wide;
}

TEST(PhotometryFile, Utf16IsRead) {
  for (const std::string& text : {test_support::ies_text({}), test_support::ldt_text({}),
                                  test_support::tm33_text(test_support::tm33_emitter({}))}) {
    Diagnostics diagnostics;
    const double flux_lm = parse_photometry(text, "x", diagnostics)->flux_lm();
    const std::string wide = as_utf16(text);
    EXPECT_EQ(parse_photometry(wide, "x", diagnostics).value().flux_lm(), flux_lm);
    EXPECT_EQ(parse_photometry(wide.substr(2), "x", diagnostics).value().flux_lm(), flux_lm);
    EXPECT_FALSE(diagnostics.has_errors());
  }
  EXPECT_EQ(messages(as_utf16(test_support::ies_text({})) + "x"),
            "x: error[photometry-encoding]: the encoding cannot be read: the UTF-16 text has an "
            "incomplete "
            "character; readable are UTF-8, UTF-16 and Windows-1252\n");
}

TEST(PhotometryFile, OtherKindsOfFilesAreNamed) {
  EXPECT_EQ(messages("%PDF-1.7\n..."),
            "x: error[file-of-other-kind]: it is a PDF document; photometry (LM-63, EULUMDAT, "
            "TM-33 or GLDF) is needed here. Pictures and documents cannot be read here\n");
  EXPECT_THAT(messages("<gbXML/>"), HasSubstr("it is a gbXML file; photometry"));
  // EULUMDAT's first line is any text.
  test_support::LdtSample sample;
  const std::string ldt = test_support::ldt_text(sample);
  Diagnostics diagnostics;
  EXPECT_TRUE(parse_photometry("a light company" + ldt.substr(ldt.find_first_of("\r\n")), "x",
                               diagnostics));
  // Of a file that nobody knows the name counts, and only then.
  EXPECT_FALSE(parse_photometry("nothing", "lamp.uld", diagnostics));
  EXPECT_THAT(test_support::diagnostics_text(diagnostics),
              HasSubstr("by its name it is a DIALux luminaire"));
  EXPECT_TRUE(parse_photometry(ldt, "lamp.uld", diagnostics));
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
}  // namespace calc::photometry_file_test
