#include "report/formats/dxf.h"

#include "report/formats/dxf_layout.h"
#include "report/formats/dxf_storeys.h"
#include "report/formats/dxf_text.h"
#include "report/formats/format.h"
#include "report/html/drawings/html_plan.h"
#include "report/text/point_thresholds.h"
#include "report/text/storey_title.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"
#include "tests/support/hostile_document.h"
#include "tests/support/legible.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace report::dxf_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

// What a strict reader makes of a file: pairs of lines and nothing else.
struct Entity {
  std::string kind;
  std::vector<std::pair<int, std::string>> groups;

  std::string text(int code) const {
    const auto found = std::find_if(groups.begin(), groups.end(),
                                    [code](const auto& group) { return group.first == code; });
    return found == groups.end() ? "" : found->second;
  }
  double number(int code) const {
    const std::string value = text(code);
    double read = std::nan("");
    const auto end = std::from_chars(value.data(), value.data() + value.size(), read).ptr;
    EXPECT_EQ(end, value.data() + value.size()) << kind << " " << code << ": '" << value << "'";
    return read;
  }
  glm::dvec3 point(int code) const { return {number(code), number(code + 10), number(code + 20)}; }
  std::string layer() const { return text(8); }
};

struct Drawing {
  std::vector<Entity> tables, blocks, entities;

  std::vector<Entity> of(std::string_view kind, std::string_view layer) const {
    std::vector<Entity> found;
    for (const Entity& entity : entities) {
      if (entity.kind == kind && entity.layer() == layer) found.push_back(entity);
    }
    return found;
  }
  std::vector<std::string> words(std::string_view layer) const {
    std::vector<std::string> found;
    for (const Entity& entity : of("TEXT", layer)) found.push_back(entity.text(1));
    return found;
  }
  const Entity* layer(std::string_view name) const {
    for (const Entity& row : tables) {
      if (row.kind == "LAYER" && row.text(2) == name) return &row;
    }
    return nullptr;
  }
};

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find("\r\n");
    EXPECT_NE(end, std::string_view::npos) << "the last line has no end";
    if (end == std::string_view::npos) break;
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 2);
  }
  return lines;
}

// Fails on everything that R12 does not allow.
Drawing read_strictly(const std::string& dxf) {
  Drawing drawing;
  const std::vector<std::string> lines = lines_of(dxf);
  EXPECT_EQ(lines.size() % 2, 0u);
  std::vector<std::string> sections;
  std::vector<Entity>* list = nullptr;
  std::string section;
  bool is_at_end = false;
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    EXPECT_FALSE(is_at_end) << "line " << i << " is behind the end";
    const std::string& value = lines[i + 1];
    EXPECT_LE(value.size(), 255u);
    // Bytes that Windows-1252 has no letter for stand in no value.
    EXPECT_EQ(value.find_first_of("\x7F\x81\x8D\x8F\x90\x9D"), std::string::npos) << value;
    EXPECT_TRUE(std::all_of(value.begin(), value.end(), [](char c) {
      return static_cast<unsigned char>(c) >= 0x20;
    })) << value;
    EXPECT_EQ(lines[i].size(), 3u) << "line " << i;
    int code = -1;
    const std::size_t digits = lines[i].find_first_not_of(' ');
    const auto read =
        std::from_chars(lines[i].data() + digits, lines[i].data() + lines[i].size(), code);
    EXPECT_EQ(read.ptr, lines[i].data() + lines[i].size()) << "line " << i << ": " << lines[i];
    if (code != 0) {
      if (section.empty()) {
        EXPECT_EQ(code, 2);
        section = value;
        sections.push_back(value);
        list = value == "TABLES"     ? &drawing.tables
               : value == "BLOCKS"   ? &drawing.blocks
               : value == "ENTITIES" ? &drawing.entities
                                     : nullptr;
      } else if (list != nullptr) {
        EXPECT_FALSE(list->empty());
        if (!list->empty()) list->back().groups.emplace_back(code, value);
      }
      continue;
    }
    if (value == "SECTION") {
      EXPECT_EQ(section, "");
    } else if (value == "ENDSEC") {
      section.clear();
      list = nullptr;
    } else if (value == "EOF") {
      EXPECT_EQ(section, "");
      is_at_end = true;
    } else if (list != nullptr) {
      list->push_back({value, {}});
    } else {
      ADD_FAILURE() << "line " << i << ": " << value << " in " << section;
    }
  }
  EXPECT_TRUE(is_at_end);
  EXPECT_EQ(sections, (std::vector<std::string>{"HEADER", "TABLES", "BLOCKS", "ENTITIES"}));

  std::set<std::string> layers, blocks;
  const auto is_name = [](const std::string& name) {
    return !name.empty() && name.size() <= 31 &&
           name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == std::string::npos;
  };
  for (const Entity& row : drawing.tables) {
    if (row.kind == "LAYER") {
      EXPECT_TRUE(is_name(row.text(2))) << row.text(2);
      EXPECT_TRUE(layers.insert(row.text(2)).second) << row.text(2);
    }
  }
  for (const Entity& entity : drawing.blocks) {
    if (entity.kind == "BLOCK") {
      EXPECT_TRUE(is_name(entity.text(2))) << entity.text(2);
      EXPECT_TRUE(blocks.insert(entity.text(2)).second) << entity.text(2);
    }
    EXPECT_TRUE(layers.contains(entity.layer())) << entity.kind << " on " << entity.layer();
  }
  std::string open;  // what a SEQEND ends
  for (const Entity& entity : drawing.entities) {
    EXPECT_TRUE(layers.contains(entity.layer())) << entity.kind << " on " << entity.layer();
    if (entity.kind == "VERTEX") {
      EXPECT_EQ(open, "POLYLINE");
    } else if (entity.kind == "ATTRIB") {
      EXPECT_EQ(open, "INSERT");
    } else if (entity.kind == "SEQEND") {
      EXPECT_NE(open, "");
      open.clear();
    } else {
      EXPECT_EQ(open, "") << entity.kind;
      if (entity.text(66) == "1") open = entity.kind;
      const std::set<std::string> known{"LINE", "POLYLINE", "CIRCLE", "TEXT", "INSERT"};
      EXPECT_TRUE(known.contains(entity.kind)) << entity.kind;
    }
    if (entity.kind == "INSERT") {
      EXPECT_TRUE(blocks.contains(entity.text(2)));
    }
    if (entity.kind == "TEXT") {
      EXPECT_GT(entity.number(40), 0.0);
      EXPECT_NE(entity.text(1), "");
    }
    for (const auto& [code, value] : entity.groups) {
      if (code >= 10 && code < 60) {
        EXPECT_TRUE(std::isfinite(entity.number(code)));
      }
    }
  }
  EXPECT_EQ(open, "");
  return drawing;
}

