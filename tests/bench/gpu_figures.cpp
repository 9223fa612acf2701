// All figures of the GPU backend that need a machine with a GPU, in one call:
//   gpu_figures [--quick] [--device N] [--limit SECONDS]
// Renderer and driver; rays a second of each stage in the office, the corridor and the hall; direct
// light of 204 panels; whole runs to 1 % and 0.1 % at 1e3, 1e4 and 1e5 points, on all cores and
// with the GPU; where the two break even, measured and by the cost model of `--backend auto`;
// pictures and shadow maps. Every run ends at the limit, but for a picture, and what is left out
// for it is named.
#include "calc/forecast/device_cost.h"
#include "calc/forecast/drawing_cost.h"
#include "calc/forecast/scene_plan.h"
#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/looks/solve.h"
#include "calc/radiosity/paths/light_paths.h"
#include "calc/radiosity/paths/vertex_bounds.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/device/calibration.h"
#include "gpu/gather/gl_gatherer.h"
#include "gpu/raster/room_drawing.h"
#include "gpu/raster/shadow_map_gatherer.h"
#include "gpu/rays/gl_direct_tracer.h"
#include "gpu/rays/gl_path_tracer.h"
#include "gpu/rays/gl_short_rays.h"
#include "tests/bench/scenes.h"
#include "tests/bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace {

using namespace bench;

struct Settings {
  bool is_quick = false, wants_messages = false;
  int device = -1;
  double limit_s = 0.0;  // of one run
};

struct Worker {
  const char* name;
  const calc::Stages& stages;
};

// One run, ended by its error or by the limit.
struct Outcome {
  double seconds = 0.0, error = 0.0, average_lx = 0.0;
  bool is_late = false;
  double light_rays = 0.0, connections = 0.0, near_rays = 0.0;
  calc::SolveTimes times;
};

// Standard errors of the illuminance, relative, RMS over points; and the plane's average.
void add_errors(const calc::PlaneField& field, Outcome& outcome) {
  const auto n = static_cast<double>(field.replicates);
  const std::size_t channels = field.channels.size();
  double squares = 0.0, sum_lx = 0.0;
  for (std::size_t i = 0; i < field.points; ++i) {
    double sum = 0.0, sum2 = 0.0;
    for (std::size_t r = 0; r < field.replicates; ++r) {
      double lx = 0.0;
      for (std::size_t c = 0; c < channels; ++c) {
        const std::size_t k = (r * channels + c) * field.points + i;
        lx += field.direct_exact_lx[c * field.points + i];
        if (!field.indirect_lx.empty()) lx += field.indirect_lx[k];
        if (!field.direct_sampled_lx.empty()) lx += field.direct_sampled_lx[k];
      }
      sum += lx;
      sum2 += lx * lx;
    }
    const double mean = sum / n;
    sum_lx += mean;
    if (mean > 0.0) squares += std::max(0.0, sum2 / n - mean * mean) / (n - 1.0) / (mean * mean);
  }
  outcome.error = std::sqrt(squares / static_cast<double>(field.points));
  outcome.average_lx = sum_lx / static_cast<double>(field.points);
}

// target: relative error at which it ends; 0 = one look of so many paths.
Outcome run(const BenchScene& scene, const Worker& worker, double target, std::uint64_t paths,
            double limit_s) {
  calc::RadiositySettings settings;
  settings.first_paths = target > 0.0 ? 1024 : paths;
  settings.max_paths = target > 0.0 ? std::uint64_t{1} << 22 : paths;
  settings.time_limit_s = limit_s;
  // Stages are measured with all their rays, also where a proof could spare them.
  if (!(target > 0.0)) settings.skips.forbid_all();
  Outcome outcome;
  const auto look_test = [&](std::size_t, const calc::PlaneField& field, calc::Look) {
    calc::LookAnswer answer;
    add_errors(field, outcome);
    if (target > 0.0 && outcome.error <= target) answer.finished = calc::StopReason::accurate;
    return answer;
  };
  const double begin_s = calc::now_s();
  const calc::SpaceSolution solution = calc::solve_illuminance(
      scene.scene, {{"plane", &scene.grid}}, settings, 0.95, worker.stages, look_test, {});
  outcome.seconds = calc::now_s() - begin_s;
  const calc::PlaneField& field = solution.fields.front();
  if (!field.problem.empty()) {
    if (outcome.seconds < limit_s) {
      throw std::runtime_error(
          fmt::format("{}, {}: {}", scene.name, worker.name, field.problem.english()));
    }
    outcome.is_late = true;  // before its first look was over
    return outcome;
  }
  add_errors(field, outcome);
  outcome.is_late =
      target > 0.0 ? outcome.error > target : field.stop == calc::StopReason::time_limit;
  outcome.light_rays = static_cast<double>(solution.pool_rays);
  outcome.connections = static_cast<double>(field.counters.connection_rays);
  outcome.near_rays = static_cast<double>(field.counters.near_rays);
  outcome.times = solution.times;
  return outcome;
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos && colon + 2 < line.size()) return line.substr(colon + 2);
  }
  return "an unnamed processor";
}

