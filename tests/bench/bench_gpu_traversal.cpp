// What a ray costs in the device's tree (gpu/scene/bvh.h) beside the tree before it, which was
// binary and searched in one order along skip links: nodes, triangles, bytes and memory sectors of
// 32 bytes per ray, counted by the shaders themselves; processor time on a software device; rays
// whose answers differ from the CPU's.
//   bench_gpu_traversal [rays [repeats [scene...]]]
#include "calc/radiosity/paths/light_paths.h"
#include "calc/radiosity/sampling/random.h"
#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/terms/path_terms.h"
#include "gpu/device/device_thread.h"
#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/rays/path_shader_text.h"
#include "gpu/scene/box_tree.h"
#include "gpu/scene/bvh.h"
#include "tests/bench/scenes.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace {

constexpr std::uint32_t kLeafStep = 8;

// The tree of old: depth first, `next` leads past what is below.
struct SkipNode {
  std::array<float, 3> low_m;
  std::uint32_t next;
  std::array<float, 3> high_m;
  std::uint32_t leaf;  // 0 = inner node, else first triangle * kLeafStep + number of triangles
};
static_assert(sizeof(SkipNode) == 32);

const char* const kSkipLinks = R"glsl(
bool misses_box(uvec4 low, uvec4 high, vec3 from, vec3 per_along, float t_near, float t_far) {
  const float rounding = 1.0e-6;
  const vec3 t0 = (uintBitsToFloat(low.xyz) - from) * per_along;
  const vec3 t1 = (uintBitsToFloat(high.xyz) - from) * per_along;
  const vec3 first = min(t0, t1), last = max(t0, t1);
  const float enter = max(max(first.x, first.y), max(first.z, t_near));
  const float leave = min(min(last.x, last.y), min(last.z, t_far));
  return !(enter * (1.0 - rounding) <= leave * (1.0 + rounding));
}

bool is_blocked_by_links(vec3 from, vec3 to, out bool is_cut) {
  is_cut = false;
  const vec3 along = to - from;
  const float t_near = offset_m / sqrt(dot(along, along));
  const float t_far = 1.0;
  if (!(t_near < t_far)) return false;
  const vec3 per_along = reciprocals(along);
  uint at = 0u;
  while (at < node_count) {
    COUNT_NODE;
    const uvec4 low = bvh_node[2u * at];
    const uvec4 high = bvh_node[2u * at + 1u];
    if (misses_box(low, high, from, per_along, t_near, t_far)) {
      at = low.w;
      continue;
    }
    const uint begin = high.w / 8u;
    const uint end = begin + high.w % 8u;
    for (uint k = begin; k < end; ++k) {
      COUNT_TRIANGLE;
      if (is_hit(k, from, along, t_near, t_far)) return true;
    }
    ++at;
  }
  is_cut = at < node_count;
  return false;
}

bool closest_hit_by_links(vec3 from, vec3 along, float t_near, float t_far, out uint triangle,
                          out dvec2 share) {
  const vec3 per_along = reciprocals(along);
  bool is_found = false;
  triangle = 0u;
  share = dvec2(0.0lf);
  uint at = 0u;
  while (at < node_count) {
    COUNT_NODE;
    const uvec4 low = bvh_node[2u * at];
    const uvec4 high = bvh_node[2u * at + 1u];
    if (misses_box(low, high, from, per_along, t_near, t_far)) {
      at = low.w;
      continue;
    }
    const uint begin = high.w / 8u;
    const uint end = begin + high.w % 8u;
    for (uint k = begin; k < end; ++k) {
      COUNT_TRIANGLE;
      float t;
      if (!is_crossed(k, from, along, t)) continue;
      if (!(t > t_near && t <= t_far) || (is_found && t == t_far)) continue;
      is_found = true;
      t_far = t;
      triangle = k;
    }
    ++at;
  }
  if (at < node_count) is_cut = true;
  if (is_found) share = place_on(triangle, from, along);
  return is_found;
}
)glsl";

const char* const kMain = R"glsl(
layout(local_size_x = GROUP_SIZE) in;
layout(std430, binding = 3) readonly buffer Rays { vec4 ray[]; };
layout(std430, binding = 6) writeonly buffer Answers { uvec4 answer[]; };
uniform uint ray_count;
uniform float t_near, t_far;

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= ray_count) return;
  const vec3 from = ray[2u * i].xyz, to = ray[2u * i + 1u].xyz;
  uint met = 0xffffffffu;
#if IS_ANY_HIT
  bool is_lost;
  if (SEARCH(from, to, is_lost)) met = 1u;
  if (is_lost) is_cut = true;
#else
  uint triangle;
  dvec2 share;
  if (SEARCH(from, to, t_near, t_far, triangle, share)) met = triangle_of[triangle];
