#include "calc/project/objects/library_xml.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/project/objects/housing_xml.h"
#include "calc/project/reading/project_elements.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace calc {
namespace {

// Fresh white paint and glazed tiles come to 0.9, black paint to 0.05. 0 is no mistake: it is how
// reflected light is switched off.
constexpr double kHighestUsualReflectance = 0.9;
constexpr double kLowestUsualReflectance = 0.05;

Material read_material_element(ElementReader& reader) {
  reader.allow(kMaterialElement);
  Material material{reader.id(), reader.number("reflectance", kFraction), reader.where()};
  if (material.reflectance > kHighestUsualReflectance) {
    reader.report(DiagnosticId::reflectance_very_high, reader.where("reflectance"), material.id,
                  material.reflectance);
  }
  if (material.reflectance > 0.0 && material.reflectance < kLowestUsualReflectance) {
    reader.report(DiagnosticId::reflectance_very_low, reader.where("reflectance"), material.id,
                  material.reflectance);
  }
  return material;
}

MaintenanceFactor read_maintenance(const ProjectContext& context, ElementReader& reader) {
  constexpr std::array<std::string_view, 4> kParts{"llmf", "lsf", "lmf", "rsmf"};
  MaintenanceFactor factor;
  const std::array<std::optional<double>*, 4> parts{&factor.llmf, &factor.lsf, &factor.lmf,
                                                    &factor.rsmf};
  bool has_parts = false;
  for (std::size_t i = 0; i < kParts.size(); ++i) {
    *parts[i] = reader.optional_number(kParts[i], kPositiveFraction);
    if (!parts[i]->has_value()) continue;
    if (!has_parts) reader.exclude("maintenance-factor", kParts[i]);
    has_parts = true;
    factor.product *= **parts[i];
  }
  if (!has_parts) {
    factor.product = reader.number_or("maintenance-factor", kPositiveFraction,
                                      context.maintenance_factor.value_or(1.0));
  }
  factor.is_stated =
      has_parts || reader.has("maintenance-factor") || context.maintenance_factor.has_value();
  return factor;
}

// Which light of the photometry file is meant.
PhotometryOptions read_photometry_options(ElementReader& reader) {
  PhotometryOptions options;
  options.where = reader.where("photometry");
  if (reader.has("lamp-set")) options.lamp_set = reader.integer("lamp-set", 1);
  if (reader.has("variant")) options.variant = reader.text("variant");
  if (reader.has("emitter")) options.emitter = reader.text("emitter");
  return options;
}

struct LightTotals {
  double flux_lm = 0.0;
  double power_w = 0.0;  // 0: one of the emitters does not state it
};

LightTotals totals_of(const Project& project, const std::vector<PlacedWeb>& light) {
  LightTotals totals;
  bool is_power_known = true;
  for (const PlacedWeb& emitter : light) {
    const PhotometricWeb& web = project.webs[emitter.web];
    totals.flux_lm += web.flux_lm();
    totals.power_w += web.source().input_power_w;
    is_power_known = is_power_known && web.source().input_power_w > 0.0;
  }
  if (!is_power_known) totals.power_w = 0.0;
  return totals;
}

// The light of one type: of several emitters the first one gets `type`, and all get their places.
void add_emitters(const Project& project, const std::vector<PlacedWeb>& light, double flux_scale,
                  LuminaireType& type, std::vector<LuminaireType>& further) {
  type.web = light.front().web;
  type.flux_scale = flux_scale;
  if (light.size() == 1) return;
  for (std::size_t i = 0; i < light.size(); ++i) {
    type.emitters.push_back({project.luminaire_types.size() + i, light[i].place});
    if (i == 0) continue;
    LuminaireType emitter = type;
    emitter.id += "/" + light[i].emitter;
    emitter.web = light[i].web;
    emitter.power_w = emitter.file_power_w = 0.0;
    emitter.price.reset();
    emitter.packages.clear();
    emitter.package.reset();
    emitter.emitters.clear();
    emitter.is_further_emitter = true;
    further.push_back(std::move(emitter));
  }
}

std::vector<LampPackage> read_packages(const ProjectContext& context, const XmlElement& type) {
  std::vector<LampPackage> packages;
  std::map<std::string, int> line_of;
  for (const XmlElement& child : type.children) {
    if (child.name != kPackageName) continue;
    ElementReader reader(child, context.diagnostics);
    reader.allow(kPackageElement);
    LampPackage package;
    package.article = reader.text(kArticleName);
    package.flux_lm = reader.number("flux-lm", kPositive);
    package.power_w = reader.number("power-w", kPositive);
    package.price = reader.optional_number("price", kNonNegative);
    if (package.article.empty()) continue;
    const auto [known, is_new] = line_of.try_emplace(package.article, reader.where().line);
    if (!is_new) {
      reader.report(DiagnosticId::duplicate_id, reader.where(kArticleName), "package",
                    package.article, known->second);
    }
    packages.push_back(std::move(package));
  }
  return packages;
}

// The package that the type takes.
void choose_package(ElementReader& reader, LuminaireType& type) {
  if (!reader.has(kPackageName)) return;
  for (const std::string_view other : kReplacedByPackage) reader.exclude(kPackageName, other);
  const std::string article = reader.text(kPackageName);
  if (article.empty()) return;
  Names known;
  for (std::size_t i = 0; i < type.packages.size(); ++i) {
    if (type.packages[i].article == article) type.package = i;
    known.push_back(type.packages[i].article);
  }
  if (!type.package) report_unknown_reference(reader, kPackageName, "package", article, known);
}

// The type, and behind it those of its further emitters.
std::vector<LuminaireType> read_luminaire_type(ProjectContext& context, ElementReader& reader) {
  reader.allow(kLuminaireTypeElement);
  LuminaireType type;
  type.id = reader.id();
  type.where = reader.where();
  type.photometry_file = reader.text("photometry");
  type.maintenance = read_maintenance(context, reader);
  const WebUse use{reader.choice_or("opening", kOpeningType.words, 0) == 1,
                   reader.choice_or("interpolation", kInterpolationType.words, 0) == 1};
  std::optional<double> flux_lm = reader.optional_number("flux-lm", kPositive);
  std::optional<double> power_w = reader.optional_number("power-w", kPositive);
  type.price = reader.optional_number("price", kNonNegative);
  type.packages = read_packages(context, reader.element());
  choose_package(reader, type);
  const std::size_t errors = reader.diagnostics().error_count();
  const PhotometryOptions options = read_photometry_options(reader);
  if (type.photometry_file.empty() || reader.diagnostics().error_count() != errors) return {type};
  const std::vector<PlacedWeb> light =
      context.files.light(type.photometry_file, use, reader.where("photometry"), options);
  if (light.empty()) return {type};
  const LightTotals file = totals_of(context.project, light);
  if (type.package) {
    const LampPackage& package = type.packages[*type.package];
    flux_lm = package.flux_lm;
    power_w = package.power_w;
    if (package.price) type.price = package.price;
  }
  const double flux_scale = flux_lm ? *flux_lm / file.flux_lm : 1.0;
  type.flux_scale = flux_scale;
  type.power_w = power_w.value_or(type.is_of_other_flux() ? 0.0 : file.power_w);
  type.file_power_w = file.power_w;
  read_housing(context, reader.element(), light, type);
  std::vector<LuminaireType> types{type};
  std::vector<LuminaireType> further;
  add_emitters(context.project, light, flux_scale, types.front(), further);
  types.insert(types.end(), further.begin(), further.end());
  return types;
}

// Empty if `name` was dimmed before.
void read_dim(const ProjectContext& context, ElementReader& reader, LightScene& scene) {
  reader.allow(kDimElement);
  const std::string group(trim(reader.text("group")));
  const double level = reader.number("level", kFraction);
  if (group.empty()) return;
  if (!context.groups.contains(group)) {
    report_unknown_reference(reader, "group", "luminaire with the dimming group", group,
                             Names(context.groups.begin(), context.groups.end()));
  }
  scene.level_of_group.emplace_back(group, level);
}

LightScene read_light_scene(const ProjectContext& context, ElementReader& reader) {
  reader.allow(kSceneElement);
  LightScene scene;
  scene.id = reader.id();
  scene.where = reader.where();
  IdTable groups("dimming group");
  for (const XmlElement& child : reader.element().children) {
    if (child.name != "dim") continue;
    ElementReader dim(child, reader.diagnostics());
    read_dim(context, dim, scene);
    groups.add(dim, std::string(trim(dim.text_or("group", ""))), 0);
  }
  return scene;
}

}  // namespace

