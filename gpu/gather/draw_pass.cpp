#include "gpu/gather/draw_pass.h"

#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_error.h"

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
  program.set("first_receiver", word(piece.first_receiver));
  program.set("first_tile", word(piece.first_tile));
  program.set("draws", piece.batch->draws);
  program.set("two", 2u);
}

}  // namespace

DrawPrograms::DrawPrograms(const DeviceState& device, const DrawShape& shape)
    : weigh("weigh", draw_shader(DrawStage::weigh, shape), device.programs),
      share("share", draw_shader(DrawStage::share, shape), device.programs),
      trace("trace", draw_shader(DrawStage::trace, shape), device.programs),
      add("add", draw_shader(DrawStage::add, shape), device.programs) {}

DrawPass::DrawPass(const Device& device, const DrawLimits& limits)
    : most_bytes_(most_bytes(limits)),
      pacer_(
          {std::min(kFewestPlaces, limits.dispatch), limits.dispatch,
           std::min(device.is_software ? kFirstSoftwarePlaces : kFirstPlaces, limits.dispatch)}) {
  for (std::unique_ptr<Slot>& slot : slot_) slot = std::make_unique<Slot>();
}

std::size_t DrawPass::Slot::bytes() const {
  return sent_tiles.bytes() + tiles.bytes() + weights.bytes() + cumulated.bytes() +
         spacings.bytes() + results.bytes() + sums.bytes() + bounded.bytes() +
         read_back.room_bytes() + rest_back.room_bytes();
}

std::size_t DrawPass::bytes() const {
  std::size_t sum = 0;
  for (const std::unique_ptr<Slot>& slot : slot_) sum += slot->bytes();
  return sum;
}

// Of four large pieces: three batches take no more room than three.
std::size_t DrawPass::most_bytes(const DrawLimits& limits) {
  constexpr std::size_t kPerWeight = sizeof(float) + sizeof(double);
  constexpr std::size_t kPerPlace = sizeof(std::uint32_t) + 2 * sizeof(BoundedDraw);
  return 4 * (limits.weights * kPerWeight + limits.places * kPerPlace);
}

const DrawPrograms& DrawPass::programs(const DeviceState& device, const DrawShape& shape) {
  std::unique_ptr<DrawPrograms>& made = programs_[shape];
  if (!made) made = std::make_unique<DrawPrograms>(device, shape);
  return *made;
}

// Small pieces leave large buffers to large ones.
std::optional<std::size_t> DrawPass::take_slot(const DrawPiece& piece) {
  const std::size_t wanted = piece.weights() * sizeof(float);
  const auto fits_better = [&](Slot& a, Slot& b) {
    if (a.has_all() != b.has_all()) return a.has_all();
    const bool fits = a.weights.bytes() >= wanted, other_fits = b.weights.bytes() >= wanted;
    if (fits != other_fits) return fits;
    return fits ? a.weights.bytes() < b.weights.bytes() : a.weights.bytes() > b.weights.bytes();
  };
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < kSlots; ++k) {
    if (slot_[k]->is_free && (!best || fits_better(*slot_[k], *slot_[*best]))) best = k;
  }
  if (best) slot_[*best]->is_free = false;
  return best;
}

// Pieces of all sizes would otherwise make every slot as large as the largest of them.
void DrawPass::give_back() {
  while (bytes() > most_bytes_) {
    std::unique_ptr<Slot>* largest = nullptr;
    for (std::unique_ptr<Slot>& slot : slot_) {
      if (!slot->is_free || !slot->has_all()) continue;
      if (largest == nullptr || slot->bytes() > (*largest)->bytes()) largest = &slot;
    }
    if (largest == nullptr || (*largest)->bytes() == 0) return;
    *largest = std::make_unique<Slot>();
  }
}

void DrawPass::upload(const DrawTask& task) {
  const DrawPiece& piece = *task.piece;
  Slot& slot = *slot_[task.slot];
  const std::size_t answer_bytes =
      piece.receivers * piece.words_per_answer() * sizeof(std::uint32_t);
  if (piece.chooses_nodes()) {
    slot.tiles.assign(piece.tile_count * piece.words_per_tile() * sizeof(std::uint32_t), kNotDone);
  } else {
    slot.sent_tiles.assign(piece.tiles);
  }
  slot.weights.reserve(piece.weights() * sizeof(float));
  slot.cumulated.reserve(piece.weights() * sizeof(double));
  slot.spacings.reserve(piece.receivers * sizeof(glm::dvec2));
  if (piece.shape.has_bound) {
    slot.bounded.assign(sizeof(std::uint32_t) + piece.places() * sizeof(BoundedDraw), kNotDone);
    slot.bounded.fill(sizeof(std::uint32_t), 0);
  }
  // A device that silently stops must not look like darkness.
  slot.results.assign(piece.places() * sizeof(std::uint32_t), kNotDone);
  slot.sums.assign(answer_bytes, kNotDone);
  check_gl("sending work");
}

