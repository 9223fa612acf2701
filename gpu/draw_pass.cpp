#include "gpu/draw_pass.h"

#include "calc/radiosity/phase_timer.h"
#include "gpu/gl_error.h"
#include "gpu/shader_text.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cfloat>

namespace gpu {
namespace {

constexpr std::size_t kFewestPlaces = std::size_t{1} << 12;
constexpr std::size_t kMostPlaces = std::size_t{1} << 21;
constexpr double kShort_s = 0.025, kLong_s = 0.05;  // of one dispatch

unsigned groups(std::size_t count) {
  return static_cast<unsigned>((count + kGroupSize - 1) / kGroupSize);
}

std::uint32_t word(std::size_t number) { return static_cast<std::uint32_t>(number); }

void set_common(const GlProgram& program, const DrawPiece& piece) {
  program.use();
  program.set("most_nodes", piece.most_nodes);
  program.set("draws", piece.batch->draws);
}

}  // namespace

DrawPrograms::DrawPrograms(const DeviceState& device, const DrawShape& shape)
    : weigh("weigh", draw_shader(DrawStage::weigh, shape), device.programs),
      share("share", draw_shader(DrawStage::share, shape), device.programs),
      trace("trace", draw_shader(DrawStage::trace, shape), device.programs),
      add("add", draw_shader(DrawStage::add, shape), device.programs) {}

const DrawPrograms& DrawPass::programs(const DeviceState& device, const DrawShape& shape) {
  std::unique_ptr<DrawPrograms>& made = programs_[shape];
  if (!made) made = std::make_unique<DrawPrograms>(device, shape);
  return *made;
}

void DrawPass::upload(Slot& slot, const DrawPiece& piece) {
  const std::size_t receivers = piece.receivers.size();
  const std::size_t places = receivers * piece.places_per_receiver();
  const std::size_t weights = receivers * piece.most_nodes;
  const std::size_t answer_bytes = receivers * piece.words_per_answer() * sizeof(std::uint32_t);
  slot.receivers.assign(piece.receivers);
  slot.tiles.assign(piece.tiles);
  slot.weights.reserve(weights * sizeof(float));
  slot.cumulated.reserve(weights * sizeof(double));
  slot.spacings.reserve(receivers * sizeof(double));
  if (piece.shape.has_bound) {
    slot.bounded.assign(sizeof(std::uint32_t) + places * sizeof(BoundedDraw), kNotDone);
    slot.bounded.fill(sizeof(std::uint32_t), 0);
  }
  // A device that silently stops must not look like darkness.
  slot.results.assign(places * sizeof(std::uint32_t), kNotDone);
  slot.sums.assign(answer_bytes, kNotDone);
  slot.receivers.bind(4);
  slot.tiles.bind(5);
  slot.weights.bind(8);
  slot.cumulated.bind(9);
  slot.spacings.bind(10);
  slot.results.bind(12);
  slot.sums.bind(13);
  slot.bounded.bind(14);
  check_gl("sending calculation points");
}

void DrawPass::start(DeviceState& device, DevicePools& pools, std::size_t slot_number,
                     DrawPiece& piece, const PackedPool* packed) {
  Slot& slot = slot_[slot_number];
  const calc::DrawBatch& batch = *piece.batch;
  const DrawPrograms& program = programs(device, piece.shape);
  const std::uint64_t identity = batch.tree.identity();
  const DevicePool* pool = pools.find(identity, true);
  if (pool == nullptr) {
    pool = &pools.send(identity, packed != nullptr ? *packed : pack_pool(batch.tree));
  }
  slot.started_s = calc::now_s();
  upload(slot, piece);
  pool->bind_vertices();
  pool->bind_tree();

  const std::size_t receivers = piece.receivers.size();
  set_common(program.weigh, piece);
  program.weigh.set("smallest_bound_per_m2", batch.cut.smallest_bound_per_m2);
  glDispatchCompute(groups(piece.most_nodes), static_cast<unsigned>(receivers), 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  set_common(program.share, piece);
  glDispatchCompute(static_cast<unsigned>(receivers), 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  check_gl("drawing connections");
  trace(program.trace, device, slot, piece);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  set_common(program.add, piece);
  program.add.set("most_ranges", piece.most_ranges);
  glDispatchCompute(static_cast<unsigned>(receivers), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glFlush();
  check_gl("adding light");
}

void DrawPass::trace(const GlProgram& program, DeviceState& device, Slot& slot, DrawPiece& piece) {
  set_common(program, piece);
  if (piece.shape.has_shadows) {
    const DeviceScene& scene = device.scenes.of(piece.batch->tracer);
    scene.bind();
    program.set("node_count", scene.nodes);
    program.set("offset_m", static_cast<float>(piece.batch->tracer.offset_m()));
  }
  program.set("lift_m", static_cast<float>(piece.batch->tracer.offset_m()));
  program.set("bounded_from_per_m2", std::min(piece.batch->bounds.lowest_per_m2(), FLT_MAX));
  const std::size_t places = piece.receivers.size() * piece.places_per_receiver();
  slot.dispatches = 0;
  for (std::size_t first = 0; first < places; first += places_per_dispatch_) {
    if (calc::is_past(piece.batch->deadline_s)) {
      piece.is_cut_short = true;
      return;
    }
    const std::size_t count = std::min(places_per_dispatch_, places - first);
    program.set("first_place", word(first));
    program.set("place_count", word(count));
    glDispatchCompute(groups(count), 1, 1);
    ++slot.dispatches;
    if (first + count < places) glFinish();  // so that the deadline is looked at while it works
  }
  check_gl("tracing shadow rays");
}

void DrawPass::finish(DeviceState& device, std::size_t slot_number, DrawPiece& piece) {
  Slot& slot = slot_[slot_number];
  // "Not done" also if reading back does nothing.
  piece.answers.assign(piece.receivers.size() * piece.words_per_answer(), kNotDone);
  slot.sums.read(0, std::as_writable_bytes(std::span(piece.answers)));
  device.check("gathering light");
  const double each_s = (calc::now_s() - slot.started_s) /
                        static_cast<double>(std::max<std::size_t>(slot.dispatches, 1));
  if (each_s < kShort_s) places_per_dispatch_ = std::min(2 * places_per_dispatch_, kMostPlaces);
  if (each_s > kLong_s) places_per_dispatch_ = std::max(places_per_dispatch_ / 2, kFewestPlaces);
  if (!piece.shape.has_bound) return;
  std::size_t bounded = 0;
  for (std::size_t k = 0; k < piece.answers.size(); k += piece.words_per_answer()) {
    if (piece.answers[k] != kNotDone) bounded += piece.answers[k + 1];
  }
  piece.bounded.resize(bounded);
  slot.bounded.read(sizeof(std::uint32_t), std::as_writable_bytes(std::span(piece.bounded)));
  device.check("gathering light");
}

}  // namespace gpu
