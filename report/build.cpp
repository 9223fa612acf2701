#include "report/build.h"

#include "rules/candidates.h"
#include "rules/error_spending.h"
#include "rules/metrics.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

namespace report {
namespace {

// Sum over channels of maintenance factor x mean over replicates, at one point.
// values: [replicate][channel][point], or empty.
double maintained_mean(const calc::PlaneField& field, const std::vector<double>& values,
                       std::size_t replicates, std::size_t point) {
  if (values.empty()) return 0.0;
  const std::size_t channels = field.channels.size();
  double sum = 0.0;
  for (std::size_t r = 0; r < replicates; ++r) {
    for (std::size_t c = 0; c < channels; ++c) {
      sum +=
          field.channels[c].maintenance_factor * values[(r * channels + c) * field.points + point];
    }
  }
  return sum / static_cast<double>(replicates);
}

std::vector<PointRow> build_points(const calc::SensorGrid& grid, const calc::PlaneField& field,
                                   const rules::PointValues& maintained, double confidence) {
  const std::vector<calc::Estimate> estimates = rules::point_estimates(maintained, confidence);
  std::vector<PointRow> rows(field.points);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    PointRow& row = rows[i];
    row.position_m = grid.position_m[i];
    row.normal = grid.normal[i];
    row.column = grid.column.empty() ? 0 : grid.column[i];
    row.row = grid.row.empty() ? 0 : grid.row[i];
    row.maintained_lx = estimates[i];
    row.direct_lx = maintained_mean(field, field.direct_exact_lx, 1, i) +
                    maintained_mean(field, field.direct_sampled_lx, field.replicates, i);
    row.indirect_lx = maintained_mean(field, field.indirect_lx, field.replicates, i);
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

LuminaireRow build_luminaire(const calc::Project& project, std::size_t type_index) {
  const calc::LuminaireType& type = project.luminaire_types[type_index];
  const calc::PhotometricWeb& web = project.webs[type.web];
  LuminaireRow row;
  row.type_id = type.id;
  row.photometry_file = type.photometry_file;
  row.name = web.source().luminaire_name;
  row.format = web.source().format;
  for (const calc::Space& space : project.spaces) {
    row.count += static_cast<int>(std::count_if(
        space.luminaires.begin(), space.luminaires.end(),
        [type_index](const calc::Luminaire& luminaire) { return luminaire.type == type_index; }));
  }
  row.flux_lm = web.flux_lm() * type.flux_scale;
  row.power_w = type.power_w;
  row.max_intensity_cd = web.max_intensity_cd() * type.flux_scale;
  row.maintenance_factor = type.maintenance.product;
  row.maintenance = type.maintenance;
  row.sha256 = sha256_of(project, type.photometry_file);
  return row;
}

PlanePart named_plane(const calc::CalcPlane& plane, std::vector<rules::Finding> findings) {
  PlanePart part;
  part.id = plane.id;
  part.name = plane.name;
  part.where = plane.where;
  part.kernel = plane.kernel;
  part.made_by = plane.made_by;
  part.changed = plane.changed;
  part.findings = std::move(findings);
  return part;
}

}  // namespace

PlanePart build_plane(const calc::CalcPlane& plane, const calc::SensorGrid& grid,
                      const calc::PlaneField& field, std::vector<rules::Finding> findings,
                      double confidence) {
  const double level = rules::look_confidence(confidence, field.looks_planned);
  PlanePart part = named_plane(plane, std::move(findings));
  part.is_computed = true;
  part.grid = grid;
  part.stop = field.stop;
  part.looks_planned = field.looks_planned;
  part.unseen_points = static_cast<std::size_t>(
      std::count(field.unseen.begin(), field.unseen.end(), std::uint8_t{1}));
  part.single_sample_points = static_cast<std::size_t>(
      std::count_if(field.largest_share.begin(), field.largest_share.end(),
                    [](float share) { return share > rules::kLargestTrustedShare; }));
  part.counters = field.counters;

  const rules::PointValues maintained =
      rules::combine_channels(field, rules::LightState::maintained, {});
  // A quantity that does not exist (the uniformity of a dark plane) is not a number; renderers show
  // a dash.
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto statistic = [&](rules::Metric metric) {
    const auto found = rules::compute_metric(maintained, metric, 0.0, std::nullopt, level);
    return found ? found->estimate : calc::Estimate{kNone, kNone, kNone};
  };
  part.points = build_points(grid, field, maintained, level);
  part.average_lx = statistic(rules::Metric::average);
  part.minimum_lx = statistic(rules::Metric::minimum);
  part.maximum_lx = statistic(rules::Metric::maximum);
  part.uniformity_min_avg = statistic(rules::Metric::uniformity_min_avg);
  part.uniformity_min_max = statistic(rules::Metric::uniformity_min_max);

  if (const auto* area = std::get_if<calc::PlanarArea>(&plane.area)) {
    part.outline_m = from_grid_origin(area->outline_m, *area, grid);
    for (const auto& hole : area->holes_m) {
      part.holes_m.push_back(from_grid_origin(hole, *area, grid));
    }
  }
  return part;
}

PlanePart build_uncomputed_plane(const calc::CalcPlane& plane, std::string reason,
                                 std::vector<rules::Finding> findings) {
  PlanePart part = named_plane(plane, std::move(findings));
  part.reason = std::move(reason);
  return part;
}

SpacePart build_space(const calc::Space& space, const calc::PreparedScene& scene,
                      const calc::FluxBalance& balance, std::vector<PlanePart> planes) {
  SpacePart part;
  part.id = space.id;
  part.name = space.name;
  if (space.shell) {
    part.footprint_m = space.shell->footprint_m;
    part.floor_z_m = space.shell->floor_z_m;
    part.height_m = space.shell->height_m;
  }
  part.triangles = scene.triangle.size();
  part.degenerate_triangles = scene.degenerate_triangles;
  part.balance = balance;
  part.notes = space.notes;
  part.planes = std::move(planes);
  for (PlanePart& plane : part.planes) plane.space_id = space.id;
  return part;
}

ProjectPart build_project(const calc::Project& project) {
  ProjectPart part;
  part.path = project.path;
  part.name = project.name;
  part.inputs = project.inputs;
  for (std::size_t i = 0; i < project.luminaire_types.size(); ++i) {
    part.luminaires.push_back(build_luminaire(project, i));
  }
  return part;
}

}  // namespace report
