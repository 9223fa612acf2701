#include "report/tools/import/ifc_units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/report/tools/import/ifc_text.h"

namespace ifc_units_test {
namespace {

using cli::IfcUnits;
using cli::StepProblem;
using cli::StepText;
using test_support::ifc_file;
using ::testing::HasSubstr;

constexpr const char* kRadian = "IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.)";

std::optional<IfcUnits> units(const std::string& bytes, std::string* why = nullptr) {
  StepProblem problem;
  const auto text = StepText::open(bytes, problem);
  EXPECT_TRUE(text) << problem.what;
  if (!text) return std::nullopt;
  auto result = cli::read_ifc_units(*text, problem);
  if (!result && why != nullptr) *why = std::to_string(problem.line) + ": " + problem.what;
  return result;
}

std::string problem(const std::string& bytes) {
  std::string why;
  EXPECT_FALSE(units(bytes, &why));
  return why;
}

TEST(IfcUnits, ReadsPrefixesToTheLastBit) {
  const auto mm = units(ifc_file(""));
  ASSERT_TRUE(mm);
  EXPECT_EQ(mm->name, "mm");
  EXPECT_EQ(mm->length_m(5400.0), 5.4);
  EXPECT_EQ(mm->length_m(-7.0), -0.007);
  EXPECT_TRUE(mm->has_angle);
  EXPECT_EQ(mm->radians, 1.0);
  const auto km = units(ifc_file("", "IFC4", "IFCSIUNIT(*,.LENGTHUNIT.,.KILO.,.METRE.)"));
  ASSERT_TRUE(km);
  EXPECT_EQ(km->length_m(2.0), 2000.0);
  const auto m = units(ifc_file("", "IFC4", "IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.)"));
  ASSERT_TRUE(m);
  EXPECT_EQ(m->length_m(0.1), 0.1);
}

TEST(IfcUnits, ReadsFeetAndDegrees) {
  const auto feet =
      units(ifc_file("#910=IFCMEASUREWITHUNIT(IFCRATIOMEASURE(0.3048),#911);"
                     "#911=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);"
                     "#912=IFCMEASUREWITHUNIT(IFCPLANEANGLEMEASURE(0.0174532925199433),#913);"
                     "#913=IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.);",
                     "IFC2X3", "IFCCONVERSIONBASEDUNIT($,.LENGTHUNIT.,'FOOT',#910)",
                     "IFCCONVERSIONBASEDUNIT($,.PLANEANGLEUNIT.,'DEGREE',#912)"));
  ASSERT_TRUE(feet);
  EXPECT_EQ(feet->name, "FOOT");
  EXPECT_DOUBLE_EQ(feet->length_m(10.0), 3.048);
  EXPECT_DOUBLE_EQ(feet->radians, 0.0174532925199433);
  EXPECT_TRUE(feet->doubt.empty());
}

TEST(IfcUnits, AFootOfAnotherLengthIsADoubt) {
  const auto feet =
      units(ifc_file("#910=IFCMEASUREWITHUNIT(IFCRATIOMEASURE(0.3),#911);"
                     "#911=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);",
                     "IFC2X3", "IFCCONVERSIONBASEDUNIT($,.LENGTHUNIT.,'foot',#910)"));
  ASSERT_TRUE(feet);
  ASSERT_EQ(feet->doubt.size(), 1u);
  EXPECT_THAT(feet->doubt[0], HasSubstr("0.3 m in this file and 0.3048 m elsewhere"));
}

TEST(IfcUnits, NothingIsTakenForGranted) {
  EXPECT_THAT(problem(ifc_file("", "IFC4", kRadian)), HasSubstr("no unit of length"));
  EXPECT_THAT(problem(ifc_file("", "IFC4", "IFCSIUNIT(*,.LENGTHUNIT.,.GIGA.,.METRE.)")),
              HasSubstr("the prefix GIGA"));
  EXPECT_THAT(problem(ifc_file("", "IFC4", "IFCSIUNIT(*,.LENGTHUNIT.,$,.GRAM.)")),
              HasSubstr("GRAM"));
  EXPECT_THAT(problem(ifc_file("", "IFC4", "IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.)",
                               "IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.)")),
              HasSubstr("two units for LENGTHUNIT"));
  EXPECT_THAT(problem(ifc_file("#903=IFCPROJECT('q',$,$,$,$,$,$,(),#901);")),
              HasSubstr("second IFCPROJECT"));
}

TEST(IfcUnits, UnitsThatStandOnThemselvesEnd) {
  EXPECT_THAT(problem(ifc_file("#910=IFCMEASUREWITHUNIT(IFCRATIOMEASURE(2.),#902);", "IFC4",
                               "IFCCONVERSIONBASEDUNIT($,.LENGTHUNIT.,'X',#910)")),
              HasSubstr("too deep"));
  EXPECT_THAT(problem(ifc_file("#910=IFCMEASUREWITHUNIT(IFCRATIOMEASURE(0.),#902);", "IFC4",
                               "IFCCONVERSIONBASEDUNIT($,.LENGTHUNIT.,'X',#910)")),
              HasSubstr("factor > 0"));
  EXPECT_THAT(problem(ifc_file("", "IFC4", "IFCCONVERSIONBASEDUNIT($,.LENGTHUNIT.,'X',#910)")),
              HasSubstr("factor > 0"));
}

TEST(IfcUnits, AFileWithoutAnAngleSaysSo) {
  const auto none = units(ifc_file("", "IFC4", "IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.)",
                                   "IFCSIUNIT(*,.MASSUNIT.,$,.GRAM.)"));
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->has_angle);
}

}  // namespace
}  // namespace ifc_units_test