#endif
  answer[i] = uvec4(met, counted_nodes, counted_triangles, is_cut ? 1u : 0u);
}
)glsl";

enum class Query { any_hit, closest_hit };

std::string shader(Query query, bool has_links, bool is_counted) {
  std::string text = gpu::ray_text();
  const std::size_t after_version = text.find('\n') + 1;
  std::string defines = "uint counted_nodes = 0u, counted_triangles = 0u;\n";
  if (is_counted)
    defines += "#define COUNT_NODE ++counted_nodes\n#define COUNT_TRIANGLE ++counted_triangles\n";
  const bool is_any_hit = query == Query::any_hit;
  defines += fmt::format("#define IS_ANY_HIT {}\n#define SEARCH {}{}\n", is_any_hit ? 1 : 0,
                         is_any_hit ? "is_blocked" : "closest_hit", has_links ? "_by_links" : "");
  text.insert(after_version, defines);
  return text + kSkipLinks + kMain;
}

void add_skip_nodes(const gpu::BoxTree& tree, std::size_t at, std::vector<SkipNode>& flat) {
  const gpu::BoxTree::Node& from = tree.nodes[at];
  const std::size_t place = flat.size();
  const auto leaf = static_cast<std::uint32_t>(from.first * kLeafStep + from.count);
  const glm::vec3 &low = from.box.low, &high = from.box.high;
  flat.push_back({{low.x, low.y, low.z}, 0, {high.x, high.y, high.z}, from.is_leaf() ? leaf : 0});
  if (!from.is_leaf()) {
    add_skip_nodes(tree, at + 1, flat);
    add_skip_nodes(tree, from.second_child, flat);
  }
  flat[place].next = static_cast<std::uint32_t>(flat.size());
}

struct GpuRay {
  glm::vec4 from, to;  // or direction
};

struct Rays {
  std::string name;
  Query query;
  float t_near, t_far;  // of closest hits
  std::vector<GpuRay> ray;
  std::vector<std::uint32_t> expected;  // triangle, 1 for blocked, ~0 = none
};

// Aisles between racks of four shelves with boxes on them.
bench::RoomModel rack_hall() {
  bench::RoomModel room;
  room.name = "racks";
  room.size_m = {48.0, 30.0, 9.0};
  for (int row = 0; row < 8; ++row) {
    for (int bay = 0; bay < 14; ++bay) {
      const glm::dvec3 at(3.0 + 3.0 * bay, 2.0 + 3.4 * row, 0.02);
      const auto add = [&](const glm::dvec3& low, const glm::dvec3& size, double rho) {
        room.blocks.push_back({"", at + low, size, rho});
      };
      for (const double x : {0.0, 2.85}) {
        for (const double y : {0.0, 1.05}) add({x, y, 0.0}, {0.1, 0.1, 6.0}, 0.3);
      }
      for (int shelf = 0; shelf < 4; ++shelf) {
        const double z = 0.2 + 1.6 * shelf;
        add({0.0, 0.11, z}, {2.95, 0.93, 0.05}, 0.4);
        for (int box = 0; box < 3; ++box) {
          const auto key = calc::RandomKey(5).with(
              static_cast<std::uint64_t>(row + 8 * (bay + 14 * (shelf + 4 * box))));
          add({0.15 + 0.95 * box, 0.2, z + 0.06}, {0.8, 0.75, 0.4 + 0.8 * key.uniform()}, 0.4);
        }
      }
    }
  }
  room.webs = {bench::wide_web(20000.0)};
  for (int k = 0; k < 40; ++k) {
    room.lamps.push_back({{3.0 + 6.0 * (k % 8), 3.0 + 6.0 * (k / 8), 8.9}, 0, false, ""});
  }
  room.grid = {{0.5, 0.5, 0.8}, 47.0, 29.0, 40, 30};
  return room;
}

