#include "calc/project/reading/luminaire_list_csv.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace calc::luminaire_list_csv_test {
namespace {

struct Parsed {
  std::optional<LuminaireList> list;
  std::string messages;
};

Parsed parse(const std::string& text) {
  Diagnostics diagnostics;
  Parsed parsed;
  parsed.list = parse_luminaire_list(text, "l.csv", diagnostics);
  for (const Diagnostic& d : diagnostics.all()) {
    parsed.messages += (parsed.messages.empty() ? "" : "\n") + format_diagnostic(d);
  }
  EXPECT_EQ(parsed.list.has_value(), !diagnostics.has_errors());
  return parsed;
}

const std::string kHead = "name,type,x_m,y_m,z_m\n";

TEST(LuminaireList, ColumnsMayStandInAnyOrder) {
  const Parsed parsed = parse(
      "\xEF\xBB\xBFtype, name,x_m,y_m,z_m,aim_x_m,aim_y_m,aim_z_m,axis_x,axis_y,axis_z,"
      "rotation_deg,group\r\n"
      "spot,a,1,2,3,,,,0,1,0,90,row 1\r\n\r\nspot,b,1.5,2,3,4,5,0,,,,,\r\n");
  ASSERT_TRUE(parsed.list) << parsed.messages;
  ASSERT_EQ(parsed.list->entry.size(), 2u);
  const LuminaireEntry& a = parsed.list->entry[0];
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.type, "spot");
  EXPECT_EQ(a.group, "row 1");
  EXPECT_EQ(a.position_m, glm::dvec3(1, 2, 3));
  EXPECT_EQ(a.axis, glm::dvec3(0, 1, 0));
  EXPECT_FALSE(a.aim_m);
  EXPECT_NEAR(a.rotation_rad, 1.5707963267948966, 1e-15);
  const LuminaireEntry& b = parsed.list->entry[1];
  EXPECT_EQ(b.aim_m, glm::dvec3(4, 5, 0));
  EXPECT_EQ(b.rotation_rad, 0.0);
  EXPECT_EQ(b.line, 4);
}

TEST(LuminaireList, ColumnsNameTheUnit) {
  const Parsed parsed =
      parse("name,type,x_mm,y_mm,z_mm,aim_x_mm,aim_y_mm,aim_z_mm\na,spot,1500,2000,3000,0,0,500\n");
  ASSERT_TRUE(parsed.list) << parsed.messages;
  EXPECT_EQ(parsed.list->entry[0].position_m, glm::dvec3(1.5, 2, 3));
  EXPECT_EQ(parsed.list->entry[0].aim_m, glm::dvec3(0, 0, 0.5));
  EXPECT_NE(parse("name,type,x_m,y_m,z_mm\na,spot,1,2,3000\n")
                .messages.find("; columns 'y_m' and 'z_mm' have different units"),
            std::string::npos);
  EXPECT_NE(parse("name,type,x_m,y_m,z_m,x_mm\n").messages.find("column 'x_mm' is given twice"),
            std::string::npos);
}

TEST(LuminaireList, CellsMayBeQuoted) {
  const Parsed parsed = parse(
      "\"name\",type,x_m,y_m,z_m,group\na,\"Panel, north\",1,\"2\",3,\"row \"\"A\"\"\r\nend\"\n"
      "b,spot,4,5,6,\n");
  ASSERT_TRUE(parsed.list) << parsed.messages;
  ASSERT_EQ(parsed.list->entry.size(), 2u);
  EXPECT_EQ(parsed.list->entry[0].type, "Panel, north");
  EXPECT_EQ(parsed.list->entry[0].group, "row \"A\" end");
  EXPECT_EQ(parsed.list->entry[0].position_m, glm::dvec3(1, 2, 3));
  EXPECT_EQ(parsed.list->entry[0].line, 2);
  EXPECT_EQ(parsed.list->entry[1].line, 4);
}

