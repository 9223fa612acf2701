#pragma once
// Surfaces and points for Radiance, and how to run it.

#include "calc/scene/prepared_scene.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"

#include <string>
#include <vector>

namespace cli::radiance {

// A plane whose points are written.
struct Plane {
  std::string id;
  const calc::SensorGrid* grid;
};

// Points are lifted off surfaces they may lie in by this distance, along their normals.
inline constexpr double kLift_m = 1e-4;

// is_partial: a result of the project has points besides these.
std::string write_materials(const calc::PreparedScene& scene);    // materials.rad
std::string write_surfaces(const calc::PreparedScene& scene);     // surfaces.rad
std::string write_points(const std::vector<Plane>& planes);       // points.txt: x y z nx ny nz
std::string write_point_table(const std::vector<Plane>& planes);  // points.csv: which they are
std::string write_script(bool is_partial);                        // run.sh
std::string write_readme(const calc::Project& project, const calc::Space& space,
                         const calc::PreparedScene& scene, const std::vector<Plane>& planes,
                         bool is_partial, const std::vector<std::string>& changed);

}  // namespace cli::radiance