std::string rate(double rays, double seconds) {
  if (!(rays > 0.0) || !(seconds > 0.0)) return "-";
  return fmt::format("{:.3g}", 1e-6 * rays / seconds);
}

// Hangs `copies` panels of 1.2 x 0.3 m near each place of a luminaire, in place of it.
void give_panels(BenchScene& scene, int copies) {
  const calc::PhotometricWeb& web = *scene.scene.luminaires.front().web;
  std::vector<double> cd;
  for (std::size_t plane = 0; plane < web.c_rad().size(); ++plane) {
    for (std::size_t gamma = 0; gamma < web.gamma_rad().size(); ++gamma) {
      cd.push_back(web.table_cd(plane, gamma));
    }
  }
  scene.webs.push_back(std::make_unique<calc::PhotometricWeb>(
      calc::PhotometricWeb::make(web.c_rad(), web.gamma_rad(), cd,
                                 {calc::OpeningShape::rectangle, 1.2, 0.3, 0.0}, {}, web.axis())));
  const calc::PhotometricWeb& panel = *scene.webs.back();
  const std::vector<calc::PlacedLuminaire> places = scene.scene.luminaires;
  scene.scene.luminaires.clear();
  for (calc::PlacedLuminaire lamp : places) {
    lamp.web = &panel;
    lamp.opening = panel.opening();
    lamp.flux_scale /= copies;
    const double first_m = lamp.position_m.y;
    for (int k = 0; k < copies; ++k) {
      lamp.position_m.y = first_m + 0.1 * (k - 0.5 * (copies - 1));
      scene.scene.luminaires.push_back(lamp);
    }
  }
}

struct DirectRun {
  double seconds = 0.0, rays = 0.0;
  bool is_late = false;
};

DirectRun run_direct(const BenchScene& scene, const Worker& worker, double limit_s) {
  calc::RadiositySettings settings;
  settings.first_paths = settings.max_paths = 16;
  settings.time_limit_s = limit_s;
  const calc::SpaceSolution solution = calc::solve_illuminance(
      scene.scene, {{"plane", &scene.grid}}, settings, 0.95, worker.stages,
      [](std::size_t, const calc::PlaneField&, calc::Look) { return calc::LookAnswer{}; }, {});
  const calc::PlaneField& field = solution.fields.front();
  return {solution.times.direct_s, static_cast<double>(field.counters.direct_rays),
          !field.problem.empty()};
}

void print_stages(const Settings& settings, const std::vector<Worker>& workers) {
  Table table(
      "Rays a second of each stage, millions, all threads and all they do beside",
      {"scene", "triangles", "points", "by", "light paths", "connections", "near field", "run s"});
  const std::uint64_t paths = settings.is_quick ? 256 : 8192;
  for (const char* name : {"office", "corridor", "hall"}) {
    if (settings.is_quick && std::string_view(name) == "hall") {
      fmt::print("skipped for --quick: stages in the hall\n");
      continue;
    }
    const BenchScene scene = make_scene(
        settings.is_quick && std::string_view(name) == "office" ? office(14, 9) : find_room(name));
    for (const Worker& worker : workers) {
      run(scene, worker, 0.0, 16, settings.limit_s);  // compiled, sent
      const Outcome o = run(scene, worker, 0.0, paths, settings.limit_s);
      table.add({name, fmt::format("{}", scene.scene.triangle.size()),
                 fmt::format("{}", scene.points()), worker.name, rate(o.light_rays, o.times.pool_s),
                 rate(o.connections, o.times.connect_s), rate(o.near_rays, o.times.near_s),
                 o.is_late ? fmt::format("> {:.3g}, cut off", settings.limit_s)
                           : fmt::format("{:.3g}", o.seconds)});
    }
  }
  table.print();
}

