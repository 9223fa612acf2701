#pragma once
// The light of planes, in more detail than a document has.

#include "calc/base/field.h"
#include "calc/radiosity/looks/solve.h"
#include "calc/scene/sensor_grid.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace cli {

struct PlaneLight {
  calc::SensorGrid grid;
  calc::PlaneField field;
};
using LightOfPlanes = std::map<std::string, PlaneLight>;  // by plane id

// Keeps the light of a project during its check; spaces may come at the same time.
class KeptLight {
 public:
  void keep(const std::vector<calc::PlaneTask>& tasks, const calc::SpaceSolution& solution) {
    const std::scoped_lock lock(mutex_);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      planes_.insert_or_assign(tasks[i].plane_id, PlaneLight{*tasks[i].grid, solution.fields[i]});
    }
  }
  // Returns the light, once the project is done.
  const LightOfPlanes& planes() const { return planes_; }

 private:
  std::mutex mutex_;
  LightOfPlanes planes_;
};

}  // namespace cli
