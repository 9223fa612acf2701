// The search of the device's tree by itself: its boxes against real numbers, its answers against
// the CPU's, and what it says when the driver leaves its loops early.
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/terms/path_terms.h"
#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/rays/path_shader_text.h"
#include "gpu/scene/bvh.h"
#include "tests/support/lamp_shop.h"
#include "tests/support/opengl.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace traversal_test {
namespace {

using namespace test_support;

void dispatch(std::size_t invocations) {
  const std::size_t groups = (invocations + gpu::kGroupSize - 1) / gpu::kGroupSize;
  glDispatchCompute(static_cast<GLuint>(groups), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
}

struct GpuRay {
  glm::vec3 from;
  float t_near;
  glm::vec3 along;
  float t_far;
};
static_assert(sizeof(GpuRay) == 32);

// ---- boxes ----

const char* const kBoxes = R"glsl(
layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = 3) readonly buffer Rays { vec4 ray[]; };
layout(std430, binding = 6) writeonly buffer Answers { uint answer[]; };
void main() {
  const uint i = gl_GlobalInvocationID.x;
  const vec4 from = ray[2u * i], along = ray[2u * i + 1u];
  answer[i] = boxes_met(bvh_node[5u * i], bvh_node[5u * i + 2u], bvh_node[5u * i + 3u],
                        bvh_node[5u * i + 4u], from.xyz, reciprocals(along.xyz), from.w, along.w);
}
)glsl";

// Whether a ray comes into a box that is larger by a part of the coordinates.
bool meets(const GpuRay& ray, const gpu::Box& box, double larger) {
  double enter = static_cast<double>(ray.t_near), leave = static_cast<double>(ray.t_far);
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.low[axis], high = box.high[axis];
    const double from = ray.from[axis], along = ray.along[axis];
    const double by = larger * std::max({std::abs(low), std::abs(high), std::abs(from)});
    const double t0 = (low - by - from) / along, t1 = (high + by - from) / along;
    if (along == 0.0) {
      if (from < low - by || from > high + by) return false;
      continue;
    }
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter <= leave;
}

struct Boxes {
  std::array<gpu::Box, gpu::kBvhWidth> box;
  gpu::BvhNode node{};
  GpuRay ray;
};

// A node of boxes from points to the size of all, and a ray at one of them: at its inside, at
// faces, edges and corners, along axes among others, from near, far, and from places in its planes.
Boxes random_boxes(std::uint64_t trial) {
  const calc::RandomKey key = calc::RandomKey(47).with(trial);
  const auto u = [&](std::uint64_t part, std::uint64_t k) {
    return key.with(part).with(k).uniform();
  };
  const double size = std::pow(10.0, 11.0 * u(0, 0) - 5.0);
  const double away = u(0, 1) < 0.5 ? -0.5 * size : size * std::pow(10.0, 4.0 * u(0, 2) - 2.0);
  Boxes result;
  float largest = 0.0f;
  for (std::uint64_t slot = 0; slot < gpu::kBvhWidth; ++slot) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = 10 * slot + static_cast<std::uint64_t>(axis);
      const double low = away + (u(1, k) < 0.2 ? 0.0 : size * u(2, k));
      const double extent = u(3, k) < 0.25 ? 0.0 : size * std::pow(10.0, -6.0 * u(4, k));
      result.box[slot].low[axis] = static_cast<float>(low);
      result.box[slot].high[axis] = static_cast<float>(low + extent);
      largest = std::max(
          {largest, std::abs(result.box[slot].low[axis]), std::abs(result.box[slot].high[axis])});
    }
  }
  gpu::set_boxes(result.node, result.box, gpu::least_step_m(largest));
  const gpu::Box& aim = result.box[trial % gpu::kBvhWidth];
  const bool is_segment = u(5, 0) < 0.5;
  GpuRay& ray = result.ray;
  glm::vec3 to;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::uint64_t>(axis);
    const double place = u(6, k) < 0.3 ? 0.0 : u(6, k) > 0.7 ? 1.0 : u(7, k);
    to[axis] = static_cast<float>(static_cast<double>(aim.low[axis]) * (1.0 - place) +
                                  static_cast<double>(aim.high[axis]) * place);
    ray.from[axis] = u(8, k) < 0.3 ? to[axis]  // the ray stays in a plane
                                   : static_cast<float>(away + size * (3.0 * u(9, k) - 1.0));
    if (u(10, k) < 0.1) ray.from[axis] = aim.low[axis];
  }
  ray.along = to - ray.from;
  if (!is_segment && ray.along != glm::vec3(0)) {
    ray.along = glm::vec3(glm::normalize(glm::dvec3(ray.along)));
  }
  if (u(11, 0) < 0.2) ray.along = -ray.along;
  ray.t_near = u(11, 1) < 0.5 ? 0.0f : is_segment ? 1e-6f : static_cast<float>(1e-6 * size);
  ray.t_far = is_segment ? 1.0f : u(11, 2) < 0.5 ? 1e30f : static_cast<float>(size);
  return result;
}

