#include "report/html/page/html.h"
#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_hash.h"
#include "report/document/same_bits.h"
#include "report/html/drawings/shared_scale.h"
#include "report/html/page/html_markup.h"
#include "report/html/page/html_pages.h"
#include "report/html/page/html_script.h"
#include "report/text/base64.h"
#include "report/text/svg.h"
#include "tests/support/hostile_document.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace report::html_test {
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
  EXPECT_TRUE(tree.select_nodes("//link | //iframe | //img | //object").empty());
  EXPECT_TRUE(tree.select_nodes("//@src").empty());
  for (const pugi::xpath_node& node : tree.select_nodes("//@href")) {
    const std::string target = node.attribute().value();
    EXPECT_TRUE(target.starts_with("#") || target.starts_with("data:image/png;base64,")) << target;
  }
}

// The policy lets run exactly the script that is in the page, and nothing else in it is a script.
TEST(Html, OnlyItsOwnScriptMayRun) {
  const std::string html = render_html(sample_document());
  const std::size_t from = html.find("<script>") + 8;
  const std::string script = html.substr(from, html.find("</script>", from) - from);
  EXPECT_EQ(script, html_script({}));
  EXPECT_EQ(script.find_first_of("<&"), std::string::npos);
  const std::string hex = calc::sha256_hex(script);
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  EXPECT_THAT(html, HasSubstr("script-src 'sha256-" + base64(bytes) + "'\""));
  const pugi::xml_document tree = parsed(html);
  EXPECT_EQ(tree.select_nodes("//script").size(), 1U);
  EXPECT_TRUE(tree.select_nodes("//@*[starts-with(name(), 'on')]").empty());
}

TEST(Html, CanBeUsedWithKeysAndScreenReaders) {
  const pugi::xml_document tree = parsed(render_html(sample_document()));
  EXPECT_STREQ(tree.select_node("//body/*[1]/@href").attribute().value(), "#main");
  EXPECT_EQ(tree.select_nodes("/html/body/main[@id='main']").size(), 1U);
  EXPECT_EQ(tree.select_nodes("/html/body/header").size(), 1U);
  EXPECT_EQ(tree.select_nodes("//header//nav[@aria-label]").size(), 1U);
  EXPECT_TRUE(tree.select_nodes("//details[not(*[1][self::summary])]").empty());
  // What only a script can serve is hidden without one.
  EXPECT_EQ(tree.select_nodes("//*[@id='summary-tools'][@hidden]").size(), 1U);
  EXPECT_TRUE(tree.select_nodes("//button").empty());
}

TEST(Html, PassedPlanesAreFoldedWhereThereAreMany) {
  Document document = small_document();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  EXPECT_EQ(parsed(render_html(document)).select_nodes("//details[@class='card'][@open]").size(),
            1U);
  for (int i = 0; i < 4; ++i) {
    planes.push_back(planes[0]);
    planes.back().findings.pop_back();  // the one that fails
  }
  const pugi::xml_document tree = parsed(render_html(document));
  EXPECT_EQ(tree.select_nodes("//details[@class='card']").size(), 5U);
  EXPECT_EQ(tree.select_nodes("//details[@class='card'][@open]").size(), 1U);
  // A link to a plane leads into the fold, which opens it.
  EXPECT_EQ(tree.select_nodes("//details[@class='card']/*[@id='p1s1k2']").size(), 1U);
}

TEST(Html, SummaryIsGroupedByRoomAndCanBeSorted) {
  const Document document = sample_document();
  const pugi::xml_document tree = parsed(render_html(document));
  std::size_t rooms = 0, findings = 0;
  for (const ProjectPart& project : document.projects) {
    rooms += project.spaces.size();
    if (!project.is_judged) ++findings;
    for (const SpacePart& space : project.spaces) {
      for (const PlanePart& plane : space.planes)
        findings += std::max<std::size_t>(1, plane.findings.size());
    }
  }
  EXPECT_EQ(tree.select_nodes("//table[@class='summary']//th[@scope='rowgroup']").size(), rooms);
  const pugi::xpath_node_set rows = tree.select_nodes("//tr[starts-with(@class, 'finding')]");
  EXPECT_EQ(rows.size(), findings);
  for (const pugi::xpath_node& row : rows)
    EXPECT_TRUE(row.node().child("th").attribute("data-v")) << text_of(row.node());
}

