// Searches in single precision that never leave out what meets() in double would find.
//
// u = 2^-24 is the largest relative error of one rounding. With fused multiplications errors are
// smaller or equal, so that the bounds below hold for every way in which the compiler or the
// processor may put these sums together. |x|1 is the sum of absolute components. Denormal results
// may be flushed: scenes are taken to be larger than a micrometre.
#include "calc/rays/tree_kernels.h"

#include "calc/rays/instruction_set.h"

#include <algorithm>
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "calc/rays/tree_kernels.cpp"
#include <hwy/foreach_target.h>  // includes this file once for each target
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace calc {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tree = TriangleTree;
constexpr hn::CappedTag<float, Tree::kWidth> kTag;

constexpr float kRounding = 1.0f / 16777216.0f;  // u

// A ray as the searches need it.
struct Probe {
  std::array<float, 3> origin, direction;
  // For planes of boxes where the ray comes in and goes out. The origins are moved apart by more
  // than rounding can do, which makes every box that much larger on all sides.
  std::array<float, 3> origin_in, origin_out, inverse;
  std::array<float, 3> moment;  // -2 origin x direction
  float edge_scale, height_error, slope_error;
  float least, most;
};

HWY_INLINE void prepare(const TreeView& tree, const Ray& ray, Probe& probe) {
  float direction_sum = 0.0f, origin_sum = 0.0f;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    probe.origin[i] = ray.origin[k];
    probe.direction[i] = ray.direction[k];
    direction_sum += std::fabs(ray.direction[k]);
    origin_sum += std::fabs(ray.origin[k]);
  }
  // (plane - origin) * inverse is wrong by 4 u of |plane - origin| at most, the moved origin by one
  // more u of itself: 5 u (largest + |origin|1); a hit lies off the ray, and so outside its box, by
  // up to 8 u (kMostOff of triangle_hit.cpp), and its distance is rounded to single precision, 1 u.
  const float margin = 16.0f * kRounding * (tree.largest_m + origin_sum);
  // So slow a direction leaves no box within any distance that matters.
  const float slowest = 1e-18f * direction_sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const float along = std::fabs(probe.direction[i]) < slowest
                            ? std::copysign(slowest, probe.direction[i])
                            : probe.direction[i];
    const float shift = std::copysign(margin, along);
    probe.inverse[i] = 1.0f / along;
    probe.origin_in[i] = probe.origin[i] + shift;
    probe.origin_out[i] = probe.origin[i] - shift;
  }
  const std::array<float, 3>&o = probe.origin, &d = probe.direction;
  probe.moment = {-2.0f * (o[1] * d[2] - o[2] * d[1]), -2.0f * (o[2] * d[0] - o[0] * d[2]),
                  -2.0f * (o[0] * d[1] - o[1] * d[0])};
  probe.edge_scale = direction_sum * (origin_sum + tree.largest_m);
  // height - normal . origin: 6 u (reach + |origin|) with the rounding of height and normal, and 2
  // u of each comparison.
  probe.height_error = 12.0f * kRounding * (tree.reach_m + origin_sum);
  // normal . direction: 5 u |direction|1. A slope below it means a place beyond the triangle unless
  // the height is below its error, too, so that this only saves looking twice.
  probe.slope_error = 6.0f * kRounding * direction_sum;
  probe.least = ray.least;
  probe.most = ray.most;
}