TEST(GlTraversal, NoBoxIsMissedThatARayMeets) {
  LUXGATE_NEEDS_OPENGL();
  constexpr std::size_t kTrials = 1u << 16;
  std::vector<Boxes> boxes;
  std::vector<gpu::BvhNode> nodes;
  std::vector<GpuRay> rays;
  for (std::uint64_t k = 0; k < kTrials; ++k) {
    boxes.push_back(random_boxes(k));
    nodes.push_back(boxes.back().node);
    rays.push_back(boxes.back().ray);
  }
  std::vector<std::uint32_t> answer(kTrials);
  gl_device()->run([&](gpu::DeviceState&) {
    const gpu::GlProgram program("boxes", gpu::ray_text() + kBoxes);
    gpu::GlBuffer to_nodes("nodes"), to_rays("rays"), answers("answers");
    to_nodes.assign(nodes);
    to_rays.assign(rays);
    answers.reserve(4 * kTrials);
    to_nodes.bind(0);
    to_rays.bind(3);
    answers.bind(6);
    program.use();
    dispatch(kTrials);
    answers.read(0, std::as_writable_bytes(std::span(answer)));
  });
  std::size_t met = 0, missed = 0, far = 0, far_told = 0;
  for (std::size_t k = 0; k < kTrials; ++k) {
    for (std::size_t slot = 0; slot < gpu::kBvhWidth; ++slot) {
      const bool is_told = ((answer[k] >> slot) & 1u) != 0;
      gpu::Box grown = boxes[k].box[slot];  // what the bytes can make of it, and a little
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const float step = std::ldexp(1.0f, boxes[k].node.step[a] - 127);
        grown.low[axis] -= 1.1f * step;
        grown.high[axis] += 1.1f * step;
      }
      if (meets(rays[k], boxes[k].box[slot], 1e-12)) {
        ++met;
        if (!is_told && ++missed <= 3) ADD_FAILURE() << "trial " << k << ", slot " << slot;
      } else if (!meets(rays[k], grown, 2e-6)) {
        ++far;
        if (is_told) ++far_told;
      }
    }
  }
  EXPECT_EQ(missed, 0u);
  EXPECT_GT(met, kTrials / 2);
  EXPECT_GT(far, kTrials);
  EXPECT_LT(far_told, far / 1000);
}

// ---- searches ----

const char* const kSearch = R"glsl(
layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = 3) readonly buffer Rays { vec4 ray[]; };
layout(std430, binding = 4) buffer Unused { uint unused[]; };
layout(std430, binding = 6) writeonly buffer Answers { uvec4 answer[]; };
uniform uint ray_count, turns_before;
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= ray_count) return;
  // So that a driver that counts turns has so many fewer left.
  uint turns = 0u;
  while (turns < turns_before) {
    ++turns;
    unused[i] = turns;
  }
  const vec4 from = ray[2u * i], along = ray[2u * i + 1u];
  bool is_shadow_cut;
  const bool is_shadowed = is_blocked(from.xyz, from.xyz + along.xyz, is_shadow_cut);
  uint triangle;
  dvec2 share;
  const bool is_met = closest_hit(from.xyz, along.xyz, from.w, along.w, triangle, share);
  answer[i] = uvec4(is_shadow_cut ? 2u : is_shadowed ? 1u : 0u,
                    is_met ? triangle_of[triangle] : 0xffffffffu, is_cut ? 1u : 0u, turns);
}
)glsl";

constexpr std::uint32_t kNoTriangle = 0xffff'ffff;

struct Answer {
  std::uint32_t shadow;  // 1 = blocked, 2 = not done
  std::uint32_t triangle;
  std::uint32_t is_cut;
  std::uint32_t turns;
};

class Search {
 public:
  explicit Search(const calc::PreparedScene& scene) : tracer_(scene), device_(gl_device()) {}

