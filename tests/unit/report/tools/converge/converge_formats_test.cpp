#include "report/tools/converge/converge_document.h"
#include "report/tools/converge/converge_plot.h"
#include "report/tools/converge/converge_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>

namespace report::converge_formats_test {
namespace {

using testing::HasSubstr;
using testing::Not;

ConvergeDocument sample() {
  ConvergeDocument document;
  document.project = "A <room> & more";
  document.path = "room.xml";
  document.space_id = "s";
  document.part = "total";
  document.reference = "own";
  document.replicates = 16;
  document.seeds = 3;
  document.methods = {{"core", "luxgate's core", {}}, {"path-tracing", "path tracing", {}}};
  ConvergePlane& plane = document.planes.emplace_back();
  plane.id = "desk";
  plane.points = 10;
  plane.average_lx = 512.0;
  plane.minimum_lx = 300.0;
  plane.uo = 0.586;
  plane.reference_error = 0.0004;
  plane.curves.resize(2);
  for (std::size_t m = 0; m < 2; ++m) {
    const double factor = m == 0 ? 1.0 : 2.0;
    for (int k = 0; k < 4; ++k) {
      ConvergeStep step;
      step.paths = 64u << k;
      step.seconds = 0.01 * std::pow(2.0, k) * factor;
      step.phases.connect = step.seconds;
      step.light_rays = m == 0 ? 100.0 * std::pow(2.0, k) : 0.0;
      step.rays_per_point = 50.0 * std::pow(2.0, k);
      document.methods[m].steps.push_back(step);
      const double error = 0.1 * std::pow(0.6, k) * factor;
      plane.curves[m].errors.push_back({ConvergeError{error, 0.8 * error, 1.3 * error, false},
                                        ConvergeError{2 * error, error, 3 * error, false},
                                        ConvergeError{0.1 * error, 0.0, error, k == 3},
                                        ConvergeError{std::nan(""), 0.0, 0.0, false}});
      plane.curves[m].coverage.push_back({28, 30});
      plane.curves[m].average_coverage.push_back({3, 3});
    }
    plane.curves[m].slopes[0] = {-0.74, -0.73};
    plane.curves[m].targets[0] = {0.02 * factor, false};
    plane.curves[m].targets[1] = {0.05 * factor, true};
  }
  return document;
}

// Numbers that are none, not the middle of "illuminance".
bool shows_no_number(const std::string& text) {
  return std::regex_search(text, std::regex("(^|[^a-z])-?(nan|inf)([^a-z]|$)"));
}

TEST(ConvergeHtml, IsWellFormedAndLoadsNothing) {
  const std::string html = render_converge_html(sample());
  pugi::xml_document tree;
  ASSERT_TRUE(tree.load_buffer(html.data(), html.size(), pugi::parse_full));
  EXPECT_EQ(tree.select_nodes("//svg[@class='plot' and @role='img']").size(), 5u);  // no Uo known
  EXPECT_TRUE(
      tree.select_nodes("//script | //link | //img | //@src | //@href[not(starts-with(., '#'))]")
          .empty());
  EXPECT_THAT(html, Not(HasSubstr("http:")));
  EXPECT_THAT(html, Not(HasSubstr("https:")));
  EXPECT_THAT(html, HasSubstr("A &lt;room&gt; &amp; more"));
  EXPECT_FALSE(shows_no_number(html));
  EXPECT_THAT(html, HasSubstr("<b>2.0 times</b>"));
  const std::string empty = render_converge_html({});
  EXPECT_TRUE(tree.load_buffer(empty.data(), empty.size(), pugi::parse_full));
}

TEST(ConvergeHtml, LeadNamesWhatIsKnownOfBoth) {
  ConvergeDocument document = sample();
  EXPECT_THAT(render_converge_html(document), HasSubstr("To 2 % of RMS error"));
  EXPECT_THAT(render_converge_html(document), Not(HasSubstr("Its last error")));
  document.planes[0].curves[1].targets[1] = {};
  EXPECT_THAT(render_converge_html(document), HasSubstr("To 5 % of RMS error"));
  EXPECT_THAT(render_converge_html(document), HasSubstr("Its last error is 4.3 %."));
}

TEST(ConvergeHtml, IsInTheReadersLanguage) {
  const std::string html =
      render_converge_html(sample(), Texts(Language::german, true), Paper::letter);
  for (const char* words : {"<html lang=\"de\">", "Bis zu 2 % RMS-Fehler", "<b>2,0-mal</b>",
                            "RMS aller Punkte", "size: letter;"}) {
    EXPECT_THAT(html, HasSubstr(words));
  }
  EXPECT_THAT(html, Not(HasSubstr("run time")));
}

TEST(ConvergePlot, PlacesPointsByTheirLogarithms) {
  PlotSpec spec;
  spec.title = "t";
  spec.x_title = "x";
  // Powers of ten in steps: places must be evenly spaced.
  spec.series.push_back({0,
                         {{0.01, 0.1, 0.1, 0.1, false, "first"},
                          {0.1, 0.01, 0.01, 0.01, true, "second"},
                          {1.0, 0.001, 0.001, 0.001, false, "third"}}});
  const std::string svg = log_log_plot(spec);
  pugi::xml_document tree;
  ASSERT_TRUE(tree.load_buffer(svg.data(), svg.size()));
  const std::string curve =
      tree.select_node("//path[@class='curve']").node().attribute("d").value();
  double x[3], y[3];
  ASSERT_EQ(std::sscanf(curve.c_str(), "M%lf,%lfL%lf,%lfL%lf,%lf", &x[0], &y[0], &x[1], &y[1],
                        &x[2], &y[2]),
            6);
  EXPECT_NEAR(x[1] - x[0], x[2] - x[1], 0.02);
  EXPECT_NEAR(y[1] - y[0], y[2] - y[1], 0.02);
  EXPECT_GT(x[1], x[0] + 20.0);
  EXPECT_GT(y[1], y[0] + 20.0);  // a smaller error lies below
  EXPECT_EQ(tree.select_nodes("//path[@class='mark hollow']").size(), 1u);
  EXPECT_THAT(svg, HasSubstr("<title>second</title>"));
  for (const char* label : {">10 ms<", ">0.1 s<", ">1 s<", ">10 %<", ">1 %<", ">0.1 %<"}) {
    EXPECT_THAT(svg, HasSubstr(label));
  }
}

TEST(ConvergePlot, NothingToShowIsNothing) {
  PlotSpec spec;
  EXPECT_EQ(log_log_plot(spec), "");
  spec.series.push_back({0, {{1.0, std::nan(""), 0.0, 0.0, false, ""}}});
  EXPECT_EQ(log_log_plot(spec), "");
}

TEST(ConvergeCsv, HasOneLineForEveryStep) {
  const std::string csv = render_converge_csv(sample());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 9);
  const std::size_t columns =
      static_cast<std::size_t>(std::count(csv.begin(), csv.begin() + csv.find('\n'), ','));
  for (std::size_t at = 0; at < csv.size(); at = csv.find('\n', at) + 1) {
    EXPECT_EQ(static_cast<std::size_t>(
                  std::count(csv.begin() + at, csv.begin() + csv.find('\n', at), ',')),
              columns);
  }
  EXPECT_THAT(csv, HasSubstr("s,desk,core,64,16,3,0.01,"));
  EXPECT_FALSE(shows_no_number(csv));
}

TEST(ConvergeJson, HoldsEverything) {
  const nlohmann::json json = nlohmann::json::parse(render_converge_json(sample()));
  EXPECT_EQ(json["planes"][0]["curves"][1]["method"], "path-tracing");
  const auto& curve = json["planes"][0]["curves"][0];
  EXPECT_EQ(curve["steps"].size(), 4u);
  EXPECT_DOUBLE_EQ(curve["steps"][0]["rms"]["error"], 0.1);
  EXPECT_TRUE(curve["steps"][0]["uo"]["error"].is_null());
  EXPECT_TRUE(curve["steps"][3]["average"]["below_reference"]);
  EXPECT_DOUBLE_EQ(curve["slopes"]["rms"]["over_time"], -0.74);
  EXPECT_TRUE(curve["time_to"][1]["extrapolated"]);
  EXPECT_TRUE(curve["time_to"][4]["seconds"].is_null());
}

TEST(ConvergeText, AlignsAndMarks) {
  const std::string text = render_converge_text(sample());
  EXPECT_THAT(text, HasSubstr("luxgate's core (core)"));
  EXPECT_THAT(text, HasSubstr("< "));
  EXPECT_THAT(text, HasSubstr("~50 ms"));
  EXPECT_THAT(text, HasSubstr("rms -0.74"));
  EXPECT_FALSE(shows_no_number(text));
}

TEST(ConvergeWords, HaveTwoDigits) {
  EXPECT_EQ(error_words(0.1234), "12 %");
  EXPECT_EQ(error_words(0.01234), "1.2 %");
  EXPECT_EQ(error_words(0.0001234), "0.012 %");
  EXPECT_EQ(error_words(2.5), "250 %");
  EXPECT_EQ(error_words(0.0), "0 %");
  EXPECT_EQ(time_words(0.00123), "1.2 ms");
  EXPECT_EQ(time_words(0.31), "0.31 s");
  EXPECT_EQ(time_words(12.3), "12 s");
}

TEST(ConvergePhases, TimeOfShadowMapsIsShownWhereTheyWereDrawn) {
  ConvergeDocument document = sample();
  EXPECT_THAT(render_converge_text(document), Not(HasSubstr("shadow maps")));
  EXPECT_THAT(render_converge_html(document), Not(HasSubstr("shadow maps")));
  EXPECT_THAT(render_converge_csv(document),
              HasSubstr(",light_paths_s,shadow_maps_s,connections_s,"));
  document.methods[1].steps[3].phases.maps = 0.064;
  EXPECT_THAT(render_converge_text(document), HasSubstr("shadow maps"));
  EXPECT_THAT(render_converge_text(document), HasSubstr("64 ms"));
  EXPECT_THAT(render_converge_html(document), HasSubstr("</i>shadow maps</th>"));
  EXPECT_THAT(render_converge_html(document), HasSubstr(">64 ms</td>"));
  EXPECT_THAT(render_converge_csv(document), HasSubstr(",0.064,"));
  const auto json = nlohmann::json::parse(render_converge_json(document));
  EXPECT_EQ(json["methods"][1]["steps"][3]["phases"]["shadow_maps_s"], 0.064);
  EXPECT_EQ(json["methods"][0]["steps"][3]["phases"]["shadow_maps_s"], 0.0);
}

TEST(ConvergeDocument, NamesTheDeviceAndSaysThatSoftwareIsNoGpu) {
  ConvergeDocument document = sample();
  EXPECT_THAT(render_converge_text(document), Not(HasSubstr("OpenGL")));
  EXPECT_TRUE(nlohmann::json::parse(render_converge_json(document))["opengl"].is_null());
  document.opengl = "a <card>";
  EXPECT_THAT(render_converge_text(document), HasSubstr("OpenGL: a <card>\n"));
  EXPECT_THAT(render_converge_html(document), HasSubstr("a &lt;card&gt;"));
  document.is_software_opengl = true;
  EXPECT_THAT(render_converge_text(document), HasSubstr("a <card>, software: the times"));
  EXPECT_EQ(nlohmann::json::parse(render_converge_json(document))["opengl"], "a <card>");
}

}  // namespace
}  // namespace report::converge_formats_test
