#include "gpu/rays/gl_direct_tracer.h"

#include "calc/radiosity/gather/gatherer.h"
#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/gather/shader_text.h"
#include "gpu/opengl/buffer_sets.h"
#include "gpu/rays/direct_pass.h"
#include "gpu/rays/path_shader_text.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <bit>
#include <exception>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace gpu {
namespace {

// What comes back of one piece at most: some 32 MiB.
constexpr std::size_t kMostTotals = std::size_t{1} << 22;

bool is_point(const calc::PlacedLuminaire& luminaire) {
  return luminaire.opening.shape == calc::OpeningShape::point;
}

// [luminaire]: 1 = it may give something, and has a point opening or not.
std::vector<std::uint8_t> asked(const calc::DirectBatch& batch, bool wants_points) {
  const auto& luminaires = batch.tracer.scene().luminaires;
  std::vector<std::uint8_t> is_asked(luminaires.size(), 0);
  for (std::size_t l = 0; l < luminaires.size(); ++l) {
    is_asked[l] = static_cast<std::uint8_t>(is_point(luminaires[l]) == wants_points &&
                                            !batch.proofs.leaves_out(l));
  }
  return is_asked;
}

bool is_any(const std::vector<std::uint8_t>& flags) {
  return std::find(flags.begin(), flags.end(), 1) != flags.end();
}

class GlDirectTracer : public calc::DirectTracer {
 public:
  GlDirectTracer(std::shared_ptr<DeviceThread> thread, const DirectLimits& limits)
      : thread_(std::move(thread)), limits_(limits) {}
  ~GlDirectTracer() override {
    thread_->clean_up([this](DeviceState&) { clear(); });
  }
  GlDirectTracer(const GlDirectTracer&) = delete;
  GlDirectTracer& operator=(const GlDirectTracer&) = delete;

  std::uint64_t add_point_sources(const calc::DirectBatch& batch, std::span<double> lx) override {
    std::uint64_t rays = 0;
    const std::vector<std::uint8_t> is_asked = asked(batch, true);
    if (!is_any(is_asked)) return rays;
    const std::size_t n = batch.receivers.size();
    for_each_piece(batch, 1, is_asked, {}, {}, [&](std::size_t first, const DirectPiece& piece) {
      const std::size_t points = piece.points.size();
      for (std::size_t i = 0; i < piece.known_lx.size(); ++i) {
        lx[i / points * n + first + i % points] += piece.known_lx[i];
      }
      if (batch.proofs.has_shadows) rays += piece.asked_pairs;
    });
    return rays;
  }

  void add_openings(const calc::DirectBatch& batch, std::span<const calc::RandomKey> keys,
                    const calc::OpeningRounds& rounds, const calc::DirectBatchSums& sums) override {
    const std::vector<std::uint8_t> is_asked = asked(batch, false);
    if (!is_any(is_asked)) return;
    for_each_piece(batch, rounds.replicates, is_asked, keys, rounds,
                   [&](std::size_t first, const DirectPiece& piece) {
                     take(batch, first, piece, sums);
                     add_left(batch, first, piece, sums);
                   });
  }

 private:
  struct UnderWay {
    BufferSets<DirectBuffers>::BufferSet turn;
    DirectPiece piece;
    std::size_t first;  // of the batch's points
  };

  template <class Take>
  void for_each_piece(const calc::DirectBatch& batch, std::size_t replicates,
                      const std::vector<std::uint8_t>& is_asked,
                      std::span<const calc::RandomKey> keys, const calc::OpeningRounds& rounds,
                      const Take& take_piece) {
    const std::size_t totals = replicates * (batch.tracer.scene().channels.size() + 1);
    const std::size_t pairs = is_asked.size() * (rounds.last - rounds.first);
    const std::size_t most =
        std::max<std::size_t>(1, std::min(limits_.pairs / pairs, kMostTotals / totals));
    // The device proves one piece while this thread looks at the one before, if there are buffers.
    std::unique_ptr<UnderWay> before;
    const auto finish_before = [&] {
      if (!before) return true;
      finish(*before);
      const bool goes_on = !before->piece.is_cut_short;
      if (goes_on) take_piece(before->first, before->piece);
      before.reset();
      return goes_on;
    };
    for (std::size_t first = 0; first < batch.receivers.size(); first += most) {
      if (calc::is_past(batch.deadline_s)) return;
      std::optional<BufferSets<DirectBuffers>::BufferSet> turn;
      if (before) turn = sets_.try_take();
      if (!turn) {
        if (!finish_before()) return;
        turn = sets_.take();
      }
      const std::size_t points = std::min(most, batch.receivers.size() - first);
      auto next = std::make_unique<UnderWay>(
          UnderWay{std::move(*turn),
                   {&batch.tracer, batch.receivers.subspan(first, points),
                    keys.empty() ? keys : keys.subspan(first, points), is_asked,
                    batch.proofs.has_shadows, rounds, batch.deadline_s},
                   first});
      run([&](DeviceState& device) { pass_->start(device, next->piece, next->turn.buffers()); });
      if (!finish_before() || next->piece.is_cut_short) return;
      before = std::move(next);
    }
    finish_before();
  }