  std::vector<Answer> ask(const std::vector<GpuRay>& rays,
                          const std::vector<std::uint32_t>& turns_before = {0}) {
    std::vector<Answer> all;
    device_->run([&](gpu::DeviceState& state) {
      const gpu::GlProgram program("search", gpu::ray_text() + kSearch);
      gpu::GlBuffer to_rays("rays"), unused("unused"), answers("answers");
      const gpu::DeviceScene& scene = state.scenes.of(tracer_);
      std::vector<Answer> answer(rays.size());
      to_rays.assign(rays);
      unused.reserve(4 * rays.size());
      answers.reserve(sizeof(Answer) * rays.size());
      for (const std::uint32_t turns : turns_before) {
        program.use();
        scene.bind();
        scene.bind_surfaces();
        to_rays.bind(3);
        unused.bind(4);
        answers.bind(6);
        program.set("node_count", scene.nodes);
        program.set("offset_m", static_cast<float>(tracer_.offset_m()));
        program.set("ray_count", static_cast<std::uint32_t>(rays.size()));
        program.set("turns_before", turns);
        dispatch(rays.size());
        answers.read(0, std::as_writable_bytes(std::span(answer)));
        all.insert(all.end(), answer.begin(), answer.end());
      }
      state.check("asking");
    });
    return all;
  }

  const calc::Tracer& tracer() const { return tracer_; }

 private:
  calc::Tracer tracer_;
  std::shared_ptr<gpu::DeviceThread> device_;
};

glm::dvec3 random_place(const calc::RandomKey& key, double size_m) {
  return size_m * (glm::dvec3(key.with(1).uniform(), key.with(2).uniform(), key.with(3).uniform()) -
                   glm::dvec3(0.5));
}

// Triangles of all sizes, and a grid that is flat.
calc::PreparedScene heap(double size_m, const glm::dvec3& at_m) {
  calc::PreparedScene scene;
  for (std::uint64_t k = 0; k < 3000; ++k) {
    const calc::RandomKey key = calc::RandomKey(59).with(k);
    const double own_m = 0.3 * size_m * std::pow(10.0, -2.0 * key.with(0).uniform());
    const glm::dvec3 a = at_m + random_place(key.with(4), size_m);
    add_triangle(scene, a, a + random_place(key.with(5), own_m),
                 a + random_place(key.with(6), own_m), 0.5);
  }
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 10; ++i) {
      add_quad(scene, at_m + size_m * glm::dvec3(0.1 * i - 0.5, 0.1 * j - 0.5, -0.5),
               {0.1 * size_m, 0, 0}, {0, 0.1 * size_m, 0}, 0.5);
    }
  }
  set_extent(scene);
  return scene;
}

TEST(GlTraversal, AnswersAsTheCpuDoesInTinyAndHugeScenes) {
  LUXGATE_NEEDS_OPENGL();
  constexpr std::size_t kRays = 8000;
  for (const auto& [size_m, at_m] : {std::pair{1e-3, glm::dvec3(0)},
                                     {1.0, glm::dvec3(0)},
                                     {10.0, glm::dvec3(900, -400, 200)},
                                     {1e6, glm::dvec3(0)}}) {
    const calc::PreparedScene scene = heap(size_m, at_m);
    Search search(scene);
    const calc::Tracer& tracer = search.tracer();
    std::vector<GpuRay> rays;
    for (std::uint64_t k = 0; k < kRays; ++k) {
      const calc::RandomKey key = calc::RandomKey(61).with(k);
      const glm::vec3 from(at_m + random_place(key.with(0), size_m));
      glm::vec3 to(at_m + random_place(key.with(1), size_m));
      if (k % 8 < 3) to[static_cast<int>(k % 8)] = from[static_cast<int>(k % 8)];
      if (k % 64 == 8) to = {from.x, from.y, static_cast<float>(at_m.z - size_m)};
      rays.push_back({from, 0.0f, to - from, k % 2 == 0 ? 1e30f : 1.0f});
    }
    const std::vector<Answer> answers = search.ask(rays);
    std::size_t met = 0, blocked = 0, differing = 0;
    for (std::size_t k = 0; k < kRays; ++k) {
      const glm::dvec3 from(rays[k].from), to(rays[k].from + rays[k].along);
      calc::SurfaceHit hit{};
      const bool is_met = tracer.closest_hit(from, glm::dvec3(rays[k].along),
                                             static_cast<double>(rays[k].t_far), hit);
      const bool is_blocked = tracer.is_blocked(from, to, calc::kReceiverToVertex);
      met += is_met ? 1 : 0;
      blocked += is_blocked ? 1 : 0;
      const std::uint32_t expected = is_met ? hit.triangle : kNoTriangle;
      if (answers[k].triangle != expected) ++differing;
      if (answers[k].shadow != (is_blocked ? 1u : 0u)) ++differing;
      ASSERT_EQ(answers[k].is_cut, 0u);
    }
    std::printf("%g m: %zu of %zu rays differ, %zu hits, %zu blocked\n", size_m, differing, kRays,
                met, blocked);
    EXPECT_GT(met, kRays / 3) << size_m;
    EXPECT_GT(blocked, kRays / 4) << size_m;
    EXPECT_LT(blocked, 3 * kRays / 4) << size_m;
    EXPECT_LE(differing, kRays / 2000) << size_m;
  }
}

