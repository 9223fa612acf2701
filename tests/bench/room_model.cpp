#include "tests/bench/room_model.h"

#include "tests/support/scenes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace bench {
namespace {

// Corners in double until the scene's centre is known.
class MeshBuilder {
 public:
  void add_face(const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& v, int cells,
                double reflectance) {
    const auto first = static_cast<std::uint32_t>(vertex_m_.size());
    const auto row = static_cast<std::uint32_t>(cells) + 1;
    for (std::uint32_t j = 0; j < row; ++j) {
      for (std::uint32_t i = 0; i < row; ++i) {
        vertex_m_.push_back(origin + static_cast<double>(i) / cells * u +
                            static_cast<double>(j) / cells * v);
      }
    }
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      for (std::uint32_t i = 0; i + 1 < row; ++i) {
        const std::uint32_t a = first + j * row + i;
        add_triangle({a, a + 1, a + row + 1}, reflectance);
        add_triangle({a, a + row + 1, a + row}, reflectance);
      }
    }
  }

  // floor, walls, ceiling
  void add_box(const glm::dvec3& low, const glm::dvec3& size, int cells,
               const std::array<double, 3>& reflectance) {
    const glm::dvec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    add_face(low, x, y, cells, reflectance[0]);
    add_face(low + z, x, y, cells, reflectance[2]);
    add_face(low, x, z, cells, reflectance[1]);
    add_face(low + y, x, z, cells, reflectance[1]);
    add_face(low, y, z, cells, reflectance[1]);
    add_face(low + x, y, z, cells, reflectance[1]);
    ++body_;
  }

  void add_ball(const Ball& ball) {
    calc::PreparedScene sphere;
    test_support::add_sphere(sphere, ball.radius_m, ball.levels, ball.reflectance);
    const auto first = static_cast<std::uint32_t>(vertex_m_.size());
    for (const glm::vec3& p : sphere.vertex_m) vertex_m_.push_back(ball.centre_m + glm::dvec3(p));
    for (const glm::uvec3& t : sphere.triangle) add_triangle(t + first, ball.reflectance);
    ++body_;
  }

  // Everything but the luminaires; the origin is the centre, as in calc::prepare_scene.
  calc::PreparedScene take(const std::vector<Lamp>& lamps) {
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    const auto add = [&](const glm::dvec3& p) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    };
    for (const glm::dvec3& p : vertex_m_) add(p);
    for (const Lamp& lamp : lamps) add(lamp.position_m);
    scene_.origin_m = 0.5 * (low + high);
    scene_.extent_m = glm::length(high - low);
    for (const glm::dvec3& p : vertex_m_) scene_.vertex_m.emplace_back(p - scene_.origin_m);
    return std::move(scene_);
  }

 private:
  void add_triangle(const glm::uvec3& corner, double reflectance) {
    scene_.triangle.push_back(corner);
    scene_.reflectance.push_back(reflectance);
    scene_.body.push_back(body_);
  }

  std::vector<glm::dvec3> vertex_m_;
  std::uint32_t body_ = 0;
  calc::PreparedScene scene_;
};

bool is_inside(const RoomModel& model, const glm::dvec3& p) {
  const auto in_block = [&](const Block& block) {
    return glm::all(glm::greaterThan(p, block.low_m)) &&
           glm::all(glm::lessThan(p, block.low_m + block.size_m));
  };
  const auto in_ball = [&](const Ball& ball) {
    return glm::length(p - ball.centre_m) < ball.radius_m;
  };
  return std::any_of(model.blocks.begin(), model.blocks.end(), in_block) ||
         std::any_of(model.balls.begin(), model.balls.end(), in_ball);
}

void add_points(const RoomModel& model, BenchScene& out) {
  const Grid& grid = model.grid;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const glm::dvec3 p = grid.low_m + glm::dvec3((column + 0.5) * grid.along_x_m / grid.columns,
                                                   (row + 0.5) * grid.along_y_m / grid.rows, 0.0);
      if (is_inside(model, p)) continue;
      out.grid.position_m.push_back(p);
      out.grid.normal.emplace_back(0.0, 0.0, 1.0);
      out.grid.column.push_back(column);
      out.grid.row.push_back(row);
      out.label.emplace_back();
    }
  }
  out.grid.columns = grid.columns;
  out.grid.rows = grid.rows;
  for (const Point& point : model.points) {
    out.grid.position_m.push_back(point.position_m);
    out.grid.normal.push_back(point.normal);
    out.grid.column.push_back(static_cast<int>(out.grid.column.size()));
    out.grid.row.push_back(0);
    out.label.push_back(point.label);
  }
}

void add_luminaires(const RoomModel& model, BenchScene& out) {
  for (const WebTable& table : model.webs) {
    out.webs.push_back(std::make_unique<calc::PhotometricWeb>(make_web(table)));
  }
  const glm::dmat3 down(1.0);
  const glm::dmat3 up(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
  for (const Lamp& lamp : model.lamps) {
    auto& channels = out.scene.channels;
    const auto found = std::find_if(channels.begin(), channels.end(), [&](const auto& channel) {
      return channel.group == lamp.group;
    });
    const auto channel = static_cast<std::uint32_t>(found - channels.begin());
    if (found == channels.end()) channels.push_back({lamp.group, 1.0});
    calc::PlacedLuminaire placed;
    placed.position_m = lamp.position_m - out.scene.origin_m;
    placed.world_from_luminaire = lamp.shines_up ? up : down;
    placed.web = out.webs[lamp.web].get();
    placed.opening = placed.web->opening();
    placed.channel = channel;
    out.scene.luminaires.push_back(placed);
  }
}

}  // namespace

BenchScene make_scene(const RoomModel& model) {
  MeshBuilder mesh;
  if (model.size_m.x > 0.0) {
    mesh.add_box({0, 0, 0}, model.size_m, model.cells, {model.floor, model.walls, model.ceiling});
  }
  for (const Block& b : model.blocks) {
    mesh.add_box(b.low_m, b.size_m, b.cells, {b.reflectance, b.reflectance, b.reflectance});
  }
  for (const Ball& ball : model.balls) mesh.add_ball(ball);
  BenchScene out;
  out.name = model.name;
  out.is_convex = model.blocks.empty() && model.balls.size() == (model.size_m.x > 0.0 ? 0u : 1u);
  out.scene = mesh.take(model.lamps);
  add_luminaires(model, out);
  // A lone ball is the room itself: its points are inside.
  RoomModel for_points = model;
  if (out.is_convex) for_points.balls.clear();
  add_points(for_points, out);
  return out;
}

double surface_area_m2(const calc::PreparedScene& scene) {
  return test_support::surface_area_m2(scene);
}

double mean_chord_m(const calc::PreparedScene& scene) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const glm::vec3& p : scene.vertex_m) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 size(high - low);
  return 2.0 * size.x * size.y * size.z / (size.x * size.y + size.y * size.z + size.z * size.x);
}

}  // namespace bench