TEST(LuminaireList, MistakesWithQuotesEndTheReading) {
  EXPECT_EQ(parse(kHead + "a,spot,1,2\nb, \"spot,1,2,3\nc,spot,1,2,3\n").messages,
            "l.csv:2: error[luminaire-list-line]: expected 5 values as in the first line, found 4\n"
            "l.csv:3:4: error[csv-quotes]: a quote is not closed");
  EXPECT_EQ(parse("\"name,type,x_m,y_m,z_m\n").messages,
            "l.csv:1:1: error[csv-quotes]: a quote is not closed");
  EXPECT_EQ(parse(kHead + "a,5\" tube,1,2,3\n").messages,
            "l.csv:2:4: error[csv-quotes]: misplaced quote; enclose the whole cell in quotes and "
            "write a quote in it twice");
}

TEST(LuminaireList, HeadersAreChecked) {
  const std::string start =
      "l.csv:1: error[luminaire-list-header]: the first line must name columns: name, type, x_m, "
      "y_m, z_m; optional are axis_x, axis_y, axis_z or aim_x_m, aim_y_m, aim_z_m, rotation_deg, "
      "group; other units are _mm, _cm, _in and _ft; ";
  EXPECT_EQ(parse("").messages, start + "unknown column ''");
  EXPECT_EQ(parse("name;type;x;y;z\n").messages,
            "l.csv:1:5: error[csv-separator]: cells are separated by semicolons; commas are needed "
            "between cells, and decimal points in numbers");
  EXPECT_EQ(parse("name,type,x_m,y_m,z_m,rotation_dg\n").messages,
            start + "unknown column 'rotation_dg'; did you mean 'rotation_deg'?");
  EXPECT_EQ(parse("name,type,x_m,y_m\n").messages, start + "column 'z_m' is missing");
  EXPECT_EQ(parse("name,type,x_m,y_m,z_m,x_m\n").messages, start + "column 'x_m' is given twice");
  EXPECT_EQ(parse("name,type,x_m,y_m,z_m,aim_y_m\n").messages,
            start + "columns 'aim_x_m', 'aim_y_m' and 'aim_z_m' must be given together");
  EXPECT_EQ(parse(kHead).messages,
            "l.csv: error[luminaire-list-empty]: no luminaires after the header line");
}

TEST(LuminaireList, LinesAreChecked) {
  const auto error = [](const std::string& what) {
    return "l.csv:2: error[luminaire-list-line]: " + what;
  };
  EXPECT_EQ(parse(kHead + "a,spot,1,2\n").messages,
            error("expected 5 values as in the first line, found 4"));
  EXPECT_EQ(parse(kHead + "a,spot,1,2,nan\n").messages,
            error("z_m 'nan' is not a number from -1e9 to 1e9"));
  EXPECT_EQ(parse(kHead + "a b,spot,1,2,3\n").messages,
            error("the name 'a b' is not an id; allowed are letters, digits and _ . : -"));
  EXPECT_EQ(parse(kHead + "a,,1,2,3\n").messages, error("the type is empty"));
  EXPECT_EQ(parse(kHead + "a,spot,1,2,3\na,spot,2,2,3\n").messages,
            "l.csv:3: error[luminaire-list-line]: the name 'a' is also in line 2");
  const std::string aimed = "name,type,x_m,y_m,z_m,aim_x_m,aim_y_m,aim_z_m,axis_x,axis_y,axis_z\n";
  EXPECT_EQ(parse(aimed + "a,spot,1,2,3,1,2,3,,,\n").messages,
            error("the aim is the luminaire's own position; it must be another point"));
  EXPECT_EQ(parse(aimed + "a,spot,1,2,3,1,2,0,0,0,1\n").messages,
            error("the luminaire has both an axis and an aim; give only one of them"));
  EXPECT_EQ(parse(aimed + "a,spot,1,2,3,,,,0,0,0\n").messages,
            error("the axis is zero; it must be a direction"));
  EXPECT_EQ(parse(aimed + "a,spot,1,2,3,1,,0,,,\n").messages,
            error("aim_y_m '' is not a number from -1e9 to 1e9"));
}

TEST(LuminaireList, ErrorsEndAfterTen) {
  std::string text = kHead;
  for (int i = 0; i < 20; ++i) text += "a\n";
  const std::string messages = parse(text).messages;
  EXPECT_EQ(std::count(messages.begin(), messages.end(), '\n'), 10);
  EXPECT_NE(messages.find("l.csv:12: error[luminaire-list-gives-up]"), std::string::npos);
}

}  // namespace
}  // namespace calc::luminaire_list_csv_test
