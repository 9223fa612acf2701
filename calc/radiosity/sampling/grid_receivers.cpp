#include "calc/radiosity/sampling/grid_receivers.h"

#include <cmath>
#include <cstddef>

namespace calc {

glm::dvec3 side_of_axis(const glm::dvec3& axis, std::size_t quarter) {
  const glm::dvec3 aside = std::abs(axis.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 first = glm::normalize(aside - glm::dot(aside, axis) * axis);
  const glm::dvec3 side = quarter % 2 == 0 ? first : glm::cross(axis, first);
  return quarter < 2 ? side : -side;
}

std::vector<Receiver> receivers_of(const Tracer& tracer, const SensorGrid& grid) {
  std::vector<Receiver> receivers;
  receivers.reserve(grid.position_m.size());
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    receivers.push_back(
        {grid.measured_m(i) - tracer.scene().origin_m, grid.normal[i], grid.kernel});
  }
  const std::size_t points = receivers.size();
  receivers.reserve(points * receivers_per_point(grid.derived));
  for (std::size_t part = 1; part < receivers_per_point(grid.derived); ++part) {
    for (std::size_t i = 0; i < points; ++i) {
      const glm::dvec3 axis = grid.derived == DerivedQuantity::modelling
                                  ? grid.normal[i]
                                  : side_of_axis(grid.normal[i], part - 1);
      receivers.push_back({receivers[i].position_m, axis, ReceiverKernel::planar});
    }
  }
  return receivers;
}

}  // namespace calc
