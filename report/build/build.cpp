#include "report/build/build.h"

#include "calc/base/glare_limits.h"
#include "calc/base/sentences.h"
#include "calc/base/statistics.h"
#include "calc/base/units.h"
#include "calc/scene/luminaire_sums.h"
#include "report/build/build_evidence.h"
#include "report/text/number_format.h"
#include "rules/measure/candidates.h"
#include "rules/measure/derived_metrics.h"
#include "rules/measure/error_spending.h"
#include "rules/measure/measure.h"
#include "rules/measure/metrics.h"
#include "rules/measure/replicate_sample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace report {
namespace {

// Sum over channels of weight x mean over replicates, at one point.
// values: [replicate][channel][point], or empty. weight: [channel].
double weighted_mean(const calc::PlaneField& field, const std::vector<double>& values,
                     const std::vector<double>& weight, std::size_t replicates, std::size_t point) {
  if (values.empty()) return 0.0;
  const std::size_t channels = field.channels.size();
  double sum = 0.0;
  for (std::size_t r = 0; r < replicates; ++r) {
    for (std::size_t c = 0; c < channels; ++c) {
      sum += weight[c] * values[(r * channels + c) * field.points + point];
    }
  }
  return sum / static_cast<double>(replicates);
}

// Of a point: the mean over the receivers that its value is the mean of, or its first one.
double weighted_point(const calc::PlaneField& field, const calc::SensorGrid& grid,
                      const std::vector<double>& values, const std::vector<double>& weight,
                      std::size_t replicates, std::size_t point) {
  if (grid.derived != calc::DerivedQuantity::four_planes) {
    return weighted_mean(field, values, weight, replicates, point);
  }
  const std::size_t parts = calc::receivers_per_point(grid.derived);
  double sum = 0.0;
  for (std::size_t part = 1; part < parts; ++part) {
    sum += weighted_mean(field, values, weight, replicates, part * grid.position_m.size() + point);
  }
  return sum / static_cast<double>(parts - 1);
}

double direct_at(const calc::PlaneField& field, const calc::SensorGrid& grid,
                 const std::vector<double>& weight, std::size_t point) {
  return weighted_point(field, grid, field.direct_exact_lx, weight, 1, point) +
         weighted_point(field, grid, field.direct_sampled_lx, weight, field.replicates, point);
}

std::vector<double> maintenance_of(const calc::PlaneField& field) {
  std::vector<double> factor;
  for (const calc::LightChannel& channel : field.channels) {
    factor.push_back(channel.maintenance_factor);
  }
  return factor;
}

std::vector<PointRow> build_points(const calc::SensorGrid& grid, const calc::PlaneField& field,
                                   const std::vector<calc::Estimate>& estimates) {
  std::vector<PointRow> rows(grid.position_m.size());
  const std::vector<double> weight = maintenance_of(field);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    PointRow& row = rows[i];
    row.position_m = grid.position_m[i];
    row.normal = grid.normal[i];
    row.column = grid.column.empty() ? 0 : grid.column[i];
    row.row = grid.row.empty() ? 0 : grid.row[i];
    row.measured = estimates[i];
    row.direct_lx = direct_at(field, grid, weight, i);
    row.indirect_lx = weighted_point(field, grid, field.indirect_lx, weight, field.replicates, i);
  }
  return rows;
}

// Outlines are kept relative to the area's origin; the document wants them from the grid's.
std::vector<glm::dvec2> from_grid_origin(const std::vector<glm::dvec2>& polygon,
                                         const calc::PlanarArea& area,
                                         const calc::SensorGrid& grid) {
  std::vector<glm::dvec2> moved;
  moved.reserve(polygon.size());
  for (const glm::dvec2& corner : polygon) {
    const glm::dvec3 offset_m =
        area.origin_m + corner.x * area.u + corner.y * area.v - grid.origin_m;
    moved.emplace_back(glm::dot(offset_m, grid.u), glm::dot(offset_m, grid.v));
  }
  return moved;
}

std::string sha256_of(const calc::Project& project, const std::string& file) {
  const auto found = std::find_if(project.inputs.begin(), project.inputs.end(),
                                  [&file](const calc::InputFile& input) {
                                    return input.path == file || input.path.ends_with("/" + file);
                                  });
  return found == project.inputs.end() ? "" : found->sha256;
}