TEST(Html, LooksGroupsAndPolarDiagramsAreShown) {
  Document document = small_document();
  ProjectPart& project = document.projects[0];
  PlanePart& plane = project.spaces[0].planes[0];
  const auto look = [&](std::uint64_t paths, double half_width, rules::Verdict verdict) {
    PlaneLook result{paths, 4 * paths, 2, estimate(512.5, half_width), {}};
    for (const rules::Finding& finding : plane.findings)
      result.findings.push_back({verdict, estimate(finding.measured.value, half_width)});
    return result;
  };
  using enum rules::Verdict;
  plane.looks = {look(1024, 16, undecided), look(2048, 8, pass), look(4096, 4, pass)};
  plane.groups = {{"row <2>", estimate(400, 3), 300}, {"", estimate(112.5, 1), 50}};
  LuminaireRow row;
  row.count = 1;
  row.c0_cd.assign(2 * kPolarHalfSteps + 1, 0);
  row.c0_cd[kPolarHalfSteps] = 480;
  project.luminaires = {row};
  const std::string html = render_html(document);
  const pugi::xml_document tree = parsed(html);
  const pugi::xml_node chart = tree.select_node("//figure[@class='converge']/svg").node();
  EXPECT_EQ(chart.select_nodes(".//path[@class='curve']").size(), 2U);
  // The dot is where the verdict came: at the second of three looks, so in the middle of a picture
  // whose work doubles from look to look.
  const double x = chart.select_node(".//circle/@cx").attribute().as_double();
  EXPECT_NEAR(x, (58 + 640 - 30) / 2.0, 0.01);
  EXPECT_EQ(tree.select_nodes("//table[@class='looks']/tbody/tr").size(), 3U);
  EXPECT_THAT(html, HasSubstr("row &lt;2&gt;"));
  EXPECT_EQ(tree.select_nodes("//svg[@class='polar']").size(), 1U);
  EXPECT_THAT(html, HasSubstr("outer ring 500 cd"));
  EXPECT_THAT(html, HasSubstr("The flux of all luminaires ×1.08 would reach the limit."));
}

TEST(Html, HousingsAreWithTheirType) {
  Document document = sample_document();
  EXPECT_THAT(render_html(document), HasSubstr("housing of white metal, 0.08 m deep"));
  document.projects[0].luminaires.at(0).housing_depth_m = 0.0;
  EXPECT_THAT(render_html(document), HasSubstr("light-absorbing face of white metal"));
}

TEST(HtmlPages, HoldEveryPlaneOnceAndAllLinksLead) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.planes.resize(2 * kPlanesPerPage + 1, space.planes[0]);
  document.projects[0].spaces.push_back(small_document().projects[0].spaces[0]);
  std::set<std::string> targets;  // "p1s1.html#p1s1k1"
  std::size_t cards = 0;
  const std::vector<HtmlPage> pages = pages_of(document);
  ASSERT_EQ(pages.size(), 4U);
  for (const HtmlPage& page : pages) {
    const std::string html = rendered_page(document, page, "../report.html");
    const pugi::xml_document tree = parsed(html);
    EXPECT_EQ(tree.select_nodes("//a[@href='../report.html']").size(), 1U);
    const pugi::xpath_node_set found = tree.select_nodes("//details[@class='card']/*[@id]");
    EXPECT_LE(found.size(), kPlanesPerPage);
    cards += found.size();
    for (const pugi::xpath_node& card : found)
      targets.insert(page.name + "#" + card.node().attribute("id").value());
    targets.insert(page.name);
  }
  EXPECT_EQ(cards, 2 * kPlanesPerPage + 2);
  const std::string index = rendered_index(document, "report-rooms");
  const pugi::xml_document tree = parsed(index);
  EXPECT_TRUE(tree.select_nodes("//article").empty());
  std::size_t links = 0;
  for (const pugi::xpath_node& node : tree.select_nodes("//a/@href")) {
    const std::string target = node.attribute().value();
    if (!target.starts_with("report-rooms/")) continue;
    ++links;
    EXPECT_TRUE(targets.contains(target.substr(13))) << target;
  }
  EXPECT_GE(links, 2 * kPlanesPerPage + 2 + pages.size());
}