// Lines of the legend as one text.
std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : " ") + line;
  return text;
}

std::string rendered_dxf(const Document& document, const Texts& t = {},
                         const DrawingStyle& drawing = {}) {
  FormatStyle style;
  style.texts = t;
  style.page.drawing = drawing;
  return rendered("dxf", document, style);
}

Drawing drawn(const Document& document) { return read_strictly(rendered_dxf(document)); }

// Corners of polylines on a layer, one list each.
std::vector<std::vector<glm::dvec3>> polylines(const Drawing& drawing, std::string_view layer) {
  std::vector<std::vector<glm::dvec3>> found;
  bool is_open = false;
  for (const Entity& entity : drawing.entities) {
    if (entity.kind == "POLYLINE") {
      is_open = entity.layer() == layer;
      if (is_open) found.emplace_back();
    } else if (entity.kind == "VERTEX" && is_open) {
      found.back().push_back(entity.point(10));
    }
  }
  return found;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_NEAR(a.x, b.x, 1e-6);
  EXPECT_NEAR(a.y, b.y, 1e-6);
  EXPECT_NEAR(a.z, b.z, 1e-6);
}

// Of task areas, shown or not, in the order of the file.
std::vector<Entity> values_of(const Drawing& drawing) {
  std::vector<Entity> values;
  for (const Entity& entity : drawing.entities) {
    const std::string layer = entity.layer();
    if (entity.kind == "TEXT" && (layer == "LUX_VALUES" || layer == "LUX_VALUES_MORE"))
      values.push_back(entity);
  }
  return values;
}

TEST(DxfText, NoNameIsAControlCode) {
  EXPECT_EQ(dxf_text("Office 12"), "Office 12");
  EXPECT_EQ(dxf_text("B\u00FCro \u05D0"), "B\xFCro \\U+05D0");
  EXPECT_EQ(dxf_text("\u20AC\u0152\u0178\u00A0\u00FF"), "\x80\x8C\x9F\xA0\xFF");
  EXPECT_EQ(dxf_text("\uFFFD\u0100"), "\\U+FFFD\\U+0100");
  EXPECT_EQ(dxf_text("\U0001F4A1"), "<U+1F4A1>");
  EXPECT_EQ(dxf_text("a\r\n  0\r\nEOF"), "a    0  EOF");
  EXPECT_EQ(dxf_text("\\U+000A"), "\\U+005CU+000A");
  EXPECT_EQ(dxf_text("^J"), "^ J");
  EXPECT_EQ(dxf_text("50 %"), "50 %");
  EXPECT_EQ(dxf_text("%%d %%%"), "% %d % % %");
  EXPECT_EQ(dxf_text("5 \u00B1 1\u00B0"), "5 %%p 1%%d");
  EXPECT_EQ(dxf_text("%\u00B1%p"), "% %%p%p");
  EXPECT_EQ(dxf_text(""), "");
}

TEST(DxfText, LongTextsAreCutBetweenCharacters) {
  const std::string whole(kMostDxfBytes, 'x');
  EXPECT_EQ(dxf_text(whole), whole);
  EXPECT_EQ(dxf_text(whole + "y"), std::string(kMostDxfBytes - 3, 'x') + "...");
  std::string umlauts, escaped;
  for (int i = 0; i < 1000; ++i) umlauts += "\u00FC";
  for (int i = 0; i < 1000; ++i) escaped += "\u0151";
  EXPECT_EQ(dxf_text(umlauts), std::string(kMostDxfBytes - 3, '\xFC') + "...");
  const std::string cut = dxf_text(escaped);
  EXPECT_EQ(cut.size() % 7, 3u);
  EXPECT_LE(cut.size(), kMostDxfBytes);
  EXPECT_TRUE(cut.ends_with("\\U+0151..."));
}

TEST(DxfText, LinesAreBrokenAtBlanksAndNothingIsLost) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(dxf_lines("one two three", 8), (Lines{"one two", "three"}));
  EXPECT_EQ(dxf_lines("  abcdefghij", 6), (Lines{"  abcd", "efghij"}));
  EXPECT_EQ(dxf_lines("", 8), (Lines{""}));
  std::string escaped;
  for (int i = 0; i < 100; ++i) escaped += "\u0151";
  std::string together;
  for (const std::string& line : dxf_lines(escaped, 200)) {
    EXPECT_LE(line.size(), kMostDxfBytes);
    together += line;
  }
  EXPECT_EQ(together.size(), 700u);
}

TEST(DxfText, NumbersHaveAPointAndNoSignOfZero) {
  EXPECT_EQ(dxf_number(0.0), "0.0");
  EXPECT_EQ(dxf_number(-1e-9), "0.0");
  EXPECT_EQ(dxf_number(-2.5), "-2.5");
  EXPECT_EQ(dxf_number(100), "100.0");
  EXPECT_EQ(dxf_number(1.0 / 3.0), "0.333333");
  EXPECT_EQ(dxf_number(1e300), "1e+300");
  EXPECT_EQ(dxf_number(4e9), "4e+09");
  EXPECT_EQ(dxf_number(std::nan("")), "0.0");
}

TEST(DxfText, NamesOfBlocks) {
  EXPECT_EQ(dxf_name("LUX_1_", "panel 600\n\u00FC"), "LUX_1_PANEL_600__");
  EXPECT_EQ(dxf_name("LUX_1_", std::string(100, 'x')).size(), 31u);
}

TEST(Dxf, IsReadStrictly) {
  for (const Document& document : {small_document(), sample_document(), Document{}}) {
    drawn(document);
  }
  EXPECT_THAT(rendered_dxf(small_document()), HasSubstr("AC1009"));
}

TEST(Dxf, NoNameStartsAGroup) { drawn(hostile_document()); }

TEST(Dxf, ValuesAreAsInHtmlAndAtTheirPlaces) {
  const Document document = sample_document();
  const PlanePart& plane = document.projects[0].spaces[0].planes[0];
  const Drawing drawing = drawn(document);
  std::map<std::pair<long long, long long>, std::string> at;  // in millimetres
  for (const Entity& text : values_of(drawing)) {
    const glm::dvec3 place = text.point(11);
    if (place.z == plane.grid.origin_m.z)
      at[{std::llround(place.x * 1000), std::llround(place.y * 1000)}] = text.text(1);
  }
  ASSERT_FALSE(plane.points.empty());
  for (const PointRow& point : plane.points) {
    const auto found =
        at.find({std::llround(point.position_m.x * 1000), std::llround(point.position_m.y * 1000)});
    ASSERT_NE(found, at.end());
    EXPECT_EQ(found->second, format_cell(point.measured.value, point_thresholds(plane)));
  }
}

