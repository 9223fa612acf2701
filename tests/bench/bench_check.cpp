// Time of a project's calculation by phase, and the share of it that the ray tracer alone would
// need.
//   bench_check PROJECT.xml [TOLERANCE]
// Prints one line per space: points, paths, seconds by phase, rays per second, and the ratio of the
// connection phase to the time of its shadow rays alone, for as many of the same rays, measured in
// the same process.
#include "calc/base/file_reader.h"
#include "calc/project/project_xml.h"
#include "calc/radiosity/direct/emission.h"
#include "calc/radiosity/looks/solve.h"
#include "calc/radiosity/paths/light_paths.h"
#include "calc/radiosity/paths/vertex_tree.h"
#include "calc/scene/prepared_scene.h"
#include "calc/scene/sensor_grid.h"
#include "rules/binding/bind.h"
#include "rules/pack/builtin_packs.h"
#include "rules/verdict/stop_rule.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

namespace {

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Front-facing pairs of points and light vertices as ready-made packets, in gathering order.
std::vector<calc::SegmentPacket> make_packets(const calc::Tracer& tracer,
                                              const calc::LightVertices& vertices,
                                              const calc::SensorGrid& grid, std::size_t most) {
  std::vector<calc::SegmentPacket> packets;
  for (std::size_t i = 0; i < grid.position_m.size() && packets.size() < most; ++i) {
    const glm::dvec3 x = grid.position_m[i] - tracer.scene().origin_m;
    calc::SegmentPacket next;
    const glm::vec3 from(tracer.lift(x, grid.normal[i]));
    for (std::size_t j = 0; j < vertices.size(); ++j) {
      const glm::dvec3 y(vertices[j].position_m), ny(vertices[j].normal);
      if (calc::geometry_term(x, grid.normal[i], y, ny) <= 0.0) continue;
      const glm::vec3 to(y);
      next.add(from, to);
      if (!next.is_full()) continue;
      packets.push_back(next);
      next.count = 0;
    }
  }
  return packets;
}

// Best of five, rays per second on all threads.
double raw_occlusion_rate(const calc::Tracer& tracer,
                          const std::vector<calc::SegmentPacket>& packets) {
  double best_s = std::numeric_limits<double>::max();
  for (int run = 0; run < 5; ++run) {
    const double begin = now_s();
    tbb::parallel_for(std::size_t{0}, packets.size() / 256 + 1, [&](std::size_t chunk) {
      const calc::FlushDenormals flush;
      volatile std::uint32_t sink = 0;
      const std::size_t end = std::min(packets.size(), (chunk + 1) * 256);
      for (std::size_t p = chunk * 256; p < end; ++p) {
        sink = sink ^ tracer.blocked(packets[p]);
      }
    });
    best_s = std::min(best_s, now_s() - begin);
  }
  return static_cast<double>(packets.size() * calc::SegmentPacket::kSize) / best_s;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: bench_check PROJECT.xml [TOLERANCE]\n", stderr);
    return 2;
  }
  const double tolerance = argc > 2 ? std::atof(argv[2]) : 0.02;
  calc::Diagnostics diagnostics;
  const double load_begin = now_s();
  const auto project = calc::load_project(calc::DiskFileReader(), argv[1], diagnostics);
  if (!project) {
    for (const auto& d : diagnostics.all()) fmt::print(stderr, "{}\n", calc::format_diagnostic(d));
    return 2;
  }
  const double load_s = now_s() - load_begin;
  const auto requirements =
      rules::bind_requirements(*project, rules::builtin_rule_packs(), diagnostics);
  for (const calc::Space& space : project->spaces) {
    std::vector<calc::SensorGrid> grids;
    for (const calc::CalcPlane& plane : space.planes) {
      if (auto grid = calc::make_sensor_grid(plane, space, diagnostics))
        grids.push_back(std::move(*grid));
    }
    if (grids.size() != space.planes.size()) return 2;
    std::vector<calc::PlaneTask> tasks;
    std::size_t points = 0;
    for (std::size_t p = 0; p < grids.size(); ++p) {
      tasks.push_back({space.planes[p].id, &grids[p]});
      points += grids[p].position_m.size();
    }
    if (tasks.empty()) continue;
    const calc::PreparedScene scene = calc::prepare_scene(*project, space);
    const auto gatherer = calc::make_cpu_gatherer();
    const double begin = now_s();
    const calc::SpaceSolution solution = calc::solve_illuminance(
        scene, tasks, {}, 0.95, *gatherer,
        [&](std::size_t task, const calc::PlaneField& field, calc::Look) {
          const auto own = rules::requirements_of_plane(requirements, tasks[task].plane_id);
          rules::LookJudgement answer = rules::judge_look({rules::Goal::accuracy, tolerance, 0.95},
                                                          own, grids[task], field, project->scenes);
          return calc::LookAnswer{answer.finished, std::move(answer.active)};
        },
        {});
    const double total_s = now_s() - begin;
    std::uint64_t paths = 0, connection_rays = 0, near_rays = 0, direct_rays = 0;
    for (const auto& field : solution.fields) {
      paths = std::max(paths, field.counters.paths);
      connection_rays += field.counters.connection_rays;
      near_rays += field.counters.near_rays;
      direct_rays += field.counters.direct_rays;
    }
    const calc::SolveTimes& t = solution.times;
    fmt::print("space {}: {} planes, {} points, {} triangles, {} paths, tolerance {} %\n", space.id,
               tasks.size(), points, scene.triangle.size(), paths, 100 * tolerance);
    fmt::print(
        "  seconds: load {:.3f} build {:.3f} direct {:.3f} pool {:.3f} connect {:.3f} near {:.3f} "
        "total {:.3f}\n",
        load_s, t.build_s, t.direct_s, t.pool_s, t.connect_s, t.near_s, total_s);
    fmt::print("  rays: direct {} pool {} connect {} near {}\n", direct_rays, solution.pool_rays,
               connection_rays, near_rays);
    if (connection_rays == 0) continue;
    const calc::Tracer tracer(scene);
    const calc::Emitter emitter(scene);
    const calc::TracedPaths traced = calc::trace_light_paths(tracer, emitter, {1, 0, 0, 1024});
    const auto packets =
        make_packets(tracer, calc::VertexTree(traced.vertices, scene.channels.size()).vertices(),
                     grids[0], 200000);
    const double raw = raw_occlusion_rate(tracer, packets);
    const double connect = static_cast<double>(connection_rays) / t.connect_s;
    fmt::print("  connection rays/s {:.1f} M, rays alone {:.1f} M, ratio {:.2f}\n", connect / 1e6,
               raw / 1e6, connect / raw);
  }
  return 0;
}
