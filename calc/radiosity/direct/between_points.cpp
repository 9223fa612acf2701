#include "calc/radiosity/direct/between_points.h"

#include "calc/radiosity/direct/direct.h"
#include "calc/radiosity/direct/emission.h"
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/receiver.h"
#include "calc/radiosity/sampling/shadow_batch.h"
#include "calc/radiosity/sampling/threads.h"
#include "calc/scene/point_filter.h"
#include "calc/scene/polygon.h"

#include <tbb/parallel_for.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace calc {
namespace {

constexpr std::size_t kFewCells = 32, kMostCells = 128;
constexpr std::size_t kOtherPlaces = 6;      // that are tried where one is none
constexpr std::size_t kMostPairs = 1 << 18;  // of cells and luminaires

// Of all luminaires: places, frames, flux and peak.
RandomKey key_of(const PreparedScene& scene) {
  RandomKey key = stage_key(0, RandomStage::between_points);
  for (const PlacedLuminaire& luminaire : scene.luminaires) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      key = key.with(std::bit_cast<std::uint64_t>(luminaire.position_m[axis]))
                .with(std::bit_cast<std::uint64_t>(luminaire.world_from_luminaire[0][axis]))
                .with(std::bit_cast<std::uint64_t>(luminaire.world_from_luminaire[2][axis]));
    }
    key = key.with(std::bit_cast<std::uint64_t>(luminaire.flux_scale))
              .with(std::bit_cast<std::uint64_t>(luminaire.web->flux_lm()))
              .with(std::bit_cast<std::uint64_t>(luminaire.web->max_intensity_cd()));
  }
  return key;
}

// Places of cells, world coordinates.
class CellPlaces {
 public:
  CellPlaces(const Space& space, const CalcPlane& plane, const SensorGrid& grid)
      : plane_(plane), grid_(grid), filter_(space, grid.kernel, region(grid)) {
    if (grid.route) cells_.emplace(grid.route->cells(grid.rows));
  }

  // offset: from the middle, [-0.5, 0.5) of the cell's sides.
  glm::dvec3 place_m(std::size_t point, const glm::dvec2& offset) const {
    return cells_ ? on_route_m(point, offset) : on_plane_m(point, offset);
  }

  bool is_in_area(const glm::dvec3& at) const {
    const auto* area = std::get_if<PlanarArea>(&plane_.area);
    if (area == nullptr) return true;
    const glm::dvec3 from_origin = at - area->origin_m;
    const glm::dvec2 flat(glm::dot(from_origin, area->u), glm::dot(from_origin, area->v));
    return contains_point(area->outline_m, flat) &&
           distance_to_boundary(area->outline_m, flat) >= area->margin_m &&
           std::none_of(area->holes_m.begin(), area->holes_m.end(),
                        [&](const auto& hole) { return contains_point(hole, flat); });
  }

  // From where it is measured; empty: nothing can be, there.
  std::optional<glm::dvec3> measured_m(std::size_t point, const glm::dvec3& at) const {
    const glm::dvec3 front = grid_.route ? glm::dvec3(0, 0, 1) : glm::cross(grid_.u, grid_.v);
    const PointStand stand = filter_.stand({at, front, grid_.normal[point]});
    if (stand.dropped || !stand.body.empty()) return std::nullopt;
    return at + stand.shift_m;
  }

 private:
  static BoundingBox region(const SensorGrid& grid) {
    BoundingBox box = bounding_box(grid.position_m);
    const double reach_m = grid.spacing_u_m + grid.spacing_v_m;
    return {box.lower - reach_m, box.upper + reach_m};
  }

  glm::dvec3 on_plane_m(std::size_t point, const glm::dvec2& offset) const {
    return grid_.position_m[point] + offset.x * grid_.spacing_u_m * grid_.u +
           offset.y * grid_.spacing_v_m * grid_.v;
  }

  // At the height of the point: a cell is a step or so.
  glm::dvec3 on_route_m(std::size_t point, const glm::dvec2& offset) const {
    const std::vector<glm::dvec2> corner = cells_->corners_m(grid_.column[point], grid_.row[point]);
    const glm::dvec2 at = offset + 0.5;
    const glm::dvec2 here = (1.0 - at.x) * ((1.0 - at.y) * corner[0] + at.y * corner[3]) +
                            at.x * ((1.0 - at.y) * corner[1] + at.y * corner[2]);
    return {here, grid_.position_m[point].z};
  }

  const CalcPlane& plane_;
  const SensorGrid& grid_;
  PointFilter filter_;
  std::optional<RouteCells> cells_;
};

// Whose cells are looked at: by chance one of each `step`, and then those of `also`.
std::vector<std::pair<std::size_t, bool>> chosen_points(const RandomKey& key, std::size_t points,
                                                        std::size_t step,
                                                        const std::vector<std::size_t>& also) {
  std::vector<std::pair<std::size_t, bool>> chosen;
  for (std::size_t first = 0; first < points; first += step) {
    const std::size_t count = std::min(step, points - first);
    const double u = key.with(points + first).uniform();
    const auto of = static_cast<std::size_t>(u * static_cast<double>(count));
    chosen.emplace_back(first + std::min(of, count - 1), true);
  }
  for (const std::size_t point : also) chosen.emplace_back(point, false);
  return chosen;
}

