#include "gpu/draw_piece.h"

#include "calc/radiosity/phase_timer.h"
#include "gpu/shader_text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace gpu {
namespace {

constexpr std::size_t kMostReceivers = 65535;  // work groups in one direction, on any device
constexpr std::size_t kFewestTiles = 64, kMostTiles = 1024;  // of a batch

std::size_t most_receivers(const DrawLimits& limits, std::size_t places, std::size_t nodes) {
  return std::min({limits.places / places, limits.weights / nodes, kMostReceivers});
}

DrawReceiver draw_receiver(const calc::Tracer& tracer, const calc::Receiver& receiver, double shift,
                           std::size_t tile) {
  DrawReceiver result{};
  result.position_m = glm::vec3(receiver.position_m);
  result.axis = glm::vec3(receiver.axis);
  result.lifted_m = glm::vec3(tracer.lift(receiver));
  result.tile = static_cast<std::uint32_t>(tile);
  result.kernel = static_cast<std::uint32_t>(receiver.kernel);
  const auto bits = std::bit_cast<std::uint64_t>(shift);
  result.shift = {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)};
  return result;
}

[[noreturn]] void throw_not_done() {
  throw calc::BackendFailure("the device did not finish its work");
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

void DrawPacker::choose_nodes(const calc::DrawTile& tile) {
  thread_local calc::Cut cut;
  nodes_.clear();
  ranges_.clear();
  cut.select(batch_.tree, calc::tile_of(tile.receivers, batch_.tracer.scene().extent_m), batch_.cut,
             nodes_, ranges_);
  has_nodes_ = true;
}

// Receivers of the tile whose nodes were chosen that the piece can still take.
std::size_t DrawPacker::room_in(const DrawPiece& piece) const {
  const std::size_t used = piece.receivers.size();
  const std::size_t row = std::max<std::size_t>({piece.most_nodes, nodes_.size(), 1});
  const std::size_t most = most_receivers(limits_, piece.places_per_receiver(), row);
  if (used == 0) return std::max<std::size_t>(most, 1);
  return most > used ? most - used : 0;
}

void DrawPacker::append(DrawPiece& piece, std::size_t count) {
  const calc::DrawTile& tile = batch_.tiles[tile_];
  // Heads come first but their number is not yet known: finish() puts them there.
  Part part{tile_, receiver_, count, {}};
  for (const calc::Cut::ChannelRange& range : ranges_) {
    part.channels.push_back(batch_.tree.nodes()[nodes_[range.begin]].channel);
  }
  for (std::size_t k = receiver_; k < receiver_ + count; ++k) {
    piece.receivers.push_back(
        draw_receiver(batch_.tracer, tile.receivers[k], tile.shifts[k], parts_.size()));
    const bool is_planar = tile.receivers[k].kernel == calc::ReceiverKernel::planar;
    (is_planar ? piece.shape.has_planar : piece.shape.has_round) = true;
  }
  const auto at = static_cast<std::uint32_t>(piece.tiles.size());
  const auto nodes = static_cast<std::uint32_t>(nodes_.size());
  const auto ranges = static_cast<std::uint32_t>(ranges_.size());
  heads_.insert(heads_.end(), {at, nodes, at + nodes, ranges});
  piece.tiles.insert(piece.tiles.end(), nodes_.begin(), nodes_.end());
  for (const calc::Cut::ChannelRange& range : ranges_) {
    piece.tiles.insert(piece.tiles.end(), {range.begin, range.end});
  }
  piece.most_nodes = std::max(piece.most_nodes, nodes);
  piece.most_ranges = std::max(piece.most_ranges, ranges);
  parts_.push_back(std::move(part));
}

void DrawPacker::finish(DrawPiece& piece) {
  const auto shift = static_cast<std::uint32_t>(heads_.size());
  for (std::size_t k = 0; k < heads_.size(); k += 2) heads_[k] += shift;
  piece.tiles.insert(piece.tiles.begin(), heads_.begin(), heads_.end());
  piece.shape.has_shadows = batch_.has_shadows && !batch_.tracer.scene().triangle.empty();
  piece.shape.has_many_channels = piece.most_ranges > 1;
  piece.shape.has_bound = std::isfinite(batch_.bounds.lowest_per_m2());
}

bool DrawPacker::next(DrawPiece& piece) {
  piece = DrawPiece{};
  piece.batch = &batch_;
  parts_.clear();
  heads_.clear();
  while (tile_ < batch_.tiles.size() && !calc::is_past(batch_.deadline_s)) {
    const calc::DrawTile& tile = batch_.tiles[tile_];
    if (!has_nodes_) choose_nodes(tile);
    const std::size_t left = nodes_.empty() ? 0 : tile.receivers.size() - receiver_;
    const std::size_t count = std::min(left, room_in(piece));
    if (count > 0) append(piece, count);
    receiver_ += count;
    if (count < left) break;
    ++tile_;
    receiver_ = 0;
    has_nodes_ = false;
  }
  if (piece.receivers.empty()) return false;
  finish(piece);
  return true;
}

std::uint64_t DrawPacker::add(const DrawPiece& piece) const {
  // Before all else: lists of the others may be anywhere then.
  for (std::size_t k = 0; k < piece.answers.size(); k += piece.words_per_answer()) {
    if (piece.answers[k] == kNotDone) throw_not_done();
  }
  std::uint64_t rays = 0;
  const std::uint32_t* words = piece.answers.data();
  for (const Part& part : parts_) {
    const calc::GatherSums& sums = batch_.tiles[part.tile].sums;
    for (std::size_t k = part.first; k < part.first + part.count; ++k) {
      DrawAnswer answer;
      std::memcpy(&answer, words, sizeof answer);
      rays += answer.rays;
      for (std::size_t range = 0; range < part.channels.size(); ++range) {
        double lx = 0.0;
        std::memcpy(&lx, words + 4 + 2 * range, sizeof lx);
        sums.lx[part.channels[range] * sums.stride + k] += lx;
      }
      float largest = std::max(sums.largest_lx[k], answer.largest_lx);
      for (std::size_t b = 0; b < answer.bounded; ++b) {
        const BoundedDraw& draw = piece.bounded.at(answer.first_bounded + b);
        if (draw.vertex == kNotDone) throw_not_done();
        const calc::LightVertex& v = batch_.tree.vertices()[draw.vertex];
        const float lx = calc::connection_lx(
            draw.weight, v.flux_lm, batch_.bounds.limited(draw.vertex, draw.geometry_per_m2));
        sums.lx[v.channel * sums.stride + k] += static_cast<double>(lx);
        largest = std::max(largest, lx);
      }
      sums.largest_lx[k] = largest;
      words += piece.words_per_answer();
    }
  }
  return batch_.has_shadows ? rays : 0;
}

}  // namespace gpu