// Direct light alone, once: many points, many panels, furniture.
void print_direct(const Settings& settings, const std::vector<Worker>& workers) {
  Table table(
      "Direct light of panels in the office, once, 16 replicates; pairs of points and panels",
      {"points", "panels", "by", "s", "million pairs/s", "million rays/s"});
  const std::vector<int> rows =
      settings.is_quick ? std::vector<int>{8} : std::vector<int>{25, 80, 250};
  for (const int row : rows) {
    BenchScene scene = make_scene(office(row * 8 / 5, row));
    give_panels(scene, settings.is_quick ? 1 : 17);
    for (const Worker& worker : workers) {
      const DirectRun o = run_direct(scene, worker, settings.limit_s);
      const auto pairs = static_cast<double>(scene.points() * scene.scene.luminaires.size());
      table.add({fmt::format("{}", scene.points()),
                 fmt::format("{}", scene.scene.luminaires.size()), worker.name,
                 o.is_late ? fmt::format("> {:.3g}", o.seconds) : fmt::format("{:.3g}", o.seconds),
                 o.is_late ? "-" : rate(pairs, o.seconds),
                 o.is_late ? "-" : rate(o.rays, o.seconds)});
    }
  }
  table.print();
}

// Instant radiosity by shadow maps: of some light vertices at all points of the scene's grid.
class MapRun {
 public:
  MapRun(const BenchScene& scene, std::size_t maps) : tracer_(scene.scene), emitter_(scene.scene) {
    const auto paths = static_cast<std::uint32_t>(maps);
    vertices_ = calc::trace_light_paths(tracer_, emitter_, {7, 0, 0, paths}).vertices;
    vertices_.resize(std::min(maps, vertices_.size()));
    for (std::size_t i = 0; i < scene.points(); ++i) {
      receivers_.push_back(
          {scene.grid.position_m[i], scene.grid.normal[i], calc::ReceiverKernel::planar});
    }
    lx_.resize(scene.scene.channels.size() * receivers_.size());
    largest_lx_.resize(receivers_.size());
  }

  std::size_t maps() const { return vertices_.size(); }
  void run(calc::Gatherer& gatherer, double deadline_s) {
    gatherer.gather_all({tracer_, vertices_, bounds_, receivers_, {}, true, 0, deadline_s},
                        {lx_.data(), receivers_.size(), largest_lx_.data()});
  }

 private:
  calc::Tracer tracer_;
  calc::Emitter emitter_;
  calc::VertexBounds bounds_{std::numeric_limits<double>::infinity()};
  calc::LightVertices vertices_;
  std::vector<calc::Receiver> receivers_;
  std::vector<double> lx_;
  std::vector<float> largest_lx_;
};

// Pictures of rooms without their light, which is the CPU's, and shadow maps of some light
// vertices; beside them what `--backend auto` assumes of hardware for the next ones, without the
// processor's sums of maps, which it has in any case.
void print_drawing(const Settings& settings, const std::shared_ptr<gpu::DeviceThread>& device,
                   const calc::DeviceRates& rates) {
  const auto assumed_ms = [&](const calc::DrawingWork& work) {
    const calc::DrawingCost cost = calc::weigh_drawing(work, rates, 1);
    return fmt::format("{:.3g}", 1e3 * (cost.hardware_s - cost.open_s));
  };
  const auto timed_ms = [&](const auto& work) {
    const double begin_s = calc::now_s();
    work();
    const double taken_s = calc::now_s() - begin_s;
    return fmt::format("{}{:.3g}", taken_s > settings.limit_s ? "> " : "", 1e3 * taken_s);
  };
  Table table("Drawing, ms: pictures, and 64 shadow maps of 128 texels with all points looked up",
              {"what", "scene", "triangles", "million pixels", "first", "next", "assumed"});
  constexpr double kTexels = 128.0;
  constexpr std::size_t kMaps = 64;
  for (const char* name : {"office", "hall"}) {
    if (settings.is_quick && std::string_view(name) == "hall") {
      fmt::print("skipped for --quick: drawing the hall\n");
      continue;
    }
    const BenchScene scene = make_scene(
        settings.is_quick && std::string_view(name) == "office" ? office(14, 9) : find_room(name));
    const calc::Tracer tracer(scene.scene);
    const int width = settings.is_quick ? 500 : 2400;
    const auto triangles = static_cast<double>(scene.scene.triangle.size());
    gpu::Picture picture;
    const auto draw = [&] {
      picture = gpu::render_vertices(*device, tracer, {}, {}, true, width, 2.0);
    };
    const std::string first = timed_ms(draw), next = timed_ms(draw);
    const double pixels = static_cast<double>(picture.width) * picture.height;
    table.add({"picture", name, fmt::format("{:.0f}", triangles),
               fmt::format("{:.2g}", 1e-6 * pixels), first, next,
               assumed_ms({.rooms = 1, .pixels = pixels, .triangles = triangles})});
    const auto gatherer =
        gpu::make_shadow_map_gatherer(device, static_cast<std::uint32_t>(kTexels));
    MapRun maps(scene, kMaps);
    const auto draw_maps = [&] { maps.run(*gatherer, calc::now_s() + settings.limit_s); };
    const std::string first_maps = timed_ms(draw_maps), next_maps = timed_ms(draw_maps);
    const double faces = 5.0 * static_cast<double>(maps.maps()), texels = faces * kTexels * kTexels;
    table.add({"maps", name, fmt::format("{:.0f}", triangles), fmt::format("{:.2g}", 1e-6 * texels),
               first_maps, next_maps,
               assumed_ms({.map_texels = texels,
                           .map_triangles = faces * triangles,
                           .lookups = static_cast<double>(maps.maps() * scene.points())})});
  }
  table.print();
}