  // What follows the start.
  void finish(UnderWay& work) {
    DirectPiece& piece = work.piece;
    BorrowedBytes pairs;
    run([&](DeviceState& device) { pairs = pass_->pairs(device, piece, work.turn.buffers()); });
    take_pairs(pairs, piece);
    pairs = {};  // given back
    if (!piece.keys.empty()) {
      const std::vector<DirectSamples> samples = samples_of(piece, limits_);
      run([&](DeviceState& device) { pass_->sample(device, piece, samples, work.turn.buffers()); });
      if (piece.is_cut_short) return;
    }
    DirectPass::Sums sums;
    run([&](DeviceState& device) { sums = pass_->sums(device, piece, work.turn.buffers()); });
    take_sums(sums.known, sums.totals, piece);
  }

  void run(const DeviceThread::Work& work) {
    thread_->run([&](DeviceState& device) {
      try {
        if (!pass_) pass_ = std::make_unique<DirectPass>(device.programs);
        work(device);
      } catch (const std::exception&) {
        clear();  // what was kept may be what left no room
        throw;
      }
    });
  }
  void clear() {
    pass_.reset();
    sets_.clear();
  }

  static void take(const calc::DirectBatch& batch, std::size_t first, const DirectPiece& piece,
                   const calc::DirectBatchSums& sums) {
    const std::size_t n = batch.receivers.size(), points = piece.points.size();
    const std::size_t sampled = piece.rounds.replicates * batch.tracer.scene().channels.size();
    const auto add = [&](std::span<double> to, const std::vector<double>& from, std::size_t rows) {
      for (std::size_t i = 0; i < rows * points; ++i) {
        if (piece.is_left[i % points] == 0) to[i / points * n + first + i % points] += from[i];
      }
    };
    if (piece.rounds.first == 0) add(sums.known_lx, piece.known_lx, piece.known_lx.size() / points);
    add(sums.sampled_lx, piece.totals, sampled);
    for (std::size_t r = 0; r < piece.rounds.replicates; ++r) {
      for (std::size_t p = 0; p < points; ++p) {
        if (piece.is_left[p] != 0) continue;
        const auto words =
            std::bit_cast<std::array<std::uint32_t, 2>>(piece.totals[(sampled + r) * points + p]);
        float& largest = sums.largest[first + p];
        largest = std::max(largest, std::bit_cast<float>(words[0]));
        add_rays({words[1] >> kChunkFlags, (words[1] & kChunkIsLit) != 0,
                  (words[1] & kChunkHasHidden) != 0, (words[1] & kChunkHasSeen) != 0},
                 sums.rays[first + p]);
      }
    }
  }

  // Points that the device left undone, on the threads of the CPU.
  static void add_left(const calc::DirectBatch& batch, std::size_t first, const DirectPiece& piece,
                       const calc::DirectBatchSums& sums) {
    const std::size_t n = batch.receivers.size();
    const std::size_t channels = batch.tracer.scene().channels.size();
    // A thread that waits here must not take up another call: it holds buffers that this may need.
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(std::size_t{0}, piece.points.size(), [&](std::size_t p) {
        if (piece.is_left[p] == 0 || calc::is_past(batch.deadline_s)) return;
        const calc::FlushDenormals flush;
        const std::size_t k = first + p;
        add_rays(calc::add_openings(
                     batch.tracer, piece.points[p],
                     {batch.proofs.is_dark, batch.proofs.has_shadows}, piece.keys[p], piece.rounds,
                     {&sums.known_lx[k], &sums.sampled_lx[k], n, channels * n, &sums.largest[k]}),
                 sums.rays[k]);
      });
    });
  }

  static void add_rays(const calc::DirectRays& rays, calc::DirectRays& to) {
    to.traced += rays.traced;
    to.may_be_lit |= rays.may_be_lit;
    to.has_hidden |= rays.has_hidden;
    to.has_seen |= rays.has_seen;
  }

  const std::shared_ptr<DeviceThread> thread_;
  const DirectLimits limits_;
  BufferSets<DirectBuffers> sets_{3};
  std::unique_ptr<DirectPass> pass_;  // of the device's thread alone
};

}  // namespace

DirectLimits direct_limits(const Device& device) {
  DirectLimits limits;
  if (device.is_software) limits.pairs = std::size_t{1} << 13;
  return limits;
}

std::unique_ptr<calc::DirectTracer> make_gl_direct_tracer(std::shared_ptr<DeviceThread> thread) {
  const DirectLimits limits = direct_limits(thread->device());
  return make_gl_direct_tracer(std::move(thread), limits);
}

std::unique_ptr<calc::DirectTracer> make_gl_direct_tracer(std::shared_ptr<DeviceThread> thread,
                                                          const DirectLimits& limits) {
  return std::make_unique<GlDirectTracer>(std::move(thread), limits);
}

}  // namespace gpu
