#include "report/html/drawings/html_difference.h"

#include "tests/support/hostile_document.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace report::html_difference_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const Texts kEnglish;

PlanePart& plane_of(Document& document) { return document.projects[0].spaces[0].planes[0]; }

RevisionPlace place_of(const Document& document) {
  const ProjectPart& project = document.projects[0];
  RevisionPlace place;
  place.project = project.path;
  place.space = project.spaces[0].id;
  place.plane = place.words = project.spaces[0].planes[0].id;
  return place;
}

// All points had more light by so much, the last one by `last_lx`.
Document darker_by(double all_lx, double last_lx) {
  Document document = small_document();
  ChangedPlane changed{place_of(document), {}};
  for (const PointRow& point : plane_of(document).points) {
    changed.before_lx.push_back(point.measured.value + all_lx);
  }
  changed.before_lx.back() = plane_of(document).points.back().measured.value + last_lx;
  document.revision.emplace().planes = {changed};
  return document;
}

std::vector<std::string> numbers_in(const std::string& html) {
  pugi::xml_document tree;
  EXPECT_TRUE(tree.load_string(("<div>" + html + "</div>").c_str()));
  std::vector<std::string> numbers;
  for (const pugi::xpath_node& node : tree.select_nodes("//g[@class='numbers']/text")) {
    numbers.emplace_back(node.node().text().get());
  }
  return numbers;
}

TEST(HtmlDifferences, AreAfterMinusBefore) {
  const Document document = darker_by(20.0, -5.0);
  const std::string html = html_differences(kEnglish, document);
  const std::vector<std::string> numbers = numbers_in(html);
  const std::size_t count = document.projects[0].spaces[0].planes[0].points.size();
  ASSERT_EQ(numbers.size(), count);
  EXPECT_THAT(numbers, testing::Contains("−20.0").Times(static_cast<int>(count) - 1));
  EXPECT_THAT(numbers, testing::Contains("+5.00").Times(1));
  EXPECT_THAT(html, HasSubstr("−20.0 to +5.00"));
}

// The same change has the same strength of colour on either side.
TEST(HtmlDifferences, LessAndMoreLightHaveColoursOfTheirOwn) {
  const std::string less = html_differences(kEnglish, darker_by(20.0, 20.0));
  const std::string more = html_differences(kEnglish, darker_by(-20.0, -20.0));
  EXPECT_THAT(less, HasSubstr("<path fill=\"#b35806\""));
  EXPECT_THAT(less, Not(HasSubstr("<path fill=\"#542788\"")));
  EXPECT_THAT(more, HasSubstr("<path fill=\"#542788\""));
  EXPECT_THAT(more, Not(HasSubstr("<path fill=\"#b35806\"")));
}

TEST(HtmlDifferences, NothingIsDrawnWhereNothingCanBeCompared) {
  Document document = small_document();
  document.revision.emplace();
  EXPECT_THAT(html_differences(kEnglish, document), IsEmpty());
  document = darker_by(20.0, 20.0);
  document.revision->planes[0].before_lx.pop_back();
  EXPECT_THAT(html_differences(kEnglish, document), IsEmpty());
  document = darker_by(20.0, 20.0);
  document.revision->planes[0].place.plane = "another";
  EXPECT_THAT(html_differences(kEnglish, document), IsEmpty());
}

TEST(HtmlDifferences, ThoseThatChangedMostComeFirstAndTheRestIsCounted) {
  Document document = darker_by(20.0, 20.0);
  const ChangedPlane changed = document.revision->planes[0];
  const PlanePart plane = plane_of(document);
  for (int k = 0; k < 14; ++k) {
    PlanePart copy = plane;
    copy.id = copy.name = "p" + std::to_string(k);
    document.projects[0].spaces[0].planes.push_back(copy);
    ChangedPlane other = changed;
    other.place.plane = other.place.words = copy.id;
    other.before_lx.back() += 1.0 + k;
    document.revision->planes.push_back(other);
  }
  const std::string html = html_differences(kEnglish, document);
  EXPECT_LT(html.find("p13"), html.find("p12"));
  EXPECT_THAT(html, HasSubstr("p2<"));
  EXPECT_THAT(html, Not(HasSubstr("p1<")));
  EXPECT_THAT(html, HasSubstr("3 more planes have changed"));
}

TEST(HtmlDifferences, NamesAreTextAndLanguageIsTheReaders) {
  Document document = darker_by(20.0, 20.0);
  plane_of(document).name = hostile_name();
  document.revision->planes[0].place.words = hostile_name();
  const std::string html = html_differences(Texts(Language::german, true), document);
  EXPECT_FALSE(numbers_in(html).empty());  // well-formed
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, HasSubstr("Änderungen des Lichts"));
}

}  // namespace
}  // namespace report::html_difference_test