// What a workplace left out is told where its room is, once, and beside the link to it.
TEST(HtmlPages, NotesOfRoomsAreOnTheFirstPageAndOnTheIndex) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  space.planes.resize(kPlanesPerPage + 1, space.planes[0]);
  space.notes = {calc::Message::words("workplace desk: left out: ceiling <open>")};
  const std::vector<HtmlPage> pages = pages_of(document);
  ASSERT_EQ(pages.size(), 2U);
  const char* told = "workplace desk: left out: ceiling &lt;open&gt;";
  EXPECT_THAT(rendered_page(document, pages[0], "../r.html"), HasSubstr(told));
  EXPECT_THAT(rendered_page(document, pages[1], "../r.html"), Not(HasSubstr(told)));
  const std::string index = rendered_index(document, "r.html-rooms");
  parsed(index);
  const std::size_t at = index.find(told);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(index.find(told, at + 1), std::string::npos);
}

// Folded values are printed, too.
TEST(HtmlPages, UnfoldWhenPrinted) {
  const Document document = small_document();
  const std::string html = rendered_page(document, pages_of(document)[0], "../r.html");
  EXPECT_THAT(html, HasSubstr("beforeprint"));
  EXPECT_THAT(html, HasSubstr("script-src 'sha256-"));
}

TEST(HtmlPages, NamesInAddressesAreQuoted) {
  EXPECT_EQ(url_name("a b#1?.html"), "a%20b%231%3F.html");
  EXPECT_EQ(url_name("büro-1_x.html"), "b%C3%BCro-1_x.html");
}

TEST(Html, TextFromFilesIsEscaped) {
  const std::string html = render_html(sample_document());
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, HasSubstr("School, phase 2 &lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;"));
  EXPECT_THAT(html, HasSubstr("hall &lt;b&gt;&quot;80 W&quot;&lt;/b&gt;"));
}

