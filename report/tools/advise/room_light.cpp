#include "report/tools/advise/room_light.h"

#include "calc/base/statistics.h"
#include "calc/radiosity/sampling/grid_receivers.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/scene_level.h"
#include "calc/scene/separate_luminaires.h"
#include "report/text/words.h"
#include "rules/catalogue/mask.h"
#include "rules/measure/metrics.h"
#include "rules/measure/replicate_sample.h"
#include "rules/verdict/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <variant>

namespace cli {
namespace {

// Of a least value: spread over all that may be the least one once the darkest are lit.
constexpr std::size_t kMostDarkPoints = 16;
constexpr double kMayBeLeast = 1.5;  // of the limit
// Of each batch: of all targets together, and of one.
constexpr std::size_t kMostPathsOfAll = 4096;
constexpr std::uint32_t kFewestPaths = 32;

const calc::LightScene* light_scene_of(const calc::Project& project, const std::string& id) {
  for (const calc::LightScene& scene : project.scenes) {
    if (scene.id == id) return &scene;
  }
  return nullptr;
}

// Empty: it is about to be followed.
std::string why_not_followed(const rules::Requirement& requirement, const calc::SensorGrid& grid) {
  if (grid.derived != calc::DerivedQuantity::none || grid.kernel != calc::ReceiverKernel::planar) {
    return "not an illuminance of a flat plane";
  }
  if (requirement.direct_only) return "only direct light";
  if (requirement.any_one_unit_out) return "with any one luminaire out";
  if (requirement.state == rules::LightState::end_of_duration)
    return "end of the battery's duration";
  switch (requirement.metric) {
    case rules::Metric::average:
    case rules::Metric::minimum:
    case rules::Metric::value_at_point:
      return "";
    default:
      return "not an average, a least value or a value at a point";
  }
}

// The darkest one, then always the one that is farthest from all that are chosen.
std::vector<std::size_t> darkest(const calc::SensorGrid& grid,
                                 const std::vector<std::size_t>& points,
                                 const std::vector<double>& lx, double limit) {
  std::vector<std::size_t> chosen{
      static_cast<std::size_t>(std::min_element(lx.begin(), lx.end()) - lx.begin())};
  while (chosen.size() < kMostDarkPoints) {
    std::optional<std::size_t> farthest;
    double distance_m = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (lx[i] >= kMayBeLeast * limit) continue;
      double nearest_m = std::numeric_limits<double>::infinity();
      for (const std::size_t other : chosen) {
        nearest_m = std::min(
            nearest_m, glm::length(grid.position_m[points[i]] - grid.position_m[points[other]]));
      }
      if (nearest_m <= distance_m) continue;
      distance_m = nearest_m;
      farthest = i;
    }
    if (!farthest) break;
    chosen.push_back(*farthest);
  }
  return chosen;
}

// Targets are numbered by names, so that their random numbers are the same in any order of planes.
std::vector<AskedOfRoom*> by_name(const RoomQuestions& questions, const calc::Space& space,
                                  std::vector<AskedOfRoom>& asked) {
  const auto room =
      std::find_if(questions.part.spaces.begin(), questions.part.spaces.end(),
                   [&](const report::SpacePart& part) { return part.id == space.id; });
  const auto name = [&](const AskedOfRoom& one) {
    return std::tie(room->planes[one.plane].id, one.told.before.requirement.id);
  };
  std::vector<AskedOfRoom*> sorted;
  for (AskedOfRoom& one : asked) sorted.push_back(&one);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const AskedOfRoom* a, const AskedOfRoom* b) { return name(*a) < name(*b); });
  return sorted;
}

