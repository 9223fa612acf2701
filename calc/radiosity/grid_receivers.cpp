#include "calc/radiosity/grid_receivers.h"

#include <cstddef>

namespace calc {
namespace {

bool touches_surface(const Tracer& tracer, const glm::dvec3& position_m) {
  // The tracer takes its offset off the distance.
  return tracer.clear_distance(position_m, glm::dvec3(0.0), 2.0 * tracer.offset_m()) <= 0.0;
}

}  // namespace

std::vector<Receiver> receivers_of(const Tracer& tracer, const SensorGrid& grid) {
  std::vector<Receiver> receivers;
  receivers.reserve(grid.position_m.size());
  for (std::size_t i = 0; i < grid.position_m.size(); ++i) {
    Receiver receiver{grid.position_m[i] - tracer.scene().origin_m, grid.normal[i], grid.kernel};
    if (!has_back(grid.kernel) && touches_surface(tracer, receiver.position_m)) {
      receiver.position_m = tracer.lift(receiver.position_m, grid.front(i));
    }
    receivers.push_back(receiver);
  }
  return receivers;
}

}  // namespace calc