// Children whose boxes the ray may meet between least and most, and where it would come in.
HWY_INLINE std::uint32_t children(const Tree::Node& node, const Probe& probe, float* enters) {
  const auto in_x = hn::Set(kTag, probe.origin_in[0]), in_y = hn::Set(kTag, probe.origin_in[1]),
             in_z = hn::Set(kTag, probe.origin_in[2]);
  const auto out_x = hn::Set(kTag, probe.origin_out[0]), out_y = hn::Set(kTag, probe.origin_out[1]),
             out_z = hn::Set(kTag, probe.origin_out[2]);
  const auto per_x = hn::Set(kTag, probe.inverse[0]), per_y = hn::Set(kTag, probe.inverse[1]),
             per_z = hn::Set(kTag, probe.inverse[2]);
  const auto& near_x = probe.inverse[0] < 0.0f ? node.high_m[0] : node.low_m[0];
  const auto& near_y = probe.inverse[1] < 0.0f ? node.high_m[1] : node.low_m[1];
  const auto& near_z = probe.inverse[2] < 0.0f ? node.high_m[2] : node.low_m[2];
  const auto& far_x = probe.inverse[0] < 0.0f ? node.low_m[0] : node.high_m[0];
  const auto& far_y = probe.inverse[1] < 0.0f ? node.low_m[1] : node.high_m[1];
  const auto& far_z = probe.inverse[2] < 0.0f ? node.low_m[2] : node.high_m[2];
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < Tree::kWidth; i += hn::Lanes(kTag)) {
    const auto x0 = hn::Mul(hn::Sub(hn::Load(kTag, near_x.data() + i), in_x), per_x);
    const auto y0 = hn::Mul(hn::Sub(hn::Load(kTag, near_y.data() + i), in_y), per_y);
    const auto z0 = hn::Mul(hn::Sub(hn::Load(kTag, near_z.data() + i), in_z), per_z);
    const auto x1 = hn::Mul(hn::Sub(hn::Load(kTag, far_x.data() + i), out_x), per_x);
    const auto y1 = hn::Mul(hn::Sub(hn::Load(kTag, far_y.data() + i), out_y), per_y);
    const auto z1 = hn::Mul(hn::Sub(hn::Load(kTag, far_z.data() + i), out_z), per_z);
    const auto enter = hn::Max(hn::Max(x0, y0), hn::Max(z0, hn::Set(kTag, probe.least)));
    const auto leave = hn::Min(hn::Min(x1, y1), hn::Min(z1, hn::Set(kTag, probe.most)));
    if (enters != nullptr) hn::Store(enter, kTag, enters + i);
    std::array<std::uint8_t, 8> bits{};
    hn::StoreMaskBits(kTag, hn::Le(enter, leave), bits.data());
    mask |= static_cast<std::uint32_t>(bits[0]) << i;
  }
  return mask;
}

// Triangles that the ray may meet between least and most, and among them those that it meets for
// certain.
struct Candidates {
  std::uint32_t possible = 0, certain = 0;
};