// Points and values of the scene; false: not to be told.
bool take_points(const RoomQuestions& questions, const std::string& scene, const PlaneLight& light,
                 const rules::Requirement& requirement, AskedOfRoom& asked) {
  const rules::MaskedPoints masked = rules::apply_mask(requirement.mask, light.grid);
  if (!masked.problem.empty() || masked.points.empty()) return false;
  const calc::LightScene* levels = light_scene_of(questions.project, scene);
  const rules::PointValues values = rules::select_points(
      rules::combine_channels(light.field, requirement.state,
                              levels == nullptr ? std::vector<std::pair<std::string, double>>()
                                                : levels->level_of_group),
      masked.points);
  const rules::ReplicateSample sample = rules::summarize(values, 0, values.replicates);
  asked.grid = &light.grid;
  asked.told.of_points = masked.points.size();
  asked.is_mean = requirement.metric == rules::Metric::average;
  if (asked.is_mean) {
    asked.points = masked.points;
    asked.value_lx = {sample.plane_mean_lx};
    return true;
  }
  std::vector<std::size_t> chosen;
  if (requirement.metric == rules::Metric::value_at_point) {
    const auto& asked_at = std::get<rules::PointOfValue>(requirement.arguments);
    const auto distance = [&](std::size_t point) {
      return glm::length(light.grid.position_m[point] - asked_at.point_m.value());
    };
    const auto nearest =
        std::min_element(masked.points.begin(), masked.points.end(),
                         [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    chosen = {static_cast<std::size_t>(nearest - masked.points.begin())};
    asked.told.of_points = 1;
  } else {
    chosen = darkest(light.grid, masked.points, sample.mean_lx, requirement.limit);
  }
  for (const std::size_t i : chosen) {
    asked.points.push_back(masked.points[i]);
    asked.value_lx.push_back(sample.mean_lx[i]);
  }
  asked.told.points = asked.points.size();
  return true;
}

}  // namespace

std::vector<AskedOfRoom> asked_of_room(const RoomQuestions& questions, std::size_t space,
                                       const std::string& scene, bool only_lacking,
                                       std::vector<std::string>& left_out) {
  std::vector<AskedOfRoom> all;
  const report::SpacePart& room = questions.part.spaces[space];
  for (std::size_t p = 0; p < room.planes.size(); ++p) {
    const report::PlanePart& plane = room.planes[p];
    for (std::size_t f = 0; f < plane.findings.size(); ++f) {
      const rules::Finding& finding = plane.findings[f];
      const rules::Requirement& requirement = finding.requirement;
      if (requirement.scene != scene || !rules::counts(rules::outcome_of(finding)) ||
          !rules::is_lower_limit(requirement.comparison) ||
          finding.verdict == rules::Verdict::not_judged ||
          (only_lacking && finding.verdict == rules::Verdict::pass)) {
        continue;
      }
      AskedOfRoom asked;
      asked.plane = p;
      asked.finding = f;
      asked.told.plane = report::title_of(plane.name, plane.id);
      asked.told.before = finding;
      asked.lack_lx = requirement.limit - finding.measured.low;
      const auto light = questions.light.find(plane.id);
      std::string why = "its light is not known";
      if (light != questions.light.end() && light->second.field.problem.empty()) {
        why = why_not_followed(requirement, light->second.grid);
        if (why.empty() && !take_points(questions, scene, light->second, requirement, asked)) {
          why = "no point counts";
        }
      }
      if (why.empty()) {
        all.push_back(std::move(asked));
      } else if (only_lacking) {
        left_out.push_back(fmt::format("{}, {}: {}", asked.told.plane, requirement.id, why));
      }
    }
  }
  return all;
}

RoomLight::RoomLight(const RoomQuestions& questions, const calc::Space& space,
                     const std::string& scene, std::vector<AskedOfRoom>& asked,
                     const std::vector<calc::Luminaire>& luminaires,
                     const std::vector<std::string>& surfaces)
    : scene_(light_scene_of(questions.project, scene)), confidence_(questions.confidence) {
  calc::Space with_these = space;
  with_these.luminaires = luminaires;
  calc::PreparedScene prepared = calc::prepare_scene(questions.project, with_these);
  calc::separate_luminaires(prepared);
  channels_ = prepared.channels;
  const calc::Tracer tracer(prepared);
  std::vector<calc::ImportanceTarget> targets;
  for (AskedOfRoom* const sorted : by_name(questions, space, asked)) {
    AskedOfRoom& one = *sorted;
    const std::vector<calc::Receiver> receivers = calc::receivers_of(tracer, *one.grid);
    const std::vector<double> weights = calc::point_weights(*one.grid);
    one.first_target = targets.size();
    calc::ImportanceTarget target;
    for (const std::size_t point : one.points) {
      target.receiver.push_back(receivers[point]);
      if (!weights.empty()) target.weight.push_back(weights[point]);
      if (!one.is_mean) targets.push_back(std::exchange(target, {}));
    }
    if (one.is_mean) targets.push_back(std::move(target));
  }
  calc::SurfaceClasses classes;
  if (!surfaces.empty()) {
    classes.count = surfaces.size();
    classes.step = kReflectanceStep;
    for (const std::uint32_t body : prepared.body) {
      const auto found = std::find(surfaces.begin(), surfaces.end(),
                                   surface_of_body(space, prepared.body_id[body]));
      classes.of_triangle.push_back(found == surfaces.end()
                                        ? calc::kNoClass
                                        : static_cast<std::uint32_t>(found - surfaces.begin()));
    }
  }
  // With many targets each is known less well, and all together take no longer.
  calc::ImportanceSettings importance = questions.importance;
  while (importance.paths > kFewestPaths && importance.paths * targets.size() > kMostPathsOfAll) {
    importance.paths /= 2;
  }
  const calc::ImportancePool pool = calc::trace_importance(tracer, targets, classes, importance);
  light_ = calc::light_of_luminaires(tracer, targets, pool, importance);
}

double RoomLight::weight(const AskedOfRoom& asked, std::size_t luminaire) const {
  const calc::LightChannel& channel = channels_[luminaire];
  const double level = calc::level_in_scene(scene_, channel.group);
  const bool is_new = asked.told.before.requirement.state == rules::LightState::initial;
  return is_new ? level : level * channel.maintenance_factor;
}

// batch_lx(batch, target): what is added there. Of a least value what is the least afterwards.
template <class Batch>
calc::Estimate RoomLight::grown(const AskedOfRoom& asked, const Batch& batch_lx) const {
  std::optional<calc::Estimate> least;
  const double before = *std::min_element(asked.value_lx.begin(), asked.value_lx.end());
  for (std::size_t i = 0; i < asked.value_lx.size(); ++i) {
    std::vector<double> batches;
    for (std::size_t b = 0; b < light_.batches; ++b) {
      batches.push_back(batch_lx(b, asked.first_target + i));
    }
    calc::Estimate gain = calc::t_interval(batches, confidence_);
    const double more = asked.value_lx[i] - before;
    gain = {gain.value + more, gain.low + more, gain.high + more};
    if (!least || gain.value < least->value) least = gain;
  }
  return *least;
}

calc::Estimate RoomLight::gain_lx(const AskedOfRoom& asked, std::size_t luminaire) const {
  return grown(asked, [&](std::size_t batch, std::size_t target) {
    return weight(asked, luminaire) * light_.total_lx(batch, target, luminaire);
  });
}

calc::Estimate RoomLight::gain_instead_lx(const AskedOfRoom& asked, std::size_t luminaire,
                                          std::size_t of) const {
  return grown(asked, [&](std::size_t batch, std::size_t target) {
    return weight(asked, luminaire) * light_.total_lx(batch, target, luminaire) -
           weight(asked, of) * light_.total_lx(batch, target, of);
  });
}

std::vector<double> RoomLight::added_lx(const AskedOfRoom& asked, std::size_t luminaire) const {
  std::vector<double> lx(asked.value_lx.size());
  for (std::size_t i = 0; i < lx.size(); ++i) {
    for (std::size_t b = 0; b < light_.batches; ++b) {
      lx[i] += light_.total_lx(b, asked.first_target + i, luminaire);
    }
    lx[i] *= weight(asked, luminaire) / static_cast<double>(light_.batches);
  }
  return lx;
}

calc::Estimate RoomLight::surface_lx(const AskedOfRoom& asked, std::size_t surface,
                                     bool is_slope) const {
  const std::vector<double>& lx = is_slope ? light_.slope_lx : light_.step_lx;
  const double factor = is_slope ? kReflectanceStep : 1.0;
  return grown(asked, [&](std::size_t batch, std::size_t target) {
    double sum = 0.0;
    for (std::size_t l = 0; l < light_.luminaires; ++l) {
      sum += factor * weight(asked, l) * lx[light_.class_index(batch, target, surface, l)];
    }
    return sum;
  });
}

std::string surface_of_body(const calc::Space& room, const std::string& body) {
  if (!room.shell) return "";
  if (body == room.id + ".floor") return "floor";
  if (body == room.id + ".ceiling") return "ceiling";
  for (std::size_t i = 1; i <= room.shell->footprint_m.size(); ++i) {
    if (body == fmt::format("{}.wall{}", room.id, i)) return "walls";
  }
  return "";
}

std::string unused_luminaire_id(const calc::Project& project, const std::string& wish) {
  std::string id = wish;
  const auto is_taken = [&] {
    return std::any_of(project.spaces.begin(), project.spaces.end(), [&](const calc::Space& space) {
      return std::any_of(space.luminaires.begin(), space.luminaires.end(),
                         [&](const calc::Luminaire& one) {
                           // Of grids and lists: "id[3]", "id.3"
                           return one.id.starts_with(id);
                         });
    });
  };
  while (is_taken()) id += "-x";
  return id;
}

PassCount count_passes(const report::ProjectPart& part, const std::string& scene) {
  PassCount count;
  for (const FindingPlace& where : counted_findings(part)) {
    const rules::Finding& finding = finding_at(part, where);
    if (finding.requirement.scene == scene) count.add(finding);
  }
  return count;
}

const calc::Space* space_of(const RoomQuestions& questions, std::size_t part_index) {
  for (const calc::Space& space : questions.project.spaces) {
    if (space.id == questions.part.spaces[part_index].id) return &space;
  }
  return nullptr;
}

}  // namespace cli