struct Cell {
  std::string name;
  calc::DeviceWork first_look;      // as `--backend auto` predicts it
  std::optional<Outcome> cpu, gpu;  // none: skipped
};

std::string seconds_of(const std::optional<Outcome>& o) {
  if (!o) return "skipped";
  if (!o->is_late) return fmt::format("{:.3g}", o->seconds);
  if (!(o->error > 0.0)) return fmt::format("> {:.3g} (no result)", o->seconds);
  return fmt::format("> {:.3g} (to {} %)", o->seconds, percent(o->error));
}

calc::DeviceWork first_look(const BenchScene& scene) {
  calc::RadiositySettings settings;
  const calc::ScenePlan plan =
      calc::make_scene_plan(scene.scene, {{"plane", &scene.grid}}, settings);
  calc::DeviceWork work;
  work.threads = plan.threads;
  work.add(plan.first_look, plan.workload, settings, plan.threads);
  return work;
}

std::vector<Cell> whole_runs(const Settings& settings, const std::vector<Worker>& workers) {
  struct Size {
    int columns, rows;
  };
  const std::vector<Size> sizes = settings.is_quick
                                      ? std::vector<Size>{{8, 5}, {14, 9}}
                                      : std::vector<Size>{{40, 25}, {125, 80}, {400, 250}};
  const std::vector<double> targets =
      settings.is_quick ? std::vector<double>{0.02} : std::vector<double>{0.01, 0.001};
  std::vector<Cell> cells;
  for (const double target : targets) {
    std::vector<bool> is_hopeless(workers.size(), false);
    for (const Size& size : sizes) {
      const BenchScene scene = make_scene(office(size.columns, size.rows));
      Cell& cell = cells.emplace_back();
      cell.name = fmt::format("{} points to {} %", scene.points(), 100.0 * target);
      cell.first_look = first_look(scene);
      for (std::size_t w = 0; w < workers.size(); ++w) {
        if (is_hopeless[w]) {
          fmt::print("skipped: {} by {}, as fewer points took more than {:.3g} s\n", cell.name,
                     workers[w].name, settings.limit_s);
          continue;
        }
        const Outcome outcome = run(scene, workers[w], target, 0, settings.limit_s);
        is_hopeless[w] = outcome.is_late;
        (w == 0 ? cell.cpu : cell.gpu) = outcome;
        std::fflush(stdout);
      }
    }
  }
  return cells;
}

