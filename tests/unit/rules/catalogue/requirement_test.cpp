#include "rules/catalogue/requirement.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace rules::requirement_test {
namespace {

TEST(MetricNames, AreThoseOfProjectFiles) {
  const std::vector<std::string_view> expected{"average",    "minimum", "maximum", "Uo",      "Ud",
                                               "percentile", "value",   "share",   "gradient"};
  EXPECT_EQ(metric_names(), expected);
  EXPECT_EQ(calc::name_of(Metric::uniformity_min_max), "Ud");
}

TEST(MetricNames, AreReadBack) {
  for (const std::string_view name : metric_names()) {
    ASSERT_TRUE(calc::find_value<Metric>(name).has_value());
    EXPECT_EQ(calc::name_of(*calc::find_value<Metric>(name)), name);
  }
  EXPECT_FALSE(calc::find_value<Metric>("uo").has_value());
  EXPECT_FALSE(calc::find_value<Metric>("").has_value());
}

TEST(MetricUnits, AreLuxExceptForRatios) {
  for (const std::string_view name : metric_names()) {
    const Metric metric = *calc::find_value<Metric>(name);
    const bool is_plain = name == "Uo" || name == "Ud" || name == "share" || name == "gradient";
    EXPECT_EQ(is_ratio(metric), is_plain) << name;
    EXPECT_STREQ(metric_unit(metric), is_plain ? "" : "lx") << name;
  }
}

TEST(UnitOf, IsThatOfThePointsQuantityOrOfTheStatistic) {
  for (const calc::PlaneQuantity& quantity : calc::kPlaneQuantities) {
    Requirement requirement;
    requirement.derived = quantity.derived;
    requirement.metric = Metric::minimum;
    EXPECT_STREQ(unit_of(requirement), quantity.unit) << quantity.name;
    EXPECT_EQ(is_in_lux(requirement), !calc::is_plain_number(quantity.derived)) << quantity.name;
    requirement.metric = Metric::share;
    EXPECT_STREQ(unit_of(requirement), "") << quantity.name;
    requirement.metric = Metric::power_density;
    EXPECT_STREQ(unit_of(requirement), "W/m2") << quantity.name;
  }
}

TEST(RatingOf, IsThatOfGlareAlone) {
  Requirement requirement;
  for (const auto& [metric, rating] :
       {std::pair(Metric::ugr_table, "UGR"), std::pair(Metric::glare_rating, "GR"),
        std::pair(Metric::average, ""), std::pair(Metric::uniformity_min_avg, "")}) {
    requirement.metric = metric;
    EXPECT_STREQ(rating_of(requirement), rating) << calc::name_of(metric);
  }
  requirement.derived = calc::DerivedQuantity::ugr;  // of observers
  requirement.metric = Metric::maximum;
  EXPECT_STREQ(rating_of(requirement), "UGR");
  requirement.metric = Metric::share;  // of observers, not a rating
  EXPECT_STREQ(rating_of(requirement), "");
}

}  // namespace
}  // namespace rules::requirement_test
