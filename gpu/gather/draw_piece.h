#pragma once
// A part of a calc::DrawBatch on its way to the device and back.

#include "calc/radiosity/gather/gatherer.h"
#include "gpu/opengl/borrowed_bytes.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

// A draw above the smallest bound, whose own bound the CPU has to find.
struct BoundedDraw {
  std::uint32_t vertex;
  float weight;           // as in calc::Connection
  float geometry_per_m2;  // before the bound
};
static_assert(sizeof(BoundedDraw) == 12);

// The device's answer for a receiver, before a sum for each channel of the pool.
struct DrawAnswer {
  std::uint32_t rays;  // kNotDone: the device did not do its work
  std::uint32_t bounded, first_bounded;
  float largest_lx;
};
static_assert(sizeof(DrawAnswer) == 16);

// The features that a piece needs; its programs omit the others.
struct DrawShape {
  bool has_shadows = false;
  bool has_planar = false, has_round = false;  // kernels of receivers
  bool has_many_channels = false;
  bool has_bound = false;
  bool has_given_shifts = false;  // of hits: with each receiver, not from its key

  friend auto operator<=>(const DrawShape&, const DrawShape&) = default;
};

struct DrawPiece {
  const calc::DrawBatch* batch = nullptr;
  DrawShape shape;
  std::uint32_t most_nodes = 0;   // of a tile
  std::uint32_t most_ranges = 0;  // channels of the pool
  // Block of the plane's tiles, see device_points.h: neighbours there.
  std::size_t block = 0;
  std::size_t first_receiver = 0, receivers = 0;  // in the block
  std::size_t first_tile = 0, tile_count = 0;     // in the block; the last may be cut
  // Tiles whose nodes the device does not choose, as in shaders/gather/tile_words.glsl; else empty.
  std::vector<std::uint32_t> tiles;

  // What comes back, read by whoever asked; given back before the next piece is.
  BorrowedBytes answers;  // [receiver] a DrawAnswer and doubles, see words_per_answer()
  // A word and a list of BoundedDraw; the rest of it, where it is longer than was thought.
  BorrowedBytes bounded, bounded_rest;
  bool is_cut_short = false;  // the deadline has passed

  // Returns a draw; throws calc::BackendFailure if the device did not do its work.
  BoundedDraw bounded_draw(std::size_t index) const;

  std::size_t places_per_receiver() const { return std::size_t{batch->draws} + 1; }
  std::size_t places() const { return receivers * places_per_receiver(); }
  std::size_t weights() const { return receivers * most_nodes; }
  bool chooses_nodes() const { return tiles.empty(); }
  std::size_t words_per_tile() const;
  std::size_t words_per_answer() const { return 4 + 2 * std::size_t{most_ranges}; }
};

// Limits of a piece, or of those that go together, on the device, whose buffers may be no larger
// than 128 MiB. A receiver with more draws makes a piece on its own. Most pieces end by their
// weights: half a million draws, twice the number of threads of a large device.
struct DrawLimits {
  std::size_t places = std::size_t{1} << 22;    // of draws: 12 bytes in the longest list
  std::size_t weights = std::size_t{1} << 23;   // of groups: 8 bytes
  std::size_t dispatch = std::size_t{1} << 21;  // draws whose rays go in one dispatch
};

// Returns the tiles in a batch: as many as make one dispatch of one piece, so that enough work
// fills the device, but no more than a thread's share. Small beside a replicate, and large beside
// the transfer to the device and back, a tenth of a millisecond.
std::size_t tiles_per_batch(const calc::TileWork& work, const DrawLimits& limits,
                            std::size_t places_per_dispatch);

// Cuts a batch into pieces that fit onto the device, and adds their results. Chooses the nodes of
// tiles whose cuts are too large for the device: those of few points with thousands of draws each.
class DrawPacker {
 public:
  DrawPacker(const calc::DrawBatch& batch, const DrawLimits& limits);

  // Makes the next piece; returns false after the last, or past the deadline.
  bool next(DrawPiece& piece);
  // Adds the answers to the sums of that piece, the last that next() made; returns the rays. Throws
  // calc::BackendFailure if the device did not do its work.
  std::uint64_t add(const DrawPiece& piece) const;

 private:
  // Some receivers of one tile, consecutive in the piece.
  struct Part {
    std::size_t tile, first, count;
  };

  void append_nodes(const calc::ReceiverTile& tile, DrawPiece& piece);
  std::size_t group() const { return batch_.first_tile + tile_; }
  bool belongs_to(const DrawPiece& piece) const;
  std::size_t room_in(const DrawPiece& piece) const;
  void append(DrawPiece& piece, std::size_t count);

  const calc::DrawBatch& batch_;
  const DrawLimits limits_;
  const std::vector<std::uint32_t> channels_;  // of the pool, in order of its roots
  const std::uint32_t most_nodes_;
  std::size_t tile_ = 0, receiver_ = 0;  // of the batch: where the next piece begins
  std::vector<Part> parts_;
};

}  // namespace gpu