// Every string of a document in turn holds what would break out of text or attributes.
TEST(Html, NoFieldEscapesItsPlace) {
  const std::string evil = "\"'><img onerror=x>]]>&\x01\xFF";
  Document document = sample_document();
  ProjectPart& project = document.projects[0];
  document.provenance = {evil, evil, evil, evil, 0, 0.95, rules::Goal::verdict, 0.02, 0, 0, evil};
  document.provenance.method = evil;
  project.path = project.name = evil;
  for (SpacePart& space : project.spaces) {
    space.id = space.name = evil;
    space.notes = {calc::Message::words(evil)};
    for (PlanePart& plane : space.planes) {
      plane.id = plane.name = evil;
      plane.reason = plane.grid.rule = calc::Message::words(evil);
      plane.made_by = plane.changed = calc::Message::words(evil);
      for (calc::DroppedPoint& point : plane.grid.dropped) point.body = evil;
      for (rules::Finding& finding : plane.findings) {
        finding.requirement.scene = evil;
        finding.reason = finding.requirement.clause = calc::Message::words(evil);
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

// What a browser makes of it, the browser test sees.
TEST(Html, HostileNamesStayText) {
  const Document document = hostile_document();
  std::vector<std::string> all{render_html(document), rendered_index(document, "x-rooms")};
  for (const HtmlPage& page : pages_of(document))
    all.push_back(rendered_page(document, page, "../x.html"));
  for (const std::string& html : all) {
    const pugi::xml_document tree = parsed(html);
    EXPECT_LE(tree.select_nodes("//script").size(), 1U);
    EXPECT_TRUE(tree.select_nodes("//img | //@onerror | //@onload | //@src").empty());
    EXPECT_EQ(tree.select_nodes("//style").size(), 1U);
    EXPECT_EQ(html.find_first_of("\x01\x1B"), std::string::npos);
  }
  // Nothing is lost, either.
  EXPECT_THAT(all[0], HasSubstr("&lt;script&gt;window.hacked=1&lt;/script&gt;"));
}

TEST(Html, ProjectDataAreInTheHead) {
  Document document = small_document();
  calc::AboutProject& about = document.projects[0].about;
  EXPECT_THAT(render_html(document), Not(HasSubstr("class=\"about\"")));
  about.client = "Meier & Sons";
  about.revision = "b";
  about.logo = {"l.png", calc::LogoFormat::png, "foobar"};
  const pugi::xml_document tree = parsed(render_html(document));
  const pugi::xml_node block = tree.select_node("//header//div[@class='about']").node();
  EXPECT_EQ(text_of(block.child("dl")), "ClientMeier & SonsRevisionb");
  EXPECT_STREQ(block.child("img").attribute("src").value(), "data:image/png;base64,Zm9vYmFy");
  EXPECT_STREQ(block.child("img").attribute("alt").value(), "Logo");
  // Of several projects each has its own.
  document.projects.push_back(document.projects[0]);
  document.projects[1].about.client = "Other";
  const std::string html = render_html(document);
  EXPECT_THAT(html, HasSubstr("<dd>Meier &amp; Sons</dd>"));
  EXPECT_THAT(html, HasSubstr("<dd>Other</dd>"));
}

// A cover by itself is for projects that go to somebody: those that say whose they are.
TEST(Html, ACoverIsForProjectsThatSayWhoseTheyAre) {
  Document document = small_document();
  const auto has_cover = [&](Cover cover) {
    PageStyle style;
    style.cover = cover;
    const std::string html =
        render_whole(document, [&](const DocumentFrame& frame, const SpillPlace& place) {
          return html_writer(frame, place, {}, "", style);
        });
    const pugi::xml_document tree = parsed(html);
    const pugi::xml_node block = tree.select_node("//header/div[@class='cover']").node();
    // What a reader must know of a document stands on it; the contents come behind.
    EXPECT_EQ(!block.empty(), !block.select_node("h1").node().empty());
    EXPECT_EQ(!block.empty(), !block.select_node("*[contains(@class, 'banner')]").node().empty());
    EXPECT_FALSE(tree.select_node("//header/nav").node().empty());
    // Its page has no head and no foot.
    EXPECT_EQ(!block.empty(), html.find("@bottom-left { content: none; }") != std::string::npos);
    return !block.empty();
  };
  EXPECT_FALSE(has_cover(Cover::automatic));
  EXPECT_TRUE(has_cover(Cover::always));
  document.projects[0].about.revision = "b";  // as CI fills it in
  EXPECT_FALSE(has_cover(Cover::automatic));
  document.projects[0].about.client = "Meier";
  EXPECT_TRUE(has_cover(Cover::automatic));
  EXPECT_FALSE(has_cover(Cover::never));
  document.projects.push_back(document.projects[0]);
  EXPECT_FALSE(has_cover(Cover::automatic));
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
  EXPECT_THAT(html, HasSubstr("95 %, over all planned sampling rounds of a plane"));
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
  const std::size_t fail = html.find("0.42 ± 0.01", attention),
                    open = html.find("204 ± 2 lx", attention);
  EXPECT_LT(attention, fail);
  EXPECT_LT(fail, open);
  EXPECT_LT(open, html.find("id=\"summary\""));
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
               "424 ± 5 lx (direct 324, indirect 100)");
  EXPECT_EQ(tree.select_nodes("//g[@class='numbers']/text").size(), 2U);
  EXPECT_EQ(tree.select_nodes("//path[starts-with(@fill, 'url(#hatch-')]").size(), 1U);
}

TEST(Html, IsoluxLinesAreLabelledAndTheRequiredOneIsThick) {
  const pugi::xml_document tree = parsed(render_html(sample_document()));
  const pugi::xml_node plan = tree.select_node("//*[@id='p1s1k1']//svg[@class='plan']").node();
  EXPECT_EQ(plan.select_nodes(".//path[@class='isolux required']").size(), 2U);  // 240 and 500 lx
  EXPECT_GE(plan.select_nodes(".//path[@class='isolux']").size(), 2U);
  EXPECT_EQ(plan.select_nodes(".//text[@class='isolux-label required'][.='500']").size(), 1U);
  EXPECT_THAT(text_of(tree.select_node("//*[@id='p1s1k1']//figure").node()),
              HasSubstr("isolux of the required 240 lx, 500 lx"));
}

TEST(Html, HistogramCountsEveryPoint) {
  const Document document = sample_document();
  const pugi::xml_document tree = parsed(render_html(document));
  int points = 0;
  for (const pugi::xpath_node& bar :
       tree.select_nodes("//*[@id='p1s1k1']//g[@class='histogram']/rect/title")) {
    points += bar.node().text().as_int();
  }
  EXPECT_EQ(static_cast<std::size_t>(points),
            document.projects[0].spaces[0].planes[0].points.size());
}

// Cells lie where they are; the table of values goes along the line.
TEST(Html, ARouteIsDrawnAlongItsLine) {
  const Document document = route_document();
  const std::string html = render_html(document);
  EXPECT_NE(html.find("7.00 m long, 1.20 m wide, 2 legs"), std::string::npos);
  EXPECT_NE(html.find("distances along the line of the route (columns)"), std::string::npos);
  EXPECT_NE(html.find("<th scope=\"row\">−0.40</th>"), std::string::npos);
  const pugi::xml_document tree = parsed(html);
  const auto cells = tree.select_nodes("//g[@class='cells']/path");
  EXPECT_EQ(cells.size(), document.projects[0].spaces[0].planes[0].points.size());
  for (const pugi::xpath_node& cell : cells) {
    EXPECT_EQ(std::string(cell.node().attribute("d").value()).find('h'), std::string::npos);
  }
}

TEST(Html, ALongRouteIsOnePathForEachColour) {
  const Document document = route_document(0.004);
  const std::string html = render_html(document);
  EXPECT_EQ(html.find("class=\"cells\""), std::string::npos);
  EXPECT_EQ(html.find("image-rendering:pixelated"), std::string::npos);
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
              HasSubstr("Average of semicylindrical illuminance Esz 512 ± 5 lx, minimum"));
}

TEST(Html, RatingsHaveNoUnit) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.derived = calc::DerivedQuantity::modelling;
  plane.kernel = calc::ReceiverKernel::cylindrical;
  plane.remarks = {calc::Message::words("how it was come by")};
  plane.points[0].measured = {0.5, 0.45, 0.55};
  plane.points[1].measured = {0.4, 0.35, 0.45};
  plane.minimum = plane.points[1].measured;
  plane.maximum = plane.points[0].measured;
  plane.average = no_estimate();
  plane.findings.clear();
  const std::string html = render_html(document);
  parsed(html);
  for (const char* words :
       {"modelling Ez/E: minimum 0.40 ± 0.05, maximum 0.50 ± 0.05.",
        "modelling Ez/E from 0.400 to 0.500, minimum at",
        "Maintained modelling Ez/E, every luminaire", "Maintained modelling Ez/E; distances",
        "how it was come by", "class=\"unit\"></text>"}) {
    EXPECT_THAT(html, HasSubstr(words));
  }
  EXPECT_THAT(html, Not(HasSubstr("0.400 lx")));
  EXPECT_THAT(html, Not(HasSubstr(">Uo")));
  // No colour for what has no value: the list of values remains.
  plane.points[0].measured = no_estimate();
  const std::string without = render_html(document);
  parsed(without);
  EXPECT_THAT(without, Not(HasSubstr("Heat map of Work plane")));
}

Document rated_document(calc::DerivedQuantity derived) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.derived = plane.grid.derived = derived;
  plane.points[0].measured = {18.5, 18.25, 18.75};
  plane.points[1].measured = {16.5, 16.25, 16.75};
  plane.minimum = plane.points[1].measured;
  plane.maximum = plane.points[0].measured;
  plane.average = plane.uniformity_min_avg = plane.uniformity_min_max = no_estimate();
  rules::Finding finding = sample_finding(rules::Metric::maximum, 17, plane.maximum);
  finding.requirement.comparison = rules::Comparison::at_most;
  finding.requirement.derived = derived;
  finding.verdict = rules::Verdict::fail;
  finding.margin = -1.5 / 17;
  plane.findings = {finding};
  PlaneLook look{1024, 4096, 2, no_estimate(), {{finding.verdict, finding.measured}}};
  plane.looks = {look, look};
  return document;
}

