#include "report/build/build_plan_marks.h"

#include "calc/base/elementary.h"
#include "report/build/surface_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace report {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Counter-clockwise, without the points on its sides.  [Andrew79, monotone chain]
std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points) {
  const auto is_before = [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  std::sort(points.begin(), points.end(), is_before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<glm::dvec2> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const glm::dvec2& p : points) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// The opening of a luminaire from above; empty for a point.
std::vector<glm::dvec2> opening_outline(const calc::PlacedLuminaire& luminaire,
                                        const glm::dvec3& centre_m) {
  const glm::dvec3 half_m = 0.5 * luminaire.opening.size_m();
  if (half_m == glm::dvec3(0.0)) return {};
  using enum calc::OpeningShape;
  const calc::OpeningShape shape = luminaire.opening.shape;
  const bool is_round = shape == disk || shape == cylinder || shape == ellipsoid;
  const double ends_m = shape == ellipsoid ? 0.0 : half_m.z;
  std::vector<glm::dvec2> points;
  for (const double z : {-ends_m, ends_m}) {
    constexpr int kSides = 24;
    const int corners = is_round ? kSides : 4;
    for (int i = 0; i < corners; ++i) {
      const double turn = 6.283185307179586 * (i + 0.5) / corners;
      const double reach = is_round ? 1.0 : 1.4142135623730951;
      const glm::dvec3 local{half_m.x * reach * calc::cos(turn), half_m.y * reach * calc::sin(turn),
                             z};
      points.emplace_back(centre_m + luminaire.world_from_luminaire * local);
    }
  }
  std::vector<glm::dvec2> hull = convex_hull(std::move(points));
  return hull.size() < 3 ? std::vector<glm::dvec2>{} : hull;  // on edge: a line
}

// [vertex]: the first vertex at the same place, since files may repeat them for every face.
std::vector<std::size_t> places(const calc::Body& body) {
  std::map<std::array<double, 3>, std::size_t> first;
  std::vector<std::size_t> place;
  place.reserve(body.vertex_m.size());
  for (const glm::dvec3& vertex : body.vertex_m) {
    const auto found = first.try_emplace({vertex.x, vertex.y, vertex.z}, place.size()).first;
    place.push_back(found->second);
  }
  return place;
}

using Lines = std::vector<std::array<glm::dvec2, 2>>;

// Sides that belong to one only of the triangles, which are few where the body is simple.
Lines border(const calc::Body& body, bool upward_only) {
  constexpr double kUp = 0.2;  // of the normal: steeper faces are sides
  const std::vector<std::size_t> place = places(body);
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  for (const glm::uvec3& t : body.triangle) {
    const glm::dvec3 a = body.vertex_m[t.x], b = body.vertex_m[t.y], c = body.vertex_m[t.z];
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    if (!(length > 0.0)) continue;
    if (upward_only && normal.z < kUp * length) continue;
    for (const auto& [from, to] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)})
      ++uses[std::minmax({place[from], place[to]})];
  }
  Lines lines;
  for (const auto& [side, count] : uses) {
    if (count != 1) continue;
    const glm::dvec2 from(body.vertex_m[side.first]), to(body.vertex_m[side.second]);
    if (from != to) lines.push_back({from, to});
  }
  return lines;
}

void add_surface_lines(const calc::Space& space, SpacePart& part) {
  std::vector<SurfaceLine> lines = surface_lines(space.bodies);
  if (lines.size() > kMostSurfaceLines) {
    std::stable_sort(lines.begin(), lines.end(), [](const SurfaceLine& a, const SurfaceLine& b) {
      return glm::distance(a.from_m, a.to_m) > glm::distance(b.from_m, b.to_m);
    });
    part.surface_lines_left_out = lines.size() - kMostSurfaceLines;
    lines.resize(kMostSurfaceLines);
  }
  for (const SurfaceLine& line : lines) {
    part.surface_lines_m.push_back(line.from_m);
    part.surface_lines_m.push_back(line.to_m);
  }
}

std::string materials_of(const calc::Project& project, const calc::Body& body) {
  std::vector<std::uint32_t> seen;
  std::string words;
  for (const std::uint32_t material : body.material_of) {
    if (std::find(seen.begin(), seen.end(), material) != seen.end()) continue;
    seen.push_back(material);
    words += (words.empty() ? "" : ", ") + project.materials[material].id;
  }
  return words;
}

BodyMark mark_of(const calc::Project& project, const calc::Body& body) {
  BodyMark mark;
  mark.id = body.id;
  mark.materials = materials_of(project, body);
  mark.low_z_m = std::numeric_limits<double>::max();
  mark.high_z_m = std::numeric_limits<double>::lowest();
  for (const glm::dvec3& vertex : body.vertex_m) {
    mark.low_z_m = std::min(mark.low_z_m, vertex.z);
    mark.high_z_m = std::max(mark.high_z_m, vertex.z);
  }
  mark.lines_m = border(body, true);
  if (mark.lines_m.empty()) mark.lines_m = border(body, false);
  if (!mark.lines_m.empty() && mark.lines_m.size() <= kMostBodyLines) return mark;
  const std::vector<glm::dvec2> hull =
      convex_hull(std::vector<glm::dvec2>(body.vertex_m.begin(), body.vertex_m.end()));
  mark.lines_m.clear();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    mark.lines_m.push_back({hull[i], hull[(i + 1) % hull.size()]});
  }
  return mark;
}

}  // namespace

void add_plan_marks(const calc::Project& project, const calc::Space& space,
                    const calc::PreparedScene& scene, SpacePart& part) {
  for (std::size_t i = 0; i < space.luminaires.size() && i < scene.luminaires.size(); ++i) {
    const calc::Luminaire& luminaire = space.luminaires[i];
    if (!project.luminaire_types[luminaire.type].counts_as_luminaire()) continue;
    LuminaireMark mark;
    mark.position_m = luminaire.position_m;
    mark.type_id = project.luminaire_types[luminaire.type].id;
    mark.id = luminaire.id;
    mark.group = luminaire.group;
    mark.outline_m = opening_outline(scene.luminaires[i], luminaire.position_m);
    mark.c0 = luminaire.world_from_luminaire[0];
    mark.axis = -luminaire.world_from_luminaire[2];
    part.luminaires.push_back(std::move(mark));
  }
  // floor, ceiling and one wall per corner come first; a building file has nothing but surfaces
  if (!space.surfaces_file.empty()) {
    add_surface_lines(space, part);
    return;
  }
  const std::size_t shell = space.shell ? space.shell->footprint_m.size() + 2 : 0;
  for (std::size_t i = 0; i < std::min(shell, space.bodies.size()); ++i) {
    const calc::Body& body = space.bodies[i];
    const std::string of_room = space.id + ".";
    part.finishes.push_back(
        {body.id.starts_with(of_room) ? body.id.substr(of_room.size()) : body.id,
         materials_of(project, body)});
  }
  for (std::size_t i = shell; i < space.bodies.size(); ++i) {
    if (!space.bodies[i].housing_of.empty()) continue;  // luminaires are drawn themselves
    if (part.bodies.size() == kMostBodies) {
      ++part.bodies_left_out;
    } else if (!space.bodies[i].triangle.empty()) {
      part.bodies.push_back(mark_of(project, space.bodies[i]));
    }
  }
}

}  // namespace report
