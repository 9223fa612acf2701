#include "report/html.h"

#include "report/html_markup.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <set>
#include <string>

namespace report {
namespace {

using testing::HasSubstr;
using testing::Not;

// HTML that is XML, too, can be searched.
pugi::xml_document parsed(const std::string& html) {
  pugi::xml_document tree;
  const pugi::xml_parse_result result =
      tree.load_buffer(html.data(), html.size(), pugi::parse_full);
  EXPECT_TRUE(result) << result.description() << " at "
                      << html.substr(static_cast<std::size_t>(result.offset), 80);
  return tree;
}

// All text below a node, in order.
std::string text_of(const pugi::xml_node& node) {
  if (node.type() == pugi::node_pcdata) return node.value();
  std::string text;
  for (const pugi::xml_node& child : node.children()) text += text_of(child);
  return text;
}

TEST(Html, IsWellFormed) {
  const pugi::xml_document tree = parsed(render_html(sample_document()));
  EXPECT_STREQ(tree.child("html").attribute("lang").value(), "en");
  parsed(render_html(small_document()));
  parsed(render_html({}));
}

TEST(Html, LoadsNothingAndRunsNothing) {
  const std::string html = render_html(sample_document());
  EXPECT_THAT(html, Not(HasSubstr("http://")));
  EXPECT_THAT(html, Not(HasSubstr("https://")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
  EXPECT_THAT(html, Not(HasSubstr("url(\"")));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  const pugi::xml_document tree = parsed(html);
  EXPECT_TRUE(tree.select_nodes("//script | //link | //iframe | //img | //object").empty());
  EXPECT_TRUE(tree.select_nodes("//@src").empty());
  for (const pugi::xpath_node& node : tree.select_nodes("//@href")) {
    const std::string target = node.attribute().value();
    EXPECT_TRUE(target.starts_with("#") || target.starts_with("data:image/png;base64,")) << target;
  }
}

TEST(Html, TextFromFilesIsEscaped) {
  const std::string html = render_html(sample_document());
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, HasSubstr("School, phase 2 &lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;"));
  EXPECT_THAT(html, HasSubstr("hall &lt;b&gt;&quot;80 W&quot;&lt;/b&gt;"));
}

// Every string of a document in turn holds what would break out of text or attributes.
TEST(Html, NoFieldEscapesItsPlace) {
  const std::string evil = "\"'><img onerror=x>]]>&\x01\xFF";
  Document document = sample_document();
  ProjectPart& project = document.projects[0];
  document.provenance = {evil, evil, evil, 0, 0.95, rules::Goal::verdict, 0.02, 0, 0, evil};
  project.path = project.name = evil;
  for (SpacePart& space : project.spaces) {
    space.id = space.name = evil;
    space.notes = {evil};
    for (PlanePart& plane : space.planes) {
      plane.id = plane.name = plane.reason = plane.grid.rule = evil;
      plane.made_by = plane.changed = evil;
      for (calc::DroppedPoint& point : plane.grid.dropped) point.body = evil;
      for (rules::Finding& finding : plane.findings) {
        finding.reason = finding.requirement.scene = finding.requirement.clause = evil;
      }
    }
  }
  for (LuminaireRow& row : project.luminaires) {
    row.type_id = row.name = row.photometry_file = row.format = row.sha256 = evil;
  }
  project.inputs = {{evil, evil}};
  calc::Diagnostics found;
  found.report(calc::DiagnosticId::file_not_readable, calc::SourceLocation{evil, 1, 1}, evil, evil);
  project.diagnostics = found.all();
  const pugi::xml_document tree = parsed(render_html(document));
  EXPECT_TRUE(tree.select_nodes("//img | //@onerror").empty());
}

TEST(Html, LinksAndIdsMatch) {
  const pugi::xml_document tree = parsed(render_html(sample_document()));
  std::set<std::string> ids;
  for (const pugi::xpath_node& node : tree.select_nodes("//@id")) {
    EXPECT_TRUE(ids.insert(node.attribute().value()).second)
        << "twice: " << node.attribute().value();
  }
  for (const pugi::xpath_node& node : tree.select_nodes("//a/@href | //@aria-labelledby")) {
    std::string target = node.attribute().value();
    if (target.starts_with('#')) target.erase(0, 1);
    EXPECT_TRUE(ids.contains(target)) << target;
  }
}

TEST(Html, TablesAndPicturesAreAccessible) {
  const pugi::xml_document tree = parsed(render_html(sample_document()));
  EXPECT_TRUE(tree.select_nodes("//table[not(caption)]").empty());
  EXPECT_TRUE(tree.select_nodes("//th[not(@scope)]").empty());
  EXPECT_TRUE(tree.select_nodes("//svg[not(ancestor::svg) and not(@role='img' and @aria-label) and "
                                "not(@aria-hidden='true')]")
                  .empty());
  EXPECT_EQ(tree.select_nodes("//h1").size(), 1U);
}

TEST(Html, VerdictComesFirstInWords) {
  const pugi::xml_document tree = parsed(render_html(sample_document()));
  const pugi::xml_node banner = tree.select_node("//header//*[contains(@class, 'banner')]").node();
  EXPECT_THAT(text_of(banner),
              HasSubstr("Not everything could be judged, and not all requirements are met"));
  EXPECT_THAT(text_of(banner),
              HasSubstr("6 requirements: 2 pass, 2 fail, 1 undecided, 1 not judged"));
}

TEST(Html, HeadlineAgreesWithTheExitCode) {
  Document document = small_document();  // one requirement fails: exit code 1
  EXPECT_THAT(render_html(document), HasSubstr(">Not all requirements are met<"));
  document.projects[0].spaces[0].planes.emplace_back().is_computed = false;  // exit code 2
  EXPECT_THAT(render_html(document),
              HasSubstr(">Not everything could be judged, and not all requirements are met<"));
  document.projects[0].spaces[0].planes[0].findings.pop_back();
  EXPECT_THAT(render_html(document), HasSubstr(">Not everything could be judged<"));
}

TEST(Html, SaysWhatTheIntervalsMean) {
  Document document = small_document();
  document.projects[0].spaces[0].planes[0].looks_planned = 9;
  document.projects[0].spaces[0].planes[0].counters.active_points = {2, 2, 1};
  const std::string html = render_html(document);
  EXPECT_THAT(html, HasSubstr("95 %, over all planned looks of a plane"));
  EXPECT_THAT(html, HasSubstr("3 of 9 planned"));
}

TEST(Html, PointsThatCannotBeTrustedAreTold) {
  Document document = small_document();
  EXPECT_THAT(render_html(document), Not(HasSubstr("single samples")));
  document.projects[0].spaces[0].planes[0].single_sample_points = 1;
  EXPECT_THAT(render_html(document), HasSubstr("1 of 2 points rest on single samples"));
}

TEST(Html, FailuresComeBeforeWhatIsUndecided) {
  const std::string html = render_html(sample_document());
  const std::size_t attention = html.find("Needs attention");
  const std::size_t fail = html.find("0.417 ± 0.004", attention),
                    open = html.find("204.2 ± 1.2 lx", attention);
  EXPECT_LT(attention, fail);
  EXPECT_LT(fail, open);
  EXPECT_LT(open, html.find(">Summary<"));
}

TEST(Html, NothingNeedsAttentionWhenAllPass) {
  Document document = small_document();
  document.projects[0].spaces[0].planes[0].findings.pop_back();
  const std::string html = render_html(document);
  EXPECT_THAT(html, Not(HasSubstr("Needs attention")));
  EXPECT_THAT(html, HasSubstr("All requirements are met"));
}

TEST(Html, SmallGridIsDrawnCellByCell) {
  const pugi::xml_document tree = parsed(render_html(small_document()));
  EXPECT_EQ(tree.select_nodes("//g[@class='cells']/path").size(), 2U);
  EXPECT_STREQ(tree.select_node("//g[@class='cells']/path/title").node().child_value(),
               "424.5 ± 4.2 lx (direct 324, indirect 100)");
  EXPECT_EQ(tree.select_nodes("//g[@class='numbers']/text").size(), 2U);
  EXPECT_EQ(tree.select_nodes("//path[starts-with(@fill, 'url(#hatch-')]").size(), 1U);
}

TEST(Html, LargeGridIsOnePicture) {
  Document document = sample_document();
  document.projects[0].spaces.erase(document.projects[0].spaces.begin());
  const pugi::xml_document tree = parsed(render_html(document));
  EXPECT_EQ(tree.select_nodes("//image").size(), 1U);
  EXPECT_TRUE(tree.select_nodes("//g[@class='cells']").empty());
}

TEST(Html, DroppedPointsAreAccountedFor) {
  EXPECT_THAT(render_html(sample_document()),
              HasSubstr("42 outside the area, 1 inside a solid (cupboard)"));
}

TEST(Html, QuantitiesAreNamed) {
  const std::string planar = render_html(small_document());
  EXPECT_THAT(planar, HasSubstr("planar illuminance"));
  EXPECT_THAT(planar, HasSubstr("Maintained illuminance in lx"));
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.kernel = calc::ReceiverKernel::semicylindrical;
  for (PointRow& point : plane.points) point.normal = {0, -1, 0};
  const std::string html = render_html(document);
  parsed(html);
  for (const char* words :
       {"average of semicylindrical illuminance Esz", "Statistics of semicylindrical illuminance",
        "Heat map of Work plane: 2 points, semicylindrical illuminance Esz from",
        "semicylindrical illuminance Esz, looking to (0.00, −1.00)",
        "Maintained semicylindrical illuminance Esz in lx, every luminaire",
        "Maintained semicylindrical illuminance Esz in lx; distances"}) {
    EXPECT_THAT(html, HasSubstr(words));
  }
  EXPECT_THAT(html, Not(HasSubstr("planar")));
  plane.findings.clear();
  EXPECT_THAT(render_html(document),
              HasSubstr("Average of semicylindrical illuminance Esz 512.5 ± 4.0 lx, minimum"));
}

TEST(Html, RatingsHaveNoUnit) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.derived = calc::DerivedQuantity::modelling;
  plane.kernel = calc::ReceiverKernel::cylindrical;
  plane.remarks = {"how it was come by"};
  plane.points[0].maintained_lx = {0.5, 0.45, 0.55};
  plane.points[1].maintained_lx = {0.4, 0.35, 0.45};
  plane.minimum_lx = plane.points[1].maintained_lx;
  plane.maximum_lx = plane.points[0].maintained_lx;
  plane.average_lx = no_estimate();
  plane.findings.clear();
  const std::string html = render_html(document);
  parsed(html);
  for (const char* words :
       {"modelling Ez/E: minimum 0.400 ± 0.050, maximum 0.500 ± 0.050.",
        "modelling Ez/E from 0.400 to 0.500, minimum at",
        "Maintained modelling Ez/E, every luminaire", "Maintained modelling Ez/E; distances",
        "how it was come by", "class=\"unit\"></text>"}) {
    EXPECT_THAT(html, HasSubstr(words));
  }
  EXPECT_THAT(html, Not(HasSubstr("0.400 lx")));
  EXPECT_THAT(html, Not(HasSubstr("Uo")));
  // No colour for what has no value: the list of values remains.
  plane.points[0].maintained_lx = no_estimate();
  const std::string without = render_html(document);
  parsed(without);
  EXPECT_THAT(without, Not(HasSubstr("Heat map of Work plane")));
}

TEST(Html, TimeAppearsOnlyOnRequest) {
  Document document = small_document();
  EXPECT_THAT(render_html(document), Not(HasSubstr("<caption>Time</caption>")));
  document.provenance.timestamp = "2024-01-02T03:04:05Z";
  document.projects[0].times.total_s = 1.5;
  EXPECT_THAT(render_html(document), HasSubstr("2024-01-02T03:04:05Z"));
  EXPECT_THAT(render_html(document), HasSubstr("<caption>Time</caption>"));
}

TEST(Html, RepeatabilityIsPromisedOnlyWhereItHolds) {
  Document document = small_document();
  EXPECT_THAT(render_html(document), HasSubstr("gives the same report."));
  document.projects[0].spaces[0].planes[0].stop = calc::StopReason::time_limit;
  EXPECT_THAT(render_html(document), Not(HasSubstr("gives the same report.")));
}

TEST(Html, SameDocumentSameBytes) {
  EXPECT_EQ(render_html(sample_document()), render_html(sample_document()));
}

TEST(HtmlMarkup, Base64OfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(HtmlMarkup, CoordinatesAreShort) {
  EXPECT_EQ(svg_number(12.0), "12");
  EXPECT_EQ(svg_number(0.304), "0.3");
  EXPECT_EQ(svg_number(-0.001), "0");
  EXPECT_EQ(svg_number(100.0), "100");
}

}  // namespace
}  // namespace report