TEST(Html, GlareRatingsAreOfTheNewInstallation) {
  const std::string glare = render_html(rated_document(calc::DerivedQuantity::ugr));
  parsed(glare);
  for (const char* words : {"Initial glare rating UGR, every luminaire at full output",
                            "Initial glare rating UGR; distances", "scope=\"col\">Initial</th>"}) {
    EXPECT_THAT(glare, HasSubstr(words));
  }
  // Before the explanation of terms.
  EXPECT_THAT(glare.substr(0, glare.find("id=\"method\"")), Not(HasSubstr("Maintained")));
  EXPECT_THAT(render_html(rated_document(calc::DerivedQuantity::modelling)),
              HasSubstr("Maintained modelling Ez/E, every luminaire"));
}

TEST(Html, RatingsHaveNoUnitInFindingsLooksAndKeys) {
  for (const auto derived : {calc::DerivedQuantity::ugr, calc::DerivedQuantity::modelling}) {
    Document document = rated_document(derived);
    const std::string html = render_html(document);
    parsed(html);
    EXPECT_THAT(html, HasSubstr("18.5 ± 0.3"));
    EXPECT_THAT(html, HasSubstr("Course of the verdicts: 2 sampling rounds"));
    EXPECT_THAT(html, HasSubstr("above 17<"));  // in the key of the hatching
    for (const char* wrong : {"18.5 ± 0.3 lx", "isolux, lx", "isolux of", "17 lx", "17.00"}) {
      EXPECT_THAT(html, Not(HasSubstr(wrong))) << wrong;
    }
  }
}