TEST(Dxf, PointsThatWereLeftOutAreMarkedAndCounted) {
  Document document = small_document();
  document.projects[0].spaces[0].planes[0].grid.dropped = {
      {{3.5, 1.0, 0.8}, 1, 0, calc::DropReason::inside_solid, "box"}};
  const Drawing drawing = drawn(document);
  EXPECT_THAT(drawing.words("LUX_VALUES"), Contains("x"));
  EXPECT_THAT(drawing.words("LUX_LEGEND"),
              Contains("Office / Work plane: omitted points: 1 inside a solid"));
  EXPECT_THAT(drawn(small_document()).words("LUX_VALUES"), Not(Contains("x")));
}

TEST(Dxf, MarksAndLabelsWithoutAPlaceAreCounted) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.grid.dropped = {{plane.points[0].position_m, 1, 0, calc::DropReason::inside_solid, "box"}};
  const Drawing drawing = drawn(document);
  EXPECT_THAT(drawing.words("LUX_VALUES"), Not(Contains("x")));
  EXPECT_THAT(drawing.words("LUX_VALUES_MORE"), Contains("x"));
  EXPECT_EQ(drawing.layer("LUX_VALUES_MORE")->text(70), "1");
  EXPECT_THAT(joined(drawing.words("LUX_LEGEND")),
              HasSubstr("1 mark of an omitted point (x); see the frozen layer LUX_VALUES_MORE."));

  for (const auto& [language, words] :
       {std::pair(Language::german, "1 Zeichen eines weggelassenen Punkts"),
        std::pair(Language::french, "1 marque de point omis")}) {
    const Drawing other = read_strictly(rendered_dxf(document, Texts(language, true)));
    EXPECT_THAT(joined(other.words("LUX_LEGEND")), HasSubstr(words));
  }

  // All that is on the layer, in a drawing with much of it.
  const Drawing full = read_strictly(rendered_dxf(sample_document(), {}, {200}));
  const std::string legend = joined(full.words("LUX_LEGEND"));
  const auto sum_of = [&](const char* pattern, auto&& count_of) {
    const std::regex words(pattern);
    std::size_t sum = 0;
    for (std::sregex_iterator one(legend.begin(), legend.end(), words), end; one != end; ++one)
      sum += count_of(*one);
    return sum;
  };
  const std::size_t values = sum_of("([0-9]+) of ([0-9]+) values are shown", [](const auto& found) {
    return std::stoul(found[2]) - std::stoul(found[1]);
  });
  const std::size_t others = sum_of("([0-9]+) (labels? of|marks? of)",
                                    [](const auto& found) { return std::stoul(found[1]); });
  EXPECT_GT(values, 0u);
  EXPECT_EQ(values + others, full.words("LUX_VALUES_MORE").size());
}

// These decide; the texts are so large that most others have no place.
TEST(Dxf, TheLowestAndTheHighestValueAreShown) {
  const Document document = sample_document();
  const PlanePart& plane = document.projects[0].spaces[0].planes[0];
  const auto [low, high] = std::minmax_element(
      plane.points.begin(), plane.points.end(),
      [](const PointRow& a, const PointRow& b) { return a.measured.value < b.measured.value; });
  const Drawing drawing = read_strictly(rendered_dxf(document, {}, {200}));
  const std::vector<Entity> values = drawing.of("TEXT", "LUX_VALUES");
  EXPECT_LT(2 * values.size(), plane.points.size());
  for (const PointRow& point : {*low, *high}) {
    EXPECT_TRUE(std::any_of(values.begin(), values.end(), [&](const Entity& text) {
      return glm::distance(text.point(11), point.position_m) < 1e-5;
    })) << point.measured.value;
  }
}

TEST(Dxf, APlaneOfOnePointHasItsValue) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.points.resize(1);
  plane.grid.columns = 1;
  for (auto* list : {&plane.grid.position_m, &plane.grid.normal}) list->resize(1);
  for (auto* list : {&plane.grid.column, &plane.grid.row}) list->resize(1);
  const Drawing drawing = drawn(document);
  EXPECT_THAT(drawing.words("LUX_VALUES"),
              testing::ElementsAre(format_cell(600.5, point_thresholds(plane))));
}

// Of two values in one place the one that a limit is for stays.
TEST(Dxf, APlaneOneMillimetreWideShowsTheValueThatDecides) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.outline_m = {{0, 0}, {0.001, 0}, {0.001, 1.5}, {0, 1.5}};
  plane.grid.spacing_u_m = 0.0005;
  for (std::size_t i = 0; i < plane.points.size(); ++i) {
    plane.points[i].position_m.x = 0.50025 + 0.0005 * static_cast<double>(i);
    plane.grid.position_m[i] = plane.points[i].position_m;
  }
  const Drawing drawing = drawn(document);
  EXPECT_THAT(drawing.words("LUX_VALUES"),
              testing::ElementsAre(format_cell(424.5, point_thresholds(plane))));
  EXPECT_THAT(joined(drawing.words("LUX_LEGEND")), HasSubstr("1 of 2 values are shown"));
}

TEST(Dxf, AHundredThousandPointsAreThinned) {
  SampleLight light;
  light.position_m = {{2.0, 1.0, 2.8}};
  Document document = small_document();
  document.projects[0].spaces[0].planes = {sample_plane("big", "Big", {0, 0, 0.8}, {1, 0, 0},
                                                        {0, 1, 0}, {400, 250}, {4, 2}, light,
                                                        [](double, double) { return true; })};
  const std::string words = words_of_drawing(rendered_dxf(document));
  std::smatch shown;
  ASSERT_TRUE(std::regex_search(words, shown, std::regex("([0-9]+) of 100000 values are shown")));
  EXPECT_GE(std::stoul(shown[1]), 2u);
  EXPECT_LT(std::stoul(shown[1]), 5000u);
}

TEST(Dxf, AValueThatIsNoneIsMarked) {
  Document document = small_document();
  document.projects[0].spaces[0].planes[0].points[0].measured = no_estimate();
  const Drawing drawing = drawn(document);
  EXPECT_THAT(drawing.words("LUX_VALUES"), Contains("-"));
  EXPECT_THAT(joined(drawing.words("LUX_LEGEND")), HasSubstr("no isolux lines"));
}

TEST(Dxf, RoomsAreClosedAndInTheirPlaces) {
  Document document = small_document();
  document.projects[0].spaces[0].floor_z_m = 3.25;
  const Drawing drawing = drawn(document);
  const std::vector<Entity> rooms = drawing.of("POLYLINE", "LUX_ROOMS");
  ASSERT_EQ(rooms.size(), 1u);
  EXPECT_EQ(rooms[0].text(70), "1");
  EXPECT_EQ(rooms[0].number(30), 3.25);
  const auto corners = polylines(drawing, "LUX_ROOMS").at(0);
  const std::vector<glm::dvec2>& wanted = document.projects[0].spaces[0].footprint_m;
  ASSERT_EQ(corners.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) expect_near(corners[i], {wanted[i], 3.25});
  EXPECT_THAT(drawing.words("LUX_ROOM_NAMES"), Contains("Office"));
}