void print_runs(const std::vector<Cell>& cells, const calc::DeviceRates& rates, double open_s) {
  Table table("Whole runs in the office, s; GPU: without opening it",
              {"run", "connections", "CPU", "GPU", "CPU / GPU", "averages differ by %",
               "auto takes", "best", "auto loses %"});
  for (const Cell& cell : cells) {
    const Outcome* known = cell.cpu ? &*cell.cpu : cell.gpu ? &*cell.gpu : nullptr;
    if (known == nullptr) continue;
    const bool is_whole = cell.cpu && cell.gpu && !cell.cpu->is_late && !cell.gpu->is_late;
    const bool takes_gpu = calc::is_device_worth_it(calc::weigh_device(cell.first_look, rates, {}));
    std::vector<std::string> row{cell.name, count(known->connections), seconds_of(cell.cpu),
                                 seconds_of(cell.gpu)};
    if (is_whole) {
      const double cpu_s = cell.cpu->seconds, gpu_s = cell.gpu->seconds + open_s;
      const double taken_s = takes_gpu ? gpu_s : cpu_s;
      row.push_back(fmt::format("{:.2f}", cell.cpu->seconds / cell.gpu->seconds));
      row.push_back(percent(std::abs(cell.gpu->average_lx / cell.cpu->average_lx - 1.0)));
      row.emplace_back(takes_gpu ? "GPU" : "CPU");
      row.emplace_back(gpu_s < cpu_s ? "GPU" : "CPU");
      row.push_back(percent(taken_s / std::min(cpu_s, gpu_s) - 1.0));
    } else {
      row.insert(row.end(), {"-", "-", takes_gpu ? "GPU" : "CPU", "-", "-"});
    }
    table.add(row);
  }
  table.print();
}

// Connections of the first look above which the model takes the GPU, for work like this; none:
// never.
std::optional<double> model_break_even(const calc::DeviceWork& like,
                                       const calc::DeviceRates& rates) {
  for (double size = 1e-4; size < 1e6; size *= 1.02) {
    calc::DeviceWork work = like;
    for (double* amount :
         {&work.work.light_paths, &work.work.pool_rays, &work.work.direct_rays,
          &work.work.opening_pairs, &work.work.connection_rays, &work.work.near_rays,
          &work.one_thread.direct, &work.one_thread.pool, &work.one_thread.connect,
          &work.one_thread.near_field, &work.receivers}) {
      *amount *= size;
    }
    if (calc::is_device_worth_it(calc::weigh_device(work, rates, {}))) {
      return work.work.connection_rays;
    }
  }
  return std::nullopt;
}

// Time is taken for a line over connections, through the smallest and the largest whole run.
void print_break_even(const std::vector<Cell>& cells, const calc::DeviceRates& rates,
                      double open_s) {
  const Cell *small = nullptr, *large = nullptr;
  for (const Cell& cell : cells) {
    if (!cell.cpu || !cell.gpu || cell.cpu->is_late || cell.gpu->is_late) continue;
    if (!small || cell.cpu->connections < small->cpu->connections) small = &cell;
    if (!large || cell.cpu->connections > large->cpu->connections) large = &cell;
  }
  if (cells.empty() || !cells.front().cpu) return;
  const calc::DeviceWork& like = cells.front().first_look;
  const std::optional<double> model = model_break_even(like, rates);
  fmt::print("Break-even by the cost model ({} threads): {}\n", like.threads,
             model ? fmt::format("{:.2g} connections in the first look", *model) : "never");
  if (small == large) {
    fmt::print("Break-even, measured: needs two runs that both finished\n");
    return;
  }
  const double span = large->cpu->connections - small->cpu->connections;
  const double cpu_each_s = (large->cpu->seconds - small->cpu->seconds) / span;
  const double gpu_each_s = (large->gpu->seconds - small->gpu->seconds) / span;
  const double ahead_s = open_s + small->gpu->seconds - small->cpu->seconds;
  fmt::print("Each connection more: CPU {:.3g} ns, GPU {:.3g} ns, with all that goes with it\n",
             1e9 * cpu_each_s, 1e9 * gpu_each_s);
  if (!(gpu_each_s < cpu_each_s)) {
    fmt::print("Break-even, measured: never\n");
    return;
  }
  const double at = small->cpu->connections + ahead_s / (cpu_each_s - gpu_each_s);
  fmt::print("Break-even, measured, of the whole run: {}\n",
             at > 0.0 ? fmt::format("{:.2g} connections", at) : "at any size");
}

// Of a first run on a device: whether it moves buffers to host memory, or where it puts them.
void print_messages(const gpu::DriverMessages& messages) {
  using Kind = gpu::DriverMessages::Kind;
  fmt::print("\nThe driver's messages: {} about performance, {} others\n",
             messages.count(Kind::performance), messages.count(Kind::other));
  for (const Kind kind : {Kind::performance, Kind::other}) {
    for (const gpu::DriverMessages::Message& message : messages.messages()) {
      if (message.kind != kind) continue;
      fmt::print("  {}{} times: {}\n", kind == Kind::performance ? "performance, " : "",
                 message.count, message.text);
    }
  }
  for (const std::string& buffer : messages.buffers()) fmt::print("  {}\n", buffer);
}

