// What the model of devices (gpu_model.py) is fed with, counted on the CPU; JSON to stdout:
//   gpu_model_counts [SCENE [PATHS COLUMNS ROWS]...]
// Node visits and triangle tests of a ray in the device's tree (shaders/common/visibility.glsl and
// closest_hit.glsl said again), for connections, light paths and short rays; the counters, the
// error and the seconds of one look at the office with PATHS light paths per replicate and so many
// points; and what a connection takes llvmpipe, where that is the OpenGL there is.
#include "calc/radiosity/looks/solve.h"
#include "calc/radiosity/paths/near_field.h"
#include "calc/radiosity/sampling/grid_receivers.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "calc/radiosity/sampling/threads.h"
#include "calc/radiosity/terms/path_terms.h"
#include "gpu/gather/gl_gatherer.h"
#include "gpu/scene/bvh.h"
#include "tests/bench/scenes.h"

#include <fmt/format.h>

#include <ctime>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct Visits {
  double rays = 0, nodes = 0, triangles = 0, hits = 0;
};

// Slots whose boxes the ray meets; those without a child among them.
std::uint32_t boxes_met(const gpu::BvhNode& node, const glm::vec3& from, const glm::vec3& per_along,
                        float t_near, float t_far) {
  std::uint32_t met = 0;
  for (std::size_t slot = 0; slot < gpu::kBvhWidth; ++slot) {
    float enter = t_near, leave = t_far;
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      const float step = std::bit_cast<float>(static_cast<std::uint32_t>(node.step[k]) << 23U);
      const float begin = (node.low_m[k] - from[axis]) * per_along[axis];
      const float cell = step * per_along[axis];
      const float slack = 1e-6f * (std::abs(begin) + 255.0f * std::abs(cell));
      const float t0 = begin + cell * static_cast<float>(node.low[k][slot]);
      const float t1 = begin + cell * static_cast<float>(node.high[k][slot]);
      enter = std::max(enter, std::min(t0, t1) - slack);
      leave = std::min(leave, std::max(t0, t1) + slack);
    }
    if (!(enter > leave)) met |= 1U << slot;
  }
  return met;
}

bool is_crossed(const gpu::BvhTriangle& triangle, const glm::vec3& from, const glm::vec3& along,
                float& t) {
  const auto& c = triangle.corner_m;
  const glm::vec3 v0 = glm::vec3(c[0]) - from, v1 = glm::vec3(c[1]) - from,
                  v2 = glm::vec3(c[2]) - from;
  const float a = glm::dot(glm::cross(v2 - v0, v2 + v0), along);
  const float b = glm::dot(glm::cross(v0 - v1, v0 + v1), along);
  const float d = glm::dot(glm::cross(v1 - v2, v1 + v2), along);
  if (!(std::min(a, std::min(b, d)) >= 0.0f || std::max(a, std::max(b, d)) <= 0.0f)) return false;
  const glm::vec3 normal(c[0].w, c[1].w, c[2].w);
  const float slope = glm::dot(normal, along);
  if (slope == 0.0f) return false;
  t = glm::dot(normal, v0) / slope;
  return true;
}

// Where something stands among its like.
std::uint32_t place_among(std::uint32_t mask, std::uint32_t bit) {
  return static_cast<std::uint32_t>(std::popcount(mask & ((1U << bit) - 1U)));
}

// Children that wait: of those from `first` on, by slot ^ signs.
struct Waiting {
  std::uint32_t first, inner, open;
};

void trace(const gpu::Bvh& bvh, const glm::vec3& from, const glm::vec3& along, float t_near,
           float t_far, bool any_hit, Visits& visits) {
  const auto reciprocal = [](float x) { return 1.0f / (std::abs(x) > 1e-28f ? x : 1e-28f); };
  const glm::vec3 per_along(reciprocal(along.x), reciprocal(along.y), reciprocal(along.z));
  std::uint32_t signs = 0;  // any hit takes children as they stand
  for (int axis = 0; axis < 3 && !any_hit; ++axis) {
    if (per_along[axis] < 0.0f) signs |= 1U << static_cast<unsigned>(axis);
  }
  bool is_found = false;
  ++visits.rays;
  std::vector<Waiting> waiting;
  if (!bvh.nodes.empty()) waiting.push_back({0, 1, 1U << signs});  // the root as an only child
  while (!waiting.empty() && !(is_found && any_hit)) {
    Waiting& group = waiting.back();
    const std::uint32_t slot = static_cast<std::uint32_t>(std::countr_zero(group.open)) ^ signs;
    const gpu::BvhNode& node = bvh.nodes[group.first + place_among(group.inner, slot)];
    group.open &= group.open - 1;
    if (group.open == 0) waiting.pop_back();
    ++visits.nodes;
    const std::uint32_t met = boxes_met(node, from, per_along, t_near, t_far);
    for (std::uint32_t bit = 0; bit < 4 * gpu::kBvhWidth; ++bit) {
      if (((node.triangles >> bit) & (met >> (bit / 4)) & 1U) == 0) continue;
      float t = 0.0f;
      ++visits.triangles;
      const std::uint32_t k = node.first_triangle + place_among(node.triangles, bit);
      if (!is_crossed(bvh.triangles[k], from, along, t) || t < t_near || t > t_far) continue;
      is_found = true;
      if (any_hit) break;
      t_far = t;
    }
    std::uint32_t open = 0;
    for (std::uint32_t child = 0; child < gpu::kBvhWidth; ++child) {
      if (((met & node.inner) >> child & 1U) != 0) open |= 1U << (child ^ signs);
    }
    if (open != 0) waiting.push_back({node.first_child, node.inner, open});
  }
  if (is_found) ++visits.hits;
}