TEST(Dxf, LuminairesAreInsertsOfABlockOfTheirType) {
  Document document = small_document();
  SpacePart& space = document.projects[0].spaces[0];
  LuminaireRow type;
  type.type_id = "panel";
  type.maker = "Maker";
  type.flux_lm = 3600;
  document.projects[0].luminaires = {type};
  LuminaireMark mark{{1.0, 1.0, 2.5}, "panel"};
  mark.axis = {0, 0, -1};
  mark.c0 = {1, 0, 0};
  mark.outline_m = {{0.7, 0.9}, {1.3, 0.9}, {1.3, 1.1}, {0.7, 1.1}};
  LuminaireMark turned = mark;
  turned.position_m = {3.0, 1.0, 2.6};
  turned.c0 = {0, 1, 0};
  turned.outline_m = {{2.9, 0.7}, {3.1, 0.7}, {3.1, 1.3}, {2.9, 1.3}};
  turned.id = "L2";
  space.luminaires = {mark, turned, {{2, 1, 2.5}, "spot"}};
  space.luminaires[0].label = "A1";
  space.luminaires[1].label = "A2";
  space.luminaires[2].label = "B1";
  const Drawing drawing = drawn(document);
  const std::vector<Entity> inserts = drawing.of("INSERT", "LUX_LUMINAIRES");
  ASSERT_EQ(inserts.size(), 3u);
  for (std::size_t i = 0; i < inserts.size(); ++i)
    expect_near(inserts[i].point(10), space.luminaires[i].position_m);
  EXPECT_EQ(inserts[0].number(50), 0.0);
  EXPECT_EQ(inserts[1].number(50), 90.0);
  EXPECT_EQ(inserts[0].text(2), inserts[1].text(2));  // one block for both
  EXPECT_NE(inserts[0].text(2), inserts[2].text(2));
  EXPECT_THAT(inserts[0].text(2), HasSubstr("PANEL"));
  EXPECT_THAT(drawing.words("LUX_LUMINAIRE_NUMBERS"), testing::ElementsAre("A1", "A2", "B1"));
  std::vector<std::map<std::string, std::string>> attributes;
  for (const Entity& entity : drawing.entities) {
    if (entity.layer() != "LUX_LUMINAIRES") continue;
    if (entity.kind == "INSERT") attributes.emplace_back();
    if (entity.kind == "ATTRIB") attributes.back()[entity.text(2)] = entity.text(1);
  }
  EXPECT_EQ(attributes[1]["MARK"], "A2");
  EXPECT_EQ(attributes[1]["NUMBER"], "2");
  EXPECT_EQ(attributes[1]["ID"], "L2");
  EXPECT_EQ(attributes[1]["TYPE"], "panel");
  EXPECT_EQ(attributes[1]["MAKER"], "Maker");
  EXPECT_EQ(attributes[1]["FLUX_LM"], "3600");
  EXPECT_EQ(attributes[1]["HEIGHT_M"], "2.6");
  EXPECT_EQ(attributes[2]["FLUX_LM"], "");  // not known
}

TEST(Dxf, VerdictsAreColoursAndWords) {
  const auto label_of = [](const Document& document) {
    const Drawing drawing = drawn(document);
    const std::vector<Entity> labels = drawing.of("TEXT", "LUX_PLANE_NAMES");
    EXPECT_FALSE(labels.empty());
    const std::vector<Entity> outlines = drawing.of("POLYLINE", "LUX_PLANES");
    if (!outlines.empty()) {
      EXPECT_EQ(outlines[0].text(62), labels[0].text(62));
    }
    return labels[0].text(1) + ", " + labels[0].text(62);
  };
  Document document = small_document();
  EXPECT_EQ(label_of(document), "Work plane: fail, 1");
  std::vector<rules::Finding>& findings = document.projects[0].spaces[0].planes[0].findings;
  findings[1].requirement.limit = 424.0;
  judge_again(findings[1]);
  EXPECT_EQ(label_of(document), "Work plane: undecided, 30");
  findings.pop_back();
  EXPECT_EQ(label_of(document), "Work plane: pass, 3");
  findings.clear();
  EXPECT_EQ(label_of(document), "Work plane: nothing is required, 8");
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.unseen_points = 1;
  EXPECT_EQ(label_of(document), "Work plane: nothing is required (Doubt), 8");
}

TEST(Dxf, WhatWasNotComputedIsNamedAndHasNoValues) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  PlanePart none;
  none.id = plane.id;
  none.name = plane.name;
  none.reason = calc::Message::words("no point of the grid is left");
  plane = none;
  const Drawing drawing = drawn(document);
  EXPECT_THAT(drawing.words("LUX_PLANE_NAMES"),
              testing::ElementsAre("Work plane: not judged, not computed"));
  EXPECT_TRUE(drawing.words("LUX_VALUES").empty());
  EXPECT_THAT(joined(drawing.words("LUX_NOTES")), HasSubstr("no point of the grid is left"));
}

TEST(Dxf, IsoluxLinesAreThoseOfHtml) {
  const Document document = sample_document();
  const SpacePart& space = document.projects[0].spaces[0];
  const PlanePart& plane = space.planes[0];
  const ColourScales scales(document.projects[0], ScaleSharing::project);
  const PlanIsolux isolux = plan_isolux({}, space, plane, scales.of(space, plane));
  const Drawing drawing = drawn(document);
  auto lines = polylines(drawing, "LUX_ISOLUX");
  const auto limits = polylines(drawing, "LUX_ISOLUX_LIMITS");
  lines.insert(lines.end(), limits.begin(), limits.end());
  std::size_t count = 0;
  for (const IsoluxLevel& level : isolux.levels) {
    for (const IsoluxLine& line : level.lines) {
      ++count;
      const glm::dvec2& first = line.points_m.front();
      const glm::dvec3 start =
          plane.grid.origin_m + first.x * plane.grid.u + first.y * plane.grid.v;
      EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const auto& corners) {
        return glm::distance(corners.front(), start) < 1e-5 &&
               corners.size() == line.points_m.size() - (line.is_closed ? 1 : 0);
      }));
    }
    std::vector<Entity> labels = drawing.of("TEXT", "LUX_ISOLUX_LABELS");
    const std::vector<Entity> without_place = drawing.of("TEXT", "LUX_VALUES_MORE");
    labels.insert(labels.end(), without_place.begin(), without_place.end());
    // A value may have the same words; the label is on a line of its level.
    const auto is_label = [&](const Entity& text) {
      return text.text(1) == format_shortest(level.value) &&
             std::any_of(level.lines.begin(), level.lines.end(), [&](const IsoluxLine& line) {
               return std::any_of(line.points_m.begin(), line.points_m.end(), [&](const auto& uv) {
                 const glm::dvec3 at =
                     plane.grid.origin_m + uv.x * plane.grid.u + uv.y * plane.grid.v;
                 return glm::distance(text.point(11), at) < 1e-5;
               });
             });
    };
    EXPECT_TRUE(level.lines.empty() || std::any_of(labels.begin(), labels.end(), is_label))
        << level.value;
  }
  EXPECT_GT(count, 3u);
}

