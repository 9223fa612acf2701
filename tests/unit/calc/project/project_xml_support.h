#pragma once
// A small project around the few lines a test is about.

#include "calc/base/diagnostics.h"
#include "calc/project/project_xml.h"
#include "tests/support/gbxml_samples.h"
#include "tests/support/gldf_samples.h"
#include "tests/support/memory_file_reader.h"
#include "tests/support/mesh_samples.h"
#include "tests/support/tm33_samples.h"

#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <string>

namespace calc::tests {

// Rotationally symmetric, 100 cd straight down, 0 at gamma = 90 degrees; 12 W.
inline const std::string kSpotIes =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2024\n[MANUFAC] none\nTILT=NONE\n"
    "1 1000 1 2 1 1 2 0 0 0\n1 1 12\n0 90\n0\n100 0\n";

// Two triangles: one of "wood", one without usemtl.
inline const std::string kTableObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nusemtl wood\nf 1 3 4\n";

struct Loaded {
  std::optional<Project> project;
  std::string messages;  // formatted, one per line, no line end after the last one
};

// Two lamp sets, of 1000 and 1200 lm.
inline std::string two_lamp_sets_ldt() {
  test_support::LdtSample sample;
  sample.lamp_set_lines = {"1", "warm", "1000", "", "", "10", "1", "cold", "1200", "", "", "12"};
  return test_support::ldt_text(sample);
}

// Two emitters of 100 cd straight down, the second with the quantity 2.
inline std::string two_emitters_tm33() {
  test_support::Tm33Emitter second;
  second.head = "<Quantity>2</Quantity><InputWattage>1</InputWattage>";
  return test_support::tm33_text(test_support::tm33_emitter({}) +
                                 test_support::tm33_emitter(second));
}

// The variants "down" (an .ldt) and "up" (an .ies).
inline std::string two_variants_gldf() {
  test_support::GldfSample sample;
  sample.emitters =
      "<Emitter id='e1'><LightEmitter photometryId='p1'/></Emitter>"
      "<Emitter id='e2'><LightEmitter photometryId='p2'/></Emitter>";
  sample.variants =
      "<Variant id='down'><EmitterReference emitterId='e1'/></Variant>"
      "<Variant id='up'><EmitterReference emitterId='e2'/></Variant>";
  return test_support::gldf_bytes(sample);
}

inline MemoryFileReader project_files(const std::string& xml) {
  return MemoryFileReader({{"dir/p.xml", xml},
                           {"dir/spot.ies", kSpotIes},
                           {"dir/two.ldt", two_lamp_sets_ldt()},
                           {"dir/two.xml", two_emitters_tm33()},
                           {"dir/two.gldf", two_variants_gldf()},
                           {"dir/table.obj", kTableObj},
                           {"dir/house.xml", two_rooms()},
                           {"dir/plan.csv", "name,type,x_m,y_m,z_m\nA1,spot,1,1,2.5\n"},
                           {"dir/points.csv", "x,y,z,nx,ny,nz\n1,1,0.8,0,0,2\n"}});
}

inline Loaded load(const MemoryFileReader& files) {
  Diagnostics diagnostics;
  Loaded loaded;
  loaded.project = load_project(files, "dir/p.xml", diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (!loaded.messages.empty()) loaded.messages += '\n';
    loaded.messages += format_diagnostic(diagnostic);
  }
  return loaded;
}

inline Loaded load(const std::string& xml) { return load(project_files(xml)); }

// `lines` begin in line 4, column 1, of a project with the material "white" and the luminaire type
// "spot".
inline std::string in_project(const std::string& lines) {
  return "<luxgate version=\"1\">\n<material id=\"white\" reflectance=\"0.7\"/>\n"
         "<luminaire-type id=\"spot\" photometry=\"spot.ies\"/>\n" +
         lines + "\n</luxgate>\n";
}

// `lines` begin in line 5 of a project, inside a room of 4 x 3 x 2.5 m with one luminaire and one
// plane after them.
inline std::string in_room(const std::string& lines) {
  return in_project(
      "<room id=\"r\" size=\"4 3 2.5\" ceiling=\"white\" walls=\"white\" floor=\"white\">\n" +
      lines +
      "\n<luminaire id=\"l\" type=\"spot\" position=\"2 1.5 2.5\" group=\"row\"/>\n"
      "<plane id=\"task\" height=\"0.75\"/>\n</room>");
}

// Broken files for the message tests, besides those of project_files().
inline MemoryFileReader files_for_messages(const std::string& xml) {
  MemoryFileReader files = project_files(xml);
  files.add("dir/broken.ies", "hello");
  files.add("dir/tile.gltf", kSquareGltf);
  files.add("dir/tile.bin", square_bytes());
  files.add("dir/bad.csv", "x,y,z,nx,ny,nz\n1,2,3,0,0,1\n1,2,3,0,0\n1,2,x,0,0,1\n");
  files.add("dir/zero.csv", "x,y,z,nx,ny,nz\n1,2,3,0,0,0\n");
  files.add("dir/head.csv", "x;y;z\n");
  files.add("dir/looks.csv", "x,y,z,nx,ny,nz\n1,1,1,1,0,0\n\n1,2,1,0,0,3\n1,2,1,0,3,3\n");
  files.add("dir/empty.csv", "x,y,z,nx,ny,nz\n");
  return files;
}

struct MessageCase {
  std::string name;  // of the test
  std::string xml;
  std::string messages;  // all of them, see Loaded
};

inline void PrintTo(const MessageCase& message_case, std::ostream* out) {
  *out << message_case.name;
}

inline std::string case_name(const ::testing::TestParamInfo<MessageCase>& info) {
  return info.param.name;
}

}  // namespace calc::tests
