#include "calc/project/objects/luminous_surface.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/elementary.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/project/objects/frame.h"
#include "calc/project/reading/project_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace calc {
namespace {

constexpr const char* kExitance = "luminous-exitance";
constexpr double kRightAngleCosine = 1.0e-6;  // corners from CAD files are rounded

// I = I0 cos(gamma), between entries as straight lines: too dark by 2.4e-6 at most, which the flux
// makes up for.
PhotometricWeb lambert_web(double exitance_lm_m2, double width_m, double depth_m) {
  constexpr int kSteps = 360;  // of a quarter of a degree
  std::vector<double> gamma_rad, intensity_cd;
  for (int i = 0; i <= kSteps; ++i) {
    gamma_rad.push_back(0.5 * kPi * i / kSteps);
    intensity_cd.push_back(i == kSteps ? 0.0 : calc::cos(gamma_rad.back()));
  }
  PhotometrySource source;
  source.format = "luminous surface";
  source.luminaire_name =
      fmt::format("{:.6g} lm/m2, {:.4g} x {:.4g} m", exitance_lm_m2, width_m, depth_m);
  return PhotometricWeb::make({0.0}, std::move(gamma_rad), std::move(intensity_cd),
                              {OpeningShape::rectangle, width_m, depth_m, 0.0}, std::move(source));
}

MaintenanceFactor read_maintenance_factor(const ProjectContext& context, ElementReader& reader) {
  MaintenanceFactor factor;
  factor.product = reader.number_or("maintenance-factor", kPositiveFraction,
                                    context.maintenance_factor.value_or(1.0));
  factor.is_stated = reader.has("maintenance-factor") || context.maintenance_factor.has_value();
  return factor;
}

// Of types, ids are unique; surfaces of other rooms may have the same.
std::string unused_type_id(const ProjectContext& context, const std::string& id) {
  const std::vector<LuminaireType>& types = context.project.luminaire_types;
  std::string name = id;
  const auto is_used = [&] {
    return std::any_of(types.begin(), types.end(),
                       [&](const LuminaireType& type) { return type.id == name; });
  };
  for (int number = 2; is_used(); ++number) name = fmt::format("{}-{}", id, number);
  return name;
}

}  // namespace

void add_luminous_surface(ProjectContext& context, ElementReader& reader,
                          const RectangleSides& sides, ObjectSet& set) {
  if (!reader.has(kExitance)) {
    for (const AttributeRow& attribute : kLuminousAttributes) {
      if (!reader.has(attribute.name)) continue;
      reader.report(DiagnosticId::missing_partner, reader.where(attribute.name),
                    reader.element().name, attribute.name, kExitance);
    }
    return;
  }
  const double exitance_lm_m2 = reader.number(kExitance, kPositive);
  LuminaireType type;
  type.maintenance = read_maintenance_factor(context, reader);
  type.power_w = reader.optional_number("power-w", kPositive).value_or(0.0);
  type.price = reader.optional_number("price", kNonNegative);
  type.where = reader.where();
  Luminaire luminaire;
  if (reader.has("group")) {
    luminaire.group = trim(reader.text("group"));
    context.groups.insert(luminaire.group);
  }
  if (!reader.ok()) return;
  const double width_m = glm::length(sides.u_m), depth_m = glm::length(sides.v_m);
  const double cosine = glm::dot(sides.u_m, sides.v_m) / (width_m * depth_m);
  if (std::abs(cosine) > kRightAngleCosine) {
    reader.report(DiagnosticId::luminous_not_rectangle, reader.where("v"), kExitance,
                  degrees_from_radians(calc::acos(cosine)));
    return;
  }
  PhotometricWeb web = lambert_web(exitance_lm_m2, width_m, depth_m);
  type.id = unused_type_id(context, reader.text("id"));
  type.web = context.project.webs.size();
  type.flux_scale = exitance_lm_m2 * width_m * depth_m / web.flux_lm();
  context.project.webs.push_back(std::move(web));
  luminaire.type = context.project.luminaire_types.size();
  context.project.luminaire_types.push_back(std::move(type));
  luminaire.position_m = sides.origin_m + 0.5 * (sides.u_m + sides.v_m);
  const glm::dvec3 axis = glm::normalize(glm::cross(sides.u_m, sides.v_m));
  luminaire.world_from_luminaire = luminaire_frame_towards(axis, sides.u_m).value();
  luminaire.where = reader.where();
  set.luminaires.push_back(std::move(luminaire));
}

}  // namespace calc
