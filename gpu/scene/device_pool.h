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

// A pool in the shaders' layout, in separate arrays, so that the largest pool (calc::kMostVertices)
// fits into buffers of 128 MiB.
struct PackedPool {
  std::vector<glm::vec4> position_m;  // last component: flux, lm
  std::vector<glm::vec4> normal;      // last component: channel
  std::vector<glm::vec4> sphere;      // [node] centre and radius, m
  std::vector<glm::uvec4> rest;       // [node] flux and vertices per m2 as floats; first, count
  std::vector<glm::vec4> half;        // [node] half sizes of its box, m; cos_spread
  std::vector<glm::uvec4> axis;       // [node] mean normal as floats; child
  std::span<const double> flux_before_lm;
  bool has_tree = false;  // the nodes and the flux are there
};

PackedPool pack_pool(std::span<const calc::LightVertex> vertices);
PackedPool pack_pool(const calc::VertexTree& tree);  // which must live on

struct DevicePool {
  std::uint64_t identity;
  bool has_tree;
  GlBuffer position, normal, sphere, rest, half, axis, flux_before;

  std::size_t bytes() const;
  // Bind to bindings 2, 3; for draws 6, 7, 11; to choose nodes 6 to 9.
  void bind_vertices() const;
  void bind_tree() const;
  void bind_nodes() const;
};

// The pools used last, because the replicates of a sampling round are computed side by side.
class DevicePools {
 public:
  // Returns the data for find_or_send(), packed once for all threads that need it at the same time;
  // null if the device has it with its tree. For all threads.
  std::shared_ptr<const PackedPool> pack_unless_held(const calc::VertexTree& tree);

  // All others, also the destructor, need the context current in which the pools live. Returns null
  // if it is missing, or lacks the needed tree. Valid until the next call.
  const DevicePool* find(std::uint64_t identity, bool needs_tree);
  // Sends a pool and replaces one of the same identity. identity: as VertexTree::identity(), 0 =
  // never used again. Throws GlError.
  const DevicePool& send(std::uint64_t identity, const PackedPool& packed);
  // Returns the pool with its tree. packed: of pack_unless_held(); null, but the pool is gone:
  // packs it now.
  const DevicePool& find_or_send(const calc::VertexTree& tree, const PackedPool* packed);
  void clear();

 private:
  bool holds(std::uint64_t identity) const;

  mutable std::mutex mutex_;     // changes of the list, and reading it outside the context's thread
  std::list<DevicePool> pools_;  // latest use first
  PackOnce<std::uint64_t, PackedPool> packings_;  // by VertexTree::identity()
};

}  // namespace gpu
