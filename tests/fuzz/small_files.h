#pragma once
// A small intact file of every kind that a project may name.

#include "calc/base/file_reader.h"
#include "tests/support/gbxml_samples.h"
#include "tests/support/gldf_samples.h"
#include "tests/support/mesh_samples.h"
#include "tests/support/photometry_samples.h"
#include "tests/support/tm33_samples.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace fuzz {

inline std::string small_ies() {
  test_support::IesSample sample;
  sample.gamma_deg = {0, 45, 90};
  return test_support::ies_text(sample);
}

inline std::string small_ldt() {
  test_support::LdtSample sample;
  sample.symmetry = "1";
  sample.all_c_deg = sample.stored_c_deg = {0};
  sample.gamma_deg = {0, 45, 90};
  sample.lamp_set_lines = {"1", "warm", "1000", "", "", "10", "1", "cold", "1200", "", "", "12"};
  return test_support::ldt_text(sample);
}

inline std::string small_tm33() {
  test_support::Tm33Emitter first, second;
  first.c_deg = second.c_deg = {0, 90, 180, 270};
  first.gamma_deg = second.gamma_deg = {0, 45, 90};
  second.head = "<Quantity>2</Quantity><InputWattage>1</InputWattage>";
  return test_support::tm33_text(test_support::tm33_emitter(first) +
                                 test_support::tm33_emitter(second));
}

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

// Every file that a project may name, by the end of its name; the project itself is "d/p.xml".
class SmallFiles : public calc::FileReader {
 public:
  std::string project;

  calc::FileContent read_within(const std::string&, const std::string& path) const override {
    if (path == "d/p.xml") return {project, {}};
    const auto found = std::find_if(kinds_.begin(), kinds_.end(),
                                    [&](const auto& kind) { return path.ends_with(kind.first); });
    if (found == kinds_.end()) return {{}, "No such file or directory"};
    return {found->second, {}};
  }

 private:
  std::vector<std::pair<std::string, std::string>> kinds_ = {
      {".ies", small_ies()},
      {".ldt", small_ldt()},
      {"two.xml", small_tm33()},
      {".xml", calc::tests::two_rooms()},
      {".gldf", two_variants_gldf()},
      {".obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nusemtl wood\nf 1 3 4\n"},
      {".gltf", calc::tests::kSquareGltf},
      {".bin", calc::tests::square_bytes()},
      {"points.csv", "x,y,z,nx,ny,nz\n1,1,0.8,0,0,2\n"},
      {".csv", "name,type,x_m,y_m,z_m\nA1,spot,1,1,2.5\n"}};
};

}  // namespace fuzz