// Of triangles in one place the first of the scene, from all sides: nodes and leaves part them in
// every way.
TEST(GlTraversal, OfEquallyNearTrianglesTheFirstOfTheSceneIsMet) {
  LUXGATE_NEEDS_OPENGL();
  constexpr std::uint32_t kPlaces = 200, kEach = 11;
  calc::PreparedScene scene;
  for (std::uint32_t each = 0; each < kEach; ++each) {
    for (std::uint32_t place = 0; place < kPlaces; ++place) {
      const calc::RandomKey key = calc::RandomKey(67).with((77 * each + 13 * place) % kPlaces);
      const glm::dvec3 a = random_place(key.with(0), 10.0);
      add_triangle(scene, a, a + random_place(key.with(1), 4.0), a + random_place(key.with(2), 4.0),
                   0.5);
    }
  }
  set_extent(scene);
  Search search(scene);
  std::vector<GpuRay> rays;
  for (std::uint64_t k = 0; k < 20'000; ++k) {
    const calc::RandomKey key = calc::RandomKey(71).with(k);
    const glm::dvec3 from = random_place(key.with(0), 20.0);
    rays.push_back({glm::vec3(from), 0.0f,
                    glm::vec3(glm::normalize(random_place(key.with(1), 6.0) - from)), 1e30f});
  }
  std::size_t met = 0, later = 0;
  for (const Answer& answer : search.ask(rays)) {
    if (answer.triangle == kNoTriangle) continue;
    ++met;
    if (answer.triangle >= kPlaces) ++later;
  }
  EXPECT_GT(met, 5000u);
  EXPECT_EQ(later, 0u);
}

// However few turns are left when a search begins, what it says is right, or it says that it is not
// done. Drivers that count no turns answer all.
TEST(GlTraversal, ALoopThatWasLeftEarlyIsNoAnswer) {
  LUXGATE_NEEDS_OPENGL();
  const LampHall hall(0.5);
  Search search(hall.scene);
  std::vector<GpuRay> rays;
  for (std::uint64_t k = 0; k < 24; ++k) {
    const calc::RandomKey key = calc::RandomKey(73).with(k);
    rays.push_back({glm::vec3(random_place(key.with(0), 3.0)) + glm::vec3(0, 0, 1.5f), 0.0f,
                    glm::vec3(random_place(key.with(1), 6.0)), 1e30f});
  }
  const std::vector<Answer> right = search.ask(rays);
  std::vector<std::uint32_t> turns;
  for (std::uint32_t left = 0; left < 250; left += 2) turns.push_back(65'535 - left);
  const std::vector<Answer> answers = search.ask(rays, turns);
  std::size_t done = 0, not_done = 0, wrong = 0;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const Answer& expected = right[k % rays.size()];
    if (answers[k].shadow == 2) {
      ++not_done;
    } else {
      ++done;
      if (answers[k].shadow != expected.shadow) ++wrong;
    }
    if (answers[k].is_cut != 0) {
      ++not_done;
    } else {
      ++done;
      if (answers[k].triangle != expected.triangle) ++wrong;
    }
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(done, 1000u);
  std::printf("%zu done, %zu not\n", done, not_done);
}

// Half sheets, one above the other: a ray meets all their boxes and none of them, in more turns
// than some llvmpipe takes.
TEST(GlTraversal, SaysSoWhenARayNeedsTooManyTurns) {
  LUXGATE_NEEDS_OPENGL();
  calc::PreparedScene pile;
  for (int k = 0; k < 70'000; ++k) {
    add_triangle(pile, {-500, -500, 1e-3 * k}, {500, -500, 1e-3 * k}, {-500, 500, 1e-3 * k}, 0.5);
  }
  set_extent(pile);
  Search search(pile);
  const std::optional<bool> leaves = leaves_long_loops(gl_device()->device());
  for (const Answer& answer : search.ask({{{200, 200, -1}, 0.0f, {0, 0, 100}, 1e30f},
                                          {{200, 200, 90}, 0.0f, {1, 0, -100}, 1e30f}})) {
    EXPECT_EQ(answer.triangle, kNoTriangle);
    const bool is_cut = leaves.value_or(answer.is_cut != 0);
    EXPECT_EQ(answer.is_cut, is_cut ? 1u : 0u);
    EXPECT_EQ(answer.shadow, is_cut ? 2u : 0u);
  }
}

}  // namespace
}  // namespace traversal_test