std::string json(std::string_view name, const Visits& v) {
  return fmt::format("\"{}\": {{\"nodes\": {:.1f}, \"triangles\": {:.2f}, \"hits\": {:.3f}}}", name,
                     v.nodes / v.rays, v.triangles / v.rays, v.hits / v.rays);
}

// Connections by flux, which draws follow near enough for counting; light paths from their
// vertices; short rays from the points.
std::string visits_json(const bench::BenchScene& scene) {
  constexpr std::uint32_t kRays = 40000;
  const gpu::Bvh bvh = gpu::build_bvh(scene.scene);
  const calc::Tracer tracer(scene.scene);
  const calc::Emitter emitter(scene.scene);
  const calc::LightVertices vertices =
      calc::trace_light_paths(tracer, emitter, {1, 0, 0, 4096}).vertices;
  const calc::VertexTree tree(vertices, scene.scene.channels.size());
  const std::vector<calc::Receiver> receivers = calc::receivers_of(tracer, scene.grid);
  const auto reach_m = static_cast<float>(calc::GeometryBound(tracer, emitter, 1024).reach_m());
  Visits connections, paths, short_rays;
  for (std::uint32_t k = 0; k < kRays; ++k) {
    const calc::RandomKey key = calc::RandomKey(5).with(k);
    const calc::Receiver& receiver = receivers[k % receivers.size()];
    const glm::vec3 from(tracer.lift(receiver));
    const std::uint32_t v = tree.vertex_at(0, static_cast<std::uint32_t>(tree.vertices().size()),
                                           key.with(0).uniform());
    const calc::LightVertex& vertex = tree.vertices()[v];
    const glm::vec3 along = vertex.position_m - from;
    if (glm::dot(glm::vec3(receiver.axis), along) > 0.0f && glm::dot(vertex.normal, along) < 0.0f) {
      const float t_near = static_cast<float>(tracer.offset_m()) / glm::length(along);
      trace(bvh, from, along, t_near, 1.0f, true, connections);
    }
    const double u0 = key.with(1).uniform(), u1 = key.with(2).uniform();
    trace(bvh, vertex.position_m,
          glm::vec3(calc::cosine_direction(glm::dvec3(vertex.normal), u0, u1)), 0.0f, 1e30f, false,
          paths);
    trace(bvh, from, glm::vec3(calc::cosine_direction(receiver.axis, u0, u1)), 1e-4f, reach_m,
          false, short_rays);
  }
  return fmt::format("{{{}, {}, {}, \"tree_nodes\": {}, \"reach_m\": {:.3f}}}",
                     json("connections", connections), json("light_paths", paths),
                     json("near_field", short_rays), bvh.nodes.size(), reach_m);
}

// Relative standard error of the indirect part's and direct part's sum, RMS over points.
double error_of(const calc::PlaneField& field) {
  const auto n = static_cast<double>(field.replicates);
  double squares = 0.0;
  for (std::size_t i = 0; i < field.points; ++i) {
    double sum = 0.0, sum2 = 0.0;
    for (std::size_t r = 0; r < field.replicates; ++r) {
      double lx = 0.0;
      for (std::size_t c = 0; c < field.channels.size(); ++c) {
        const std::size_t k = (r * field.channels.size() + c) * field.points + i;
        lx += field.direct_exact_lx[c * field.points + i];
        if (!field.indirect_lx.empty()) lx += field.indirect_lx[k];
        if (!field.direct_sampled_lx.empty()) lx += field.direct_sampled_lx[k];
      }
      sum += lx;
      sum2 += lx * lx;
    }
    const double mean = sum / n;
    if (mean > 0.0) squares += std::max(0.0, sum2 / n - mean * mean) / (n - 1.0) / (mean * mean);
  }
  return std::sqrt(squares / static_cast<double>(field.points));
}