HWY_INLINE Candidates candidates(const Tree::Block& block, const Probe& probe) {
  const auto direction_x = hn::Set(kTag, probe.direction[0]),
             direction_y = hn::Set(kTag, probe.direction[1]),
             direction_z = hn::Set(kTag, probe.direction[2]);
  const auto height_error = hn::Set(kTag, probe.height_error),
             slope_error = hn::Set(kTag, probe.slope_error);
  const auto least = hn::Set(kTag, probe.least), most = hn::Set(kTag, probe.most);
  Candidates found;
  for (std::size_t i = 0; i < Tree::kWidth; i += hn::Lanes(kTag)) {
    // Where the ray goes through the plane: t = height / slope, known within the errors of both.
    const auto normal_x = hn::Load(kTag, block.normal[0].data() + i),
               normal_y = hn::Load(kTag, block.normal[1].data() + i),
               normal_z = hn::Load(kTag, block.normal[2].data() + i);
    const auto slope = hn::MulAdd(
        normal_x, direction_x, hn::MulAdd(normal_y, direction_y, hn::Mul(normal_z, direction_z)));
    const auto height =
        hn::NegMulAdd(normal_x, hn::Set(kTag, probe.origin[0]),
                      hn::NegMulAdd(normal_y, hn::Set(kTag, probe.origin[1]),
                                    hn::NegMulAdd(normal_z, hn::Set(kTag, probe.origin[2]),
                                                  hn::Load(kTag, block.height_m.data() + i))));
    const auto speed = hn::Abs(slope);
    const auto ahead = hn::IfThenElse(hn::Lt(slope, hn::Zero(kTag)), hn::Neg(height), height);
    const auto is_known = hn::Gt(speed, slope_error);
    const auto fastest = hn::Add(speed, slope_error), slowest = hn::Sub(speed, slope_error);
    const auto nearest = hn::Sub(ahead, height_error), farthest = hn::Add(ahead, height_error);
    const auto is_out = hn::And(is_known, hn::Or(hn::Gt(nearest, hn::Mul(most, fastest)),
                                                 hn::Lt(farthest, hn::Mul(least, slowest))));
    if (hn::AllTrue(kTag, is_out)) continue;
    const auto is_in = hn::And(is_known, hn::And(hn::Gt(nearest, hn::Mul(least, fastest)),
                                                 hn::Lt(farthest, hn::Mul(most, slowest))));

    // On which side of each edge: edge . moment of the ray + moment of the edge . direction, wrong
    // by u |direction|1 max|edge| (18 |origin|1 + 28 largest) at most.
    const auto side_of = [&](std::size_t which) HWY_ATTR {
      const std::array<Tree::Lanes, 3>&edge = block.edge[which], &moment = block.moment[which];
      auto sum = hn::Mul(hn::Load(kTag, moment[2].data() + i), direction_z);
      sum = hn::MulAdd(hn::Load(kTag, moment[1].data() + i), direction_y, sum);
      sum = hn::MulAdd(hn::Load(kTag, moment[0].data() + i), direction_x, sum);
      sum = hn::MulAdd(hn::Load(kTag, edge[2].data() + i), hn::Set(kTag, probe.moment[2]), sum);
      sum = hn::MulAdd(hn::Load(kTag, edge[1].data() + i), hn::Set(kTag, probe.moment[1]), sum);
      return hn::MulAdd(hn::Load(kTag, edge[0].data() + i), hn::Set(kTag, probe.moment[0]), sum);
    };
    const auto a = side_of(0), b = side_of(1), c = side_of(2);
    const auto lowest = hn::Min(a, hn::Min(b, c)), highest = hn::Max(a, hn::Max(b, c));
    const auto error =
        hn::Mul(hn::Load(kTag, block.edge_error.data() + i), hn::Set(kTag, probe.edge_scale));
    const auto may_meet = hn::Or(hn::Ge(lowest, hn::Neg(error)), hn::Le(highest, error));
    const auto must_meet = hn::Or(hn::Gt(lowest, error), hn::Lt(highest, hn::Neg(error)));

    std::array<std::uint8_t, 8> bits{};
    hn::StoreMaskBits(kTag, hn::AndNot(is_out, may_meet), bits.data());
    found.possible |= static_cast<std::uint32_t>(bits[0]) << i;
    hn::StoreMaskBits(kTag, hn::And(is_in, must_meet), bits.data());
    found.certain |= static_cast<std::uint32_t>(bits[0]) << i;
  }
  const std::uint32_t used = (1u << block.count) - 1u;  // of at most 8
  found.possible &= used;
  found.certain &= used;
  return found;
}

HWY_INLINE std::size_t next_bit(std::uint32_t& mask) {
  const auto lane = static_cast<std::size_t>(std::countr_zero(mask));
  mask &= mask - 1;
  return lane;
}

HWY_INLINE bool is_blocked_by(const TreeView& tree, const Tree::Block& block, const Ray& ray,
                              const Probe& probe) {
  Candidates found = candidates(block, probe);
  if (found.certain != 0) return true;
  while (found.possible != 0) {
    TriangleHit hit;
    if (meets(ray, tree.triangles[block.index[next_bit(found.possible)]], hit)) return true;
  }
  return false;
}

// Below the children of the root in `mask`.
HWY_INLINE bool is_blocked_below(const TreeView& tree, const Ray& ray, const Probe& probe,
                                 std::uint32_t mask) {
  std::array<Tree::Child, tree_detail::kStack> stack;
  std::size_t size = 0;
  const Tree::Node* node = &tree.nodes[tree.root];
  for (;;) {
    while (mask != 0) {
      const Tree::Child child = node->child[next_bit(mask)];
      if ((child & Tree::kBlock) == 0) {
        stack[size++] = child;
      } else if (is_blocked_by(tree, tree.blocks[child & ~Tree::kBlock], ray, probe)) {
        return true;
      }
    }
    if (size == 0) return false;
    node = &tree.nodes[stack[--size]];
    mask = children(*node, probe, nullptr);
  }
}

std::uint32_t Blocked(const TreeView& tree, std::span<const Ray> rays) {
  std::array<Probe, Tree::kRays> probes;
  for (std::size_t k = 0; k < rays.size(); ++k) prepare(tree, rays[k], probes[k]);
  std::uint32_t blocked = 0;
  if ((tree.root & Tree::kBlock) != 0) {
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const Tree::Block& block = tree.blocks[tree.root & ~Tree::kBlock];
      if (is_blocked_by(tree, block, rays[k], probes[k])) blocked |= 1u << k;
    }
    return blocked;
  }
  // All rays at the root first: none waits for the one before.
  std::array<std::uint32_t, Tree::kRays> mask;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    mask[k] = children(tree.nodes[tree.root], probes[k], nullptr);
  }
  for (std::size_t k = 0; k < rays.size(); ++k) {
    if (is_blocked_below(tree, rays[k], probes[k], mask[k])) blocked |= 1u << k;
  }
  return blocked;
}

