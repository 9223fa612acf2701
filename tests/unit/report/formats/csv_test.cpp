#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace report::csv_test {
namespace {

using testing::HasSubstr;

TEST(Csv, ResultsOfSmallDocument) {
  EXPECT_EQ(
      rendered("csv", small_document()),
      "project,space,plane,requirement,quantity,percent,unit,scene,state,clause,comparison,"
      "limit,value,low,"
      "high,margin,verdict,reason,place_x_m,place_y_m,place_z_m,pack,row,check,severity,waiver,"
      "note,source\r\n"
      "office.xml,r1,work,average,average,,lx,,maintained,EN 12464-1:2021 "
      "34.2,at_least,500,512.5,508.5,"
      "516.5,0.025,pass,,,,,,,,shall,,,project\r\n"
      "office.xml,r1,work,minimum,minimum,,lx,,maintained,,at_least,450,424.5,420.25,428.75,"
      "-0.056666666666666664,fail,,2.75,1,0.8,,,,shall,,,project\r\n");
}

TEST(Csv, PointsOfSmallDocument) {
  EXPECT_EQ(
      rendered("points-csv", small_document()),
      "project,space,plane,column,row,x_m,y_m,z_m,nx,ny,nz,illuminance_lx,low_lx,high_lx,direct_lx,"
      "indirect_lx,quantity,rating,rating_low,rating_high\r\n"
      "office.xml,r1,work,0,0,1.25,1,0.8,0,0,1,600.5,594.25,606.75,500.25,100.25,planar,,,\r\n"
      "office.xml,r1,work,1,0,2.75,1,0.8,0,0,1,424.5,420.25,428.75,324,100.5,planar,,,\r\n");
}

// A column that is called lx holds nothing else; an eye without a rating has none.
TEST(Csv, RatingsHaveColumnsOfTheirOwn) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.derived = calc::DerivedQuantity::ugr;
  plane.points[0].measured = {18.5, 18.25, 18.75};
  plane.points[1].measured = no_estimate();
  const std::string csv = rendered("points-csv", document);
  EXPECT_THAT(csv, HasSubstr(",0,0,1,,,,500.25,100.25,ugr,18.5,18.25,18.75\r\n"));
  EXPECT_THAT(csv, HasSubstr(",0,0,1,,,,324,100.5,ugr,,,\r\n"));
}

TEST(Csv, FieldsAreQuotedWhereNeeded) {
  Document document = small_document();
  document.projects[0].path = "a,b.xml";
  document.projects[0].spaces[0].id = "the \"big\" room";
  document.projects[0].spaces[0].planes[0].findings[0].reason = calc::Message::words("two\nlines");
  const std::string csv = rendered("csv", document);
  EXPECT_THAT(csv, HasSubstr("\r\n\"a,b.xml\",\"the \"\"big\"\" room\",work,"));
  EXPECT_THAT(csv, HasSubstr(",two lines,"));
}

TEST(Csv, EveryRowHasTheSameNumberOfFields) {
  const std::string csv = rendered("csv", sample_document());
  std::size_t begin = 0;
  for (std::size_t end = csv.find("\r\n"); end != std::string::npos;
       end = csv.find("\r\n", begin)) {
    const std::string line = csv.substr(begin, end - begin);
    if (line.find('"') == std::string::npos) {
      EXPECT_EQ(std::count(line.begin(), line.end(), ','), 27) << line;
    }
    begin = end + 2;
  }
  EXPECT_EQ(begin, csv.size());
}

TEST(Csv, UnjudgedThingsAreRowsWithoutNumbers) {
  const std::string csv = rendered("csv", sample_document());
  EXPECT_THAT(
      csv,
      HasSubstr(
          "\r\nyard.xml,,,,,,,,,,,,,,,,not judged,could not be read or calculated,,,,,,,,,,\r\n"));
  EXPECT_THAT(
      csv, HasSubstr(
               "at_least,200,,,,,not judged,the plane was not computed,,,,,,,shall,,,project\r\n"));
}

TEST(Csv, UnknownLimitIsEmpty) {
  Document document = small_document();
  rules::Finding& finding = document.projects[0].spaces[0].planes[0].findings[0];
  finding.verdict = rules::Verdict::not_judged;
  finding.requirement.limit = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(rendered("csv", document), HasSubstr(",at_least,,,,,,not judged,"));
}

TEST(Csv, PercentileNamesItsShare) {
  Document document = small_document();
  rules::Requirement& requirement =
      document.projects[0].spaces[0].planes[0].findings[0].requirement;
  requirement.metric = rules::Metric::percentile;
  requirement.arguments = rules::Percentile{12.5};
  EXPECT_THAT(rendered("csv", document), HasSubstr(",percentile,12.5,lx,"));
}

}  // namespace
}  // namespace report::csv_test
