#include "rules/binding/bind.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "calc/glare/field_glare.h"
#include "calc/glare/room_ugr.h"
#include "calc/project/reading/former_ids.h"
#include "calc/project/warnings/luminaire_warnings.h"
#include "calc/road/road_values.h"
#include "calc/scene/installed_power.h"
#include "calc/scene/lighting_energy.h"
#include "calc/scene/plane_place.h"
#include "calc/scene/scene_level.h"
#include "calc/scene/sensor_grid.h"
#include "rules/applicability/place_in_space.h"
#include "rules/binding/colour_rendering.h"
#include "rules/binding/luminaire_values.h"
#include "rules/binding/requirement_ids.h"
#include "rules/binding/requirement_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace rules {
namespace {

// Narrows the strips of a mask to the margin, so that points that the project adds to the zone
// count.
void narrow_strips(Mask& mask, double margin_m) {
  for (MaskOperation& operation : mask.operations) {
    const bool is_strip = operation.step == MaskStep::walls || operation.step == MaskStep::inset ||
                          operation.step == MaskStep::border;
    if (is_strip) operation.metres = std::min(operation.metres, margin_m);
  }
}

// Returns the narrower strip along walls that a mask omits, if the project states it or the room is
// narrow for the rule.
std::optional<double> narrower_strip_m(const calc::CalcPlane& plane, const Requirement& requirement,
                                       const RequirementContext& context) {
  if (plane.own_margin_m) return plane.own_margin_m;
  if (requirement.origin.pack.empty() || context.space == nullptr) return std::nullopt;
  for (const RulePack& pack : context.packs) {
    if (pack.full_id() != requirement.origin.pack) continue;
    const RuleCheck* check = pack.find_check(requirement.origin.check);
    const RulePlane* role = check == nullptr ? nullptr : pack.find_plane(check->role);
    if (role == nullptr) return std::nullopt;
    const double strip_m = margin_in_room_m(*role, room_width_m(*context.space, role->narrow_m));
    return strip_m < role->margin_m ? std::optional(strip_m) : std::nullopt;
  }
  return std::nullopt;
}

// Remembers elements, because copies of a workplace share an element whose errors are reported
// once.
class ElementsOnce {
 public:
  std::vector<Requirement> read(const calc::RequirementText& text,
                                const RequirementContext& context, calc::Diagnostics& diagnostics) {
    const calc::SourceLocation& where = text.element.where;
    const auto key = std::tuple(where.file, where.line, where.column, text.role);
    if (wrong_.contains(key)) return {};
    const std::size_t errors = diagnostics.error_count();
    std::vector<Requirement> requirements = read_requirement(text, context, diagnostics);
    if (diagnostics.error_count() > errors) wrong_.insert(key);
    return requirements;
  }

 private:
  std::set<std::tuple<std::string, int, int, std::string>> wrong_;
};

// Why the real light may differ from the calculated light: it may be more, or more or less.
struct OtherLight {
  calc::Message missing, unsure;  // "" = it is as calculated
};

// Returns doubts about a lit luminaire whose table ends within its light: the light beyond is not
// known. With a flux of its own, the light within is not known either, because the table has an
// unknown share of that flux.
OtherLight light_beyond_tables(const calc::Project& project, const calc::Space& space,
                               const calc::LightScene* scene) {
  OtherLight other;
  for (const calc::Luminaire& luminaire : space.road ? space.road->rows : space.luminaires) {
    const calc::LuminaireType& type = project.luminaire_types[luminaire.type];
    const double share = project.webs[type.web].source().open_end_share;
    if (!(share > 0.0) || !(calc::level_in_scene(scene, luminaire.group) > 0.0)) continue;
    if (other.missing.empty()) {
      other.missing = calc::say<calc::Sentence::light_beyond_table>(type.id, 100.0 * share);
    }
    if (type.flux_scale != 1.0) {
      other.unsure = calc::say<calc::Sentence::flux_of_part_of_table>(type.id, 100.0 * share);
      break;
    }
  }
  return other;
}

OtherLight other_light(const calc::Project& project, const calc::Space& space,
                       const calc::LightScene* scene) {
  OtherLight other = light_beyond_tables(project, space, scene);
  if (!other.missing.empty()) return other;
  if (const calc::Luminaire* lost = calc::luminaire_of_lost_light(project, space, scene)) {
    other.missing = calc::say<calc::Sentence::light_is_lost>(lost->id);
  }
  return other;
}

// Facts about a space before any light.
class SpaceValues {
 public:
  SpaceValues(const calc::Project& project, const calc::Space& space)
      : project_(project),
        space_(space),
        power(calc::installed_power(project, space)),
        energy(calc::lighting_energy(project, space, power)) {}