HWY_INLINE void look_for_first(const TreeView& tree, const Tree::Block& block, const Ray& ray,
                               Probe& probe, TriangleHit& first) {
  std::uint32_t possible = candidates(block, probe).possible;
  while (possible != 0) {
    TriangleHit hit;
    hit.triangle = block.index[next_bit(possible)];
    if (!meets(ray, tree.triangles[hit.triangle], hit) || !hit.is_before(first)) continue;
    first = hit;
    // What lies farther matters no longer; what lies as far may come first: the margins of boxes
    // and planes are above this rounding.
    probe.most = static_cast<float>(hit.t);
  }
}

// Nearer boxes are looked at first.
HWY_INLINE bool find_first(const TreeView& tree, const Ray& ray, Probe& probe, TriangleHit& first) {
  struct Entry {
    Tree::Child child;
    float enters;
  };
  std::array<Entry, tree_detail::kStack> stack;
  std::size_t size = 0;
  first = {};
  stack[size++] = {tree.root, probe.least};
  while (size > 0) {
    const Entry entry = stack[--size];
    if (entry.enters > probe.most) continue;
    if ((entry.child & Tree::kBlock) != 0) {
      look_for_first(tree, tree.blocks[entry.child & ~Tree::kBlock], ray, probe, first);
      continue;
    }
    const Tree::Node& node = tree.nodes[entry.child];
    alignas(64) Tree::Lanes enters;
    std::uint32_t mask = children(node, probe, enters.data());
    const std::size_t begin = size;
    while (mask != 0) {
      const std::size_t lane = next_bit(mask);
      std::size_t at = size++;
      for (; at > begin && stack[at - 1].enters < enters[lane]; --at) stack[at] = stack[at - 1];
      stack[at] = {node.child[lane], enters[lane]};
    }
  }
  return first.t < std::numeric_limits<double>::infinity();
}

std::uint32_t FirstHits(const TreeView& tree, std::span<const Ray> rays,
                        std::span<TriangleHit> hits) {
  std::uint32_t found = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    Probe probe;
    prepare(tree, rays[k], probe);
    if (find_first(tree, rays[k], probe, hits[k])) found |= 1u << k;
  }
  return found;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace calc
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace calc {

namespace {

// Not Highway's own choice: its library measures the clock whenever a program starts.
struct Searches {
  std::uint32_t (*blocked)(const TreeView&, std::span<const Ray>);
  std::uint32_t (*first_hits)(const TreeView&, std::span<const Ray>, std::span<TriangleHit>);
};

Searches choose_searches() {
  switch (search_kernels()) {
#if (HWY_TARGETS & HWY_AVX3) != 0
    case SearchKernels::avx512:
      return {N_AVX3::Blocked, N_AVX3::FirstHits};
#endif
#if (HWY_TARGETS & HWY_AVX2) != 0
    case SearchKernels::avx2:
      return {N_AVX2::Blocked, N_AVX2::FirstHits};
#endif
#if (HWY_TARGETS & HWY_SSE4) != 0
    case SearchKernels::sse4:
      return {N_SSE4::Blocked, N_SSE4::FirstHits};
#endif
#if (HWY_TARGETS & HWY_SSSE3) != 0
    case SearchKernels::ssse3:
      return {N_SSSE3::Blocked, N_SSSE3::FirstHits};
#endif
    default:
      return {HWY_NAMESPACE::Blocked, HWY_NAMESPACE::FirstHits};  // of all processors
  }
}

const Searches& searches() {
  static const Searches chosen = choose_searches();
  return chosen;
}

}  // namespace

std::uint32_t blocked_rays(const TreeView& tree, std::span<const Ray> rays) {
  return searches().blocked(tree, rays);
}

std::uint32_t first_hits_of_rays(const TreeView& tree, std::span<const Ray> rays,
                                 std::span<TriangleHit> hits) {
  return searches().first_hits(tree, rays, hits);
}

}  // namespace calc
#endif
