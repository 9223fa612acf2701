#include "calc/base/file_kind.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace calc::file_kind_test {
namespace {

using namespace std::string_literals;
using testing::EndsWith;
using testing::HasSubstr;

std::string kind_of(const std::string& bytes) {
  const FileKind* kind = kind_by_content(bytes);
  return kind == nullptr ? "" : std::string(kind->words);
}

TEST(FileKind, ContentsTell) {
  const std::vector<std::pair<std::string, std::string>> kKnown{
      {"%PDF-1.7\n", "a PDF document"},
      {"ISO-10303-21;\nHEADER;FILE_SCHEMA(('IFC2X3'));", "an IFC building model"},
      {"ISO-10303-21;\nHEADER;FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));", "a STEP model"},
      {"AC1027\0\0\0"s, "an AutoCAD drawing (DWG)"},
      {"  0\r\nSECTION\r\n  2\r\nHEADER\r\n", "an AutoCAD drawing (DXF)"},
      {"999\ndxfrw 0.6.3\n0\nSECTION\n", "an AutoCAD drawing (DXF)"},
      {"AutoCAD Binary DXF\r\n\x1A\0"s, "an AutoCAD drawing (DXF)"},
      {"\x4D\x4D\x10\0\0\0\x02\0\x0A\0\0\0"s, "a 3DS model"},
      {"Kaydara FBX Binary  \0"s, "an FBX model"},
      {"; FBX 7.4.0 project file\n", "an FBX model"},
      {"\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p\0"s, "a SketchUp model"},
      {"#?RADIANCE\noconv a.rad\nFORMAT=Radiance_octree\n", "a Radiance octree or picture"},
      {"# room\nvoid plastic wall\n0\n0\n5 .5 .5 .5 0 0\n", "a Radiance scene"},
      {"!genbox a b 1 1 1\nwall polygon p\n0\n0\n9 0 0 0\n", "a Radiance scene"},
      {"[VERSION]\nSTFF=1.0.5\n", "an STF file"},
      {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1....R\0e\0v\0i\0t\0"s, "a Revit model"},
      {"<?xml version='1.0'?><COLLADA>", "a COLLADA scene"},
      {"<!DOCTYPE html><html>", "a web page"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:12\n",
       "a Git LFS pointer, not the file itself"},
      {"<ns0:gbXML xmlns:ns0='x'>", "a gbXML file"},
      {"<luxgate version='1'/>", "a luxgate project"},
      {"<rule-pack id='a'/>", "a rule pack"},
      {"<luxgate-policy version='1'/>", "a policy"},
      {"v 0 0 0\nf 1 2 3\n", "an OBJ mesh"},
      {"# hall\nmtllib a.mtl\no light\nv 1 2 3\n", "an OBJ mesh"},
      {"g glass box\nv 1 2 3\n", "an OBJ mesh"},
      {"solid a\nfacet\n", "an STL mesh"},
      {"a company\r\n1\r\n1\r\n24\r\n15\r\n37\r\n5\r\nreport\r\n", "an EULUMDAT file"},
      {"IESNA:LM-63-2002\n", "an LM-63 file"},
      {"{\"format\": \"luxgate-result\", ", "a luxgate result"},
      {"{\"asset\": {\"version\": \"2.0\"}}", "a glTF model"},
      {"PK\x03\x04........product.xml", "a GLDF file"},
      {"PK\x03\x04........structure.xml", "an L3D body of a luminaire"},
      // A GLDF file lists its product last, and may begin with an L3D body.
      {"PK\x03\x04....structure.xml" + std::string(10'000, ' ') + "product.xml", "a GLDF file"},
      {"PK\x03\x04........", "a ZIP archive"},
      {"\x1F\x8B\x08", "a compressed file"}};
  for (const auto& [bytes, words] : kKnown) EXPECT_EQ(kind_of(bytes), words) << bytes;
}

TEST(FileKind, WhatOthersReadIsNotTakenForSomethingElse) {
  const std::vector<std::string> kNone{"",
                                       "solid a\n",
                                       "v 2\nb 3\n",
                                       "a light company\r\n1\r\n1\r\n24\r\n",
                                       "x,y,z\n0,1,2\n",
                                       "0\n1\n2\n",
                                       "just words\n",
                                       "<Root/>",
                                       "{}"};
  for (const std::string& bytes : kNone) {
    // The fourth of EULUMDAT looks like a Radiance scene: readers ask for the kind after their own.
    if (bytes.starts_with("a light")) continue;
    EXPECT_EQ(kind_of(bytes), "") << bytes;
  }
}

TEST(FileKind, NamesCountWhereContentsSayNothing) {
  EXPECT_EQ(kind_by_name("a/House.RVT")->words, "a Revit model");
  EXPECT_EQ(kind_by_name("a.ifc/b"), nullptr);
  const auto problem = [](const std::string& bytes, const std::string& name, bool is_recognised) {
    return other_kind_problem(bytes, name, FileUse::mesh, is_recognised);
  };
  EXPECT_EQ(problem("words", "a.evo", true), "");
  EXPECT_THAT(problem("words", "a.evo", false), HasSubstr("by its name it is a DIALux project"));
  EXPECT_EQ(problem("ply\n", "a.pdf", false), "");
  EXPECT_EQ(problem("%PDF-1", "a.obj", true),
            "it is a PDF document; a mesh (OBJ, STL, PLY or glTF) is needed here. Pictures "
            "and documents cannot be read here");
  // Of an archive the name says more.
  EXPECT_THAT(problem("PK\x03\x04........", "a.evo", true), HasSubstr("a DIALux project"));
  EXPECT_THAT(problem("IESNA91", "a.obj", true),
              HasSubstr(". Use it as <luminaire-type photometry=\"a.obj\">"));
  EXPECT_EQ(other_kind_problem("AC1027\0\0"s, "a", FileUse::photometry),
            "it is an AutoCAD drawing (DWG); photometry (LM-63, EULUMDAT, TM-33 or GLDF) is needed "
            "here");
}

TEST(FileKind, AnEmptyFileIsEmptyWhateverItsName) {
  EXPECT_EQ(other_kind_problem("", "a.json", FileUse::result, false),
            "it is empty; a result that 'luxgate check --format json' wrote is needed here");
  EXPECT_EQ(other_kind_problem("", "a.obj", FileUse::mesh, false), "");
}

TEST(FileKind, AdviceIsForWhatIsNeeded) {
  EXPECT_THAT(other_kind_problem("words", "a.xlsx", FileUse::table, false),
              EndsWith(". Save the sheet as CSV"));
  EXPECT_THAT(other_kind_problem("words", "a.xlsx", FileUse::project, false),
              EndsWith(" is needed here"));
  const std::string dwg = "AC1027\0\0"s;
  EXPECT_THAT(other_kind_problem(dwg, "a", FileUse::drawing), EndsWith(". Save it as DXF"));
  EXPECT_THAT(other_kind_problem(dwg, "a", FileUse::project),
              EndsWith(". Save it as DXF, which 'luxgate import' reads"));
  EXPECT_THAT(other_kind_problem("#VRML", "a", FileUse::drawing),
              EndsWith(". Export it as IFC or DXF"));
  EXPECT_THAT(other_kind_problem("v 0 0 0\n", "b/hall.obj", FileUse::project),
              EndsWith(". Use it as <room file=\"hall.obj\"> or <mesh file=\"hall.obj\">"));
  EXPECT_THAT(other_kind_problem("v 0 0 0\n", "", FileUse::table),
              EndsWith(". Use it as <room file=\"...\"> or <mesh file=\"...\">"));
  EXPECT_THAT(other_kind_problem("<gbXML/>", "h.xml", FileUse::project),
              EndsWith(". Use it as <room file=\"h.xml\" space=\"...\">"));
  EXPECT_THAT(
      other_kind_problem("version https://git-lfs.github.com/spec/v1\n", "a.dxf", FileUse::drawing),
      EndsWith(" is needed here. Run 'git lfs pull' to get the file"));
  EXPECT_EQ(other_kind_problem("0\nSECTION\n", "a.obj", FileUse::drawing), "");
}

TEST(FileKind, TheErrorNamesTheFile) {
  Diagnostics diagnostics;
  EXPECT_FALSE(check_file_kind("%PDF-1", "a.obj", FileUse::gbxml, diagnostics));
  EXPECT_TRUE(format_diagnostic(diagnostics.all().at(0))
                  .starts_with("a.obj: error[file-of-other-kind]: it is a PDF document; gbXML"));
  EXPECT_TRUE(check_file_kind("<gbXML>", "a.obj", FileUse::gbxml, diagnostics));
}

}  // namespace
}  // namespace calc::file_kind_test
