#include "report/check/between_points_warning.h"

#include "rules/catalogue/requirement.h"
#include "rules/measure/measure.h"
#include "rules/measure/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace check {
namespace {

// EN 12464-1's grids are for averages that are known within a few per cent; honest designs that
// were looked at differ by 4 % at most.
constexpr double kMostOfAverage = 0.10;

bool counts(const rules::Requirement& requirement) {
  return requirement.problem.empty() && requirement.severity != rules::Severity::advice &&
         !rules::is_of_space(requirement.metric);
}

struct LightOfCells {
  double at_points_lx = 0.0, between_lx = 0.0;  // directly
  double average_lx = 0.0;                      // at the points, of all light

  // What the points flatter the plane by.
  double too_good_lx(const rules::Requirement& of) const {
    return rules::is_lower_limit(of.comparison) ? at_points_lx - between_lx
                                                : between_lx - at_points_lx;
  }
};

LightOfCells light_of_cells(const calc::PlaneField& field, const calc::LightBetweenPoints& between,
                            const std::vector<double>& weights) {
  LightOfCells light;
  const auto replicates = static_cast<double>(field.replicates);
  for (std::size_t c = 0; c < weights.size(); ++c) {
    double direct_lx = 0.0, reflected_lx = 0.0;
    for (const std::size_t point : between.point) {
      direct_lx += field.direct_exact_at(c, point);
      for (std::size_t r = 0; r < field.replicates; ++r) {
        direct_lx += field.direct_sampled_at(r, c, point) / replicates;
        reflected_lx += field.indirect_at(r, c, point) / replicates;
      }
    }
    light.at_points_lx += weights[c] * direct_lx;
    light.average_lx += weights[c] * (direct_lx + reflected_lx);
    light.between_lx += weights[c] * between.direct_lx[c];
  }
  const auto cells = static_cast<double>(between.point.size());
  light.at_points_lx /= cells;
  light.average_lx /= cells;
  return light;
}

}  // namespace

bool is_asked_of_points(const PlaneJob& job) {
  return job.grid && std::any_of(job.requirements.begin(), job.requirements.end(), counts);
}

void warn_of_light_between_points(const PlaneJob& job, const calc::PlaneField& field,
                                  const calc::LightBetweenPoints& between,
                                  const std::vector<calc::LightScene>& scenes,
                                  calc::Diagnostics& diagnostics) {
  if (between.point.empty()) return;
  LightOfCells most;
  double most_share = kMostOfAverage;
  const rules::Requirement* of = nullptr;
  for (const rules::Requirement& requirement : job.requirements) {
    if (!counts(requirement)) continue;
    const auto* levels = rules::levels_of(requirement.scene, scenes);
    if (levels == nullptr) continue;
    const LightOfCells light =
        light_of_cells(field, between, rules::channel_weights(field, requirement.state, *levels));
    const double share = light.too_good_lx(requirement) / light.average_lx;
    if (!(share > most_share)) continue;  // also of no light at all
    most_share = share;
    most = light;
    of = &requirement;
  }
  if (of == nullptr) return;
  diagnostics.report(calc::DiagnosticId::light_between_points, job.plane->where, job.plane->id,
                     most.at_points_lx, most.between_lx,
                     of->scene.empty() ? std::string() : fmt::format(" in scene '{}'", of->scene),
                     most.average_lx);
}

}  // namespace check
