#include "calc/rays/triangle_tree.h"

#include "calc/rays/instruction_set.h"
#include "calc/rays/tree_kernels.h"

// The version that CMake found. What is asked of it here is the same in both.
#if LUXGATE_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace calc {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

void throw_embree_error(void* /*user*/, RTCError code, const char* text) {
  throw std::runtime_error(fmt::format("Embree error {}: {}", static_cast<int>(code), text));
}

// One for the whole process, which is never released: where memory ends, threads that open and
// release devices wait for each other for ever (Embree 3.13 and 4.3).
RTCDevice embree_device() {
  static const RTCDevice device = [] {
    const RTCDevice opened = rtcNewDevice(embree_instruction_set().c_str());
    if (opened == nullptr) throw std::runtime_error("Embree gives no device");
    rtcSetDeviceErrorFunction(opened, throw_embree_error, nullptr);
    return opened;
  }();
  return device;
}

struct ReleaseTree {
  void operator()(RTCBVH tree) const { rtcReleaseBVH(tree); }
};

// Sine of the angle between two edges below which rounding to double may turn the normal by more
// than single precision shows: 2^-53 / kThinnest is far below 2^-24.
constexpr double kThinnest = 0x1p-22;

float rounded_up(double value) { return std::nextafter(static_cast<float>(value), kInfinity); }

}  // namespace

// Embree divides the triangles into leaves and calls back, on many threads; nodes and blocks stand
// in the order of its calls, which no answer depends on.
class TriangleTree::Builder {
 public:
  explicit Builder(TriangleTree& tree) : tree_(tree) {}

  void build() {
    const std::unique_ptr<std::remove_pointer_t<RTCBVH>, ReleaseTree> tree(
        rtcNewBVH(embree_device()));
    if (tree == nullptr) throw std::runtime_error("Embree gives no tree");

    std::vector<RTCBuildPrimitive> primitives;
    primitives.reserve(tree_.triangles_.size());
    for (const Triangle& triangle : tree_.triangles_) {
      // Corners were floats: exact.
      const glm::vec3 low(glm::min(triangle.a, glm::min(triangle.b, triangle.c)));
      const glm::vec3 high(glm::max(triangle.a, glm::max(triangle.b, triangle.c)));
      primitives.push_back({low.x, low.y, low.z, 0, high.x, high.y, high.z,
                            static_cast<unsigned>(primitives.size())});
    }
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.maxBranchingFactor = kWidth;
    arguments.maxLeafSize = kWidth;
    arguments.sahBlockSize = kWidth;
    arguments.bvh = tree.get();
    arguments.primitives = primitives.data();
    arguments.primitiveCount = primitives.size();
    arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = create_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = create_leaf;
    arguments.userPtr = this;
    void* const root = rtcBuildBVH(&arguments);
    if (root == nullptr) throw std::runtime_error("Embree builds no tree");
    tree_.root_ = child_of(root);
    if (depth(tree_.root_) * (kWidth - 1) + kWidth > tree_detail::kStack) {
      throw std::runtime_error("the tree over the surfaces is too deep");
    }
  }

 private:
  // Embree hands pointers back that it never follows; ours are children, plus one as 0 means none.
  static void* pointer_to(Child child) {
    return std::bit_cast<void*>(static_cast<std::uintptr_t>(child) + 1);
  }
  static Child child_of(void* pointer) {
    return static_cast<Child>(std::bit_cast<std::uintptr_t>(pointer) - 1);
  }

  static void* create_node(RTCThreadLocalAllocator /*allocator*/, unsigned /*children*/,
                           void* user) {
    auto& self = *static_cast<Builder*>(user);
    Node node;
    for (Lanes& low : node.low_m) low.fill(kInfinity);
    for (Lanes& high : node.high_m) high.fill(-kInfinity);
    node.child.fill(kNone);
    const std::lock_guard lock(self.mutex_);
    self.tree_.nodes_.push_back(node);
    return pointer_to(static_cast<Child>(self.tree_.nodes_.size() - 1));
  }

  static void set_children(void* pointer, void** children, unsigned count, void* user) {
    auto& self = *static_cast<Builder*>(user);
    const std::lock_guard lock(self.mutex_);
    Node& node = self.tree_.nodes_[child_of(pointer)];
    for (unsigned k = 0; k < count; ++k) node.child[k] = child_of(children[k]);
  }

  static void set_bounds(void* pointer, const RTCBounds** bounds, unsigned count, void* user) {
    auto& self = *static_cast<Builder*>(user);
    const std::lock_guard lock(self.mutex_);
    Node& node = self.tree_.nodes_[child_of(pointer)];
    for (unsigned k = 0; k < count; ++k) {
      const RTCBounds& box = *bounds[k];
      node.low_m[0][k] = box.lower_x;
      node.low_m[1][k] = box.lower_y;
      node.low_m[2][k] = box.lower_z;
      node.high_m[0][k] = box.upper_x;
      node.high_m[1][k] = box.upper_y;
      node.high_m[2][k] = box.upper_z;
    }
  }