// Draws of points: 64 light vertices each. Rays of light paths. Short rays around points, 64 each.
std::vector<Rays> rays_in(const bench::BenchScene& scene, const calc::Tracer& tracer,
                          std::size_t count) {
  const calc::RandomKey key(7);
  const calc::Emitter emitter(scene.scene);
  const auto vertices = calc::trace_light_paths(tracer, emitter, {1, 0, 0, 8192}).vertices;
  const auto vertex = [&](std::uint64_t i) -> const calc::LightVertex& {
    const auto size = static_cast<double>(vertices.size());
    return vertices[static_cast<std::size_t>(size * key.with(i).with(1).uniform())];
  };
  const auto point = [&](std::uint64_t i) {
    const auto size = static_cast<double>(scene.points());
    const auto p = static_cast<std::size_t>(size * key.with(i / 64).with(2).uniform());
    return tracer.lift(scene.grid.position_m[p] - scene.scene.origin_m, scene.grid.normal[p]);
  };
  std::vector<Rays> result{
      {"shadow rays", Query::any_hit, 0.0f, 1.0f, {}, {}},
      {"light paths", Query::closest_hit, 0.0f, 1e30f, {}, {}},
      {"short rays", Query::closest_hit, static_cast<float>(tracer.offset_m()), 1.0f, {}, {}}};
  for (std::size_t i = 0; i < count; ++i) {
    const calc::LightVertex& from = vertex(i);
    const glm::vec3 position(from.position_m), receiver(point(i));
    const auto direction = [&](const glm::dvec3& normal) {
      return glm::vec3(calc::cosine_direction(normal, key.with(i).with(3).uniform(),
                                              key.with(i).with(4).uniform()));
    };
    result[0].ray.push_back({glm::vec4(receiver, 0), glm::vec4(position, 0)});
    result[1].ray.push_back(
        {glm::vec4(position, 0), glm::vec4(direction(glm::dvec3(from.normal)), 0)});
    result[2].ray.push_back({glm::vec4(receiver, 0), glm::vec4(direction({0, 0, 1}), 0)});
  }
  for (Rays& rays : result) {
    for (const GpuRay& ray : rays.ray) {
      const glm::dvec3 from(ray.from), to(ray.to);
      if (rays.query == Query::any_hit) {
        rays.expected.push_back(tracer.is_blocked(from, to, calc::kReceiverToVertex) ? 1 : ~0u);
        continue;
      }
      calc::RayPacket packet;
      packet.add(from, to);
      std::array<calc::SurfaceHit, calc::RayPacket::kSize> hit;
      const bool is_met = tracer.closest_hits(packet, rays.t_near, rays.t_far, hit) != 0;
      rays.expected.push_back(is_met ? hit[0].triangle : ~0u);
    }
  }
  return result;
}

double processor_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct DeviceTree {
  std::string name;
  double node_bytes, node_sectors;
  std::uint32_t nodes = 0;
  std::size_t bytes = 0;
  gpu::GlBuffer node{"nodes"}, triangle{"triangles"}, order{"order"};
};

struct Cost {
  double nodes = 0.0, triangles = 0.0, bytes = 0.0, sectors = 0.0, us = 0.0;
  std::size_t differing = 0;
};

