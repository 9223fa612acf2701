// <maintenance-plan> and north: read, kept in range, and said once.

#include "calc/project/reading/project_elements.h"
#include "calc/scene/maintenance_plan.h"
#include "tests/unit/calc/project/project_xml_support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace calc::tests::maintenance_plan_xml_test {
namespace {

using ::testing::HasSubstr;

Loaded load_plan(const std::string& lines) { return load(project_files(in_project(lines))); }

TEST(MaintenancePlanXml, EveryAttributeIsRead) {
  const Loaded loaded = load_plan(
      "<maintenance-plan environment=' clean office ' clean-luminaires-months='12' "
      "clean-surfaces-months='36.5' replace-lights-hours='50000' hours-in-a-year='2500' "
      "instructions='by the house'/>");
  ASSERT_TRUE(loaded.project) << loaded.messages;
  const MaintenancePlan& plan = loaded.project->maintenance_plan;
  EXPECT_EQ(plan.environment, "clean office");
  EXPECT_EQ(plan.instructions, "by the house");
  EXPECT_EQ(plan.clean_luminaires_months, 12.0);
  EXPECT_EQ(plan.clean_surfaces_months, 36.5);
  EXPECT_EQ(plan.replace_lights_h, 50000.0);
  EXPECT_EQ(plan.use_h, 2500.0);
  EXPECT_FALSE(plan.is_empty());
}

TEST(MaintenancePlanXml, NothingOfItIsNeeded) {
  for (const char* lines : {"", "<maintenance-plan/>"}) {
    const Loaded loaded = load_plan(lines);
    ASSERT_TRUE(loaded.project) << loaded.messages;
    EXPECT_TRUE(loaded.project->maintenance_plan.is_empty());
    EXPECT_FALSE(loaded.project->north_deg);
  }
}

TEST(MaintenancePlanXml, MistakesAreNamed) {
  for (const char* attribute :
       {"clean-luminaires-months='0'", "clean-surfaces-months='-1'", "replace-lights-hours='soon'",
        "hours-in-a-year='8761'", "lamps='1'"}) {
    const Loaded loaded = load_plan("<maintenance-plan " + std::string(attribute) + "/>");
    EXPECT_FALSE(loaded.project) << attribute;
    EXPECT_NE(loaded.messages, "");
  }
  const Loaded twice = load_plan("<maintenance-plan/>\n<maintenance-plan/>");
  EXPECT_FALSE(twice.project);
  EXPECT_THAT(twice.messages, HasSubstr("maintenance-plan"));
}

TEST(North, IsAnAngleOfTheRoot) {
  const auto with_north = [](const std::string& value) {
    std::string xml = in_project("");
    const std::size_t at = xml.find("<luxgate ");
    EXPECT_NE(at, std::string::npos);
    return load(xml.insert(at + std::string("<luxgate ").size(), "north='" + value + "' "));
  };
  EXPECT_EQ(with_north("-30").project->north_deg, -30.0);
  for (const char* value : {"361", "up", "nan"}) EXPECT_FALSE(with_north(value).project) << value;
}

// The table that readers and writers go by has every number of the element.
TEST(MaintenancePlanXml, NamesOfNumbersAreAttributes) {
  std::set<std::string> names;
  for (const std::string_view name : attribute_names(kMaintenancePlanElement)) names.emplace(name);
  EXPECT_EQ(names.erase("environment") + names.erase("instructions"), 2U);
  for (const MaintenanceNumber& one : kMaintenanceNumbers)
    EXPECT_EQ(names.erase(one.name), 1U) << one.name;
  EXPECT_TRUE(names.empty());
}

}  // namespace
}  // namespace calc::tests::maintenance_plan_xml_test
