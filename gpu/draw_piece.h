#pragma once
// Part of a calc::DrawBatch as it goes to the device and comes back.

#include "calc/radiosity/gatherer.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

// A receiver as the shaders read it: four uvec4, the first three with vectors of floats.
struct DrawReceiver {
  glm::vec3 position_m;  // local
  std::uint32_t unused0 = 0;
  glm::vec3 axis;
  std::uint32_t unused1 = 0;
  glm::vec3 lifted_m;  // where its rays begin
  std::uint32_t unused2 = 0;
  std::uint32_t tile;
  std::uint32_t kernel;  // calc::ReceiverKernel
  glm::uvec2 shift;      // the halves of a double
};
static_assert(sizeof(DrawReceiver) == 64);

// One of the draws above the smallest bound, whose own bound the CPU has to find.
struct BoundedDraw {
  std::uint32_t vertex;
  float weight;           // as in calc::Connection
  float geometry_per_m2;  // before the bound
};
static_assert(sizeof(BoundedDraw) == 12);

// What the device answers for a receiver, before a sum for each range of channels.
struct DrawAnswer {
  std::uint32_t rays;  // kNotDone: the device did not do its work
  std::uint32_t bounded, first_bounded;
  float largest_lx;
};
static_assert(sizeof(DrawAnswer) == 16);

// The programs of a piece leave out what it does not need.
struct DrawShape {
  bool has_shadows = false;
  bool has_planar = false, has_round = false;  // kernels of receivers
  bool has_many_channels = false;
  bool has_bound = false;

  friend auto operator<=>(const DrawShape&, const DrawShape&) = default;
};

struct DrawPiece {
  const calc::DrawBatch* batch = nullptr;
  DrawShape shape;
  std::uint32_t most_nodes = 0, most_ranges = 0;  // of a tile
  std::vector<DrawReceiver> receivers;
  // Four words for each tile: where its nodes begin here and how many they are, then the same of
  // its ranges of channels; then what those point to. Ranges have two words, begin and end.
  std::vector<std::uint32_t> tiles;

  // What comes back.
  std::vector<std::uint32_t>
      answers;  // [receiver] a DrawAnswer and doubles, see words_per_answer()
  std::vector<BoundedDraw> bounded;
  bool is_cut_short = false;  // the deadline has passed

  std::size_t places_per_receiver() const { return std::size_t{batch->draws} + 1; }
  std::size_t words_per_answer() const { return 4 + 2 * std::size_t{most_ranges}; }
};

// Bounds of what a piece takes on the device, whose buffers may be no larger than 128 MiB. A
// receiver with more draws makes a piece alone. Most pieces end by their weights: half a million
// draws, twice what a large device has threads.
struct DrawLimits {
  std::size_t places = std::size_t{1} << 21;    // of draws: 12 bytes in the longest list
  std::size_t weights = std::size_t{1} << 23;   // of groups: 8 bytes
  std::size_t dispatch = std::size_t{1} << 21;  // draws whose rays go in one dispatch
};

// Tiles in a batch: as many as make one dispatch of one piece, so that the device is full where the
// work is enough, but no more than a thread's share. Small beside a replicate, and large beside the
// way to the device and back, a tenth of a millisecond.
std::size_t tiles_per_batch(const calc::TileWork& work, const DrawLimits& limits,
                            std::size_t places_per_dispatch);

// Cuts a batch into pieces that fit onto the device, chooses the nodes of each tile on the way, and
// adds what comes back.
class DrawPacker {
 public:
  DrawPacker(const calc::DrawBatch& batch, const DrawLimits& limits)
      : batch_(batch), limits_(limits) {}

  // The next piece; false after the last, or past the deadline.
  bool next(DrawPiece& piece);
  // Adds the answers to the sums of that piece, the last that next() made; returns the rays. Throws
  // calc::BackendFailure if the device did not do its work.
  std::uint64_t add(const DrawPiece& piece) const;

 private:
  // Some receivers of one tile, in the piece one after the other.
  struct Part {
    std::size_t tile, first, count;
    std::vector<std::uint32_t> channels;  // of its ranges
  };

  void choose_nodes(const calc::DrawTile& tile);
  std::size_t room_in(const DrawPiece& piece) const;
  void append(DrawPiece& piece, std::size_t count);
  void finish(DrawPiece& piece);

  const calc::DrawBatch& batch_;
  const DrawLimits limits_;
  std::size_t tile_ = 0, receiver_ = 0;  // where the next piece begins
  bool has_nodes_ = false;               // of tile_
  std::vector<std::uint32_t> nodes_;
  std::vector<calc::Cut::ChannelRange> ranges_;
  std::vector<Part> parts_;
  std::vector<std::uint32_t> heads_;
};

}  // namespace gpu