void dispatch(const gpu::GlProgram& program, const DeviceTree& tree, const Rays& rays,
              float offset_m) {
  program.use();
  tree.node.bind(0);
  tree.triangle.bind(1);
  tree.order.bind(8);
  program.set("node_count", tree.nodes);
  program.set("offset_m", offset_m);
  program.set("t_near", rays.t_near);
  program.set("t_far", rays.t_far);
  program.set("ray_count", static_cast<std::uint32_t>(rays.ray.size()));
  glDispatchCompute(static_cast<GLuint>((rays.ray.size() + gpu::kGroupSize - 1) / gpu::kGroupSize),
                    1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glFinish();
}

std::vector<glm::uvec4> answers(const gpu::GlBuffer& buffer, std::size_t count) {
  std::vector<glm::uvec4> answer(count);
  buffer.read(0, std::as_writable_bytes(std::span(answer)));
  return answer;
}

void measure(gpu::DeviceState& device, const std::array<DeviceTree, 2>& trees, const Rays& rays,
             float offset_m, int repeats) {
  gpu::GlBuffer sent("rays"), answer("answers");
  sent.assign(rays.ray);
  std::array<Cost, 2> cost;
  std::array<std::vector<double>, 2> seconds;
  std::array<std::unique_ptr<gpu::GlProgram>, 2> program;
  for (std::size_t k = 0; k < 2; ++k) {
    const gpu::GlProgram counting("counting rays", shader(rays.query, k == 0, true),
                                  device.programs);
    program[k] = std::make_unique<gpu::GlProgram>("rays", shader(rays.query, k == 0, false),
                                                  device.programs);
    answer.assign(rays.ray.size() * sizeof(glm::uvec4), ~0u);
    sent.bind(3);
    answer.bind(6);
    dispatch(counting, trees[k], rays, offset_m);
    const std::vector<glm::uvec4> counted = answers(answer, rays.ray.size());
    dispatch(*program[k], trees[k], rays, offset_m);
    for (std::size_t i = 0; i < counted.size(); ++i) {
      cost[k].nodes += counted[i].y;
      cost[k].triangles += counted[i].z;
      if (counted[i].x != rays.expected[i] || counted[i].w != 0) ++cost[k].differing;
    }
  }
  for (int r = 0; r < repeats; ++r) {
    for (std::size_t k = 0; k < 2; ++k) {  // in turn: other work on the machine meets both
      const double begin_s = processor_s();
      dispatch(*program[k], trees[k], rays, offset_m);
      seconds[k].push_back(processor_s() - begin_s);
    }
  }
  const auto count = static_cast<double>(rays.ray.size());
  for (std::size_t k = 0; k < 2; ++k) {
    constexpr double kTriangleSectors = 2.0;
    Cost& c = cost[k];
    c.nodes /= count;
    c.triangles /= count;
    c.bytes = trees[k].node_bytes * c.nodes + sizeof(gpu::BvhTriangle) * c.triangles;
    c.sectors = trees[k].node_sectors * c.nodes + kTriangleSectors * c.triangles;
    std::sort(seconds[k].begin(), seconds[k].end());
    c.us = 1e6 * seconds[k][seconds[k].size() / 2] / count;
    fmt::print(
        "  {:12} {:10} {:7.1f} nodes {:6.2f} triangles {:6.0f} bytes {:6.1f} sectors "
        "{:7.3f} us  {} of {} differ from the CPU\n",
        rays.name, trees[k].name, c.nodes, c.triangles, c.bytes, c.sectors, c.us, c.differing,
        rays.ray.size());
  }
  fmt::print(
      "  {:12} new / old  {:7.2f}       {:6.2f}           {:6.2f}       {:6.2f}         "
      "{:7.2f}\n",
      rays.name, cost[1].nodes / cost[0].nodes, cost[1].triangles / cost[0].triangles,
      cost[1].bytes / cost[0].bytes, cost[1].sectors / cost[0].sectors, cost[1].us / cost[0].us);
  std::fflush(stdout);
}

void measure(gpu::DeviceThread& device, const bench::RoomModel& model, std::size_t count,
             int repeats) {
  const bench::BenchScene scene = bench::make_scene(model);
  const calc::Tracer tracer(scene.scene);
  const std::vector<Rays> all = rays_in(scene, tracer, count);
  device.run([&](gpu::DeviceState& state) {
    std::array<DeviceTree, 2> trees{DeviceTree{"skip links", 32.0, 1.0},
                                    DeviceTree{"wide", sizeof(gpu::BvhNode), 3.0}};
    const double begin_s = processor_s();
    const gpu::Bvh bvh = gpu::build_bvh(scene.scene);
    const double build_s = processor_s() - begin_s;
    trees[1].node.assign(bvh.nodes);
    trees[1].triangle.assign(bvh.triangles);
    trees[1].order.assign(bvh.order);
    trees[1].nodes = static_cast<std::uint32_t>(bvh.nodes.size());

    const gpu::BoxTree binary = gpu::build_box_tree(scene.scene, 4);
    std::vector<SkipNode> flat;
    add_skip_nodes(binary, 0, flat);
    std::vector<std::uint32_t> place(bvh.order.size());
    for (std::size_t k = 0; k < place.size(); ++k) {
      place[bvh.order[k]] = static_cast<std::uint32_t>(k);
    }
    std::vector<gpu::BvhTriangle> triangles;
    for (const std::uint32_t t : binary.order) triangles.push_back(bvh.triangles[place[t]]);
    trees[0].node.assign(flat);
    trees[0].triangle.assign(triangles);
    trees[0].order.assign(binary.order);
    trees[0].nodes = static_cast<std::uint32_t>(flat.size());
    fmt::print(
        "{}: {} triangles; skip links {} nodes, {:.1f} bytes per triangle; wide {} nodes, "
        "{:.1f} bytes per triangle, built in {:.2f} s\n",
        model.name, triangles.size(), flat.size(),
        32.0 * static_cast<double>(flat.size()) / static_cast<double>(triangles.size()),
        bvh.nodes.size(),
        static_cast<double>(sizeof(gpu::BvhNode) * bvh.nodes.size()) /
            static_cast<double>(triangles.size()),
        build_s);
    for (const Rays& rays : all) {
      measure(state, trees, rays, static_cast<float>(tracer.offset_m()), repeats);
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  const auto rays = static_cast<std::size_t>(argc > 1 ? std::atoi(argv[1]) : 65536);
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 5;
  std::string problem;
  const auto device = gpu::DeviceThread::open({}, problem);
  if (!device) {
    fmt::print("no OpenGL: {}\n", problem);
    return 2;
  }
  fmt::print("{}; {} rays of each kind, median of {}\n", device->device().name(), rays, repeats);
  std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
  if (names.empty()) names = {"office", "racks", "hall"};
  for (const std::string& name : names) {
    measure(*device, name == "racks" ? rack_hall() : bench::find_room(name), rays, repeats);
  }
  return 0;
}