// Of all emitters; 0 where the file does not state it of each.
double stated_flux_lm(const calc::Project& project, const calc::LuminaireType& type) {
  if (type.emitters.empty()) return project.webs[type.web].source().stated_flux_lm;
  double sum_lm = 0.0;
  for (const calc::TypeEmitter& emitter : type.emitters) {
    const calc::LuminaireType& own = project.luminaire_types[emitter.type];
    const double stated_lm = project.webs[own.web].source().stated_flux_lm;
    if (!(stated_lm > 0.0)) return 0.0;
    sum_lm += stated_lm;
  }
  return sum_lm;
}

LuminaireRow build_luminaire(const calc::Project& project, std::size_t type_index) {
  const calc::LuminaireType& type = project.luminaire_types[type_index];
  const calc::PhotometricWeb& web = project.webs[type.web];
  LuminaireRow row;
  row.type_id = type.id;
  row.photometry_file = type.photometry_file;
  row.name = web.source().luminaire_name;
  if (!type.emitters.empty()) row.name += fmt::format(" ({} emitters)", type.emitters.size());
  row.format = web.source().format;
  row.maker = web.source().manufacturer;
  row.article_number = web.source().article_number;
  row.lamp = web.source().lamp;
  row.colour_temperature = web.source().colour_temperature;
  row.colour_rendering = web.source().colour_rendering;
  if (type.package) row.package = type.packages[*type.package].article;
  row.count = calc::luminaires_of_type(project, type_index);
  row.flux_lm = calc::luminaire_flux_lm(project, type);
  row.power_w = type.power_w;
  if (!type.photometry_file.empty()) row.file_flux_lm = row.flux_lm / type.flux_scale;
  row.file_power_w = type.file_power_w;
  row.stated_flux_lm = stated_flux_lm(project, type);
  row.max_intensity_cd = calc::luminaire_peak_cd(project, type);
  row.maintenance_factor = type.maintenance.product;
  row.maintenance = type.maintenance;
  if (type.housing) {
    row.housing_material = project.materials[type.housing->material].id;
    row.housing_depth_m = type.housing->depth_m;
  }
  row.sha256 = sha256_of(project, type.photometry_file);
  row.c0_cd = polar_curve(project, type, 0.0);
  row.c90_cd = polar_curve(project, type, 0.5 * calc::kPi);
  return row;
}

PlanePart named_plane(const calc::CalcPlane& plane, std::vector<rules::Finding> findings) {
  PlanePart part;
  part.id = plane.id;
  part.was = plane.was;
  part.name = plane.name;
  part.where = plane.where;
  part.kernel = plane.kernel;
  part.derived = plane.derived;
  part.made_by = plane.made_by;
  part.changed = plane.changed;
  part.findings = std::move(findings);
  return part;
}

// Points of which a receiver is so; receivers of point i are at i, i + points, ...
template <class Marks, class IsSo>
std::size_t count_points(const Marks& marks, std::size_t points, const IsSo& is_so) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < points; ++i) {
    bool found = false;
    for (std::size_t k = i; k < marks.size() && !found; k += points) found = is_so(marks[k]);
    if (found) ++count;
  }
  return count;
}

void count_doubt(const calc::PlaneField& field, PlanePart& part) {
  const std::size_t points = part.grid.position_m.size();
  part.unseen_points =
      count_points(field.unseen, points, [](std::uint8_t mark) { return mark != 0; });
  part.single_sample_points = count_points(
      field.largest_share, points, [](float share) { return share > rules::kLargestTrustedShare; });
}

// Of a plane, or of its AskedLight.
template <class Part>
void add_statistics(const rules::PointValues& values, double confidence, Part& part) {
  // A quantity that does not exist (the uniformity of a dark plane) is not a number; renderers show
  // a dash.
  const auto statistic = [&](rules::Metric metric) {
    const auto found = rules::compute_metric(values, metric, 0.0, std::nullopt, confidence);
    if (!found) return no_estimate();
    const calc::Estimate& known = found->estimate;
    // Of darkness 0 and not -0.
    return calc::Estimate{known.value + 0.0, known.low + 0.0, known.high + 0.0};
  };
  part.average = statistic(rules::Metric::average);
  part.minimum = statistic(rules::Metric::minimum);
  part.maximum = statistic(rules::Metric::maximum);
  part.uniformity_min_avg = statistic(rules::Metric::uniformity_min_avg);
  part.uniformity_min_max = statistic(rules::Metric::uniformity_min_max);
}

void add_illuminances(const calc::PlaneField& field, const rules::PointValues& maintained,
                      double confidence, PlanePart& part) {
  part.points = build_points(part.grid, field, rules::point_estimates(maintained, confidence));
  add_statistics(maintained, confidence, part);
}