void read_materials(ProjectContext& context, const XmlElement& root) {
  for (const XmlElement& child : root.children) {
    if (child.name != "material") continue;
    ElementReader reader(child, context.diagnostics);
    Material material = read_material_element(reader);
    context.materials.add(reader, material.id, context.project.materials.size());
    context.project.materials.push_back(std::move(material));
  }
}

void read_luminaire_types(ProjectContext& context, const XmlElement& root) {
  for (const XmlElement& child : root.children) {
    if (child.name != "luminaire-type") continue;
    ElementReader reader(child, context.diagnostics);
    std::vector<LuminaireType> types = read_luminaire_type(context, reader);
    std::vector<LuminaireType>& all = context.project.luminaire_types;
    context.luminaire_types.add(reader, types.front().id, all.size());
    for (LuminaireType& type : types) all.push_back(std::move(type));
  }
}

void read_light_scenes(ProjectContext& context, const XmlElement& root) {
  IdTable ids("scene");
  for (const XmlElement& child : root.children) {
    if (child.name != "scene") continue;
    ElementReader reader(child, context.diagnostics);
    LightScene scene = read_light_scene(context, reader);
    ids.add(reader, scene.id, 0);
    context.project.scenes.push_back(std::move(scene));
  }
}

}  // namespace calc
