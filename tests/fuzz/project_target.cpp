// Project files, with small intact files of every kind beside them, and the requirements in them.
#include "rules/binding/judged_project.h"
#include "rules/pack/rule_pack.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/small_files.h"
#include "tests/fuzz/target.h"

#include <cmath>

namespace {

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
  static fuzz::SmallFiles files;
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