void DrawPass::bind(DeviceState& device, const DrawTask& task) {
  const calc::DrawBatch& batch = *task.piece->batch;
  const Slot& slot = *slot_[task.slot];
  const DevicePool& pool = device.pools.find_or_send(batch.tree, task.pool);
  pool.bind_vertices();
  pool.bind_tree();
  device.draw_points.find_or_send(batch.tracer, batch.tiles, task.piece->block, task.points)
      .receivers.bind(4);
  (task.piece->chooses_nodes() ? slot.tiles : slot.sent_tiles).bind(5);
  slot.weights.bind(8);
  slot.cumulated.bind(9);
  slot.spacings.bind(10);
  slot.results.bind(12);
  slot.sums.bind(13);
  slot.bounded.bind(14);
}

void DrawPass::send(DeviceState& device, std::span<const DrawTask> fresh,
                    std::span<const DrawTask> drawn) {
  for (const DrawTask& task : fresh) upload(task);
  give_back();
  trace(device, drawn, fresh);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  for (const DrawTask& task : fresh) weigh(device, task);
  for (const DrawTask& task : drawn) add(device, task);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  for (const DrawTask& task : fresh) share(device, task);
  for (const DrawTask& task : drawn) fetch(task);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  check_gl(kDoing);
}

// The nodes that each tile's receivers choose from.
void DrawPass::choose(DeviceState& device, const DrawTask& task) {
  const DrawPiece& piece = *task.piece;
  const calc::DrawBatch& batch = *piece.batch;
  if (!piece.chooses_nodes()) return;
  if (!choose_) choose_ = std::make_unique<GlProgram>("choose", choose_shader(), device.programs);
  choose_->use();
  choose_->set("most_nodes", piece.most_nodes);
  choose_->set("most_ranges", piece.most_ranges);
  choose_->set("first_tile", word(piece.first_tile));
  choose_->set("smallest_bound_per_m2", batch.cut.smallest_bound_per_m2);
  choose_->set("wanted_nodes", word(batch.cut.nodes));
  choose_->set("leave_out_hidden", batch.cut.leave_out_hidden ? 1u : 0u);
  choose_->set("two", 2u);
  device.pools.find_or_send(batch.tree, task.pool).bind_nodes();
  device.draw_points.find_or_send(batch.tracer, batch.tiles, piece.block, task.points)
      .views.bind(4);
  slot_[task.slot]->tiles.bind(5);
  glDispatchCompute(word(piece.tile_count), 1, 1);
  check_gl("choosing groups of light vertices");
}

void DrawPass::weigh(DeviceState& device, const DrawTask& task) {
  const DrawPiece& piece = *task.piece;
  const GlProgram& program = programs(device, piece.shape).weigh;
  bind(device, task);
  set_common(program, piece);
  program.set("smallest_bound_per_m2", piece.batch->cut.smallest_bound_per_m2);
  glDispatchCompute(groups(piece.most_nodes), word(piece.receivers), 1);
  check_gl("weighing groups of light vertices");
}

void DrawPass::share(DeviceState& device, const DrawTask& task) {
  const GlProgram& program = programs(device, task.piece->shape).share;
  bind(device, task);
  set_common(program, *task.piece);
  const std::uint64_t key = task.piece->batch->key.bits();
  program.set("key_low", static_cast<std::uint32_t>(key));
  program.set("key_high", static_cast<std::uint32_t>(key >> 32));
  glDispatchCompute(word(task.piece->receivers), 1, 1);
  check_gl("drawing connections");
}

void DrawPass::add(DeviceState& device, const DrawTask& task) {
  bind(device, task);
  set_common(programs(device, task.piece->shape).add, *task.piece);
  glDispatchCompute(word(task.piece->receivers), 1, 1);
  check_gl("adding light");
}

// The list of bounded draws begins behind its length. How long it is nobody knows yet.
void DrawPass::fetch(const DrawTask& task) {
  const DrawPiece& piece = *task.piece;
  Slot& slot = *slot_[task.slot];
  std::vector<GlReadBack::Part> parts{
      {slot.sums, 0, piece.receivers * piece.words_per_answer() * sizeof(std::uint32_t)}};
  slot.bounded_fetched = 0;
  if (piece.shape.has_bound) {
    slot.bounded_fetched = std::min(bounded_expected_, piece.places());
    parts.push_back(
        {slot.bounded, 0, sizeof(std::uint32_t) + slot.bounded_fetched * sizeof(BoundedDraw)});
  }
  slot.read_back.start(parts, kNotDone);
}

