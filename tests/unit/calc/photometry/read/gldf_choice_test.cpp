#include "calc/photometry/read/gldf_choice.h"
#include "tests/support/gldf_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace calc::gldf_choice_test {
namespace {

using test_support::GldfSample;
using testing::HasSubstr;

std::string emitter(const std::string& id, const std::string& photometry,
                    const std::string& attributes = "", const std::string& name = "") {
  const std::string words = name.empty() ? "" : "<Name><Locale>" + name + "</Locale></Name>";
  const std::string fitting = "<ChangeableLightEmitter " + attributes + ">" + words +
                              "<PhotometryReference photometryId='" + photometry +
                              "'/></ChangeableLightEmitter>";
  return id.empty() ? fitting : "<Emitter id='" + id + "'>" + fitting + "</Emitter>";
}

std::string variant(const std::string& id, const std::vector<std::string>& emitters) {
  std::string text = "<Variant id='" + id + "'><Name><Locale>" + id +
                     " name</Locale></Name>"
                     "<Geometry>";
  for (const std::string& each : emitters) text += "<EmitterReference emitterId='" + each + "'/>";
  return text + "</Geometry></Variant>";
}

// "variant/emitter/photometry" of the choice, "-" for no variant; else the messages.
std::string choose(const GldfSample& sample, const std::string& variant_id = "",
                   const std::string& emitter_id = "") {
  Diagnostics diagnostics;
  const XmlElement root =
      parse_xml(product_xml(sample), "a.gldf/product.xml", diagnostics, XmlText::keep).value();
  const std::optional<GldfProduct> product = read_gldf_product(root, diagnostics);
  PhotometryOptions options;
  options.variant = variant_id;
  options.emitter = emitter_id;
  const auto lights = choose_gldf_lights(product.value(), options, "a.gldf", diagnostics);
  EXPECT_EQ(!lights, diagnostics.has_errors());
  if (!lights) return test_support::diagnostics_text(diagnostics);
  std::string text;
  for (const GldfLight& light : *lights) {
    text += (text.empty() ? "" : " ") + (light.variant == nullptr ? "-" : light.variant->id) + "/" +
            light.emitter->id + "/" + light.fitting->photometry_id;
  }
  return text;
}

TEST(GldfChoice, TheOnlyOneIsTheDefault) {
  EXPECT_EQ(choose({}), "v1/e1/p1");
  EXPECT_EQ(choose({}, "v1"), "v1/e1/p1");
  EXPECT_EQ(choose({}, "v1", "e1"), "v1/e1/p1");
  EXPECT_EQ(choose({}, "", "e1"), "-/e1/p1");
  EXPECT_EQ(choose({}, "", "e1#1"), "-/e1/p1");
}

TEST(GldfChoice, WithoutVariantsTheEmittersCount) {
  GldfSample sample;
  sample.variants = "";
  EXPECT_EQ(choose(sample), "-/e1/p1");
  sample.variants = "<Variant id='v'/>";
  EXPECT_EQ(choose(sample), "v/e1/p1");
}

TEST(GldfChoice, VariantsWithOtherLightMustBeChosen) {
  GldfSample sample;
  sample.emitters = emitter("e1", "p1") + emitter("e2", "p2");
  sample.variants = variant("a", {"e1"}) + variant("b", {"e2"});
  EXPECT_EQ(choose(sample),
            "a.gldf: error[photometry-choice-needed]: there are 2 variants with different light; "
            "choose one with 'variant': a (a name), b (b name)\n");
  EXPECT_EQ(choose(sample, "b"), "b/e2/p2");
  EXPECT_EQ(choose(sample, "", "e2"), "-/e2/p2");
  EXPECT_EQ(
      choose(sample, "c"),
      "a.gldf: error[photometry-choice]: a.gldf has no variant 'c'; allowed: a (a name), b (b "
      "name)\n");
  EXPECT_EQ(choose(sample, "a", "e2"),
            "a.gldf: error[photometry-choice]: variant 'a' has no light emitter 'e2'; allowed: "
            "e1\n");
  sample.variants = variant("a", {"e1"}) + variant("b", {"e1"});
  EXPECT_EQ(choose(sample), "-/e1/p1");  // say, of another colour
}

TEST(GldfChoice, EmittersThatShineTogetherMustBeChosen) {
  GldfSample sample;
  sample.emitters = emitter("e1", "p1", "", "up") + emitter("e2", "p2", "", "down") +
                    "<Emitter id='s'><SensorEmitter/></Emitter>";
  sample.variants = variant("a", {"e1", "s", "e2", "e1"});
  EXPECT_EQ(choose(sample),
            "a.gldf: error[photometry-choice-needed]: there are 2 emitters with different light; "
            "choose one with 'emitter': e1 (up), e2 (down); 'all' takes those that shine "
            "together\n");
  EXPECT_EQ(choose(sample, "", "e2"), "-/e2/p2");
  EXPECT_THAT(choose(sample, "a", "s"), HasSubstr("no light emitter 's'; allowed: e1 (up), e2"));
  sample.variants = variant("a", {"s", "e2"});
  EXPECT_EQ(choose(sample), "a/e2/p2");
}

TEST(GldfChoice, EmittersAreTakenTogetherOnDemand) {
  GldfSample sample;
  const std::string only_emergency = "emergencyBehaviour='EmergencyOnly'";
  sample.emitters = emitter("e1", "p1") + emitter("e2", "p2") +
                    emitter("e3", "p2", only_emergency) + "<Emitter id='e4'>" + emitter("", "p1") +
                    emitter("", "p2") + "</Emitter>";
  sample.variants = variant("a", {"e1", "e2", "e3"}) + variant("b", {"e1", "e4"});
  EXPECT_EQ(choose(sample, "a", "all"), "a/e1/p1 a/e2/p2");
  EXPECT_THAT(choose(sample, "", "all"), HasSubstr("there are 2 variants"));
  EXPECT_THAT(choose(sample, "b", "all"), HasSubstr("e4#1, e4#2"));
  EXPECT_EQ(choose(sample, "b", "e1 e4#2"), "b/e1/p1 b/e4/p2");
  EXPECT_EQ(choose(sample, "a", "e2 e1"), "a/e2/p2 a/e1/p1");
  EXPECT_THAT(choose(sample, "a", "e1 e4#1"), HasSubstr("variant 'a' has no light emitter 'e4'"));
  EXPECT_THAT(choose(sample, "b", "e4#1 e4#2"), HasSubstr("'e4' is named twice"));
  // An id goes before the word.
  sample.emitters = emitter("all", "p2") + emitter("e1", "p1");
  sample.variants = variant("a", {"e1", "all"});
  EXPECT_EQ(choose(sample, "a", "all"), "a/all/p2");
}

TEST(GldfChoice, EmittersOfSeveralChannelsAreSaidToBeLeftOut) {
  GldfSample sample;
  sample.emitters = emitter("e1", "p1") + emitter("e2", "p2") +
                    "<Emitter id='m'><MultiChannelLightEmitter/></Emitter>";
  sample.variants = variant("a", {"e1", "e2", "m"});
  EXPECT_THAT(choose(sample, "a", "all"), HasSubstr("'m' has several channels"));
  sample.variants = variant("a", {"e1", "m"});
  Diagnostics diagnostics;
  const XmlElement root = parse_xml(product_xml(sample), "p", diagnostics, XmlText::keep).value();
  const std::optional<GldfProduct> product = read_gldf_product(root, diagnostics);
  EXPECT_TRUE(choose_gldf_lights(product.value(), {}, "a.gldf", diagnostics));
  EXPECT_THAT(test_support::diagnostics_text(diagnostics),
              HasSubstr("warning[gldf-left-out]: the emitter 'm' was left out"));
}

TEST(GldfChoice, EveryChoiceIsListed) {
  GldfSample sample;
  sample.emitters = emitter("e1", "p1") + "<Emitter id='e2'>" + emitter("", "p1") +
                    emitter("", "p2") + "</Emitter><Emitter id='s'><SensorEmitter/></Emitter>";
  const auto listed = [&] {
    Diagnostics diagnostics;
    const XmlElement root = parse_xml(product_xml(sample), "p", diagnostics, XmlText::keep).value();
    std::string text;
    for (const PhotometryOptions& each :
         gldf_choices(read_gldf_product(root, diagnostics).value())) {
      text += each.variant + "/" + each.emitter + " ";
    }
    return text;
  };
  sample.variants = variant("a", {"e1", "e2", "s"}) + variant("b", {"e1"});
  EXPECT_EQ(listed(), "a/e1 a/e2#1 a/e2#2 a/all b/e1 ");
  sample.variants = "";
  EXPECT_EQ(listed(), "/e1 /e2#1 /e2#2 ");
  sample.emitters = emitter("e1", "p1") + emitter("e2", "p1", "emergencyBehaviour='EmergencyOnly'");
  sample.variants = variant("a", {"e1", "e2"});
  EXPECT_EQ(listed(), "a/e1 a/e2 ");
}

TEST(GldfChoice, EmittersAreFoundAtModelsToo) {
  GldfSample sample;
  sample.variants =
      "<Variant id='a'><Geometry><GeometryReferences><ModelGeometryReference geometryId='g'>"
      "<EmitterReference emitterId='e1'/></ModelGeometryReference></GeometryReferences></Geometry>"
      "</Variant><Variant id='b'><Geometry><SimpleGeometryReference geometryId='h' "
      "emitterId='e1'/></Geometry></Variant>";
  EXPECT_EQ(choose(sample, "a"), "a/e1/p1");
  EXPECT_EQ(choose(sample, "b"), "b/e1/p1");
}

TEST(GldfChoice, FittingsAreAlternatives) {
  GldfSample sample;
  sample.emitters = "<Emitter id='e1'>" + emitter("", "p1", "", "warm") +
                    emitter("", "p2", "", "cold") + "</Emitter>";
  EXPECT_EQ(choose(sample),
            "a.gldf: error[photometry-choice-needed]: there are 2 fittings of the emitter with "
            "different light; choose one with 'emitter': e1#1 (warm), e1#2 (cold)\n");
  EXPECT_EQ(choose(sample, "", "e1#2"), "-/e1/p2");
  EXPECT_EQ(choose(sample, "v1", "e1#1"), "v1/e1/p1");
  for (const char* bad : {"e1#0", "e1#3", "e1#x", "e1#"})
    EXPECT_THAT(choose(sample, "", bad), HasSubstr("allowed: e1#1 (warm), e1#2 (cold)")) << bad;
  sample.emitters = "<Emitter id='e1'>" + emitter("", "p1") + emitter("", "p1") + "</Emitter>";
  EXPECT_EQ(choose(sample), "v1/e1/p1");
}

TEST(GldfChoice, FittingsForEmergenciesAreNotTheDefault) {
  GldfSample sample;
  const std::string emergency = emitter("", "p2", "emergencyBehaviour='EmergencyOnly'");
  sample.emitters = "<Emitter id='e1'>" + emergency + emitter("", "p1") + "</Emitter>";
  EXPECT_EQ(choose(sample), "v1/e1/p1");
  EXPECT_EQ(choose(sample, "", "e1#1"), "-/e1/p2");
  sample.emitters = "<Emitter id='e1'>" + emergency + "</Emitter>";
  EXPECT_EQ(choose(sample), "v1/e1/p2");
}

TEST(GldfChoice, TheEarlierFormOfEmittersIsRead) {
  GldfSample sample;
  sample.emitters = "<Emitter id='e1'><LightEmitter photometryId='p2' equipmentId='q'/></Emitter>";
  EXPECT_EQ(choose(sample), "v1/e1/p2");
}

}  // namespace
}  // namespace calc::gldf_choice_test
