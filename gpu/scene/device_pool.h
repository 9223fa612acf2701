#pragma once
// Pools of light vertices on the device, with the groups that draws choose from.

#include "calc/radiosity/paths/light_vertex.h"
#include "calc/radiosity/paths/vertex_tree.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/pack_once.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace gpu {

// As the shaders read them. Apart, so that the largest pool (calc::kMostVertices) fits into buffers
// of 128 MiB.
struct PackedPool {
  std::vector<glm::vec4> position_m;  // last component: flux, lm
  std::vector<glm::vec4> normal;      // last component: channel
  std::vector<glm::vec4> sphere;      // [node] centre and radius, m
  std::vector<glm::uvec4> rest;       // [node] flux and vertices per m2 as floats; first, count
  std::vector<glm::vec4> half;        // [node] half sizes of its box, m; cos_spread
  std::vector<glm::uvec4> axis;       // [node] mean normal as floats; child
  std::span<const double> flux_before_lm;
  bool has_tree = false;  // what is said of nodes, and the flux, are there
};

PackedPool pack_pool(std::span<const calc::LightVertex> vertices);
PackedPool pack_pool(const calc::VertexTree& tree);  // which must live on

struct DevicePool {
  std::uint64_t identity;
  bool has_tree;
  GlBuffer position, normal, sphere, rest, half, axis, flux_before;

  std::size_t bytes() const;
  // To bindings 2, 3; for draws 6, 7, 11; to choose nodes 6 to 9.
  void bind_vertices() const;
  void bind_tree() const;
  void bind_nodes() const;
};

// The pools used last: the replicates of a look are computed side by side.
class DevicePools {
 public:
  // For all threads: what find_or_send() takes, packed once for all that want it at the same time;
  // null if the device has it with its tree.
  std::shared_ptr<const PackedPool> pack_unless_held(const calc::VertexTree& tree);

  // All others need the context current in which the pools live, the destructor too.
  // Null if it is not there, or lacks the tree that is needed. Valid until the next call.
  const DevicePool* find(std::uint64_t identity, bool needs_tree);
  // identity: as VertexTree::identity(), 0 = never used again. Takes the place of a pool of the
  // same identity. Throws GlError.
  const DevicePool& send(std::uint64_t identity, const PackedPool& packed);
  // With its tree. packed: of pack_unless_held(); null, though it is not there any more: packed
  // now.
  const DevicePool& find_or_send(const calc::VertexTree& tree, const PackedPool* packed);
  void clear();

 private:
  bool holds(std::uint64_t identity) const;

  mutable std::mutex mutex_;     // changes of the list, and reading it outside the context's thread
  std::list<DevicePool> pools_;  // latest use first
  PackOnce<std::uint64_t, PackedPool> packings_;  // by VertexTree::identity()
};

}  // namespace gpu
