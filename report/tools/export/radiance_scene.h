#pragma once
// Surfaces and points for Radiance, and the commands to run it.

#include "calc/scene/prepared_scene.h"
#include "calc/scene/project.h"
#include "calc/scene/sensor_grid.h"

#include <string>
#include <vector>

namespace cli::radiance {

// A plane with its written points.
struct Plane {
  std::string id;
  const calc::SensorGrid* grid;
};

// A description of the light, with notes for readers.
struct Light {
  const calc::LightScene* scene = nullptr;  // null: full output
  std::vector<std::string> changed = {};    // not as in luxgate, in words
};

// Returns the number of diffuse reflections after which less than 0.2 % of the reflected light is
// left, by the area-weighted mean reflectance: rtrace -ab. 1 to 100.
int ambient_bounces(const calc::PreparedScene& scene);

// is_partial: a result of the project has points besides these.
std::string write_materials(const calc::PreparedScene& scene);  // materials.rad
std::string write_surfaces(const calc::PreparedScene& scene);   // surfaces.rad
// Returns points.txt: x y z nx ny nz, a line for each sensor of each point.
std::string write_points(const std::vector<Plane>& planes);
// Returns weights.txt, line by line: the point, from 1, and the weight of the sensor in it.
std::string write_weights(const std::vector<Plane>& planes);
std::string write_point_table(const std::vector<Plane>& planes);  // points.csv: which they are
std::string write_script(const calc::PreparedScene& scene, const Light& light,
                         bool is_partial);  // run.sh
std::string write_readme(const calc::Project& project, const calc::Space& space,
                         const calc::PreparedScene& scene, const std::vector<Plane>& planes,
                         bool is_partial, const Light& light);

}  // namespace cli::radiance