double processor_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct LookRun {
  calc::SpaceSolution solution;
  double processor_s = 0, busy = 0;  // of all threads; of the clock
};

// One look on one thread, but for those that the gatherer has.
LookRun look(const bench::BenchScene& scene, std::uint64_t paths, calc::Gatherer& gatherer) {
  calc::RadiositySettings settings;
  settings.first_paths = settings.max_paths = paths;
  settings.jobs = 1;
  const auto go_on = [](std::size_t, const calc::PlaneField&, calc::Look) {
    return calc::LookAnswer{};
  };
  LookRun run;
  const double begin_s = calc::now_s(), cpu_begin_s = processor_s();
  run.solution = calc::solve_illuminance(scene.scene, {{"plane", &scene.grid}}, settings, 0.95,
                                         {gatherer}, go_on, {});
  run.processor_s = processor_s() - cpu_begin_s;
  run.busy = run.processor_s / (calc::now_s() - begin_s);
  const calc::Message& problem = run.solution.fields.front().problem;
  if (!problem.empty()) throw std::runtime_error(problem.english());
  return run;
}

// Processor time of a connection by OpenGL; null if that is no software: it would not be its time.
std::string software_json(const bench::BenchScene& scene, std::uint64_t paths) {
  std::string problem;
  const auto device = gpu::DeviceThread::open({}, problem);
  if (!device || !device->device().is_software) return "null";
  const auto gl = gpu::make_gl_gatherer(device);
  const auto cpu = calc::make_cpu_gatherer();
  look(scene, paths, *gl);  // compiled
  const LookRun by_cpu = look(scene, paths, *cpu), by_gl = look(scene, paths, *gl);
  const double connect_s =
      by_gl.processor_s - by_cpu.processor_s + by_cpu.busy * by_cpu.solution.times.connect_s;
  const auto connections =
      static_cast<double>(by_gl.solution.fields.front().counters.connection_rays);
  return fmt::format(
      "{{\"renderer\": \"{}\", \"points\": {}, \"draws\": {}, \"ns_per_connection\": {:.0f}}}",
      device->device().renderer, scene.points(), calc::draws_per_point(paths, scene.points()),
      1e9 * connect_s / connections);
}

std::string look_json(const bench::BenchScene& scene, std::uint64_t paths) {
  const auto gatherer = calc::make_cpu_gatherer();
  const LookRun run = look(scene, paths, *gatherer);
  // Others may use the machine: phases are the clock's, put right by the processor's time.
  const double busy = run.busy;
  const calc::SpaceSolution& s = run.solution;
  const calc::PlaneField& field = s.fields.front();
  return fmt::format(
      "{{\"points\": {}, \"paths\": {}, \"replicates\": {}, \"error\": {:.6f}, \"pool_rays\": {}, "
      "\"direct_rays\": {}, \"connections\": {}, \"near_rays\": {}, \"seconds\": {{\"direct\": "
      "{:.3f}, \"light_paths\": {:.3f}, \"connections\": {:.3f}, \"near_field\": {:.3f}}}}}",
      scene.points(), paths, field.replicates, error_of(field), s.pool_rays,
      field.counters.direct_rays, field.counters.connection_rays, field.counters.near_rays,
      busy * s.times.direct_s, busy * s.times.pool_s, busy * s.times.connect_s,
      busy * s.times.near_s);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string name = argc > 1 ? argv[1] : "office";
    const bench::BenchScene scene = make_scene(bench::find_room(name));
    std::string looks;
    for (int k = 2; k + 2 < argc; k += 3) {
      if (name != "office") throw std::runtime_error("looks are those of the office");
      const bench::BenchScene sized =
          make_scene(bench::office(std::atoi(argv[k + 1]), std::atoi(argv[k + 2])));
      looks += fmt::format("{}\n    {}", looks.empty() ? "" : ",",
                           look_json(sized, std::strtoull(argv[k], nullptr, 10)));
    }
    fmt::print("{{\n  \"scene\": \"{}\",\n  \"triangles\": {},\n  \"visits\": {},\n", name,
               scene.scene.triangle.size(), visits_json(scene));
    fmt::print("  \"llvmpipe\": {},\n  \"looks\": [{}]\n}}\n",
               name == "office" ? software_json(make_scene(bench::office(40, 25)), 256) : "null",
               looks);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