// The numbers of one would be mixed with those of the other.
TEST(Dxf, ValuesOverOthersAreOnFrozenLayersAndSaidToBe) {
  Document document = small_document();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  planes.push_back(planes[0]);
  planes[1].id = planes[1].name = "Faces";
  for (PointRow& point : planes[1].points) point.position_m.z = 1.2;
  planes[1].grid.origin_m.z = 1.2;
  const Drawing drawing = drawn(document);
  EXPECT_EQ(drawing.of("TEXT", "LUX_VALUES").size(), 2u);
  EXPECT_EQ(drawing.of("TEXT", "LUX_VALUES_2").size(), 2u);
  ASSERT_NE(drawing.layer("LUX_VALUES_2"), nullptr);
  EXPECT_EQ(drawing.layer("LUX_VALUES_2")->text(70), "1");
  EXPECT_EQ(drawing.layer("LUX_VALUES")->text(70), "0");
  EXPECT_THAT(joined(drawing.words("LUX_LEGEND")),
              HasSubstr("Office / Faces: values overlap those of another plane. They are on "
                        "frozen layers: LUX_VALUES_2."));
  EXPECT_THAT(drawing.words("LUX_PLANE_NAMES"),
              Contains("Faces: fail"));  // on a layer that is not frozen
  EXPECT_EQ(drawn(small_document()).layer("LUX_VALUES_2"), nullptr);
}

TEST(Dxf, UprightPlanesAreDrawnBesideThePlan) {
  const Document document = sample_document();
  const PlanePart& board = document.projects[0].spaces[0].planes[1];
  const Drawing drawing = drawn(document);
  EXPECT_THAT(joined(drawing.words("LUX_LEGEND")), HasSubstr("Planes that are not level"));
  std::vector<std::string> values;
  for (const Entity& text : values_of(drawing)) {
    if (text.point(11).y < 0.0) values.push_back(text.text(1));
  }
  ASSERT_GE(values.size(), board.points.size());  // labels of isolux lines come after them
  for (std::size_t i = 0; i < board.points.size(); ++i)
    EXPECT_EQ(values[i], format_cell(board.points[i].measured.value, point_thresholds(board)));
  // In place as a line in space, and flat.
  std::size_t in_place = 0;
  for (const Entity& outline : drawing.of("POLYLINE", "LUX_PLANES"))
    in_place += outline.text(70) == "9" ? 1u : 0u;
  EXPECT_EQ(in_place, 1u);
}

TEST(Dxf, ProjectsLieBesideEachOther) {
  Document document = small_document();
  document.projects.push_back(document.projects[0]);
  const Drawing drawing = drawn(document);
  const auto rooms = polylines(drawing, "LUX_ROOMS");
  ASSERT_EQ(rooms.size(), 2u);
  // The first is 4 m long; what has no free place in its room is right of it.
  EXPECT_GE(rooms[1][0].x, 5.0);
  EXPECT_EQ(rooms[1][0].y, 0.0);
  const std::string legend = joined(drawing.words("LUX_LEGEND"));
  std::smatch moved;
  ASSERT_TRUE(
      std::regex_search(legend, moved, std::regex("Small office: moved by ([0-9.]+) m in x")));
  EXPECT_NEAR(std::stod(moved[1]), rooms[1][0].x, 1e-3);
  EXPECT_LT(drawing.of("INSERT", "LUX_ROOM_DATA").at(0).point(10).x, rooms[1][0].x);
}

// Two rooms side by side and one above the first, 3 m higher.
Document storeys_document() {
  Document document = small_document();
  std::vector<SpacePart>& spaces = document.projects[0].spaces;
  const SpacePart first = spaces[0];
  const auto add = [&](const char* id, double x, double z) {
    SpacePart room = first;
    room.id = room.name = id;
    room.floor_z_m = z;
    for (glm::dvec2& corner : room.footprint_m) corner.x += x;
    for (PlanePart& plane : room.planes) {
      plane.space_id = id;
      plane.grid.origin_m += glm::dvec3(x, 0, z);
      for (PointRow& point : plane.points) point.position_m += glm::dvec3(x, 0, z);
    }
    room.luminaires = {{{x + 1.0, 1.0, z + 2.8}, "panel"}};
    spaces.push_back(room);
  };
  add("Store", 5.0, 0.0);
  add("Attic", 0.0, 3.0);
  return document;
}

// The lowest storey ends at 9 m; the gap of 2 m is more than a tenth of it.
TEST(Dxf, StoreysLieBesideEachOtherAndSayByHowMuch) {
  const Document document = storeys_document();
  const Drawing drawing = drawn(document);
  const auto ground = polylines(drawing, "LUX_ROOMS_S1"),
             above = polylines(drawing, "LUX_ROOMS_S2");
  ASSERT_EQ(ground.size(), 2u);
  ASSERT_EQ(above.size(), 1u);
  expect_near(ground[0][0], {0, 0, 0});
  expect_near(ground[1][0], {5, 0, 0});
  const double shift = above[0][0].x;  // titles are shorter than the storey
  EXPECT_EQ(shift, 11.0);
  EXPECT_EQ(above[0][0].z, 3.0);
  for (const char* layer : {"LUX_ROOMS", "LUX_VALUES", "LUX_PLANES"}) {
    EXPECT_TRUE(drawing.of("POLYLINE", layer).empty()) << layer;
    EXPECT_TRUE(drawing.of("TEXT", layer).empty()) << layer;
  }
  // All of a room moves with it.
  expect_near(drawing.of("INSERT", "LUX_LUMINAIRES_S2").at(0).point(10), {shift + 1.0, 1.0, 5.8});
  expect_near(polylines(drawing, "LUX_PLANES_S2").at(0).at(0), {shift + 0.5, 0.25, 3.8});
  std::size_t values = 0;
  for (const char* layer : {"LUX_VALUES_S2", "LUX_VALUES_MORE_S2"}) {
    for (const Entity& text : drawing.of("TEXT", layer)) {
      EXPECT_GE(text.point(11).x, shift);
      ++values;
    }
  }
  EXPECT_GE(values, 2u);
  EXPECT_EQ(drawing.layer("LUX_VALUES_S2")->text(70), "0");
  EXPECT_EQ(drawing.of("INSERT", "LUX_ROOM_DATA_S2").size(), 1u);

  const std::vector<Entity> titles = drawing.of("TEXT", "LUX_STOREY_TITLES_S2");
  ASSERT_EQ(titles.size(), 2u);
  EXPECT_EQ(titles[0].text(1), "Storey at +3.00 m");
  EXPECT_EQ(titles[1].text(1), fmt::format("drawn {:.2f} m further in x", shift));
  EXPECT_EQ(titles[0].point(10).x, shift);
  EXPECT_LT(titles[0].point(10).y, 0.0);
  EXPECT_EQ(drawing.words("LUX_STOREY_TITLES_S1").size(), 1u);
  const std::string legend = joined(drawing.words("LUX_LEGEND"));
  EXPECT_THAT(legend, HasSubstr("LUX_..._S1, and so on"));
  EXPECT_THAT(legend, HasSubstr("Storey at +3.00 m: drawn"));
  EXPECT_THAT(legend, Not(HasSubstr("overlap; the plan shows")));
}