// 499.96 lx under a limit of 500 lx must not become 500 lx anywhere.
TEST(Html, NoValueIsRoundedOntoItsLimit) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.points[0].measured = estimate(600.04, 0.01);
  plane.points[1].measured = estimate(499.96, 0.01);
  plane.minimum = plane.points[1].measured;
  plane.maximum = plane.points[0].measured;
  plane.average = estimate(549.96, 3);
  plane.findings = {sample_finding(rules::Metric::average, 550, plane.average),
                    sample_finding(rules::Metric::minimum, 500, plane.minimum),
                    sample_finding(rules::Metric::maximum, 600, plane.maximum)};
  plane.findings[2].requirement.comparison = rules::Comparison::at_most;
  plane.findings[2].verdict = rules::Verdict::fail;
  const std::string html = render_html(document);
  const pugi::xml_document tree = parsed(html);
  EXPECT_THAT(html, HasSubstr("illuminance from 499.96 to 600.04 lx"));
  // Beside the plane and in the annex.
  EXPECT_EQ(tree.select_nodes("//table[@class='matrix']//td[.='499.96' or .='600.04']").size(), 4U);
  EXPECT_EQ(tree.select_nodes("//g[@class='numbers']/text[.='499.96' or .='600.04']").size(), 2U);
  EXPECT_EQ(tree.select_nodes(
                    "//g[@class='cells']//title[contains(., '499.96') or contains(., '600.04')]")
                .size(),
            2U);
  EXPECT_THAT(html, HasSubstr("<span class=\"brief\">Ē 549.96 ± 3.00 lx"));
  const auto row = [&](const char* name) {
    const std::string path = std::string("//table[@class='facts']//tr[th='") + name + "']/td[1]";
    return text_of(tree.select_node(path.c_str()).node());
  };
  EXPECT_EQ(row("Average Ē"), "549.96 ± 3.00 lx");
  EXPECT_EQ(row("Minimum"), "499.96 ± 0.01 lx");
  EXPECT_EQ(row("Maximum"), "600.04 ± 0.01 lx");
}

