#include "gpu/raster/room_drawing.h"

#include "calc/base/elementary.h"
#include "calc/base/units.h"
#include "calc/scene/opening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace gpu {
namespace {

const glm::vec4 kEdge{0.05f, 0.06f, 0.09f, 0.75f};
const glm::vec4 kRemovedEdge{0.35f, 0.38f, 0.44f, 0.55f};
const glm::vec4 kOpening{1.0f, 0.99f, 0.93f, 0.80f};
const glm::vec4 kOpeningEdge{0.15f, 0.13f, 0.10f, 0.9f};
const glm::vec4 kOutline{1.0f, 1.0f, 1.0f, 0.95f};
const glm::vec4 kOutlineHalo{0.05f, 0.06f, 0.09f, 0.85f};
constexpr double kFoldCosine = 0.94;

using Place = std::tuple<float, float, float>;
Place place_of(const glm::vec3& p) { return {p.x, p.y, p.z}; }

// Edges by place, with the normals of the triangles there.
class EdgeSet {
 public:
  explicit EdgeSet(const calc::PreparedScene& scene) : scene_(scene) {}

  void add(std::uint32_t triangle, const glm::vec3& normal) {
    const glm::uvec3& t = scene_.triangle[triangle];
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 &a = scene_.vertex_m[t[k]], &b = scene_.vertex_m[t[(k + 1) % 3]];
      edge_[std::minmax(place_of(a), place_of(b))].push_back(normal);
    }
  }

  // Rims and folds.
  template <class Tell>
  void tell(const Tell& line) const {
    for (const auto& [edge, normals] : edge_) {
      bool is_flat = normals.size() > 1;
      for (const glm::vec3& normal : normals) {
        if (glm::dot(normal, normals.front()) < static_cast<float>(kFoldCosine)) is_flat = false;
      }
      if (is_flat) continue;
      const auto& [a, b] = edge;
      line(glm::dvec3(std::get<0>(a), std::get<1>(a), std::get<2>(a)),
           glm::dvec3(std::get<0>(b), std::get<1>(b), std::get<2>(b)));
    }
  }

 private:
  const calc::PreparedScene& scene_;
  std::map<std::pair<Place, Place>, std::vector<glm::vec3>> edge_;
};

glm::vec3 normal_of(const calc::PreparedScene& scene, std::uint32_t triangle) {
  const glm::uvec3& t = scene.triangle[triangle];
  const glm::dvec3 a(scene.vertex_m[t.x]), b(scene.vertex_m[t.y]), c(scene.vertex_m[t.z]);
  return glm::vec3(glm::normalize(glm::cross(b - a, c - a)));
}

}  // namespace

RoomBox box_of(const calc::PreparedScene& scene) {
  RoomBox box{glm::dvec3(1e300), glm::dvec3(-1e300)};
  const auto add = [&box](const glm::dvec3& p) {
    box.low_m = glm::min(box.low_m, p);
    box.high_m = glm::max(box.high_m, p);
  };
  for (const glm::vec3& p : scene.vertex_m) add(glm::dvec3(p));
  for (const calc::PlacedLuminaire& luminaire : scene.luminaires) add(luminaire.position_m);
  if (!(box.low_m.x <= box.high_m.x)) box = {glm::dvec3(0.0), glm::dvec3(0.0)};
  const glm::dvec3 least(0.005 * std::max(scene.extent_m, 1e-3));
  const glm::dvec3 missing = glm::max(least - (box.high_m - box.low_m), glm::dvec3(0.0));
  return {box.low_m - 0.5 * missing, box.high_m + 0.5 * missing};
}

std::vector<glm::dvec3> opening_rim_m(const calc::PlacedLuminaire& luminaire) {
  constexpr int kRound = 24;
  std::vector<glm::dvec3> rim;
  if (luminaire.opening.shape == calc::OpeningShape::rectangle) {
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
      rim.push_back(calc::opening_point_m(luminaire, corner.x, corner.y));
    }
    return rim;
  }
  const calc::LuminousOpening& opening = luminaire.opening;
  const glm::dvec2 half(0.5 * opening.along_c0_m, 0.5 * opening.along_c90_m);
  const bool is_rectangle = opening.shape == calc::OpeningShape::box;
  const int corners = is_rectangle ? 4 : kRound;
  for (int k = 0; k < corners; ++k) {
    const double turn = 2.0 * calc::kPi * (k + (is_rectangle ? 0.5 : 0.0)) / corners;
    const double reach = is_rectangle ? std::sqrt(2.0) : 1.0;
    const glm::dvec2 p = half * reach * glm::dvec2(calc::cos(turn), calc::sin(turn));
    rim.push_back(luminaire.position_m + luminaire.world_from_luminaire * glm::dvec3(p, 0.0));
  }
  return rim;
}