class CellLook {
 public:
  CellLook(const Tracer& tracer, const CellPlaces& places, const SensorGrid& grid)
      : tracer_(tracer), places_(places), grid_(grid) {}

  struct Seen {
    std::size_t pairs = 0;
    bool is_covered = false;  // a pair in the area was none, as surfaces lie there
    std::vector<double> direct_lx;
  };

  Seen look(std::size_t point, const RandomKey& key, std::size_t pairs) const {
    Seen seen;
    seen.direct_lx.assign(tracer_.scene().channels.size(), 0.0);
    for (std::size_t k = 0; seen.pairs < pairs && k < pairs + kOtherPlaces; ++k) {
      add_pair(point, key.with(k), seen);
    }
    for (double& lx : seen.direct_lx)
      lx /= 2.0 * static_cast<double>(std::max<std::size_t>(seen.pairs, 1));
    return seen;
  }

 private:
  void add_pair(std::size_t point, const RandomKey& key, Seen& seen) const {
    const glm::dvec3 origin_m = tracer_.scene().origin_m;
    const glm::dvec2 offset(key.with(0).uniform() - 0.5, key.with(1).uniform() - 0.5);
    std::array<glm::dvec3, 2> at{places_.place_m(point, offset), places_.place_m(point, -offset)};
    for (const glm::dvec3& place : at) {
      if (!places_.is_in_area(place)) return;
    }
    for (glm::dvec3& place : at) {
      const std::optional<glm::dvec3> measured = places_.measured_m(point, place);
      if (!measured ||
          find_touching_luminaire(tracer_.scene(), *measured - origin_m, tracer_.offset_m()) >= 0) {
        seen.is_covered = true;
        return;
      }
      place = *measured - origin_m;
    }
    ++seen.pairs;
    for (std::size_t end = 0; end < at.size(); ++end) {
      const Receiver receiver{at[end], grid_.normal[point], grid_.kernel};
      add_point_sources(tracer_, receiver, {}, seen.direct_lx.data(), 1);
      add_openings_roughly(receiver, key.with(2 + end), seen.direct_lx.data());
    }
  }

  // A place needs not be known better than a cell by its places.
  void add_openings_roughly(const Receiver& receiver, const RandomKey& key, double* sums) const {
    constexpr double kErrorFactor = 10.0;  // of 0.5 %
    ShadowBatch batch(tracer_, tracer_.has_shadows(), kReceiverToSource);
    const std::vector<PlacedLuminaire>& luminaires = tracer_.scene().luminaires;
    for (std::size_t l = 0; l < luminaires.size(); ++l) {
      if (luminaires[l].opening.shape == OpeningShape::point) continue;
      add_opening_samples(batch, tracer_, l,
                          opening_cells(luminaires[l], receiver.position_m, kErrorFactor), receiver,
                          key, 0, 1, sums, 1, nullptr);
    }
    batch.flush();
  }

  const Tracer& tracer_;
  const CellPlaces& places_;
  const SensorGrid& grid_;
};

LightBetweenPoints look_between(const Tracer& tracer, const RandomKey& key, const Space& space,
                                const PlaneOfPoints& of, const LookBetween& look) {
  LightBetweenPoints light;
  const PreparedScene& scene = tracer.scene();
  const SensorGrid& grid = *of.grid;
  if (grid.columns == 0 || grid.derived != DerivedQuantity::none || scene.luminaires.empty()) {
    return light;
  }
  const FlushDenormals flush;
  const CellPlaces places(space, *of.plane, grid);
  const CellLook cell_look(tracer, places, grid);
  const std::size_t points = grid.position_m.size();
  const std::size_t most = std::clamp(kMostPairs / scene.luminaires.size(), kFewCells, kMostCells);
  const auto pairs = std::max(static_cast<std::size_t>(look.pairs), kFewCells / points);
  for (const auto& [point, is_sample] :
       chosen_points(key, points, (points + most - 1) / most, of.also)) {
    if (!look.go_on()) return {};
    CellLook::Seen seen = cell_look.look(point, key.with(point), pairs);
    if (seen.pairs > 0) {
      light.cells.push_back({point, is_sample, std::move(seen.direct_lx)});
    } else if (is_sample && seen.is_covered) {
      ++light.not_measured;
    }
  }
  return light;
}

}  // namespace

std::vector<LightBetweenPoints> light_between_points(const PreparedScene& scene, const Space& space,
                                                     const std::vector<PlaneOfPoints>& planes,
                                                     const LookBetween& look) {
  std::vector<LightBetweenPoints> light(planes.size());
  if (planes.empty()) return light;
  const RandomKey key = key_of(scene);
  on_threads(look.jobs, [&] {
    const Tracer tracer(scene);
    tbb::parallel_for(std::size_t{0}, planes.size(), [&](std::size_t p) {
      light[p] = look_between(tracer, key, space, planes[p], look);
    });
  });
  return light;
}

}  // namespace calc
