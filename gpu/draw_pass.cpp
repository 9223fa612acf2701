#include "gpu/draw_pass.h"

#include "calc/radiosity/phase_timer.h"
#include "gpu/gl_error.h"
#include "gpu/shader_text.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cfloat>
#include <vector>

namespace gpu {
namespace {

constexpr std::size_t kFewestPlaces = std::size_t{1} << 12;
// Some 10 ms in a room of a million triangles, on an entry-level device.
constexpr std::size_t kFirstPlaces = std::size_t{1} << 17;
constexpr std::size_t kFirstSoftwarePlaces = std::size_t{1} << 14;
constexpr const char* kDoing = "gathering light";

unsigned groups(std::size_t count) {
  return static_cast<unsigned>((count + kGroupSize - 1) / kGroupSize);
}

std::uint32_t word(std::size_t number) { return static_cast<std::uint32_t>(number); }

void set_common(const GlProgram& program, const DrawPiece& piece) {
  program.use();
  program.set("most_nodes", piece.most_nodes);
  program.set("most_ranges", piece.most_ranges);
  program.set("draws", piece.batch->draws);
  program.set("two", 2u);
}

}  // namespace

DrawPrograms::DrawPrograms(const DeviceState& device, const DrawShape& shape)
    : weigh("weigh", draw_shader(DrawStage::weigh, shape), device.programs),
      share("share", draw_shader(DrawStage::share, shape), device.programs),
      trace("trace", draw_shader(DrawStage::trace, shape), device.programs),
      add("add", draw_shader(DrawStage::add, shape), device.programs) {}

DrawPass::DrawPass(const Device& device, std::size_t most_places)
    : pacer_({std::min(kFewestPlaces, most_places), most_places,
              std::min(device.is_software ? kFirstSoftwarePlaces : kFirstPlaces, most_places)}) {}

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
  if (piece.has_views()) {
    slot.views.assign(piece.views);
    slot.tiles.assign(piece.tile_count * piece.words_per_tile() * sizeof(std::uint32_t), kNotDone);
  } else {
    slot.sent_tiles.assign(piece.tiles);
  }
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
  check_gl("sending calculation points");
}

void DrawPass::bind(const DevicePool& pool, const Slot& slot, const DrawPiece& piece) {
  pool.bind_vertices();
  pool.bind_tree();
  slot.receivers.bind(4);
  (piece.has_views() ? slot.tiles : slot.sent_tiles).bind(5);
  slot.weights.bind(8);
  slot.cumulated.bind(9);
  slot.spacings.bind(10);
  slot.results.bind(12);
  slot.sums.bind(13);
  slot.bounded.bind(14);
}

// The nodes that each tile's receivers choose from.
void DrawPass::choose(DeviceState& device, const DevicePool& pool, const Slot& slot,
                      const DrawPiece& piece) {
  if (!choose_) choose_ = std::make_unique<GlProgram>("choose", choose_shader(), device.programs);
  const calc::CutRequest& cut = piece.batch->cut;
  choose_->use();
  choose_->set("most_nodes", piece.most_nodes);
  choose_->set("most_ranges", piece.most_ranges);
  choose_->set("smallest_bound_per_m2", cut.smallest_bound_per_m2);
  choose_->set("wanted_nodes", word(cut.nodes));
  choose_->set("leave_out_hidden", cut.leave_out_hidden ? 1u : 0u);
  choose_->set("two", 2u);
  pool.bind_nodes();
  slot.views.bind(4);
  slot.tiles.bind(5);
  glDispatchCompute(word(piece.tile_count), 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  check_gl("choosing groups of light vertices");
}

void DrawPass::start(DeviceState& device, DevicePools& pools, std::size_t slot_number,
                     DrawPiece& piece, const PackedPool* packed) {
  Slot& slot = slot_[slot_number];
  const calc::DrawBatch& batch = *piece.batch;
  const DrawPrograms& program = programs(device, piece.shape);
  const DevicePool& pool = pools.find_or_send(batch.tree, packed);
  upload(slot, piece);
  if (piece.has_views()) choose(device, pool, slot, piece);
  bind(pool, slot, piece);

  const std::size_t receivers = piece.receivers.size();
  set_common(program.weigh, piece);
  program.weigh.set("smallest_bound_per_m2", batch.cut.smallest_bound_per_m2);
  glDispatchCompute(groups(piece.most_nodes), static_cast<unsigned>(receivers), 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  set_common(program.share, piece);
  glDispatchCompute(static_cast<unsigned>(receivers), 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  check_gl("drawing connections");
  trace(program.trace, device, piece);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  set_common(program.add, piece);
  glDispatchCompute(static_cast<unsigned>(receivers), 1, 1);
  fetch(slot, piece);
  check_gl("adding light");
}

// The list of bounded draws begins behind its length. How long it is nobody knows yet.
void DrawPass::fetch(Slot& slot, const DrawPiece& piece) {
  const std::size_t receivers = piece.receivers.size();
  std::vector<GlReadBack::Part> parts{
      {slot.sums, 0, receivers * piece.words_per_answer() * sizeof(std::uint32_t)}};
  slot.bounded_fetched = 0;
  if (piece.shape.has_bound) {
    slot.bounded_fetched = std::min(bounded_expected_, receivers * piece.places_per_receiver());
    parts.push_back(
        {slot.bounded, sizeof(std::uint32_t), slot.bounded_fetched * sizeof(BoundedDraw)});
  }
  slot.read_back.start(parts, kNotDone);
}

void DrawPass::trace(const GlProgram& program, DeviceState& device, DrawPiece& piece) {
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
  for (std::size_t first = 0; first < places;) {
    if (calc::is_past(piece.batch->deadline_s)) {
      piece.is_cut_short = true;
      return;
    }
    const std::size_t count = std::min(pacer_.items(), places - first);
    pacer_.run(count, kDoing, [&] {
      program.set("first_place", word(first));
      program.set("place_count", word(count));
      glDispatchCompute(groups(count), 1, 1);
    });
    first += count;
  }
  check_gl("tracing shadow rays");
}

bool DrawPass::is_ready(std::size_t slot, double most_s) {
  return slot_[slot].read_back.wait_for(most_s, kDoing);
}

void DrawPass::finish(DeviceState& device, std::size_t slot_number, DrawPiece& piece) {
  Slot& slot = slot_[slot_number];
  slot.read_back.wait(kDoing);
  piece.answers.assign(piece.receivers.size() * piece.words_per_answer(), kNotDone);
  const auto answers = std::as_writable_bytes(std::span(piece.answers));
  slot.read_back.copy(0, answers);
  device.check(kDoing);
  if (!piece.shape.has_bound) return;
  std::size_t bounded = 0;
  for (std::size_t k = 0; k < piece.answers.size(); k += piece.words_per_answer()) {
    if (piece.answers[k] != kNotDone) bounded += piece.answers[k + 1];
  }
  bounded_expected_ = std::max(bounded_expected_, bounded);
  piece.bounded.resize(bounded);
  const auto list = std::as_writable_bytes(std::span(piece.bounded));
  const std::size_t behind = slot.bounded_fetched * sizeof(BoundedDraw);
  slot.read_back.copy(answers.size(), list.first(std::min(list.size(), behind)));
  if (list.size() > behind) {
    slot.read_back.start({{slot.bounded, sizeof(std::uint32_t) + behind, list.size() - behind}},
                         kNotDone);
    slot.read_back.wait(kDoing);
    slot.read_back.copy(0, list.subspan(behind));
  }
  device.check(kDoing);
}

}  // namespace gpu