// Beside an imported plan only the true place helps.
TEST(Dxf, StoreysThatLieOverNothingAreAtTheirPlaces) {
  Document document = storeys_document();
  document.projects[0].spaces.erase(document.projects[0].spaces.begin());
  const Drawing drawing = drawn(document);
  EXPECT_EQ(polylines(drawing, "LUX_ROOMS").size(), 2u);
  EXPECT_EQ(drawing.layer("LUX_ROOMS_S1"), nullptr);
  EXPECT_THAT(joined(drawing.words("LUX_LEGEND")), Not(HasSubstr("further in x")));
}

TEST(Dxf, RoomsOfOneHeightThatOverlapStayAndAreSaidToBe) {
  Document document = storeys_document();
  document.projects[0].spaces[2].floor_z_m = 0.5;
  const Drawing drawing = drawn(document);
  EXPECT_EQ(polylines(drawing, "LUX_ROOMS").size(), 3u);
  EXPECT_THAT(joined(drawing.words("LUX_LEGEND")), HasSubstr("Rooms of one height overlap"));
}

// A second project begins behind the last storey of the first.
TEST(Dxf, StoreysOfSeveralProjectsDoNotMeet) {
  Document document = storeys_document();
  document.projects.push_back(document.projects[0]);
  const Drawing drawing = drawn(document);
  std::vector<double> left;
  for (const char* layer : {"LUX_ROOMS_S1", "LUX_ROOMS_S2"}) {
    for (const auto& room : polylines(drawing, layer)) left.push_back(room[0].x);
  }
  ASSERT_EQ(left.size(), 6u);
  std::sort(left.begin(), left.end());
  for (std::size_t i = 1; i < left.size(); ++i) EXPECT_GE(left[i] - left[i - 1], 4.0);
}

SpacePart box_room(double x, double z, double width = 4.0) {
  SpacePart room;
  room.footprint_m = {{x, 0}, {x + width, 0}, {x + width, 3}, {x, 3}};
  room.floor_z_m = z;
  return room;
}

SpacePart road(double z) {
  SpacePart space;
  space.planes.emplace_back();
  space.planes[0].grid.origin_m.z = z;
  space.planes[0].points = {sample_point(0, 0, {-50, 1, z}, {}, 0.0)};
  return space;
}

ProjectPart project_of(std::vector<SpacePart> spaces) {
  ProjectPart project;
  project.spaces = std::move(spaces);
  return project;
}

TEST(DxfStoreys, TheGapIsATenthOfTheLargestExtentAndInWholeMetres) {
  const ProjectPart project =
      project_of({box_room(0.5, 0, 40.0), box_room(1.25, 3), box_room(0.5, 6), box_room(500, 9)});
  DxfStoreys storeys(project);
  ASSERT_EQ(storeys.count(), 4u);
  storeys.put_beside(0.0);
  EXPECT_EQ(storeys[0].shift_m, 0.0);
  EXPECT_EQ(storeys[1].shift_m, 44.0);  // 40.5 + 4 - 1.25 is 43.25
  EXPECT_EQ(storeys[2].shift_m, 53.0);  // 49.25 + 4 - 0.5 is 52.75
  EXPECT_EQ(storeys[3].shift_m, 0.0);   // is right of all others
  storeys.put_beside(60.0);
  EXPECT_EQ(storeys[1].shift_m, 64.0);  // behind the title of the lowest: 60.5 + 4 - 1.25
  EXPECT_EQ(storeys.layer("LUX_ROOMS", 1), "LUX_ROOMS_S2");
  EXPECT_EQ(storeys.layer("LUX_ISOLUX_LIMITS_OTHER_123456", 1), "LUX_ISOLUX_LIMITS_OTHER_123456");
}

TEST(DxfStoreys, AreCalledByTheirHeightToFiveCentimetres) {
  EXPECT_EQ(storey_title({}, 3.12), "Storey at +3.10 m");
  EXPECT_EQ(storey_title({}, -0.01), "Storey at ±0.00 m");
  EXPECT_EQ(storey_title(Texts(Language::german, true), -2.5), "Geschoss auf −2,50 m");
}

TEST(DxfStoreys, RoadsAreWithTheStoreyOfTheirGround) {
  const ProjectPart project =
      project_of({box_room(0, -3), box_room(0, 0.2), box_room(0, 3.2), road(0.0), road(5.0)});
  const DxfStoreys storeys(project);
  ASSERT_EQ(storeys.count(), 3u);
  EXPECT_EQ(storeys.storey_of(project.spaces[3]), 1u);
  EXPECT_EQ(storeys.storey_of(project.spaces[4]), 1u);  // all outdoors together
}

TEST(DxfStoreys, RoomsFromMeshesAreWhereTheirHeightIs) {
  SpacePart mesh;
  mesh.surface_lines_m = {{0, 0, 3.0}, {4, 0, 3.0}, {4, 0, 5.5}, {4, 0, 3.0}};
  const ProjectPart project = project_of({box_room(0, 0), box_room(0, 2.9), mesh});
  const DxfStoreys storeys(project);
  ASSERT_TRUE(storeys.are_apart());
  EXPECT_EQ(storeys.storey_of(project.spaces[2]), 1u);
}

