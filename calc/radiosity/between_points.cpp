#include "calc/radiosity/between_points.h"

#include "calc/radiosity/direct.h"
#include "calc/radiosity/emission.h"
#include "calc/radiosity/random.h"
#include "calc/radiosity/rays.h"
#include "calc/radiosity/receiver.h"
#include "calc/radiosity/threads.h"
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

namespace calc {
namespace {

constexpr std::size_t kFewCells = 32, kMostCells = 256;
constexpr std::size_t kMostPairs = 1 << 18;  // of cells and luminaires

// Of places and axes of all luminaires.
RandomKey key_of(const PreparedScene& scene) {
  RandomKey key = stage_key(0, RandomStage::between_points);
  for (const PlacedLuminaire& luminaire : scene.luminaires) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      key = key.with(std::bit_cast<std::uint64_t>(luminaire.position_m[axis]))
                .with(std::bit_cast<std::uint64_t>(luminaire.world_from_luminaire[2][axis]));
    }
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

  // offset: from the middle, [-0.5, 0.5) of the cell's sides. From where it is measured; empty:
  // nothing can be, there.
  std::optional<glm::dvec3> place_m(std::size_t point, const glm::dvec2& offset) const {
    const glm::dvec3 at = cells_ ? on_route_m(point, offset) : on_plane_m(point, offset);
    if (!is_in_area(at)) return std::nullopt;
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

  const CalcPlane& plane_;
  const SensorGrid& grid_;
  PointFilter filter_;
  std::optional<RouteCells> cells_;
};

LightBetweenPoints look_between(const Tracer& tracer, const RandomKey& key, const Space& space,
                                const PlaneOfPoints& of, const std::function<bool()>& go_on) {
  LightBetweenPoints light;
  const PreparedScene& scene = tracer.scene();
  const SensorGrid& grid = *of.grid;
  if (grid.columns == 0 || grid.derived != DerivedQuantity::none || scene.luminaires.empty()) {
    return light;
  }
  const FlushDenormals flush;
  const CellPlaces places(space, *of.plane, grid);
  const std::size_t points = grid.position_m.size();
  const std::size_t most = std::clamp(kMostPairs / scene.luminaires.size(), kFewCells, kMostCells);
  const std::size_t step = (points + most - 1) / most;
  std::vector<double> sums(scene.channels.size(), 0.0);
  for (std::size_t i = 0; i < points; i += step) {
    if (!go_on()) return {};
    const RandomKey cell_key = key.with(i);
    const glm::dvec2 offset(cell_key.with(0).uniform() - 0.5, cell_key.with(1).uniform() - 0.5);
    const std::array<std::optional<glm::dvec3>, 2> place{places.place_m(i, offset),
                                                         places.place_m(i, -offset)};
    const auto is_good = [&](const std::optional<glm::dvec3>& at) {
      return at && find_touching_luminaire(scene, *at - scene.origin_m, tracer.offset_m()) < 0;
    };
    if (!std::all_of(place.begin(), place.end(), is_good)) continue;
    light.point.push_back(i);
    for (std::size_t k = 0; k < place.size(); ++k) {
      const Receiver receiver{*place[k] - scene.origin_m, grid.normal[i], grid.kernel};
      add_point_sources(tracer, receiver, {}, sums.data(), 1);
      add_extended_sources(tracer, receiver, {}, cell_key.with(2 + k), 0, 1, sums.data(), 1);
    }
  }
  if (light.point.empty()) return light;
  for (double& sum : sums) sum /= 2.0 * static_cast<double>(light.point.size());
  light.direct_lx = std::move(sums);
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
      light[p] = look_between(tracer, key, space, planes[p], look.go_on);
    });
  });
  return light;
}

}  // namespace calc