TEST(Html, StrictLimitsAreHatchedWhereTheyAreReached) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.findings[1].requirement.limit = 424.5;  // the minimum itself
  EXPECT_THAT(render_html(document), Not(HasSubstr("url(#hatch-p1s1k1)")));
  plane.findings[1].requirement.comparison = rules::Comparison::more_than;
  const std::string html = render_html(document);
  EXPECT_THAT(html, HasSubstr("url(#hatch-p1s1k1)"));
  EXPECT_THAT(html, HasSubstr("not above 424.5 lx"));
}

TEST(Html, ComparisonSignsAreEscaped) {
  Document document = small_document();
  for (rules::Finding& finding : document.projects[0].spaces[0].planes[0].findings)
    finding.requirement.comparison = rules::Comparison::less_than;
  const std::string html = render_html(document);
  parsed(html);
  EXPECT_THAT(html, HasSubstr("&lt; 500 lx"));
  EXPECT_THAT(html, Not(HasSubstr("< 500 lx")));
}

TEST(Html, PassesThatNeedALookAreNotFolded) {
  Document document = small_document();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  planes[0].findings.pop_back();
  planes.resize(6, planes[0]);
  planes[1].findings[0].is_waived = true;
  planes[2].findings[0].is_close = true;
  planes[3].findings[0].by_tolerance = true;
  planes[4].single_sample_points = 1;
  const pugi::xml_document tree = parsed(render_html(document));
  EXPECT_EQ(tree.select_nodes("//details[@class='card'][not(@open)]").size(), 2U);
  EXPECT_EQ(tree.select_nodes("//details[@class='card'][@open]").size(), 4U);
}

TEST(Html, WhatNeedsAttentionKeepsItsNotes) {
  Document document = small_document();
  rules::Requirement& requirement =
      document.projects[0].spaces[0].planes[0].findings[1].requirement;
  requirement.note = calc::Message::words("unverified <requirement>");
  requirement.scene = "night";
  requirement.state = rules::LightState::initial;
  const pugi::xml_document tree = parsed(render_html(document));
  const std::string item = text_of(tree.select_node("//ul[@class='attention']/li").node());
  for (const char* words : {"unverified <requirement>", "scene night", "initial"})
    EXPECT_THAT(item, HasSubstr(words));
}

TEST(Html, EveryGroupNoteIsKept) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.groups = {{"row", estimate(400, 3), 300}, {"", estimate(112.5, 1), 50}};
  plane.findings = {sample_finding(rules::Metric::average, 600, plane.average),
                    sample_finding(rules::Metric::average, 750, plane.average)};
  const pugi::xml_document tree = parsed(render_html(document));
  EXPECT_EQ(tree.select_nodes("//table[@class='facts groups']//tr[1]//span[@class='note']").size(),
            2U);
}