TEST(DxfStoreys, NothingAndHostileNumbersAreOneStoreyOrHaveSmallShifts) {
  EXPECT_FALSE(DxfStoreys(ProjectPart()).are_apart());
  EXPECT_FALSE(DxfStoreys(project_of({road(0.0)})).are_apart());
  SpacePart point = box_room(0, 3, 0.0);
  for (glm::dvec2& corner : point.footprint_m) corner = {1.0, 1.0};
  SpacePart far = box_room(1e9, 3);
  SpacePart endless = box_room(-1e300, 1e300, 2e300);
  // A storey that is one point, and one that is smaller than any number of a drawing.
  const ProjectPart project = project_of({box_room(0, 0), box_room(0, 3), far, endless, point,
                                          box_room(1.0, 6, 1e-12), box_room(1.0, 9, 1e-12)});
  DxfStoreys storeys(project);
  ASSERT_TRUE(storeys.are_apart());
  EXPECT_EQ(storeys.storey_of(project.spaces[2]), 0u);
  EXPECT_EQ(storeys.storey_of(project.spaces[3]), 0u);
  storeys.put_beside(0.0);
  for (std::size_t i = 1; i < storeys.count(); ++i) {
    EXPECT_GE(storeys[i].shift_m, storeys[i - 1].shift_m);
    EXPECT_LT(storeys[i].shift_m, 100.0);
  }
  Document document = small_document();
  document.projects[0].spaces = project.spaces;
  for (std::size_t i = 0; i < document.projects[0].spaces.size(); ++i)
    document.projects[0].spaces[i].id = fmt::format("r{}", i);
  drawn(document);
}

// What is frozen makes no drawing larger, but no other project is drawn over it.
TEST(Dxf, FrozenPlanesBesideThePlanDoNotExtendIt) {
  const Document plain = small_document();
  Document document = plain;
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  for (int i = 0; i < 6; ++i) {
    PlanePart wall = planes[0];
    wall.id = wall.name = fmt::format("wall {}", i);
    wall.made_by = calc::Message::words("workplace");
    wall.grid.v = {0, 0, 1};
    for (rules::Finding& finding : wall.findings) finding.requirement.origin.is_of_own_role = false;
    planes.push_back(wall);
  }
  const auto head_of = [](const std::string& dxf) {
    const std::size_t at = dxf.find("$EXTMIN");
    return dxf.substr(at, dxf.find("$EXTMAX") - at);
  };
  EXPECT_EQ(head_of(rendered_dxf(document)), head_of(rendered_dxf(plain)));
  const auto legend_left = [](const Document& of) {
    const auto frames = polylines(drawn(of), "LUX_LEGEND");
    return frames.empty() ? std::nan("") : frames[0][0].x;
  };
  EXPECT_EQ(legend_left(document), legend_left(plain));
  document.projects.push_back(plain.projects[0]);
  const Drawing both = drawn(document);
  double right = 0.0;
  for (const auto& outline : polylines(both, "LUX_PLANES_OTHER")) {
    for (const glm::dvec3& corner : outline) right = std::max(right, corner.x);
  }
  EXPECT_GT(right, 10.0);
  EXPECT_GT(polylines(both, "LUX_ROOMS").at(1).at(0).x, right);
}

TEST(Dxf, TheLegendHasTheRoomsAndSpeaksTheLanguage) {
  const Drawing drawing = drawn(small_document());
  const std::string legend = joined(drawing.words("LUX_LEGEND"));
  EXPECT_THAT(legend, HasSubstr("lengths in m,"));
  EXPECT_THAT(legend, HasSubstr("95 %"));
  EXPECT_THAT(legend, HasSubstr("2 requirements: 1 pass, 1 fail"));
  EXPECT_THAT(drawing.words("LUX_LEGEND"), Contains("Office"));
  EXPECT_THAT(drawing.words("LUX_NOTES"), Contains(HasSubstr("average   >= 500 lx  512 %%p 5 lx")));
  EXPECT_EQ(drawing.layer("LUX_NOTES")->text(70), "1");
  const Drawing german =
      read_strictly(rendered_dxf(sample_document(), Texts(Language::german, true)));
  EXPECT_THAT(joined(german.words("LUX_LEGEND")), HasSubstr("Zeichnung der Ergebnisse"));
}

// Nothing is folded there: of each room each requirement, each note and each doubt.
TEST(Dxf, TheNotesAreTheWholeTable) {
  Document document = small_document();
  std::vector<SpacePart>& spaces = document.projects[0].spaces;
  spaces.push_back(spaces[0]);
  spaces[1].id = "r2";
  spaces[1].name = "Store";
  for (std::size_t k = 0; k < spaces.size(); ++k) {
    spaces[k].notes = {calc::Message::words("made-up note")};
    PlanePart& plane = spaces[k].planes[0];
    plane.space_id = spaces[k].id;
    plane.findings.resize(1);  // passes
    plane.unseen_points = k + 1;
  }
  FormatStyle style;
  style.terminal.lists_passes = style.terminal.shows_notes = true;
  const std::string table = rendered("text", document, style);
  std::string wanted;
  for (const char c : table) wanted += c == '\n' ? ' ' : c;
  const auto without_blanks = [](const std::vector<std::string>& lines) {
    std::string text = joined(lines);
    std::erase(text, ' ');
    return text;
  };
  const std::vector<std::string> notes = drawn(document).words("LUX_NOTES");
  EXPECT_EQ(without_blanks(notes), without_blanks(dxf_lines(dxf_signs(wanted), kMostDxfBytes)));
  for (const SpacePart& space : spaces)
    EXPECT_THAT(joined(notes), HasSubstr(doubt_words({}, space.planes[0])));
}

TEST(Dxf, ALongCellOfTheLegendShowsThatItIsCut) {
  Document document = small_document();
  document.projects[0].spaces[0].name = "Storage of the registry, north wing, shelves 1 to 40";
  EXPECT_THAT(
      drawn(document).words("LUX_LEGEND"),
      Contains(testing::AllOf(testing::StartsWith("Storage of the"), HasSubstr("..."),
                              testing::EndsWith("1 to 40"), testing::SizeIs(testing::Le(40)))));
}

TEST(Dxf, TheLegendIsNoTallerThanThePlan) {
  const Document document = sample_document();
  double low = 1e9, high = -1e9, plan_low = 0.0;
  const Drawing drawing = drawn(document);
  const auto frames = polylines(drawing, "LUX_LEGEND");
  ASSERT_FALSE(frames.empty());
  for (const glm::dvec3& corner : frames[0]) {
    low = std::min(low, corner.y);
    high = std::max(high, corner.y);
  }
  for (const auto& outline : polylines(drawing, "LUX_PLANES")) {
    for (const glm::dvec3& corner : outline) plan_low = std::min(plan_low, corner.y);
  }
  EXPECT_GE(low, plan_low - 1.0);
  for (const Entity& text : drawing.of("TEXT", "LUX_LEGEND")) {
    EXPECT_GT(text.point(10).y, low);
    EXPECT_LT(text.point(10).y, high);
  }
}

