#pragma once
// A room as a description, from which a benchmark scene or a project file is made.

#include "calc/photometry/web.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"
#include "tests/bench/photometry.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace bench {

// A closed box. Faces are cut into cells x cells squares of two triangles.
struct Block {
  std::string id;
  glm::dvec3 low_m, size_m;
  double reflectance;
  int cells = 1;
};

// A closed ball of 20 * 4^levels triangles.
struct Ball {
  glm::dvec3 centre_m;
  double radius_m;
  double reflectance;
  int levels;
};

struct Lamp {
  glm::dvec3 position_m;
  std::size_t web = 0;     // index into RoomModel::webs
  bool shines_up = false;  // else straight down, C 0 along x
  std::string group;
};

struct Point {
  glm::dvec3 position_m;
  glm::dvec3 normal{0.0, 0.0, 1.0};
  std::string label;  // what the point shows; empty in plain grids
};

struct Grid {
  glm::dvec3 low_m{0.0};  // a horizontal rectangle, looking up
  double along_x_m = 0.0, along_y_m = 0.0;
  int columns = 0, rows = 0;
};

struct RoomModel {
  std::string name;
  glm::dvec3 size_m{0.0};  // (0, 0, 0) to size; no walls if 0
  double floor = 0.2, walls = 0.5, ceiling = 0.7;
  int cells = 1;  // of every face of the room
  std::vector<Block> blocks;
  std::vector<Ball> balls;
  std::vector<WebTable> webs;
  std::vector<Lamp> lamps;
  Grid grid;                  // points inside blocks or balls are left out
  std::vector<Point> points;  // beside the grid's
};

struct BenchScene {
  std::string name;
  std::vector<std::unique_ptr<calc::PhotometricWeb>> webs;
  calc::PreparedScene scene;
  calc::SensorGrid grid;
  std::vector<std::string> label;  // [point]
  bool is_convex = false;          // nothing stands in the room

  std::size_t points() const { return grid.position_m.size(); }
};

BenchScene make_scene(const RoomModel& model);

double surface_area_m2(const calc::PreparedScene& scene);
// 4 V / A of the bounding box.
double mean_chord_m(const calc::PreparedScene& scene);

// Writes FOLDER/project.xml and its photometry. Only rooms of blocks with a grid. Throws
// std::runtime_error if a file cannot be written.
void write_project(const RoomModel& model, const std::string& folder);

}  // namespace bench
