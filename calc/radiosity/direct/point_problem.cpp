#include "calc/radiosity/direct/point_problem.h"

#include "calc/base/sentences.h"
#include "calc/base/triangle.h"
#include "calc/radiosity/direct/emission.h"
#include "calc/scene/opening.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace calc {
namespace {

// Room for rounding where rays begin: 2 ulp of the largest coordinate.
constexpr double kRounding = 1.0 / 16.0;

Message words(const glm::dvec3& p) {
  return Message::number(fmt::format("({:.12g} {:.12g} {:.12g})", p.x, p.y, p.z));
}

std::optional<CloseSurface> close_surface(const Tracer& tracer, const glm::dvec3& position_m,
                                          const Receiver& receiver) {
  return tracer.close_surface({position_m, tracer.lift(receiver),
                               has_back(receiver.kernel) ? receiver.axis : glm::dvec3(0),
                               tracer.touching_m(), (1.0 + kRounding) * tracer.offset_m()});
}

// A surface between where light leaves the opening and where rays begin to see surfaces.
std::optional<CloseSurface> surface_before(const Tracer& tracer, const PlacedLuminaire& luminaire,
                                           const glm::dvec3& axis) {
  constexpr std::array<double, 5> kPlaces{0.1, 0.3, 0.5, 0.7, 0.9};
  const double touching_m = tracer.touching_m();
  const double reach_m = (2.0 + 2.0 * kRounding) * tracer.offset_m();
  const OpeningView view(luminaire, axis);
  std::optional<CloseSurface> found;
  for (const double s : kPlaces) {
    for (const double t : kPlaces) {
      const OpeningView::Point place = view.point(s, t);
      const glm::dvec3 from_m = place.position_m + touching_m * place.normal;
      const glm::dvec3 to_m = place.position_m + reach_m * place.normal;
      tracer.visit_near(to_m, reach_m, [&](std::uint32_t index, const Triangle& triangle) {
        if (!divides(triangle, from_m, to_m)) return;
        const double apart_m = distance_m(place.position_m, triangle);
        const bool is_first = !found || apart_m < found->distance_m ||
                              (apart_m == found->distance_m && index < found->triangle);
        if (is_first) found = CloseSurface{index, apart_m};
      });
    }
  }
  return found;
}

Message luminaire_problem(const Tracer& tracer, const SensorGrid& grid,
                          std::span<const Receiver> receivers) {
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const int touching =
        find_touching_luminaire(tracer.scene(), receivers[i].position_m, tracer.offset_m());
    if (touching < 0) continue;
    const bool is_inside =
        tracer.scene().luminaires[static_cast<std::size_t>(touching)].opening.is_body();
    const Message point =
        say<Sentence::the_point>(words(grid.position_m[i % grid.position_m.size()]));
    return is_inside ? say<Sentence::point_in_body>(point) : say<Sentence::point_at_source>(point);
  }
  return {};
}

Message closeness_problem(const Tracer& tracer, const SensorGrid& grid,
                          std::span<const Receiver> receivers) {
  const std::size_t points = grid.position_m.size();
  const glm::dvec3& origin_m = tracer.scene().origin_m;
  std::vector<std::uint8_t> is_close(points, 0);
  tbb::parallel_for(std::size_t{0}, points, [&](std::size_t i) {
    const FlushDenormals flush;
    for (std::size_t k = i; k < receivers.size() && is_close[i] == 0; k += points) {
      is_close[i] = close_surface(tracer, grid.position_m[i] - origin_m, receivers[k]) ? 1 : 0;
    }
  });
  std::size_t count = 0, first = points;
  for (std::size_t i = points; i-- > 0;) {
    if (is_close[i] == 0) continue;
    first = i;
    ++count;
  }
  if (count == 0) return {};
  std::optional<CloseSurface> found;
  for (std::size_t k = first; !found; k += points) {
    found = close_surface(tracer, grid.position_m[first] - origin_m, receivers[k]);
  }
  const PreparedScene& scene = tracer.scene();
  const std::size_t body = scene.body[found->triangle];
  const double needed_m = (2.0 + 2.0 * kRounding) * tracer.offset_m();
  const Message point = say<Sentence::the_point>(words(grid.position_m[first]));
  const Message surface = body < scene.body_id.size()
                              ? say<Sentence::surface_of>(scene.body_id[body])
                              : say<Sentence::some_surface>();
  return count > 1 ? say<Sentence::points_too_close>(point, found->distance_m, surface, count,
                                                     scene.extent_m, needed_m)
                   : say<Sentence::point_too_close>(point, found->distance_m, surface,
                                                    scene.extent_m, needed_m);
}

}  // namespace

Message point_problem(const Tracer& tracer, const SensorGrid& grid,
                      std::span<const Receiver> receivers, bool refuses_close) {
  Message problem = luminaire_problem(tracer, grid, receivers);
  if (problem.empty() && refuses_close) problem = closeness_problem(tracer, grid, receivers);
  return problem;
}

Message source_problem(const Tracer& tracer) {
  const PreparedScene& scene = tracer.scene();
  for (const PlacedLuminaire& luminaire : scene.luminaires) {
    for (const double side : {-1.0, 1.0}) {
      if (side > 0.0 && !(luminaire.web->intensity_cd({0.0, 0.0, 1.0}) > 0.0)) continue;
      const auto found =
          surface_before(tracer, luminaire, side * luminaire.world_from_luminaire[2]);
      if (!found) continue;
      const glm::dvec3 at_m = luminaire.position_m + scene.origin_m;
      return say<Sentence::source_covered>(scene.body_id.at(scene.body[found->triangle]),
                                           found->distance_m, words(at_m), scene.extent_m,
                                           (2.0 + 2.0 * kRounding) * tracer.offset_m());
    }
  }
  return {};
}

}  // namespace calc