// As many rays in a dispatch as the last ones say, of several pieces where they are small. Beside
// the first of them, with no fence between, groups are chosen for `fresh`: there are few, which
// wait for memory, round after round.
void DrawPass::trace(DeviceState& device, std::span<const DrawTask> tasks,
                     std::span<const DrawTask> fresh) {
  std::vector<Stretch> next;
  std::size_t count = 0;
  const auto choose_all = [&] {
    for (const DrawTask& task : fresh) choose(device, task);
    fresh = {};
  };
  const auto run = [&] {
    if (next.empty()) return;
    const bool teaches = fresh.empty();
    const auto dispatch = [&] {
      choose_all();
      for (const Stretch& stretch : next) dispatch_rays(device, stretch);
    };
    pacer_.run(count, kDoing, dispatch, teaches);
    next.clear();
    count = 0;
  };
  for (const DrawTask& task : tasks) {
    const std::size_t places = task.piece->places();
    for (std::size_t first = 0; first < places;) {
      if (calc::is_past(task.piece->batch->deadline_s)) {
        task.piece->is_cut_short = true;
        break;
      }
      const std::size_t some =
          std::min(pacer_.items() - std::min(count, pacer_.items() - 1), places - first);
      next.push_back({&task, first, some});
      count += some;
      first += some;
      if (count >= pacer_.items()) run();
    }
  }
  run();
  choose_all();  // where there are no rays
  check_gl("tracing shadow rays");
}

void DrawPass::dispatch_rays(DeviceState& device, const Stretch& stretch) {
  const DrawPiece& piece = *stretch.task->piece;
  const calc::DrawBatch& batch = *piece.batch;
  const GlProgram& program = programs(device, piece.shape).trace;
  bind(device, *stretch.task);
  set_common(program, piece);
  if (piece.shape.has_shadows) {
    const DeviceScene& scene = device.scenes.of(batch.tracer);
    scene.bind();
    program.set("node_count", scene.nodes);
    program.set("offset_m", static_cast<float>(batch.tracer.offset_m()));
  }
  program.set("lift_m", static_cast<float>(batch.tracer.offset_m()));
  program.set("bounded_from_per_m2", std::min(batch.bounds.lowest_per_m2(), FLT_MAX));
  program.set("first_place", word(stretch.first));
  program.set("place_count", word(stretch.count));
  glDispatchCompute(groups(stretch.count), 1, 1);
}

bool DrawPass::is_ready(const DrawTask& task, double most_s) {
  return slot_[task.slot]->read_back.wait_for(most_s, kDoing);
}

void DrawPass::finish(DeviceState& device, const DrawTask& task) {
  DrawPiece& piece = *task.piece;
  Slot& slot = *slot_[task.slot];
  slot.is_free = true;
  slot.read_back.wait(kDoing);
  const std::size_t answers = piece.receivers * piece.words_per_answer() * sizeof(std::uint32_t);
  const std::size_t fetched = slot.bounded_fetched;
  std::size_t rest = 0;
  if (piece.shape.has_bound) {
    std::uint32_t bounded = kNotDone;
    slot.read_back.copy(answers, std::as_writable_bytes(std::span(&bounded, 1)));
    // If it is more than there can be, then it was not done, as the answers say.
    if (bounded <= piece.places()) {
      // One piece beside a bright spot must not make all later ones fetch as much.
      bounded_expected_ = std::max<std::size_t>(bounded, bounded_expected_ - bounded_expected_ / 8);
      rest = bounded > fetched ? (bounded - fetched) * sizeof(BoundedDraw) : 0;
    }
  }
  if (rest > 0) {
    slot.rest_back.start(
        {{slot.bounded, sizeof(std::uint32_t) + fetched * sizeof(BoundedDraw), rest}}, kNotDone);
    slot.rest_back.wait(kDoing);
  }
  device.check(kDoing);
  // Nothing may fail any more: nobody gives back what a piece holds that waits to be told.
  piece.answers = slot.read_back.lend(0, answers);
  if (piece.shape.has_bound) {
    piece.bounded =
        slot.read_back.lend(answers, sizeof(std::uint32_t) + fetched * sizeof(BoundedDraw));
  }
  if (rest > 0) piece.bounded_rest = slot.rest_back.lend(0, rest);
}

}  // namespace gpu