  // Of a scene of the project, or "".
  const calc::RoomUgr& ugr(const std::string& scene) {
    return known(ugr_, scene, [&](const calc::LightScene* levels) {
      return calc::room_ugr(project_, space_, levels);
    });
  }
  // Returns the veil at eyes above the points of a plane of the space.
  calc::Estimate veiling(const calc::CalcPlane& plane, const std::string& scene) {
    const std::vector<glm::dvec3>& points_m = points_of(plane).position_m;
    return known(veiling_, scene, [&](const calc::LightScene* levels) {
      return calc::field_veiling(project_, space_, levels, points_m,
                                 std::get<calc::PlanarArea>(plane.area).u);
    });
  }
  void set_luminaires(const calc::CalcPlane& plane, Requirement& requirement) {
    const std::string& scene = requirement.scene;
    set_luminaire_value(
        {project_, space_, scene_named(scene),
         [&](AngleZone zone) -> const std::vector<calc::ZoneIntensity>& {
           return known(zone_intensities_[zone], scene, [&](const calc::LightScene* levels) {
             return calc::zone_intensities(project_, space_, levels, zone.from_deg, zone.to_deg);
           });
         },
         [&]() -> const std::vector<MountingHeight>& { return heights_over(plane); },
         [&] {
           return known(upward_, scene, [&](const calc::LightScene* levels) {
             return calc::upward_share_percent(project_, space_, levels);
           });
         },
         [&]() -> const PlanePoints& { return points_of(plane); }},
        requirement);
  }
  void set_colour_rendering(Requirement& requirement) const {
    rules::set_colour_rendering(project_, space_, scene_named(requirement.scene), requirement);
  }
  // Returns Requirement::missing_light and unsure_light for a plane of the space.
  OtherLight other_light_on(const calc::CalcPlane& plane, const std::string& scene) {
    OtherLight other = known(other_light_, scene, [&](const calc::LightScene* levels) {
      return other_light(project_, space_, levels);
    });
    const bool has_rooms =
        space_.is_open_space() &&
        std::any_of(project_.spaces.begin(), project_.spaces.end(),
                    [](const calc::Space& space) { return space.shell.has_value(); });
    if (!other.unsure.empty() || !has_rooms) return other;
    const std::vector<glm::dvec3>& points_m = points_of(plane).position_m;
    const calc::Space* hiding = known(hiding_, scene, [&](const calc::LightScene* levels) {
      return calc::room_between(project_, space_, points_m, levels);
    });
    if (hiding != nullptr) {
      other.unsure = calc::say<calc::Sentence::room_throws_no_shadow>(hiding->id);
    }
    return other;
  }
  std::size_t luminaires() const { return space_.luminaires.size(); }
  // Null: the space is no road.
  const calc::RoadValues* road(const std::string& scene) {
    if (!space_.road) return nullptr;
    return &known(road_, scene, [&](const calc::LightScene* levels) {
      return calc::road_values(project_, space_, levels);
    });
  }

 private:
  template <class Value, class Calculate>
  const Value& known(std::map<std::string, Value>& by_scene, const std::string& scene,
                     Calculate calculate) {
    const auto there = by_scene.find(scene);
    if (there != by_scene.end()) return there->second;
    return by_scene.emplace(scene, calculate(scene_named(scene))).first->second;
  }