  static void* create_leaf(RTCThreadLocalAllocator /*allocator*/,
                           const RTCBuildPrimitive* primitives, std::size_t count, void* user) {
    auto& self = *static_cast<Builder*>(user);
    Block block{};
    assert(count <= kWidth);
    block.count = static_cast<std::uint32_t>(count);
    // Lanes without a triangle repeat the first: they are out whenever it is.
    for (std::size_t k = 0; k < kWidth; ++k) {
      self.fill_lane(block, k, primitives[k < count ? k : 0].primID);
    }
    const std::lock_guard lock(self.mutex_);
    self.tree_.blocks_.push_back(block);
    return pointer_to(static_cast<Child>(self.tree_.blocks_.size() - 1) | kBlock);
  }

  void fill_lane(Block& block, std::size_t lane, std::uint32_t index) const {
    const Triangle& triangle = tree_.triangles_[index];
    const std::array<glm::dvec3, 3> corner{triangle.a, triangle.b, triangle.c};
    const glm::dvec3 ab = corner[1] - corner[0], ac = corner[2] - corner[0];
    const glm::dvec3 across = glm::cross(ab, ac);
    // Corners so nearly on one line leave the plane unknown: a normal of 0 makes it decide nothing.
    const bool has_plane = glm::length(across) > kThinnest * glm::length(ab) * glm::length(ac);
    const glm::dvec3 normal = has_plane ? glm::normalize(across) : glm::dvec3(0.0);
    double longest = 0.0;
    for (std::size_t which = 0; which < 3; ++which) {
      const glm::dvec3 &begin = corner[(which + 1) % 3], &end = corner[(which + 2) % 3];
      const glm::dvec3 edge = end - begin, moment = glm::cross(edge, begin + end);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<glm::length_t>(axis);
        block.edge[which][axis][lane] = static_cast<float>(edge[i]);
        block.moment[which][axis][lane] = static_cast<float>(moment[i]);
        longest = std::max(longest, std::abs(edge[i]));
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block.normal[axis][lane] = static_cast<float>(normal[static_cast<glm::length_t>(axis)]);
    }
    block.height_m[lane] = static_cast<float>(glm::dot(normal, corner[0]));
    block.edge_error[lane] = rounded_up(32.0 * 0x1p-24 * longest);  // see tree_kernels.cpp
    block.index[lane] = index;
  }

  std::size_t depth(Child child) const {
    if (child == kNone || (child & kBlock) != 0) return 0;
    std::size_t deepest = 0;
    for (const Child below : tree_.nodes_[child].child) deepest = std::max(deepest, depth(below));
    return deepest + 1;
  }

  TriangleTree& tree_;
  std::mutex mutex_;
};

TriangleTree::TriangleTree(std::span<const glm::vec3> vertex_m,
                           std::span<const glm::uvec3> corners) {
  triangles_.reserve(corners.size());
  double largest_m = 0.0, reach_m = 0.0;
  for (const glm::uvec3& corner : corners) {
    const Triangle& triangle = triangles_.emplace_back(Triangle{glm::dvec3(vertex_m[corner.x]),
                                                                glm::dvec3(vertex_m[corner.y]),
                                                                glm::dvec3(vertex_m[corner.z])});
    for (const glm::dvec3& point_m : {triangle.a, triangle.b, triangle.c}) {
      const glm::dvec3 size_m = glm::abs(point_m);
      largest_m = std::max({largest_m, size_m.x, size_m.y, size_m.z});
      reach_m = std::max(reach_m, glm::length(point_m));
    }
  }
  largest_m_ = rounded_up(largest_m);
  reach_m_ = rounded_up(reach_m);
  if (!triangles_.empty()) Builder(*this).build();
}

std::uint32_t TriangleTree::blocked(std::span<const Ray> rays) const {
  assert(rays.size() <= kRays);
  return is_empty() ? 0 : blocked_rays(TreeView(*this), rays);
}

std::uint32_t TriangleTree::first_hits(std::span<const Ray> rays,
                                       std::span<TriangleHit> hits) const {
  assert(rays.size() <= kRays && hits.size() >= rays.size());
  return is_empty() ? 0 : first_hits_of_rays(TreeView(*this), rays, hits);
}

std::string tree_builder_version() {
  return fmt::format("Embree {}.{}.{}", RTC_VERSION_MAJOR, RTC_VERSION_MINOR, RTC_VERSION_PATCH);
}

}  // namespace calc
