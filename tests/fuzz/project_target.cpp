// Project files, with small intact files of every kind beside them, and the requirements in them.
#include "calc/base/file_reader.h"
#include "rules/binding/judged_project.h"
#include "rules/pack/rule_pack.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/target.h"
#include "tests/support/gbxml_samples.h"
#include "tests/support/gldf_samples.h"
#include "tests/support/mesh_samples.h"
#include "tests/support/photometry_samples.h"
#include "tests/support/tm33_samples.h"

#include <algorithm>
#include <cmath>

namespace {

std::string small_ies() {
  test_support::IesSample sample;
  sample.gamma_deg = {0, 45, 90};
  return test_support::ies_text(sample);
}

std::string small_ldt() {
  test_support::LdtSample sample;
  sample.symmetry = "1";
  sample.all_c_deg = sample.stored_c_deg = {0};
  sample.gamma_deg = {0, 45, 90};
  sample.lamp_set_lines = {"1", "warm", "1000", "", "", "10", "1", "cold", "1200", "", "", "12"};
  return test_support::ldt_text(sample);
}

std::string small_tm33() {
  test_support::Tm33Emitter first, second;
  first.c_deg = second.c_deg = {0, 90, 180, 270};
  first.gamma_deg = second.gamma_deg = {0, 45, 90};
  second.head = "<Quantity>2</Quantity><InputWattage>1</InputWattage>";
  return test_support::tm33_text(test_support::tm33_emitter(first) +
                                 test_support::tm33_emitter(second));
}

std::string two_variants_gldf() {
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
      {".xml", calc::testing::two_rooms()},
      {".gldf", two_variants_gldf()},
      {".obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nusemtl wood\nf 1 3 4\n"},
      {".gltf", calc::testing::kSquareGltf},
      {".bin", calc::testing::square_bytes()},
      {"points.csv", "x,y,z,nx,ny,nz\n1,1,0.8,0,0,2\n"},
      {".csv", "name,type,x_m,y_m,z_m\nA1,spot,1,1,2.5\n"}};
};

void check_space(const calc::Project& project, const calc::Space& space) {
  for (const calc::Body& body : space.bodies) {
    fuzz::check_triangles(body.vertex_m, body.triangle);
    fuzz::require(body.material_of.size() == body.triangle.size(), "a material for each triangle");
    for (const std::uint32_t material : body.material_of) {
      fuzz::require(material < project.materials.size(), "materials are in range");
    }
  }
  for (const calc::Luminaire& luminaire : space.luminaires) {
    fuzz::require(luminaire.type < project.luminaire_types.size(), "types are in range");
    const glm::dmat3& axes = luminaire.world_from_luminaire;
    fuzz::require(std::abs(glm::determinant(axes) - 1.0) < 1e-6, "a luminaire's axes are a turn");
    fuzz::check_triangles({luminaire.position_m}, {});
  }
}

void check_project(const calc::Project& project) {
  for (const calc::Material& material : project.materials) {
    fuzz::require(material.reflectance >= 0.0 && material.reflectance <= 1.0, "a reflectance");
  }
  for (const calc::LuminaireType& type : project.luminaire_types) {
    fuzz::require(type.web < project.webs.size(), "webs are in range");
    fuzz::require(std::isfinite(type.flux_scale) && type.flux_scale > 0.0, "flux scale > 0");
    fuzz::require(type.maintenance.product > 0.0 && type.maintenance.product <= 1.0,
                  "maintenance factor in (0, 1]");
  }
  for (const calc::Space& space : project.spaces) check_space(project, space);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static SmallFiles files;
  static const std::vector<rules::RulePack> kPacks = rules::builtin_rule_packs();
  files.project = fuzz::as_text(data, size);
  calc::Diagnostics diagnostics;
  const auto judged = rules::load_judged_project(files, "d/p.xml", kPacks, diagnostics);
  fuzz::check_messages(judged.has_value(), diagnostics);
  if (!judged) return 0;
  check_project(judged->project);
  for (const rules::Requirement& requirement : judged->requirements) {
    const bool is_known = std::isfinite(requirement.limit) && requirement.limit >= 0.0;
    fuzz::require(is_known || !requirement.problem.empty(), "a limit >= 0, or why it is not known");
  }
  return 0;
}