  const calc::LightScene* scene_named(const std::string& scene) const {
    const auto found =
        std::find_if(project_.scenes.begin(), project_.scenes.end(),
                     [&](const calc::LightScene& candidate) { return candidate.id == scene; });
    return found == project_.scenes.end() ? nullptr : &*found;
  }

  // Of one plane after the other, as points are.
  const std::vector<MountingHeight>& heights_over(const calc::CalcPlane& plane) {
    if (heights_of_ == &plane) return heights_;
    heights_of_ = &plane;
    heights_ = mounting_heights_m(space_, plane);
    return heights_;
  }

  // Of one plane after the other.
  const PlanePoints& points_of(const calc::CalcPlane& plane) {
    if (plane_ == &plane) return points_;
    plane_ = &plane;
    veiling_.clear();
    hiding_.clear();
    calc::Diagnostics said;  // where the plane is made to be calculated
    const auto grid = calc::make_sensor_grid(plane, space_, said);
    points_ = grid ? PlanePoints{grid->position_m, grid->normal} : PlanePoints{};
    return points_;
  }

  const calc::Project& project_;
  const calc::Space& space_;
  std::map<std::string, calc::RoomUgr> ugr_;      // by scene
  std::map<std::string, calc::RoadValues> road_;  // by scene
  std::map<std::string, calc::Estimate> upward_;  // by scene
  std::map<AngleZone, std::map<std::string, std::vector<calc::ZoneIntensity>>> zone_intensities_;
  const calc::CalcPlane* plane_ = nullptr;  // that these are of
  PlanePoints points_;
  const calc::CalcPlane* heights_of_ = nullptr;  // the same
  std::vector<MountingHeight> heights_;
  std::map<std::string, calc::Estimate> veiling_;     // by scene
  std::map<std::string, OtherLight> other_light_;     // by scene
  std::map<std::string, const calc::Space*> hiding_;  // by scene, of one plane after the other

