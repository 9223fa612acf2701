#include "gpu/gather/draw_piece.h"

#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/gather/shader_text.h"
#include "gpu/gather/tile_words.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/scene/device_points.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

namespace gpu {
namespace {

constexpr std::size_t kMostReceivers = 65535;  // work groups in one direction, on any device
constexpr std::size_t kFewestTiles = 64, kMostTiles = 1024;  // of a batch

std::size_t most_receivers(const DrawLimits& limits, std::size_t places, std::size_t nodes) {
  return std::min({limits.places / places, limits.weights / nodes, kMostReceivers});
}

std::vector<std::uint32_t> channels_of(const calc::VertexTree& tree) {
  std::vector<std::uint32_t> channels;
  for (const std::uint32_t root : tree.roots()) channels.push_back(tree.nodes()[root].channel);
  return channels;
}

// A cut has no more nodes than are asked for, or than there are channels, or vertices.
std::uint32_t most_nodes(const calc::DrawBatch& batch) {
  return static_cast<std::uint32_t>(
      std::min(std::max(batch.cut.nodes, batch.tree.roots().size()), batch.tree.vertices().size()));
}

}  // namespace

std::size_t tiles_per_batch(const calc::TileWork& work, const DrawLimits& limits,
                            std::size_t places_per_dispatch) {
  const std::size_t places = std::size_t{work.draws} + 1;
  const std::size_t receivers =
      std::min(most_receivers(limits, places, std::max<std::size_t>(work.nodes, 1)),
               places_per_dispatch / places);
  const std::size_t tiles = receivers / std::max<std::size_t>(work.receivers, 1);
  return std::clamp(std::min(tiles, work.tiles_each), kFewestTiles, kMostTiles);
}

std::size_t DrawPiece::words_per_tile() const {
  return gpu::words_per_tile(most_nodes, most_ranges);
}

DrawPacker::DrawPacker(const calc::DrawBatch& batch, const DrawLimits& limits)
    : batch_(batch),
      limits_(limits),
      channels_(channels_of(batch.tree)),
      most_nodes_(most_nodes(batch)) {}

void DrawPacker::append_nodes(const calc::ReceiverTile& tile, DrawPiece& piece) {
  thread_local calc::Cut cut;
  thread_local std::vector<std::uint32_t> nodes;
  thread_local std::vector<calc::Cut::ChannelRange> ranges;
  nodes.clear();
  ranges.clear();
  cut.select(batch_.tree, tile, batch_.cut, nodes, ranges);
  append_tile(batch_.tree, most_nodes_, nodes, ranges, piece.tiles);
}

// Whether its receivers lie where those of the next tile do.
bool DrawPacker::belongs_to(const DrawPiece& piece) const {
  return piece.receivers == 0 || group() / kTilesPerBlock == piece.block;
}

// Receivers that the piece can still take.
std::size_t DrawPacker::room_in(const DrawPiece& piece) const {
  const std::size_t most = most_receivers(limits_, piece.places_per_receiver(), most_nodes_);
  if (piece.receivers == 0) return std::max<std::size_t>(most, 1);
  return most > piece.receivers ? most - piece.receivers : 0;
}

void DrawPacker::append(DrawPiece& piece, std::size_t count) {
  if (piece.receivers == 0) {
    piece.block = group() / kTilesPerBlock;
    const std::size_t block_begin = piece.block * kTilesPerBlock;
    piece.first_tile = group() - block_begin;
    piece.first_receiver = batch_.tiles.receivers_before(group()) + receiver_ -
                           batch_.tiles.receivers_before(block_begin);
  }
  if (std::max<std::size_t>(most_nodes_, channels_.size()) > kMostChosen) {
    append_nodes(
        calc::tile_of(batch_.group(tile_).receiver, batch_.tracer.scene().whole_extent_m()), piece);
  }
  piece.receivers += count;
  ++piece.tile_count;
  parts_.push_back({tile_, receiver_, count});
}

bool DrawPacker::next(DrawPiece& piece) {
  piece = DrawPiece{};
  piece.batch = &batch_;
  piece.most_nodes = most_nodes_;
  piece.most_ranges = static_cast<std::uint32_t>(channels_.size());
  constexpr std::uint32_t kPlanar = 1u << static_cast<unsigned>(calc::ReceiverKernel::planar);
  piece.shape.has_planar = (batch_.tiles.kernels() & kPlanar) != 0;
  piece.shape.has_round = (batch_.tiles.kernels() & ~kPlanar) != 0;
  piece.shape.has_shadows = batch_.has_shadows && !batch_.tracer.scene().triangle.empty();
  piece.shape.has_many_channels = channels_.size() > 1;
  piece.shape.has_bound = std::isfinite(batch_.bounds.lowest_per_m2());
  parts_.clear();
  if (most_nodes_ == 0) return false;  // no light vertices
  while (tile_ < batch_.sums.size() && belongs_to(piece) && !calc::is_past(batch_.deadline_s)) {
    const std::size_t left = batch_.group(tile_).receiver.size() - receiver_;
    const std::size_t count = std::min(left, room_in(piece));
    if (count > 0) append(piece, count);
    receiver_ += count;
    if (count < left) break;
    ++tile_;
    receiver_ = 0;
  }
  return piece.receivers > 0;
}

BoundedDraw DrawPiece::bounded_draw(std::size_t index) const {
  constexpr std::size_t kSize = sizeof(BoundedDraw), kHead = sizeof(std::uint32_t);
  const std::size_t together =
      bounded.bytes().size() < kHead ? 0 : (bounded.bytes().size() - kHead) / kSize;
  const auto list = index < together ? bounded.bytes().subspan(kHead) : bounded_rest.bytes();
  const std::size_t at = kSize * (index < together ? index : index - together);
  BoundedDraw draw{kNotDone, 0.0f, 0.0f};
  if (at + kSize <= list.size()) std::memcpy(&draw, list.data() + at, kSize);
  if (draw.vertex == kNotDone) throw_not_done();
  return draw;
}

std::uint64_t DrawPacker::add(const DrawPiece& piece) const {
  const std::size_t answer_bytes = sizeof(std::uint32_t) * piece.words_per_answer();
  const std::span<const std::byte> answers = piece.answers.bytes();
  if (answers.size() != piece.receivers * answer_bytes) throw_not_done();
  const auto answer_at = [&](std::size_t receiver) {
    DrawAnswer answer;
    std::memcpy(&answer, answers.data() + receiver * answer_bytes, sizeof answer);
    return answer;
  };
  // Before all else: lists of the others may be anywhere then.
  for (std::size_t r = 0; r < piece.receivers; ++r) {
    if (answer_at(r).rays == kNotDone) throw_not_done();
  }
  std::uint64_t rays = 0;
  std::size_t r = 0;
  for (const Part& part : parts_) {
    const calc::GatherSums& sums = batch_.sums[part.tile];
    for (std::size_t k = part.first; k < part.first + part.count; ++k, ++r) {
      const DrawAnswer answer = answer_at(r);
      const std::byte* const channel_sums = answers.data() + r * answer_bytes + sizeof answer;
      rays += answer.rays;
      for (std::size_t range = 0; range < channels_.size(); ++range) {
        double lx = 0.0;
        std::memcpy(&lx, channel_sums + range * sizeof lx, sizeof lx);
        sums.lx[channels_[range] * sums.stride + k] += lx;
      }
      float largest = std::max(sums.largest_lx[k], answer.largest_lx);
      for (std::size_t b = 0; b < answer.bounded; ++b) {
        const BoundedDraw draw = piece.bounded_draw(answer.first_bounded + b);
        const calc::LightVertex& v = batch_.tree.vertices()[draw.vertex];
        const float lx = calc::connection_lx(
            draw.weight, v.flux_lm, batch_.bounds.limited(draw.vertex, draw.geometry_per_m2));
        sums.lx[v.channel * sums.stride + k] += static_cast<double>(lx);
        largest = std::max(largest, lx);
      }
      sums.largest_lx[k] = largest;
    }
  }
  return batch_.has_shadows ? rays : 0;
}

}  // namespace gpu
