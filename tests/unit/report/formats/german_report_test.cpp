// Reports in German: complete, and the same in everything that is not language.

#include "report/html/page/html.h"
#include "report/html/page/html_pages.h"
#include "report/html/page/html_script.h"
#include "report/text/texts.h"
#include "tests/support/hostile_document.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include <functional>
#include <map>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace report::german_report_test {
namespace {

using testing::HasSubstr;
using testing::Not;

const Texts kGerman(Language::german, true);

pugi::xml_document parsed(const std::string& html) {
  pugi::xml_document tree;
  const auto result = tree.load_buffer(html.data(), html.size(), pugi::parse_full);
  EXPECT_TRUE(result) << result.description();
  return tree;
}

// Everything that a report can say, as far as a document can hold it at once.
Document rich_document() {
  Document document = sample_document();
  document.provenance.timestamp = "2024-01-02T03:04:05Z";
  ProjectPart& project = document.projects[0];
  project.times.maps_s = project.times.total_s = 1.5;
  SpacePart& space = project.spaces[0];
  project.north_deg = 90.0;
  project.maintenance_plan = {"clean office", "by the house", 12.0, {}, 50000.0, {}};
  space.energy = calc::LightingEnergy{1000.0, 12.5, {}, calc::Message::words("by EN 15193")};
  project.spaces[1].energy =
      calc::LightingEnergy{0.0, 0.0, calc::Message::words("power is not known"), {}};
  space.notes = {calc::Message::words("workplace desk: nothing to do")};
  space.bodies_left_out = 3;
  space.bodies = {{"desk", 0.0, 0.7, {{glm::dvec2(1, 1), glm::dvec2(3, 2)}}},
                  {"shelf", 1.0, 2.0, {{glm::dvec2(2, 1), glm::dvec2(2, 2)}}}};
  for (LuminaireMark& mark : space.luminaires) mark.c0 = {1, 0, 0};
  space.pictures.list = {{"corner", "seen from above a corner", 4, 3, "png", "", ""},
                         {"plan", "seen from above", 4, 3, "png", "", ""}};
  space.pictures.highest_lx = 1e6;
  space.pictures.device = "llvmpipe";
  project.spaces[1].pictures.problem = "no device";
  PlanePart plane = space.planes[0];
  plane.made_by = calc::Message::words("workplace desk");
  plane.changed = calc::Message::words("margin");
  plane.remarks = {calc::Message::words("made of four planes")};
  plane.unseen_points = 1;
  plane.single_sample_points = 2;
  plane.groups = {{"window", plane.average, 20.0}, {"", plane.average, 1.0}};
  rules::Finding finding =
      sample_finding(rules::Metric::average, 1.2 * plane.average.value, plane.average);
  finding.verdict = rules::Verdict::fail;
  plane.findings.push_back(finding);
  finding.requirement.severity = rules::Severity::advice;
  finding.requirement.direct_only = true;
  finding.requirement.mask.id = "door";
  finding.requirement.scene = "evening";
  finding.requirement.state = rules::LightState::initial;
  finding.requirement.comparison = rules::Comparison::at_most;
  finding.by_tolerance = true;
  finding.is_waived = true;
  finding.requirement.waiver = calc::Waiver{"old hall", "A. Meier", "2099-12-31"};
  finding.requirement.origin.is_weakened = true;
  plane.findings.push_back(finding);
  finding.is_waived = false;
  plane.findings.push_back(finding);
  finding.verdict = rules::Verdict::pass;
  finding.requirement.state = rules::LightState::end_of_duration;
  finding.requirement.deviations = {
      {rules::FitAspect::grid, calc::Message::words("a grid of its own"),
       finding.requirement.waiver, true},
      {rules::FitAspect::height, calc::Message::words("too high"), {}, false}};
  plane.findings.push_back(finding);
  for (const rules::Metric metric :
       {rules::Metric::percentile, rules::Metric::share, rules::Metric::power_density,
        rules::Metric::power_per_100_lx, rules::Metric::value_at_point, rules::Metric::maximum,
        rules::Metric::uniformity_min_max}) {
    plane.findings.push_back(sample_finding(metric, 0.5, estimate(0.4, 0.01)));
    rules::MetricArguments& arguments = plane.findings.back().requirement.arguments;
    if (metric == rules::Metric::percentile) arguments = rules::Percentile{5};
    if (metric == rules::Metric::share) arguments = rules::ValueRange{300, 500};
  }
  for (int look = 0; look < 3; ++look) {
    PlaneLook taken{1024ULL << look, 4096, plane.points.size(), plane.average, {}};
    for (const rules::Finding& f : plane.findings)
      taken.findings.push_back({f.verdict, estimate(100.0, 9.0 - look)});
    plane.looks.push_back(taken);
  }
  using enum calc::StopReason;
  for (const calc::StopReason stop : {exact, decided, accurate, path_limit, time_limit,
                                      memory_limit, endless_path, interrupted}) {
    plane.stop = stop;
    space.planes.push_back(plane);
    plane.findings.clear();
    plane.looks.clear();
  }
  for (const calc::ReceiverKernel kernel :
       {calc::ReceiverKernel::cylindrical, calc::ReceiverKernel::semicylindrical,
        calc::ReceiverKernel::hemispherical, calc::ReceiverKernel::scalar}) {
    plane.kernel = kernel;
    space.planes.push_back(plane);
  }
  plane.kernel = calc::ReceiverKernel::planar;
  for (const calc::DerivedQuantity derived :
       {calc::DerivedQuantity::ugr, calc::DerivedQuantity::modelling,
        calc::DerivedQuantity::four_planes}) {
    plane.derived = derived;
    space.planes.push_back(plane);
  }
  return document;
}

// What a reader sees or hears: texts and spoken attributes, but for what is marked as English.
void collect(const pugi::xml_node& node, std::vector<std::string>& told) {
  const std::string name = node.name();
  const bool is_english = std::string_view(node.attribute("lang").value()) == "en";
  if (is_english || name == "script" || name == "style" || name == "code") return;
  if (node.type() == pugi::node_pcdata) told.emplace_back(node.value());
  for (const char* attribute : {"aria-label", "alt", "placeholder", "title"}) {
    if (node.attribute(attribute)) told.emplace_back(node.attribute(attribute).value());
  }
  for (const pugi::xml_node& child : node.children()) collect(child, told);
}

std::vector<std::string> told_by(const std::string& html) {
  const pugi::xml_document tree = parsed(html);
  std::vector<std::string> told;
  collect(tree.child("html").child("head"), told);
  collect(tree.child("html").child("body"), told);
  return told;
}

// The words between the placeholders of an English text.
std::vector<std::string> fragments(const std::string& text) {
  const std::regex placeholder(R"(\{[^}]*\})");
  std::vector<std::string> parts(
      std::sregex_token_iterator(text.begin(), text.end(), placeholder, -1), {});
  for (std::string& part : parts) {
    part.erase(0, part.find_first_not_of(" :;,.("));
    part.erase(part.find_last_not_of(" :;,.(") + 1);
  }
  return parts;
}

// English words of the table that are in no text of that language as well. Short ones may be parts
// of its words.
std::vector<std::string> english_words(Language language) {
  constexpr std::size_t kLong = 8;
  std::string all;
  for (const TextEntry& entry : texts_of(language)) all += std::string(entry.text) + "\n";
  std::vector<std::string> found;
  for (const TextEntry& entry : kEnglishTexts) {
    for (const std::string& words : fragments(entry.text)) {
      if (words.size() >= kLong && all.find(words) == std::string::npos) found.push_back(words);
    }
  }
  return found;
}

// One of them in the text, or "" if there is none.
std::string english_in(const std::string& told, Language language = Language::german) {
  static std::map<Language, std::vector<std::string>> words_of;
  std::vector<std::string>& known = words_of[language];
  if (known.empty()) known = english_words(language);
  for (const std::string& words : known) {
    if (told.find(words) != std::string::npos) return words + "' in '" + told;
  }
  return "";
}

TEST(GermanReport, TheCheckForEnglishFindsSome) {
  std::string found;
  for (const std::string& told : told_by(render_html(rich_document()))) found += english_in(told);
  EXPECT_THAT(found, HasSubstr("Not everything could be judged"));
}

TEST(TranslatedReport, NothingOfTheTableIsEnglish) {
  const Document document = rich_document();
  for (const LanguageRow& row : kLanguages) {
    if (row.language == Language::english) continue;
    const Texts t(row.language, row.has_decimal_comma);
    std::vector<std::string> pages{render_html(document, t),
                                   rendered_index(document, "x-rooms", t)};
    for (const HtmlPage& page : pages_of(document))
      pages.push_back(rendered_page(document, page, "../x.html", t));
    for (const std::string& page : pages) {
      EXPECT_THAT(page, HasSubstr("<html lang=\"" + std::string(row.tag) + "\">"));
      for (const std::string& told : told_by(page)) {
        EXPECT_EQ(english_in(told, row.language), "") << row.tag;
      }
    }
  }
}

TEST(GermanReport, SaysItsLanguageAndMarksEnglishTexts) {
  const std::string html = render_html(rich_document(), kGerman);
  EXPECT_THAT(html, HasSubstr("<html lang=\"de\">"));
  EXPECT_THAT(html, HasSubstr("<span lang=\"en\">workplace desk: nothing to do</span>"));
  EXPECT_THAT(html, HasSubstr("<b>Fehler</b> <span lang=\"en\">"));
  EXPECT_THAT(html, HasSubstr("<span lang=\"en\">The interval contains the limit"));
  EXPECT_THAT(render_html(rich_document()), Not(HasSubstr("<span lang")));
}

// Values of one attribute, in order.
std::vector<std::string> attributes(const std::string& html, const std::string& path) {
  const pugi::xml_document tree = parsed(html);
  std::vector<std::string> values;
  for (const pugi::xpath_node& node : tree.select_nodes(path.c_str()))
    values.emplace_back(node.attribute().value());
  return values;
}

TEST(GermanReport, DataAndDrawingsStayAsTheyAre) {
  const Document document = rich_document();
  const std::string english = render_html(document), german = render_html(document, kGerman);
  for (const char* path : {"//td[contains(@class, 'num')]/@data-v", "//th/@data-v", "//path/@d",
                           "//text/@x", "//@style", "//@viewBox", "//@points", "//@href", "//@id",
                           "//@class", "//option/@value", "//rect/@width"}) {
    const std::vector<std::string> expected = attributes(english, path);
    EXPECT_FALSE(expected.empty() && std::string(path) != "//@points") << path;
    EXPECT_EQ(attributes(german, path), expected) << path;
  }
  EXPECT_THAT(german,
              HasSubstr("<pre tabindex=\"0\"><code>luxgate check school/project.xml yard.xml "
                        "--seed 1 --output out</code></pre>"));
}

TEST(GermanReport, NumbersHaveCommas) {
  const pugi::xml_document tree = parsed(render_html(rich_document(), kGerman));
  const std::regex point("[0-9]\\.[0-9]"), comma("[0-9],[0-9]");
  std::size_t commas = 0;
  for (const char* path :
       {"//td[contains(@class, 'num')]//text()", "//svg//text/text()", "//svg//title/text()",
        "//ul[@class='key']//text()", "//span[@class='brief']/text()",
        "//table[@class='matrix']//td/text()"}) {
    for (const pugi::xpath_node& node : tree.select_nodes(path)) {
      const std::string text = node.node().value();
      EXPECT_FALSE(std::regex_search(text, point)) << path << ": " << text;
      commas += std::regex_search(text, comma) ? 1 : 0;
    }
  }
  EXPECT_GT(commas, 50U);
}

TEST(GermanReport, ScriptSpeaksGermanUnderItsOwnHash) {
  const std::string script = html_script(kGerman);
  EXPECT_THAT(script, HasSubstr("rows.length + ' Zeilen'"));
  EXPECT_THAT(script, HasSubstr("seen + ' von ' + rows.length"));
  EXPECT_THAT(script, Not(HasSubstr("' rows'")));
  const std::string german = render_html(small_document(), kGerman);
  EXPECT_THAT(german, HasSubstr("<script>" + script + "</script>"));
  const std::regex hash("sha256-[^']+");
  std::smatch own, other;
  const std::string english = render_html(small_document());
  ASSERT_TRUE(std::regex_search(german, own, hash) && std::regex_search(english, other, hash));
  EXPECT_NE(own.str(), other.str());
}

TEST(GermanReport, HostileNamesStayText) {
  const pugi::xml_document tree = parsed(render_html(hostile_document(), kGerman));
  EXPECT_EQ(tree.select_nodes("//script").size(), 1U);
  EXPECT_TRUE(tree.select_nodes("//*[@onerror or @onload]").empty());
}

TEST(GermanReport, MarkdownIsGerman) {
  const std::string text = rendered("markdown", rich_document(), {{}, kGerman});
  EXPECT_EQ(english_in(std::regex_replace(
                text, std::regex("no point[^|]*|cannot read[^|]*|the (interval|plane) [^|]*"), "")),
            "");
  EXPECT_THAT(text, HasSubstr("### luxgate: – nicht bewertet\n\n"));
  EXPECT_THAT(text,
              HasSubstr("| Bewertung | Ort | Größe | gefordert | berechnet | Reserve |\n| --- "));
  EXPECT_THAT(text, HasSubstr("nichts wird bewertet: "));
  EXPECT_THAT(text, HasSubstr("| ○ außerhalb der Empfehlung | "));
  Document waived = small_document();
  waived.projects[0].spaces[0].planes[0].findings.at(1).is_waived = true;
  EXPECT_THAT(rendered("markdown", waived, {{}, kGerman}), HasSubstr("nicht erfüllt, ausgenommen"));
}

TEST(GermanReport, TheTerminalsTableIsGerman) {
  const std::string text = rendered("text", small_document(), {{}, kGerman});
  EXPECT_EQ(text,
            "office.xml: Small office\n"
            "  Bewertung        Raum / Fläche        Größe       gefordert   berechnet  Reserve  "
            "Ort (m)\n"
            "  ✓ erfüllt        Office / Work plane  Mittelwert   ≥ 500 lx  512 ± 5 lx   +2,5 %\n"
            "                   └ EN 12464-1:2021 34.2 (vom Projekt selbst)\n"
            "  ✗ NICHT ERFÜLLT  Office / Work plane  Minimum      ≥ 450 lx  424 ± 5 lx   -5,7 %  "
            "(2,75; 1,00; 0,80)\n\n"
            "2 Anforderungen: 1 erfüllt, 1 nicht erfüllt\n");
}

}  // namespace
}  // namespace report::german_report_test