 public:
  const calc::InstalledPower power;
  const calc::LightingEnergy energy;
};

void set_ugr(const calc::RoomUgr& ugr, Requirement& requirement) {
  if (requirement.problem.empty()) requirement.problem = ugr.problem;
  requirement.of_space = ugr.ugr;
  add_note(ugr.words, requirement);
}

void set_power(const SpaceValues& of_space, Requirement& requirement) {
  const bool is_energy = requirement.metric == Metric::leni;
  if (requirement.problem.empty()) {
    requirement.problem = is_energy ? of_space.energy.problem : of_space.power.problem();
  }
  const double density_w_m2 = of_space.power.density_w_m2().value_or(0.0);
  if (auto* power = std::get_if<SpacePower>(&requirement.arguments)) {
    power->density_w_m2 = density_w_m2;
    return;
  }
  const double known = is_energy ? of_space.energy.leni_kwh_m2 : density_w_m2;
  requirement.of_space = {known, known, known};
  if (!is_energy) return;
  requirement.stated_words = of_space.energy.words;
  add_note(of_space.energy.words, requirement);
}

const calc::RoadValue& road_value(const calc::RoadValues& road, Metric metric) {
  switch (metric) {
    case Metric::road_luminance:
      return road.luminance_cd_m2;
    case Metric::road_uniformity:
      return road.uo;
    case Metric::road_lengthwise:
      return road.ul;
    case Metric::threshold_increment:
      return road.ti_percent;
    case Metric::edge_ratio:
      return road.rei;
    default:
      throw std::logic_error("this is not of a road");
  }
}

// Sets a value of the road. road: null for a plane of another space, which the reader has refused.
void set_road(const calc::RoadValues* road, Requirement& requirement) {
  if (road == nullptr) return;
  requirement.stated_words = road->stated;
  const bool is_of_row = !requirement.origin.pack.empty();
  if (is_of_row && requirement.problem.empty()) requirement.problem = road->why_no_row;
  const calc::RoadValue& value = road_value(*road, requirement.metric);
  if (requirement.problem.empty()) requirement.problem = value.problem;
  requirement.of_space = value.value;
  add_note(value.words, requirement);
  add_note(road->words, requirement);
}

// Returns why this plane has no GR; "" = it has.
calc::Message why_no_field(const calc::CalcPlane& plane, std::size_t luminaire_count,
                           const LitField& field) {
  constexpr double kLevel = 0.9998;  // cosine of one degree
  const auto* area = std::get_if<calc::PlanarArea>(&plane.area);
  const bool is_level = area != nullptr && plane.usual_role.empty() && area->normal().z >= kLevel &&
                        plane.kernel == calc::ReceiverKernel::planar &&
                        plane.derived == calc::DerivedQuantity::none;
  if (!is_level) return calc::say<calc::Sentence::no_field>();
  if (!(field.reflectance > 0.0)) return calc::say<calc::Sentence::no_field_reflectance>();
  // No veil of nothing that is there is no rating that anybody has judged.
  if (luminaire_count == 0) return calc::say<calc::Sentence::no_luminaire>();
  const double points = calc::planned_points(plane);
  const auto luminaires = static_cast<double>(luminaire_count);
  return points * luminaires <= calc::kMostFieldPairs
             ? calc::Message()
             : calc::say<calc::Sentence::field_too_many>(points, luminaires, calc::kMostFieldPairs);
}

void set_field_glare(SpaceValues& of_space, const calc::CalcPlane& plane,
                     Requirement& requirement) {
  auto& field = std::get<LitField>(requirement.arguments);
  if (requirement.problem.empty()) {
    requirement.problem = why_no_field(plane, of_space.luminaires(), field);
  }
  if (!requirement.problem.empty()) return;
  field.veiling_cd_m2 = of_space.veiling(plane, requirement.scene);
  requirement.stated_words = calc::say<calc::Sentence::field_stated>(field.reflectance);
  add_note(calc::say<calc::Sentence::field_glare_method>(calc::kFieldEye_m, calc::kFieldLook_deg,
                                                         field.reflectance),
           requirement);
}

// Refuses glare of a row on other areas than the row's own.
void refuse_glare_elsewhere(std::vector<Requirement>& of_plane) {
  for (Requirement& requirement : of_plane) {
    const RuleOrigin& origin = requirement.origin;
    if (requirement.metric != Metric::glare_rating || origin.pack.empty()) continue;
    if (requirement.problem.empty() && area_of(requirement, of_plane) == nullptr) {
      requirement.problem = calc::say<calc::Sentence::field_glare_elsewhere>();
    }
  }
}

void set_space_value(SpaceValues& of_space, const calc::CalcPlane& plane,
                     Requirement& requirement) {
  if (requirement.metric == Metric::glare_rating) {
    set_field_glare(of_space, plane, requirement);
    return;
  }
  if (requirement.metric == Metric::ugr_table) {
    set_ugr(of_space.ugr(requirement.scene), requirement);
  } else if (is_of_luminaires(requirement.metric)) {
    of_space.set_luminaires(plane, requirement);
  } else if (is_of_road(requirement.metric)) {
    set_road(of_space.road(requirement.scene), requirement);
  } else if (requirement.metric == Metric::colour_rendering) {
    of_space.set_colour_rendering(requirement);
  } else {
    set_power(of_space, requirement);
  }
}

void bind_plane(const calc::CalcPlane& plane, const RequirementContext& context,
                SpaceValues& of_space, ElementsOnce& elements, calc::Diagnostics& diagnostics,
                std::vector<Requirement>& bound) {
  RequirementIds ids(plane.requirements, diagnostics);
  calc::FormerIds former("requirement");
  std::vector<Requirement> of_plane;
  for (const calc::RequirementText& text : plane.requirements) {
    for (Requirement& requirement : elements.read(text, context, diagnostics)) {
      requirement.plane_id = plane.id;
      if (const auto strip_m = narrower_strip_m(plane, requirement, context)) {
        narrow_strips(requirement.mask, *strip_m);
      }
      requirement.mask_words = mask_words(requirement.mask, plane.travel);
      if (is_about_space(requirement.metric)) set_space_value(of_space, plane, requirement);
      if (requirement.is_optional && !requirement.problem.empty()) continue;
      if (is_of_light(requirement.metric)) {
        OtherLight other = of_space.other_light_on(plane, requirement.scene);
        requirement.missing_light = std::move(other.missing);
        requirement.unsure_light = std::move(other.unsure);
      }
      if (requirement.id.empty()) requirement.id = ids.next_for(requirement.metric);
      former.add(requirement.id, requirement.where.line, requirement.was, requirement.where);
      of_plane.push_back(std::move(requirement));
    }
  }
  former.check(diagnostics);
  refuse_glare_elsewhere(of_plane);
  std::move(of_plane.begin(), of_plane.end(), std::back_inserter(bound));
}

// Warns about own limits compared with light that never fades. Requirements of rule packs are then
// not judged: see rules/applicability.
void warn_about_maintenance(const calc::Project& project, const std::vector<Requirement>& bound,
                            calc::Diagnostics& diagnostics) {
  const auto is_own_and_maintained = [](const Requirement& requirement) {
    return requirement.origin.pack.empty() && requirement.state != LightState::initial &&
           (!is_of_space(requirement.metric) || is_of_road(requirement.metric));
  };
  if (std::any_of(bound.begin(), bound.end(), is_own_and_maintained))
    report_unstated_maintenance(project, diagnostics);
}

LightSources sources_of(const Requirement& requirement, const std::vector<RulePack>& packs) {
  for (const RulePack& pack : packs) {
    if (pack.full_id() != requirement.origin.pack) continue;
    const RuleCheck* check = pack.find_check(requirement.origin.check);
    if (check != nullptr) return check->sources;
  }
  return LightSources::all;
}

double level_in(const calc::LightScene& scene, const std::string& group) {
  for (const auto& [named, level] : scene.level_of_group) {
    if (named == group) return level;
  }
  return 1.0;
}

// Returns the groups of the space that a scene lights for emergencies while it switches others off.
std::vector<std::string> emergency_groups(const calc::Space& space, const calc::LightScene& scene) {
  std::vector<std::string> lit;
  bool puts_out = false;
  for (const calc::Luminaire& luminaire : space.luminaires) {
    const std::string& group = luminaire.group;
    if (level_in(scene, group) == 0.0) {
      puts_out = true;
    } else if (!group.empty() && std::find(lit.begin(), lit.end(), group) == lit.end()) {
      lit.push_back(group);
    }
  }
  return puts_out ? lit : std::vector<std::string>();
}

// What is asked without a scene is asked of all luminaires at full output, and those of the
// emergency are among them: right where they are always on, and else a false pass.
void warn_about_emergency_light(const calc::Project& project, const std::vector<RulePack>& packs,
                                const std::vector<Requirement>& bound,
                                calc::Diagnostics& diagnostics) {
  constexpr std::size_t kMostNamed = 4;
  for (const calc::Space& space : project.spaces) {
    const auto is_here = [&](const Requirement& requirement) {
      return std::any_of(space.planes.begin(), space.planes.end(),
                         [&](const auto& plane) { return plane.id == requirement.plane_id; });
    };
    const calc::LightScene* scene = nullptr;
    const Requirement* first = nullptr;
    for (const Requirement& requirement : bound) {
      if (!is_here(requirement)) continue;
      if (sources_of(requirement, packs) == LightSources::emergency) {
        const auto its =
            std::find_if(project.scenes.begin(), project.scenes.end(),
                         [&](const calc::LightScene& one) { return one.id == requirement.scene; });
        if (scene == nullptr && its != project.scenes.end()) scene = &*its;
      } else if (requirement.scene.empty() && !is_of_space(requirement.metric)) {
        if (first == nullptr) first = &requirement;
      }
    }
    if (scene == nullptr || first == nullptr) continue;
    std::vector<std::string> groups = emergency_groups(space, *scene);
    if (groups.empty()) continue;
    for (std::string& group : groups) group = "'" + group + "'";
    diagnostics.report(calc::DiagnosticId::emergency_light_counts, first->where,
                       space.id.empty() ? first->plane_id : space.id, groups.size() == 1 ? "" : "s",
                       calc::list_names(groups, kMostNamed), scene->id);
  }
}

}  // namespace

