#pragma once
// Pieces of drawn connections on the device, some at a time, so that the device has work while the
// next is sent. For the thread that owns the context.

#include "gpu/device_pool.h"
#include "gpu/device_thread.h"
#include "gpu/draw_piece.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_program.h"

#include <array>
#include <cstddef>
#include <map>
#include <memory>

namespace gpu {

// The programs of one shape, in the order in which they run.
struct DrawPrograms {
  GlProgram weigh, share, trace, add;

  DrawPrograms(const DeviceState& device, const DrawShape& shape);
};

class DrawPass {
 public:
  static constexpr std::size_t kSlots = 3;

  // Sends a piece and starts its work in a slot that is free. packed: the pool, null if the device
  // is thought to hold it. Throws GlError; what the slots hold is then lost.
  void start(DeviceState& device, DevicePools& pools, std::size_t slot, DrawPiece& piece,
             const PackedPool* packed);
  // Waits for the piece of a slot and fills in what comes back. Throws GlError.
  void finish(DeviceState& device, std::size_t slot, DrawPiece& piece);

 private:
  struct Slot {
    GlBuffer receivers{"calculation points"}, tiles{"groups of light vertices"};
    GlBuffer weights{"weights of groups"}, cumulated{"summed weights of groups"};
    GlBuffer spacings{"spacings of draws"}, results{"results"}, sums{"sums"};
    GlBuffer bounded{"bounded connections"};
    double started_s = 0.0;
    std::size_t dispatches = 0;
  };

  void upload(Slot& slot, const DrawPiece& piece);
  void trace(const GlProgram& program, DeviceState& device, Slot& slot, DrawPiece& piece);
  const DrawPrograms& programs(const DeviceState& device, const DrawShape& shape);

  std::array<Slot, kSlots> slot_;
  std::map<DrawShape, std::unique_ptr<DrawPrograms>> programs_;
  // Rays of one dispatch, so that each takes some 50 ms at most: desktop drivers watch, and between
  // dispatches the work can end early.
  std::size_t places_per_dispatch_ = std::size_t{1} << 14;
};

}  // namespace gpu