void add_edges(PictureScene& picture, const calc::PreparedScene& scene,
               const calc::Cutaway& cutaway, double scale) {
  EdgeSet shown(scene), removed(scene);
  for (const calc::SurfaceSide& side : cutaway.shown) shown.add(side.triangle, side.normal);
  for (const std::uint32_t triangle : cutaway.removed) {
    removed.add(triangle, normal_of(scene, triangle));
  }
  removed.tell([&](const glm::dvec3& a, const glm::dvec3& b) {
    picture.lines.push_back({a, b, kRemovedEdge, 1.0 * scale, 0.0});
  });
  shown.tell([&](const glm::dvec3& a, const glm::dvec3& b) {
    picture.lines.push_back({a, b, kEdge, 1.1 * scale, 0.0});
  });
}

void add_luminaires(PictureScene& picture, const calc::PreparedScene& scene, double scale,
                    const LuminaireGlow& glow) {
  for (const calc::PlacedLuminaire& luminaire : scene.luminaires) {
    const glm::vec4 colour = glow ? glow(luminaire) : kOpening;
    if (luminaire.opening.shape == calc::OpeningShape::point) {
      picture.dots.push_back(
          {luminaire.position_m, 4.0 * scale, colour, glow ? colour : kOpeningEdge});
      continue;
    }
    const std::vector<glm::dvec3> rim = opening_rim_m(luminaire);
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const glm::dvec3 &a = rim[k], &b = rim[(k + 1) % rim.size()];
      picture.faces.push_back({{luminaire.position_m, a, b}, colour});
      if (!glow) picture.lines.push_back({a, b, kOpeningEdge, 1.2 * scale, 0.0});
    }
  }
}

void add_outline(PictureScene& picture, std::span<const glm::dvec3> corner_m, double scale,
                 bool is_faint) {
  for (auto [colour, width] : {std::pair{kOutlineHalo, 3.4}, std::pair{kOutline, 1.6}}) {
    if (is_faint) colour.a *= 0.3f;
    for (std::size_t k = 0; k < corner_m.size(); ++k) {
      picture.lines.push_back(
          {corner_m[k], corner_m[(k + 1) % corner_m.size()], colour, width * scale, 0.25});
    }
  }
}

void add_vertices(PictureScene& picture, std::span<const calc::LightVertex> vertices,
                  const VertexStyle& style, double scale) {
  float most_lm = 0.0f;
  for (const calc::LightVertex& vertex : vertices) most_lm = std::max(most_lm, vertex.flux_lm);
  if (!(most_lm > 0.0f)) return;
  for (const calc::LightVertex& vertex : vertices) {
    const double share = static_cast<double>(vertex.flux_lm / most_lm);
    const double across_px = std::max(style.least_px, style.most_px * std::sqrt(share));
    picture.dots.push_back({glm::dvec3(vertex.position_m), 0.5 * across_px * scale,
                            style.colour(share), glm::vec4(0.05f, 0.06f, 0.09f, 0.9f)});
  }
}

Picture render_vertices(DeviceThread& thread, const calc::Tracer& tracer,
                        std::span<const calc::LightVertex> vertices, const VertexStyle& style,
                        bool opens_room, int width, double scale) {
  const calc::PreparedScene& scene = tracer.scene();
  const Camera camera = corner_camera(box_of(scene));
  const calc::Cutaway cutaway = calc::cut_away(tracer, camera.eye_m, opens_room);
  PictureScene picture;
  picture.lift_m = 2e-3 * scene.extent_m;
  for (const calc::SurfaceSide& side : cutaway.shown) {
    const glm::vec3& n = side.normal;
    // From upper left, so that floor, walls and sides differ.
    const float shade = 0.72f + 0.18f * n.z + 0.06f * n.x - 0.04f * n.y;
    const auto first = static_cast<std::uint32_t>(picture.position_m.size());
    for (int k = 0; k < 3; ++k) {
      picture.position_m.push_back(scene.vertex_m[scene.triangle[side.triangle][k]]);
      picture.value.push_back(std::clamp(shade, 0.0f, 1.0f));
    }
    picture.triangle.emplace_back(first, first + 1, first + 2);
  }
  add_edges(picture, scene, cutaway, scale);
  add_luminaires(picture, scene, scale);
  add_vertices(picture, vertices, style, scale);
  return draw_picture(thread, picture, camera, width);
}

}  // namespace gpu