void report_unstated_maintenance(const calc::Project& project, calc::Diagnostics& diagnostics) {
  constexpr std::size_t kMostNamed = 3;
  std::vector<std::string> names;
  const calc::LuminaireType* first = nullptr;
  for (std::size_t t = 0; t < project.luminaire_types.size(); ++t) {
    const calc::LuminaireType& type = project.luminaire_types[t];
    const bool is_used =
        std::any_of(project.spaces.begin(), project.spaces.end(), [&](const calc::Space& space) {
          return std::any_of(space.luminaires.begin(), space.luminaires.end(),
                             [&](const calc::Luminaire& luminaire) { return luminaire.type == t; });
        });
    if (!is_used || type.maintenance.is_stated || !type.counts_as_luminaire()) continue;
    if (first == nullptr) first = &type;
    names.push_back("'" + type.id + "'");
  }
  if (first == nullptr) return;
  diagnostics.report(calc::DiagnosticId::maintenance_not_stated, first->where,
                     names.size() == 1 ? "" : "s", calc::list_names(names, kMostNamed));
}

std::vector<Requirement> bind_requirements(const calc::Project& project,
                                           const std::vector<RulePack>& packs,
                                           calc::Diagnostics& diagnostics) {
  std::vector<Requirement> bound;
  ElementsOnce elements;
  for (const calc::Space& space : project.spaces) {
    SpaceValues of_space(project, space);
    for (const calc::CalcPlane& plane : space.planes) {
      bind_plane(plane,
                 {plane.kernel, project.scenes, packs, &space, plane.derived, plane.usual_role},
                 of_space, elements, diagnostics, bound);
    }
  }
  warn_about_maintenance(project, bound, diagnostics);
  warn_about_emergency_light(project, packs, bound, diagnostics);
  return bound;
}

