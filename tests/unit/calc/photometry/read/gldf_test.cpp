#include "calc/photometry/read/gldf.h"
#include "calc/photometry/read/photometry_file.h"
#include "tests/support/gldf_samples.h"
#include "tests/support/parsed_photometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace calc::gldf_test {
namespace {

using test_support::cos_deg;
using test_support::gldf_bytes;
using test_support::GldfSample;
using test_support::LdtSample;
using test_support::product_xml;
using test_support::zip_bytes;
using testing::HasSubstr;

using Parsed = test_support::ParsedPhotometry;

Parsed parse(const std::string& bytes, const PhotometryOptions& options = {}) {
  return test_support::parse_with_messages(bytes, "a.gldf", options);
}

std::string fixed_emitter(const std::string& inside) {
  return "<Emitter id='e1'><FixedLightEmitter><PhotometryReference photometryId='p1'/>"
         "<LightSourceReference fixedLightSourceId='s' lightSourceCount='2'/>" +
         inside + "</FixedLightEmitter></Emitter>";
}

TEST(Gldf, TheOnlyLightIsRead) {
  const Parsed parsed = parse(gldf_bytes({}));
  EXPECT_EQ(parsed.messages, "");
  EXPECT_NEAR(parsed.web->flux_lm(), 1000.0, 1.5);
  const PhotometrySource& source = parsed.web->source();
  EXPECT_EQ(source.format, "GLDF (EULUMDAT)");
  EXPECT_EQ(source.manufacturer, "luxgate examples");
  EXPECT_EQ(source.luminaire_name, "Lamp, One");
  EXPECT_EQ(source.applied_factors, "LDT conversion 1 x 1000 lm / 1000");
  EXPECT_EQ(source.rated_lamp_flux_lm, 1000.0);
  EXPECT_EQ(source.input_power_w, 10.0);
  EXPECT_EQ(parsed.web->opening().shape, OpeningShape::rectangle);
}

TEST(Gldf, TheContentOfAPhotometryDecidesItsFormat) {
  GldfSample sample;
  sample.photometries = "<Photometry id='p1'><PhotometryFileReference fileId='f2'/></Photometry>";
  EXPECT_EQ(parse(gldf_bytes(sample)).web->source().format, "GLDF (IESNA:LM-63-2002)");
}

TEST(Gldf, LampSetIsHandedOn) {
  LdtSample ldt;
  ldt.lamp_set_lines = {"1", "A", "1000", "", "", "10", "1", "B", "500", "", "", "5"};
  PhotometryOptions options;
  options.lamp_set = 2;
  const Parsed parsed = parse(gldf_bytes({}, ldt), options);
  EXPECT_EQ(parsed.messages, "");
  EXPECT_NEAR(parsed.web->flux_lm(), 500.0, 1.0);
  options.lamp_set = 3;
  EXPECT_THAT(
      parse(gldf_bytes({}, ldt), options).messages,
      HasSubstr("a.gldf/ldc/a.ldt has no lamp set '3'; allowed: 1 (A, 1000 lm), 2 (B, 500"));
}

TEST(Gldf, FixedFluxScalesWhereLampsAndLuminaireAreTheSame) {
  GldfSample sample;
  sample.emitters = fixed_emitter("<RatedLuminousFlux>800</RatedLuminousFlux>");
  for (const char* lamps : {"1", "-1"}) {
    LdtSample ldt;
    ldt.lamp_set_lines[0] = lamps;
    const Parsed parsed = parse(gldf_bytes(sample, ldt));
    EXPECT_THAT(parsed.messages,
                HasSubstr("a.gldf/product.xml:6:18: warning[gldf-value]: product.xml states the "
                          "luminous flux (lm) as 800, the photometry file as "));
    EXPECT_THAT(parsed.messages, HasSubstr("; the light was scaled to product.xml"));
    EXPECT_NEAR(parsed.web->flux_lm(), 800.0, 1.5);
    EXPECT_THAT(parsed.web->source().applied_factors, HasSubstr(" x GLDF 800 lm / "));
    EXPECT_EQ(parsed.web->source().rated_lamp_flux_lm, lamps[0] == '1' ? 800.0 : 0.0);
  }
}

TEST(Gldf, FixedFluxThatMayMeanTwoThingsIsNotApplied) {
  LdtSample ldt;
  ldt.cd_per_klm = [](double, double gamma) {
    return gamma < 90.0 ? 500.0 / kPi * cos_deg(gamma) : 0.0;
  };
  ldt.output_ratio = "50";
  const auto with_flux = [&](int flux_lm) {
    GldfSample sample;
    sample.emitters =
        fixed_emitter(fmt::format("<RatedLuminousFlux>{}</RatedLuminousFlux>", flux_lm));
    const Parsed parsed = parse(gldf_bytes(sample, ldt));
    EXPECT_NEAR(parsed.web->flux_lm(), 500.0, 1.5);
    EXPECT_THAT(parsed.web->source().applied_factors, testing::Not(HasSubstr("GLDF")));
    return parsed.messages;
  };
  EXPECT_EQ(with_flux(1000), "");  // of the lamps
  EXPECT_EQ(with_flux(500), "");   // of the luminaire
  EXPECT_THAT(with_flux(800),
              HasSubstr("the value of product.xml is the flux of the lamps or of the luminaire "
                        "(not known which). The light of the photometry file was "
                        "kept"));
}

TEST(Gldf, EquipmentFluxReplacesThatOfTheLamps) {
  GldfSample sample;
  sample.light_sources =
      "<ChangeableLightSource id='s'><RatedLuminousFlux>100</RatedLuminousFlux>"
      "</ChangeableLightSource>";
  sample.equipment =
      "<Equipment id='q'><LightSourceReference changeableLightSourceId='s' lightSourceCount='3'/>"
      "<RatedInputPower>12</RatedInputPower><RatedLuminousFlux>600</RatedLuminousFlux></Equipment>";
  sample.emitters =
      "<Emitter id='e1'><ChangeableLightEmitter><PhotometryReference photometryId='p1'/>"
      "<EquipmentReference equipmentId='q'/></ChangeableLightEmitter></Emitter>";
  LdtSample ldt;
  ldt.cd_per_klm = [](double, double gamma) {
    return gamma < 90.0 ? 500.0 / kPi * cos_deg(gamma) : 0.0;
  };
  ldt.output_ratio = "50";
  const Parsed parsed = parse(gldf_bytes(sample, ldt));
  EXPECT_THAT(parsed.messages,
              HasSubstr("(lm) as 600, the photometry file as 1000; the light was"));
  EXPECT_THAT(parsed.messages,
              HasSubstr("the power (W) as 12, the photometry file as 10; product"));
  EXPECT_NEAR(parsed.web->flux_lm(), 300.0, 1.0);
  EXPECT_EQ(parsed.web->source().rated_lamp_flux_lm, 600.0);
  EXPECT_EQ(parsed.web->source().input_power_w, 12.0);
  EXPECT_THAT(parsed.web->source().applied_factors, HasSubstr(" x GLDF 600 lm / 1000 lm"));

  ldt.lamp_set_lines[0] = "-1";  // absolute: the lamps' flux is unknown
  const Parsed absolute = parse(gldf_bytes(sample, ldt));
  EXPECT_NEAR(absolute.web->flux_lm(), 500.0, 1.5);
  EXPECT_THAT(absolute.messages, HasSubstr("which the photometry file does not state"));

  ldt.lamp_set_lines[0] = "1";
  sample.equipment =
      "<Equipment id='q'><LightSourceReference changeableLightSourceId='s' lightSourceCount='3'/>"
      "</Equipment>";
  const Parsed lamps_only = parse(gldf_bytes(sample, ldt));
  EXPECT_NEAR(lamps_only.web->flux_lm(), 500.0, 1.5);
  EXPECT_THAT(lamps_only.messages, HasSubstr("(lm) as 300, the photometry file as 1000; the value "
                                             "of product.xml is the flux of single lamps"));
}

// The file's 10 W are for its 1000 lm.
TEST(Gldf, PowerOfLightSourcesCountsWhereItIsHigherOrTheLightIsOther) {
  GldfSample sample;
  sample.light_sources =
      "<FixedLightSource id='s'><RatedInputPower>20</RatedInputPower></FixedLightSource>";
  sample.emitters = fixed_emitter("");
  const Parsed higher = parse(gldf_bytes(sample));
  EXPECT_EQ(higher.web->source().input_power_w, 40.0);
  EXPECT_THAT(higher.messages,
              HasSubstr("the power (W) as 40, the photometry file as 10; product"));
  EXPECT_THAT(higher.web->source().power_rule, HasSubstr("product.xml, light sources"));
  // Half the light needs less: the file's power is not that of this light.
  sample.light_sources =
      "<FixedLightSource id='s'><RatedInputPower>2</RatedInputPower></FixedLightSource>";
  sample.emitters = fixed_emitter("<RatedLuminousFlux>500</RatedLuminousFlux>");
  EXPECT_EQ(parse(gldf_bytes(sample)).web->source().input_power_w, 4.0);
  // And if nobody states one it is not known.
  sample.light_sources = "<FixedLightSource id='s'/>";
  const Parsed unknown = parse(gldf_bytes(sample));
  EXPECT_EQ(unknown.web->source().input_power_w, 0.0);
  EXPECT_THAT(unknown.messages, HasSubstr("warning[gldf-power-unknown]"));
  sample.emitters = fixed_emitter("<RatedLuminousFlux>1000</RatedLuminousFlux>");
  EXPECT_EQ(parse(gldf_bytes(sample)).web->source().input_power_w, 10.0);
}

TEST(Gldf, PowerOfALightSourceAloneIsNotTakenForLess) {
  GldfSample sample;
  sample.light_sources =
      "<FixedLightSource id='s'><RatedInputPower>4</RatedInputPower>"
      "</FixedLightSource>";
  sample.emitters = fixed_emitter("");
  const Parsed lower = parse(gldf_bytes(sample));
  EXPECT_EQ(lower.web->source().input_power_w, 10.0);
  EXPECT_THAT(lower.messages, HasSubstr("The higher one, of the photometry file, was kept"));
  LdtSample ldt;
  ldt.lamp_set_lines[5] = "0";
  EXPECT_EQ(parse(gldf_bytes(sample, ldt)).web->source().input_power_w, 8.0);
}

TEST(Gldf, RotationIsWarnedOf) {
  GldfSample sample;
  sample.emitters = fixed_emitter("<Rotation><X>0</X><Y>0</Y><Z>0</Z><G0>90</G0></Rotation>");
  const std::string warning =
      "a.gldf/product.xml:6:18: warning[photometry-not-applied]: the emitter's rotation was not "
      "applied: aim the luminaire in the project\n";
  EXPECT_EQ(parse(gldf_bytes(sample)).messages, warning);
  sample.emitters = fixed_emitter("<Rotation><X>0</X></Rotation>");
  EXPECT_EQ(parse(gldf_bytes(sample)).messages, "");
  sample.photometries =
      "<Photometry id='p1'><PhotometryFileReference fileId='f1'/>"
      "<Rotation-G0>45</Rotation-G0></Photometry>";
  EXPECT_EQ(parse(gldf_bytes(sample)).messages, warning);
}

TEST(Gldf, FilesOnTheWebAreNotFetched) {
  GldfSample sample;
  sample.files = "<File id='f1' contentType='ldc/eulumdat' type='url'>https://e.org/a.ldt</File>";
  EXPECT_EQ(parse(gldf_bytes(sample)).messages,
            "a.gldf/product.xml:2:1: error[gldf-url]: the photometry 'f1' is on the web, at "
            "'https://e.org/a.ldt', and luxgate downloads nothing; download the file and name it "
            "in the project instead of the GLDF file\n");
}

TEST(Gldf, BrokenReferencesAreNamed) {
  const auto messages = [](const auto& change) {
    GldfSample sample;
    change(sample);
    return parse(gldf_bytes(sample)).messages;
  };
  EXPECT_EQ(messages([](GldfSample& s) { s.photometries = "<Photometry id='p9'/>"; }),
            "a.gldf/product.xml:6:18: error[gldf-reference]: product.xml defines no photometry "
            "'p1'; defined: p9\n");
  EXPECT_EQ(messages([](GldfSample& s) { s.photometries = "<Photometry id='p1'/>"; }),
            "a.gldf/product.xml:3:1: error[gldf-reference]: product.xml defines no file ''; "
            "defined: f1, f2\n");
  EXPECT_THAT(messages([](GldfSample& s) {
                s.variants = "<Variant id='v'><EmitterReference emitterId='none'/></Variant>";
              }),
              HasSubstr("a.gldf/product.xml:7:1: error[gldf-reference]: product.xml defines no "
                        "emitter 'none'; defined: e1"));
  const auto file = [&](const std::string& text, const std::string& type = "ldc/eulumdat") {
    return messages([&](GldfSample& s) {
      s.files = "<File id='f1' contentType='" + type + "' type='localFileName'>" + text + "</File>";
    });
  };
  EXPECT_EQ(file("none.ldt"),
            "a.gldf: error[archive-missing]: the archive has no 'ldc/none.ldt'; it has: "
            "product.xml, ldc/a.ldt, ldc/b.ies\n");
  EXPECT_EQ(file("ldc/a.ldt"), "");
  EXPECT_THAT(file("../a.ldt"),
              HasSubstr("error[archive-name]: the archive names a file '../a.ldt'"));
  EXPECT_THAT(file("product.xml"), HasSubstr("a.gldf/product.xml:1:1: error[photometry-xml-root]"));
  EXPECT_THAT(
      file("a.ldt", "image/png"),
      HasSubstr("error[gldf-content-type]: the photometry file 'a.ldt' has the content type "
                "'image/png'; allowed: ldc/eulumdat, ldc/ies or ldc/iesxml"));
}

TEST(Gldf, DamagedContainersAreNamed) {
  EXPECT_EQ(parse(zip_bytes({})).messages,
            "a.gldf: error[archive-missing]: the archive has no 'product.xml'; it has: none\n");
  EXPECT_EQ(parse(zip_bytes({{"product.xml", "<Luminaire/>"}})).messages,
            "a.gldf/product.xml:1:1: error[photometry-xml-root]: <Luminaire> is not photometry "
            "that luxgate reads; readable: Root, in product.xml of a GLDF file\n");
  EXPECT_EQ(parse(zip_bytes({{"product.xml", "<Root/>"}})).messages,
            "a.gldf/product.xml:1:1: error[photometry-missing]: <Root> has no "
            "<GeneralDefinitions>\n");
  EXPECT_THAT(parse(zip_bytes({{"product.xml", "<Root><Header>"}})).messages,
              HasSubstr("a.gldf/product.xml:1:1"));
  EXPECT_THAT(parse(zip_bytes({{"product.xml", "<!DOCTYPE Root><Root/>"}})).messages,
              HasSubstr("error[xml-doctype]"));
  EXPECT_THAT(parse(zip_bytes({{"product.xml", "<Root><GeneralDefinitions/></Root>"}})).messages,
              HasSubstr("<Root> has no light emitter"));
  GldfSample sample;
  EXPECT_THAT(
      parse(zip_bytes({{"product.xml", product_xml(sample)}, {"ldc/a.ldt", gldf_bytes(sample)}}))
          .messages,
      HasSubstr("a.gldf/ldc/a.ldt: error[photometry-"));
  sample.light_sources =
      "<ChangeableLightSource id='s'><RatedLuminousFlux>-1</RatedLuminousFlux>"
      "</ChangeableLightSource>";
  EXPECT_THAT(parse(gldf_bytes(sample)).messages,
              HasSubstr("<RatedLuminousFlux> is -1; allowed: 0 to 1e+12"));
}

TEST(Gldf, ProductsInUtf16AreRead) {
  const std::string utf8 = product_xml({}).substr(3);
  std::string wide = "\xFE\xFF";
  for (const char c : utf8) {
    wide += '\0';
    wide += c;
  }
  const Parsed parsed =
      parse(zip_bytes({{"product.xml", wide}, {"ldc/a.ldt", test_support::ldt_text({})}}));
  EXPECT_EQ(parsed.messages, "");
  EXPECT_EQ(parsed.web->source().luminaire_name, "Lamp, One");
}

TEST(Gldf, CutContainersAreErrors) {
  const std::string bytes = gldf_bytes({});
  for (std::size_t length = 4; length < bytes.size(); length += 7) {
    EXPECT_THAT(parse(bytes.substr(0, length)).messages, HasSubstr("error[archive-unreadable]"))
        << length;
  }
}

TEST(Gldf, KeepsTheAxisOfTheTable) {
  test_support::GldfSample sample;
  sample.emitters = "<Emitter id='e1'><LightEmitter photometryId='p2'/></Emitter>";
  test_support::IesSample flood;
  flood.type = "2";
  flood.gamma_deg = flood.c_deg = test_support::angle_steps(-90, 90, 10);
  flood.cd = [](double h, double v) { return h == -20 && v == 40 ? 900.0 : 1.0; };
  const std::string ies = test_support::ies_text(flood);
  Diagnostics diagnostics;
  const auto alone = parse_photometry(ies, "b.ies", diagnostics);
  const auto packed =
      parse_photometry(test_support::zip_bytes({{"product.xml", test_support::product_xml(sample)},
                                                {"ldc/a.ldt", test_support::ldt_text({})},
                                                {"ldc/b.ies", ies}}),
                       "a.gldf", diagnostics);
  ASSERT_TRUE(alone && packed) << test_support::diagnostics_text(diagnostics);
  EXPECT_EQ(packed->axis(), TableAxis::lateral);
  const std::array<double, 3> beam =
      alone->from_table(direction_of({radians_from_degrees(40), radians_from_degrees(70)}));
  EXPECT_NEAR(packed->intensity_cd(beam), 900.0, 1e-6);
}

}  // namespace
}  // namespace calc::gldf_test
