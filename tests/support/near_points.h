#pragma once
// Near fields that are computed by two ways.

#include "calc/radiosity/paths/cut.h"
#include "calc/radiosity/paths/light_paths.h"
#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/paths/vertex_bounds.h"
#include "calc/radiosity/paths/vertex_tree.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace test_support {

// All that the near field of a scene needs, from so many light paths.
struct NearScene {
  const calc::PreparedScene& scene;
  calc::Tracer tracer{scene};
  calc::Emitter emitter{scene};
  calc::LuminaireChoice choice{scene};
  calc::GeometryBound bound;
  calc::VertexTree tree;
  calc::VertexBounds bounds{bound, tree.vertices()};
  calc::Cut cut;
  double deadline_s = 0.0;

  NearScene(const calc::PreparedScene& of, std::uint32_t paths)
      : scene(of),
        bound(tracer, emitter, paths),
        tree(calc::trace_light_paths(tracer, emitter, {7, 0, 0, paths}).vertices,
             of.channels.size()) {
    calc::ReceiverTile everywhere;
    everywhere.softening_m = static_cast<float>(0.1 * of.extent_m);
    cut.build(tree, everywhere, {128, static_cast<float>(bound.smallest()), false});
  }

  calc::NearField near() const {
    return {tracer, bound, choice, tree, bounds, cut, scene.channels.size(), deadline_s};
  }
};

// Points that are asked for short rays: as the CPU takes them, one by one, and as devices do.
struct NearPoints {
  calc::ReceiverTiles tiles;
  calc::RandomKey key{23};
  std::vector<calc::PointRays> points;
  std::vector<calc::NearFieldRequest> requests;

  NearPoints(const std::vector<calc::Receiver>& receivers, std::uint32_t rays,
             std::size_t tile_points = 32) {
    std::vector<calc::ReceiverGroup> groups;
    for (std::uint32_t i = 0; i < receivers.size(); ++i) {
      if (i % tile_points == 0) groups.emplace_back();
      groups.back().point.push_back(i);
      groups.back().receiver.push_back(receivers[i]);
      points.push_back({i, rays});
      requests.push_back({receivers[i], key.with(i), rays});
    }
    tiles = calc::ReceiverTiles(std::move(groups));
  }

  calc::NearFieldBatch batch() const { return {tiles, key, points}; }
};

// Points of all kinds in LampHall, some of them in the plane of a floor or wall.
inline NearPoints points_in_hall(std::size_t count, std::uint32_t rays) {
  std::vector<calc::Receiver> receivers;
  for (std::size_t i = 0; i < count; ++i) {
    const calc::RandomKey key = calc::RandomKey(23).with(i);
    const auto u = [&](std::uint64_t k) { return key.with(k).uniform(); };
    const auto kernel = static_cast<calc::ReceiverKernel>(i % 5);
    glm::dvec3 axis = glm::normalize(glm::dvec3(u(3) - 0.5, u(4) - 0.5, u(5) - 0.5));
    glm::dvec3 position(7.6 * u(0) - 3.8, 5.6 * u(1) - 2.8, 0.1 + 3.3 * u(2));
    if (i % 15 == 0) {
      position.z = 0.0;
      axis = {0, 0, 1};
    }
    if (i % 15 == 5) {
      position.x = -4.0;
      axis = {1, 0, 0};
    }
    if (kernel == calc::ReceiverKernel::semicylindrical && i % 15 != 5) {
      axis = glm::normalize(glm::dvec3(axis.x, axis.y, 0.0));
    }
    receivers.push_back({position, axis, kernel});
  }
  return {receivers, rays};
}

}  // namespace test_support