TEST(Html, RegionsOfPlanesWithOneNameAreToldApart) {
  Document document = small_document();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  planes.push_back(planes[0]);
  planes.push_back(planes[0]);
  const pugi::xml_document tree = parsed(render_html(document));
  std::set<std::string> names;
  const pugi::xpath_node_set regions = tree.select_nodes("//*[@role='region']");
  for (const pugi::xpath_node& region : regions)
    names.insert(region.node().attribute("aria-label").value());
  EXPECT_GT(regions.size(), 3U);
  EXPECT_EQ(names.size(), regions.size());
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
  EXPECT_THAT(render_html(document), HasSubstr("to the bit, on any x86-64 processor."));
  document.provenance.same_bits = SameBits::same_device;
  EXPECT_THAT(render_html(document), HasSubstr("to the bit, on the same graphics device"));
  document.provenance.same_bits = SameBits::nowhere;
  EXPECT_THAT(render_html(document), Not(HasSubstr("to the bit")));
}

TEST(SameBits, ARunThatTimeCutShortIsTheSameNowhere) {
  Document document = small_document();
  EXPECT_EQ(same_bits_of(totals_of(document), false), SameBits::any_processor);
  EXPECT_EQ(same_bits_of(totals_of(document), true), SameBits::same_device);
  document.projects[0].spaces[0].planes[0].stop = calc::StopReason::time_limit;
  EXPECT_EQ(same_bits_of(totals_of(document), false), SameBits::nowhere);
  EXPECT_EQ(same_bits_of(totals_of(document), true), SameBits::nowhere);
}

// A client must not read the light of all luminaires as that of an emergency.
TEST(Html, SaysOfWhichLightPicturesAre) {
  constexpr const char* kWords = "show all luminaires at full output";
  Document document = small_document();
  EXPECT_THAT(render_html(document), Not(HasSubstr(kWords)));
  rules::Requirement& asked = document.projects[0].spaces[0].planes[0].findings[0].requirement;
  asked.scene = "battery";
  asked.direct_only = true;
  const std::string html = render_html(document);
  EXPECT_THAT(html, HasSubstr("other light, too: scene battery, direct light only."));
  const std::size_t annex = html.find("class=\"annex\"");
  ASSERT_NE(annex, html.npos);
  EXPECT_LT(html.find(kWords), annex);
  EXPECT_NE(html.find(kWords, annex), html.npos);  // and beside the tables of values
}

// Where all requirements ask for one light, that light is what is shown.
TEST(Html, ShowsAPlaneInTheLightThatItIsAskedFor) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  for (rules::Finding& finding : plane.findings) finding.requirement.scene = "battery";
  AskedLight& light = plane.asked_light.emplace();
  light.scene = "battery";
  light.points = {{estimate(7.125, 0.25), 7, 0.125}, {estimate(5.5, 0.25), 5, 0.5}};
  light.average = estimate(6.3125, 0.25);
  light.minimum = estimate(5.5, 0.25);
  light.maximum = estimate(7.125, 0.25);
  light.uniformity_min_avg = light.uniformity_min_max = estimate(0.8, 0.1);
  const std::string html = render_html(document);
  EXPECT_THAT(html, HasSubstr("show the light that all of its requirements name: scene battery."));
  EXPECT_THAT(html, Not(HasSubstr("show all luminaires at full output, with")));
  EXPECT_THAT(html, HasSubstr("direct 7"));
  EXPECT_THAT(html, Not(HasSubstr("direct 500")));
  EXPECT_THAT(html, HasSubstr("Maintained illuminance in lx, scene battery. "));
  const std::size_t annex = html.find("class=\"annex\"");
  ASSERT_NE(annex, html.npos);
  EXPECT_EQ(html.find(">601<", annex), html.npos);
  EXPECT_EQ(html.find(">600<", annex), html.npos);
  const PlaneScale scale = ColourScales(document.projects[0], ScaleSharing::project)
                               .of(document.projects[0].spaces[0], plane);
  EXPECT_LT(scale.scale.high(), 20.0);
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
}  // namespace report::html_test