TEST(Dxf, ARoomIsABlockWithItsResults) {
  const Drawing drawing = drawn(small_document());
  const std::vector<Entity> inserts = drawing.of("INSERT", "LUX_ROOM_DATA");
  ASSERT_EQ(inserts.size(), 1u);
  EXPECT_EQ(inserts[0].text(2), "LUX_ROOM");
  std::map<std::string, std::string> said;
  for (const Entity& attribute : drawing.of("ATTRIB", "LUX_ROOM_DATA"))
    said[attribute.text(2)] = attribute.text(1);
  EXPECT_EQ(said["ROOM"], "Office");
  EXPECT_EQ(said["VERDICT"], "fail");
  EXPECT_THAT(said["EM"], HasSubstr(">= 500"));
  EXPECT_EQ(said["UGR"], "-");
}

// 2.5 mm on paper, whatever the text.
TEST(Dxf, AllTextsHaveTheHeightOfTheScale) {
  for (const int scale : {20, 100}) {
    const Drawing drawing = read_strictly(rendered_dxf(sample_document(), {}, {scale}));
    for (const Entity& entity : drawing.entities) {
      if (entity.kind == "TEXT" || entity.kind == "ATTRIB") {
        EXPECT_NEAR(entity.number(40), 0.0025 * scale, 1e-6) << entity.text(1);
      }
    }
  }
}

TEST(Dxf, NoVisibleValueOverlapsAnother) {
  for (const int scale : {0, 200}) {
    const Drawing drawing = read_strictly(rendered_dxf(sample_document(), {}, {scale}));
    const std::vector<Entity> values = drawing.of("TEXT", "LUX_VALUES");
    ASSERT_FALSE(values.empty());
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const glm::dvec3 apart = glm::abs(values[i].point(11) - values[k].point(11));
        const double height = values[i].number(40);
        const double wide =
            0.5 * height * static_cast<double>(values[i].text(1).size() + values[k].text(1).size());
        EXPECT_TRUE(apart.x > wide - 1e-6 || apart.y > height - 1e-6);
      }
    }
  }
}

TEST(Dxf, LengthsAreInTheUnit) {
  const std::string metres = rendered_dxf(small_document()),
                    feet = rendered_dxf(small_document(), {}, {0, DrawingUnit::ft});
  EXPECT_THAT(metres, HasSubstr("$INSUNITS\r\n 70\r\n6\r\n"));
  EXPECT_THAT(feet, HasSubstr("$INSUNITS\r\n 70\r\n2\r\n"));
  const auto in_metres = polylines(read_strictly(metres), "LUX_ROOMS").at(0),
             in_feet = polylines(read_strictly(feet), "LUX_ROOMS").at(0);
  for (std::size_t i = 0; i < in_metres.size(); ++i) expect_near(in_metres[i], 0.3048 * in_feet[i]);
}

// Walls and observers are there, but not in sight.
TEST(Dxf, WhatIsNoTaskAreaIsOnFrozenLayers) {
  Document document = small_document();
  std::vector<PlanePart>& planes = document.projects[0].spaces[0].planes;
  planes.push_back(planes[0]);
  planes[1].id = planes[1].name = "ceiling";
  planes[1].made_by = calc::Message::words("workplace");
  for (rules::Finding& finding : planes[1].findings)
    finding.requirement.origin.is_of_own_role = false;
  const Drawing drawing = drawn(document);
  EXPECT_EQ(drawing.of("TEXT", "LUX_VALUES").size(), 2u);
  EXPECT_EQ(drawing.of("TEXT", "LUX_VALUES_OTHER").size(), 2u);
  for (const char* layer : {"LUX_VALUES_OTHER", "LUX_PLANES_OTHER", "LUX_PLANE_NAMES_OTHER"})
    EXPECT_EQ(drawing.layer(layer)->text(70), "1") << layer;
  EXPECT_THAT(joined(drawing.words("LUX_LEGEND")), HasSubstr("1 plane beside the task areas"));
}

TEST(DxfLayout, TheScaleIsTheCoarsestAtWhichHalfOfTheValuesHaveRoom) {
  std::vector<DxfPlacedText> texts;
  for (int i = 0; i < 20; ++i) texts.push_back({{0.4 * i, 0.0}, "500"});
  EXPECT_EQ(chosen_scale({texts}, 40.0), 100);  // each second one, which is 0.75 m wide
  EXPECT_EQ(chosen_scale({texts}, 8.0), 50);    // 160 mm on paper
  EXPECT_EQ(chosen_scale({}, 0.0), 50);
  const std::vector<bool> shown = shown_texts(texts, text_height_m(100));
  EXPECT_EQ(std::count(shown.begin(), shown.end(), true), 10);
}

TEST(DxfLayout, TextsHaveTheirTurns) {
  const std::vector<DxfPlacedText> texts{{{0.0, 0.0}, "500"},
                                         {{0.1, 0.0}, "501", DxfTurn::second},
                                         {{0.2, 0.0}, "499", DxfTurn::first},
                                         {{9.0, 0.0}, "500"}};
  EXPECT_THAT(shown_texts(texts, 0.1), testing::ElementsAre(false, false, true, true));
}

TEST(DxfLayout, AnOutlineOfVeryManyCornersHasNoFreePlace) {
  std::vector<glm::dvec2> room{{4, 0}, {4, 3}, {0, 3}};
  for (int i = 0; i < 1000; ++i) room.emplace_back(0.004 * i, 0.0);
  EXPECT_FALSE(free_place(room, {1.0, 1.0}, TakenPlaces(0.1)).has_value());
  room.pop_back();
  room.pop_back();
  room.pop_back();
  EXPECT_TRUE(free_place(room, {1.0, 1.0}, TakenPlaces(0.1)).has_value());
}

TEST(DxfLayout, AFreePlaceIsInTheRoomAndWhereNothingIs) {
  const std::vector<glm::dvec2> room{{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  TakenPlaces taken(0.1);
  EXPECT_TRUE(free_place(room, {1.0, 1.0}, taken).has_value());
  EXPECT_FALSE(free_place(room, {5.0, 1.0}, taken).has_value());
  taken.add({{0, 0}, {4, 2.5}});
  EXPECT_FALSE(free_place(room, {1.0, 1.0}, taken).has_value());
  const auto place = free_place(room, {1.0, 0.3}, taken);
  ASSERT_TRUE(place.has_value());
  EXPECT_GE(place->y - 0.3, 2.5);
  // The highest one, and of these the leftmost: 59 steps of the way that is left.
  EXPECT_NEAR(place->x, 3.0 / 60, 1e-12);
  EXPECT_NEAR(place->y, 3.0 - 2.7 / 60, 1e-12);
}

}  // namespace
}  // namespace report::dxf_test
