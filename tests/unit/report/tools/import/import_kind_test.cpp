#include "report/tools/import/import_kind.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace import_kind_test {
namespace {

using namespace std::string_literals;
using cli::import_kind_problem;

TEST(ImportKind, OtherKindsAreNamedWithWhatToDo) {
  EXPECT_EQ(import_kind_problem("v 0 0 0\nv 1 0 0\n", "hall.obj"),
            "cannot import 'hall.obj': it is an OBJ mesh; import reads DXF and IFC. Use it as "
            "<room file=\"hall.obj\"> or <mesh file=\"hall.obj\">");
  EXPECT_EQ(import_kind_problem("\xFF\xD8\xFF\xE0"s, "plan.dxf"),
            "cannot import 'plan.dxf': it is a JPEG picture; import reads DXF and IFC. "
            "Pictures and documents cannot be read here");
  EXPECT_EQ(import_kind_problem("AC1027\0\0"s, "plan.dwg"),
            "cannot import 'plan.dwg': it is an AutoCAD drawing (DWG); import reads DXF and IFC. "
            "Save it as DXF");
  EXPECT_EQ(
      import_kind_problem("version https://git-lfs.github.com/spec/v1\noid sha256:1\n", "plan.dxf"),
      "cannot import 'plan.dxf': it is a Git LFS pointer, not the file itself; import reads "
      "DXF and IFC. Run 'git lfs pull' to get the file");
  EXPECT_EQ(import_kind_problem("", "plan.dxf"),
            "cannot import 'plan.dxf': it is empty; import reads DXF and IFC");
  EXPECT_EQ(import_kind_problem("<luxgate/>", "a.xml"),
            "cannot import 'a.xml': it is a luxgate project; import reads DXF and IFC. 'luxgate "
            "check' reads it");
  EXPECT_EQ(import_kind_problem("<Root/>", "a.xml"),
            "cannot import 'a.xml': it is an XML file of <Root>; import reads DXF and IFC");
}

TEST(ImportKind, DrawingsAndModelsAreRead) {
  const std::string step = "ISO-10303-21;\nHEADER;FILE_SCHEMA(('IFC4'));";
  EXPECT_EQ(import_kind_problem("0\nSECTION\n", "a.obj"), "");
  EXPECT_EQ(import_kind_problem(step, "a"), "");
  EXPECT_EQ(import_kind_problem("ISO-10303-21;\n" + std::string(10'000, ' '), "a.ifc"), "");
  EXPECT_EQ(import_kind_problem("words", "a.dxf"), "");
  EXPECT_EQ(import_kind_problem("PK\x03\x04....", "a.ifczip"), "");
  EXPECT_TRUE(cli::is_read_as_ifc(step));
  EXPECT_TRUE(cli::is_read_as_ifc("PK\x03\x04...."));
  EXPECT_TRUE(cli::is_read_as_ifc("<ifcXML/>"));
  EXPECT_FALSE(cli::is_read_as_ifc("0\nSECTION\n"));
}

TEST(ImportKind, WhatIsNotKnownAsDxfIsSaidToBeNeither) {
  EXPECT_EQ(cli::unread_drawing("0\nSECTION\n", "a.dxf", "line 3: it is cut off"),
            "line 3: it is cut off");
  EXPECT_EQ(cli::unread_drawing("words", "a.dxf", "line 1: a group code"),
            "cannot import 'a.dxf': it is neither DXF nor IFC (line 1: a group code)");
}

}  // namespace
}  // namespace import_kind_test