// Nothing: they ask for several, or for what the plane's own values are of.
std::optional<AskedLight> light_asked_by(const std::vector<rules::Finding>& findings) {
  std::optional<AskedLight> light;
  for (const rules::Finding& finding : findings) {
    const rules::Requirement& asked = finding.requirement;
    if (rules::is_of_space(asked.metric)) continue;
    if (asked.any_one_unit_out) return {};
    if (!light) {
      light.emplace();
      light->scene = asked.scene;
      light->state = asked.state;
      light->direct_only = asked.direct_only;
    }
    if (!light->is_asked_by(asked)) return {};
  }
  if (!light || light->is_asked_by({})) return {};
  return light;
}

void add_asked_light(const calc::PlaneField& field, double confidence,
                     const std::vector<calc::LightScene>& scenes, PlanePart& part) {
  std::optional<AskedLight> light = light_asked_by(part.findings);
  if (!light) return;
  const auto* levels = rules::levels_of(light->scene, scenes);
  if (levels == nullptr) return;
  rules::PointValues values = rules::combine_channels(
      field, light->state, *levels,
      light->direct_only ? rules::LightParts::direct : rules::LightParts::all);
  if (part.grid.derived == calc::DerivedQuantity::four_planes) {
    values = rules::mean_of_four_planes(values);
  }
  const std::vector<calc::Estimate> estimates = rules::point_estimates(values, confidence);
  const std::vector<double> weight = rules::channel_weights(field, light->state, *levels);
  for (std::size_t i = 0; i < part.points.size(); ++i) {
    const double indirect_lx =
        light->direct_only
            ? 0.0
            : weighted_point(field, part.grid, field.indirect_lx, weight, field.replicates, i);
    light->points.push_back({estimates[i], direct_at(field, part.grid, weight, i), indirect_lx});
  }
  add_statistics(values, confidence, *light);
  part.asked_light = std::move(light);
}

calc::Message ratings_remark(const calc::PlaneField& field, const std::vector<double>& weights,
                             const std::vector<std::size_t>& all, std::size_t see_none) {
  calc::Message words = calc::say<calc::Sentence::ugr_method>(calc::kTableOfIndicesDiffers) + "; " +
                        calc::say<calc::Sentence::ugr_background>();
  if (see_none > 0) {
    words += "; " + calc::say<calc::Sentence::observers_see_none>(see_none, all.size());
  }
  const rules::GlareDoubts doubts = rules::glare_doubts(field.glare, weights, all);
  if (doubts.points > 0) {
    words += "; " +
             calc::say<calc::Sentence::observers_in_doubt>(doubts.points, all.size(), doubts.first);
  }
  return words;
}

// Glare is rated for the new installation, when it is worst; ratios as maintained.
void add_ratings(const calc::PlaneField& field, double confidence, PlanePart& part) {
  const calc::DerivedQuantity derived = part.grid.derived;
  const rules::LightState state = derived == calc::DerivedQuantity::ugr
                                      ? rules::LightState::initial
                                      : rules::LightState::maintained;
  const auto weights = rules::channel_weights(field, state, {});
  const rules::PointValues receivers = rules::combine_channels(field, state, {});
  std::vector<std::size_t> all(part.grid.position_m.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto points = rules::make_derived_points(derived, field, receivers, weights, all);
  const double t = rules::one_sided_t(points->replicates(), 0.5 * (1.0 - confidence));
  const bool is_glare = derived == calc::DerivedQuantity::ugr;
  std::vector<calc::Estimate> estimates;
  std::vector<std::size_t> rated;
  std::size_t see_none = 0;  // eyes without any source
  for (const std::size_t i : all) {
    const rules::Limits limits = points->limits(i, t);
    see_none += limits.high == -rules::kInfinity ? 1 : 0;
    const bool has_value = std::isfinite(limits.value);
    if (has_value) rated.push_back(i);
    estimates.push_back(has_value ? calc::Estimate{limits.value, limits.low, limits.high}
                                  : no_estimate());
  }
  part.points = build_points(part.grid, field, estimates);
  part.average = part.uniformity_min_avg = part.uniformity_min_max = no_estimate();
  part.minimum = part.maximum = no_estimate();
  if (is_glare) part.remarks.push_back(ratings_remark(field, weights, all, see_none));
  if (rated.empty()) return;
  const auto chosen = rules::make_derived_points(derived, field, receivers, weights, rated);
  const auto statistic = [&](rules::Metric metric) {
    rules::Requirement wanted;
    wanted.metric = metric;
    return rules::compute_derived(*chosen, wanted, std::nullopt, std::nullopt, confidence)
        ->estimate;
  };
  part.minimum = statistic(rules::Metric::minimum);
  part.maximum = statistic(rules::Metric::maximum);
}

// How far the four planes are from the true integral, on average, with the interval of that.
calc::Message four_planes_remark(const rules::PointValues& receivers, double confidence) {
  const std::vector<double> four = rules::plane_means(rules::mean_of_four_planes(receivers));
  const std::vector<double> cylinder = rules::plane_means(rules::true_cylinders(receivers));
  std::vector<double> difference;
  for (std::size_t r = 0; r < four.size(); ++r) difference.push_back(four[r] - cylinder[r]);
  const double mean_lx = calc::replicate_mean(cylinder).mean;
  if (!(mean_lx > 0.0)) return calc::say<calc::Sentence::four_planes>();
  calc::Estimate share = calc::t_interval(difference, confidence);
  for (double* value : {&share.value, &share.low, &share.high}) *value *= 100.0 / mean_lx;
  const auto percent = [](double value) { return calc::Message::number(format_fixed(value, 1)); };
  return calc::say<calc::Sentence::four_planes_off>(percent(share.value), percent(share.low),
                                                    percent(share.high));
}

}  // namespace

