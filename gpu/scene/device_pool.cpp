#include "gpu/scene/device_pool.h"

#include "gpu/opengl/gl_error.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace gpu {
namespace {

constexpr std::size_t kMostPools = 128;
constexpr std::size_t kMostPoolBytes = std::size_t{1} << 30;

}  // namespace

PackedPool pack_pool(std::span<const calc::LightVertex> vertices) {
  PackedPool packed;
  packed.position_m.reserve(vertices.size());
  packed.normal.reserve(vertices.size());
  for (const calc::LightVertex& v : vertices) {
    packed.position_m.emplace_back(v.position_m, v.flux_lm);
    packed.normal.emplace_back(v.normal, static_cast<float>(v.channel));
  }
  return packed;
}

PackedPool pack_pool(const calc::VertexTree& tree) {
  PackedPool packed = pack_pool(tree.vertices());
  packed.sphere.reserve(tree.nodes().size());
  packed.rest.reserve(tree.nodes().size());
  packed.half.reserve(tree.nodes().size());
  packed.axis.reserve(tree.nodes().size());
  for (const calc::VertexNode& node : tree.nodes()) {
    packed.sphere.emplace_back(node.centre_m, node.radius_m);
    packed.rest.emplace_back(std::bit_cast<std::uint32_t>(node.flux_lm),
                             std::bit_cast<std::uint32_t>(node.per_m2), node.first, node.size());
    packed.half.emplace_back(node.half_m, node.cos_spread);
    packed.axis.emplace_back(glm::floatBitsToUint(node.axis), node.child);
  }
  packed.flux_before_lm = tree.flux_before_lm();
  packed.has_tree = true;
  return packed;
}

std::size_t DevicePool::bytes() const {
  return position.bytes() + normal.bytes() + sphere.bytes() + rest.bytes() + half.bytes() +
         axis.bytes() + flux_before.bytes();
}

void DevicePool::bind_vertices() const {
  position.bind(2);
  normal.bind(3);
}

void DevicePool::bind_tree() const {
  sphere.bind(6);
  rest.bind(7);
  flux_before.bind(11);
}

void DevicePool::bind_nodes() const {
  sphere.bind(6);
  rest.bind(7);
  half.bind(8);
  axis.bind(9);
}

bool DevicePools::holds(std::uint64_t identity) const {
  const std::scoped_lock lock(mutex_);
  return identity != 0 && std::any_of(pools_.begin(), pools_.end(), [&](const DevicePool& pool) {
           return pool.identity == identity && pool.has_tree;
         });
}

std::shared_ptr<const PackedPool> DevicePools::pack_unless_held(const calc::VertexTree& tree) {
  if (holds(tree.identity())) return nullptr;
  return packings_.get(tree.identity(), [&] { return pack_pool(tree); });
}

const DevicePool& DevicePools::find_or_send(const calc::VertexTree& tree,
                                            const PackedPool* packed) {
  const DevicePool* pool = find(tree.identity(), true);
  if (pool != nullptr) return *pool;
  return send(tree.identity(), packed != nullptr ? *packed : pack_pool(tree));
}

const DevicePool* DevicePools::find(std::uint64_t identity, bool needs_tree) {
  const std::scoped_lock lock(mutex_);
  const auto found = std::find_if(pools_.begin(), pools_.end(), [&](const DevicePool& pool) {
    return pool.identity == identity && (pool.has_tree || !needs_tree);
  });
  if (identity == 0 || found == pools_.end()) return nullptr;
  pools_.splice(pools_.begin(), pools_, found);
  return &pools_.front();
}

const DevicePool& DevicePools::send(std::uint64_t identity, const PackedPool& packed) {
  DevicePool pool{identity,
                  packed.has_tree,
                  GlBuffer("light vertices", BufferUse::fixed),
                  GlBuffer("normals of light vertices", BufferUse::fixed),
                  GlBuffer("groups of light vertices", BufferUse::fixed),
                  GlBuffer("fluxes of groups of light vertices", BufferUse::fixed),
                  GlBuffer("boxes of groups of light vertices", BufferUse::fixed),
                  GlBuffer("normals of groups of light vertices", BufferUse::fixed),
                  GlBuffer("summed flux of light vertices", BufferUse::fixed)};
  pool.position.assign(packed.position_m);
  pool.normal.assign(packed.normal);
  pool.sphere.assign(packed.sphere);
  pool.rest.assign(packed.rest);
  pool.half.assign(packed.half);
  pool.axis.assign(packed.axis);
  pool.flux_before.assign(packed.flux_before_lm);
  check_gl("sending light vertices");
  const std::scoped_lock lock(mutex_);
  if (identity != 0) {
    pools_.remove_if([&](const DevicePool& other) { return other.identity == identity; });
  }
  std::size_t bytes = pool.bytes();
  for (const DevicePool& other : pools_) bytes += other.bytes();
  while (!pools_.empty() && (pools_.size() >= kMostPools || bytes > kMostPoolBytes)) {
    bytes -= pools_.back().bytes();
    pools_.pop_back();
  }
  pools_.push_front(std::move(pool));
  return pools_.front();
}

void DevicePools::clear() {
  const std::scoped_lock lock(mutex_);
  pools_.clear();
}

}  // namespace gpu