void check_requirements(const calc::Project& project, const std::vector<RulePack>& packs,
                        calc::Diagnostics& diagnostics) {
  ElementsOnce elements;
  for (const calc::Space& space : project.spaces) {
    for (const calc::CalcPlane& plane : space.planes) {
      const RequirementContext context{
          plane.kernel,     project.scenes,         packs, nullptr, plane.derived,
          plane.usual_role, plane.is_quantity_known};
      const RequirementIds ids(plane.requirements, diagnostics);
      for (const calc::RequirementText& text : plane.requirements) {
        elements.read(text, context, diagnostics);
      }
    }
  }
}

std::vector<Requirement> requirements_of_left_out(const calc::Project& project,
                                                  const calc::Space& space,
                                                  const calc::CalcPlane& plane,
                                                  const std::vector<RulePack>& packs) {
  SpaceValues of_space(project, space);
  std::vector<Requirement> bound;
  ElementsOnce elements;
  calc::Diagnostics said;  // where the other planes of the workplace were bound
  bind_plane(plane, {plane.kernel, project.scenes, packs, &space, plane.derived, plane.usual_role},
             of_space, elements, said, bound);
  return bound;
}

std::vector<Requirement> requirements_of_plane(const std::vector<Requirement>& requirements,
                                               std::string_view plane_id) {
  std::vector<Requirement> own;
  for (const Requirement& requirement : requirements) {
    if (requirement.plane_id == plane_id) own.push_back(requirement);
  }
  return own;
}

}  // namespace rules