PlanePart build_plane(const calc::CalcPlane& plane, const calc::SensorGrid& grid,
                      const calc::PlaneField& field, std::vector<rules::Finding> findings,
                      double confidence, const std::vector<calc::LightScene>& scenes) {
  const double level = rules::look_confidence(confidence, field);
  PlanePart part = named_plane(plane, std::move(findings));
  part.is_computed = true;
  part.grid = grid;
  part.stop = field.stop;
  part.looks_planned = field.looks_planned;
  count_doubt(field, part);
  part.counters = field.counters;

  rules::PointValues maintained = rules::combine_channels(field, rules::LightState::maintained, {});
  part.groups = build_groups(field, grid.derived, level);
  if (calc::is_plain_number(grid.derived)) {
    add_ratings(field, level, part);
  } else {
    if (grid.derived == calc::DerivedQuantity::four_planes) {
      part.remarks.push_back(four_planes_remark(maintained, level));
      maintained = rules::mean_of_four_planes(maintained);
    }
    add_illuminances(field, maintained, level, part);
    add_asked_light(field, level, scenes, part);
  }
  if (grid.route) part.outline_m = grid.outline_m;
  if (const auto* area = std::get_if<calc::PlanarArea>(&plane.area)) {
    part.outline_m = from_grid_origin(area->outline_m, *area, grid);
    for (const auto& hole : area->holes_m) {
      part.holes_m.push_back(from_grid_origin(hole, *area, grid));
    }
  }
  return part;
}

PlanePart build_uncomputed_plane(const calc::CalcPlane& plane, calc::Message reason,
                                 std::vector<rules::Finding> findings) {
  PlanePart part = named_plane(plane, std::move(findings));
  part.reason = std::move(reason);
  return part;
}

SpacePart build_space(const calc::Space& space, const calc::PreparedScene& scene,
                      const calc::FluxBalance& balance, std::vector<PlanePart> planes) {
  SpacePart part;
  part.id = space.id;
  part.was = space.was;
  part.name = space.name;
  if (space.shell) {
    part.footprint_m = space.shell->footprint_m;
    part.floor_z_m = space.shell->floor_z_m;
    part.height_m = space.shell->height_m;
  }
  part.triangles = scene.triangle.size();
  part.degenerate_triangles = scene.degenerate_triangles;
  part.balance = balance;
  part.balance.absorbed_lm = settled(balance.absorbed_lm);
  part.balance.escaped_lm = settled(balance.escaped_lm);
  part.notes = space.notes;
  part.planes = std::move(planes);
  for (PlanePart& plane : part.planes) {
    plane.space_id = space.id;
    settle_estimates(plane);
  }
  return part;
}

ProjectPart build_project(const calc::Project& project) {
  ProjectPart part;
  part.path = project.path;
  part.name = project.name;
  part.about = project.about;
  part.north_deg = project.north_deg;
  part.maintenance_plan = project.maintenance_plan;
  part.inputs = project.inputs;
  for (std::size_t i = 0; i < project.luminaire_types.size(); ++i) {
    if (!project.luminaire_types[i].counts_as_luminaire()) continue;
    part.luminaires.push_back(build_luminaire(project, i));
  }
  for (const calc::Material& material : project.materials) {
    part.materials.push_back({material.id, material.reflectance});
  }
  for (const calc::LightScene& scene : project.scenes) {
    part.scenes.push_back({scene.id, scene.level_of_group});
  }
  return part;
}

}  // namespace report