// As `--backend auto` measures them, and how long that takes.
calc::DeviceRates print_rates(const Settings& settings) {
  std::string problem;
  const double begin_s = calc::now_s();
  const auto rates = gpu::measured_rates({settings.device, gpu::Fault::none, ""},
                                         gpu::kCalibrationLimit_s, problem);
  if (!rates) throw std::runtime_error("rates of the device: " + problem);
  fmt::print("Rates for --backend auto, measured in {:.2f} s (0 = no time for it)\n{}\n",
             calc::now_s() - begin_s, gpu::rates_text(*rates));
  return calc::with_assumptions(*rates);
}

Settings parse(int argc, char** argv) {
  Settings settings;
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    const bool has_value = k + 1 < argc;
    if (word == "--quick") {
      settings.is_quick = true;
    } else if (word == "--messages") {
      settings.wants_messages = true;
    } else if (word == "--device" && has_value) {
      settings.device = std::atoi(argv[++k]);
    } else if (word == "--limit" && has_value) {
      settings.limit_s = std::atof(argv[++k]);
    } else {
      throw std::runtime_error("gpu_figures [--quick] [--messages] [--device N] [--limit SECONDS]");
    }
  }
  if (!(settings.limit_s > 0.0)) settings.limit_s = settings.is_quick ? 3.0 : 20.0;
  return settings;
}

int measure(const Settings& settings) {
  const double begin_s = calc::now_s();
  std::string problem;
  gpu::DriverMessages messages;
  const auto device = gpu::DeviceThread::open(
      {settings.device, gpu::Fault::none, "", settings.wants_messages ? &messages : nullptr},
      problem);
  if (!device) {
    fmt::print("no OpenGL: {}\n", problem);
    return 2;
  }
  const double context_s = calc::now_s() - begin_s;
  const auto cpu_gatherer = calc::make_cpu_gatherer();
  const auto gatherer = gpu::make_gl_gatherer(device);
  const auto path_tracer = gpu::make_gl_path_tracer(device);
  const auto short_rays = gpu::make_gl_short_rays(device);
  const calc::Stages cpu{*cpu_gatherer, nullptr, nullptr};
  const auto direct_tracer = gpu::make_gl_direct_tracer(device);
  const calc::Stages gpu{*gatherer, path_tracer.get(), short_rays.get(), direct_tracer.get()};
  const std::vector<Worker> workers{{"CPU", cpu}, {"GPU", gpu}};
  const gpu::Device& d = device->device();
  fmt::print("renderer: {}\nvendor: {}\ndriver: {}\n{}processor: {}, {} threads, {}\n", d.renderer,
             d.vendor, d.version,
             d.is_software
                 ? "This is software: 'GPU' below is the processor again, and says nothing "
                   "about graphics hardware.\n"
                 : "",
             processor_name(), std::thread::hardware_concurrency(), cpu_gatherer->description());
  // Programs are compiled in the first of two equal runs; no cache of them is used.
  const BenchScene small = make_scene(office(8, 5));
  const double first_s = run(small, workers[1], 0.0, 64, settings.limit_s).seconds;
  const double second_s = run(small, workers[1], 0.0, 64, settings.limit_s).seconds;
  const double open_s = context_s + std::max(0.0, first_s - second_s);
  fmt::print("opening it: context {:.3g} s, programs {:.3g} s\n\n", context_s, open_s - context_s);
  std::fflush(stdout);
  const calc::DeviceRates rates = print_rates(settings);
  std::fflush(stdout);
  print_stages(settings, workers);
  print_direct(settings, workers);
  std::fflush(stdout);
  const std::vector<Cell> cells = whole_runs(settings, workers);
  print_runs(cells, rates, open_s);
  print_break_even(cells, rates, open_s);
  std::fflush(stdout);
  try {
    print_drawing(settings, device, rates);
  } catch (const calc::BackendFailure& failure) {
    fmt::print("drawing failed: {}\n", failure.what());
  }
  if (settings.wants_messages) print_messages(messages);
  fmt::print("{}took {:.0f} s\n", settings.is_quick ? "--quick: small rooms, 2 % alone; " : "",
             calc::now_s() - begin_s);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return measure(parse(argc, argv));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
