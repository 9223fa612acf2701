#pragma once
// Pieces of drawn connections on the device, some at a time, so that the device has work while the
// next is sent. For the thread that owns the context.

#include "gpu/device_pool.h"
#include "gpu/device_thread.h"
#include "gpu/dispatch_pacer.h"
#include "gpu/draw_piece.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_program.h"
#include "gpu/gl_read_back.h"

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
  // most_places: rays of one dispatch, never changes a result.
  DrawPass(const Device& device, std::size_t most_places);

  // Sends a piece and starts its work in a slot that is free. packed: the pool, null if the device
  // is thought to hold it. Throws GlError; what the slots hold is then lost.
  void start(DeviceState& device, DevicePools& pools, std::size_t slot, DrawPiece& piece,
             const PackedPool* packed);
  // Waits so long at most; whether finish() would not wait. Throws GlError.
  bool is_ready(std::size_t slot, double most_s);
  // Waits for the piece of a slot and fills in what comes back. Throws GlError.
  void finish(DeviceState& device, std::size_t slot, DrawPiece& piece);
  // Rays of a dispatch, by what the last ones took.
  std::size_t places_per_dispatch() const { return pacer_.items(); }

 private:
  struct Slot {
    GlBuffer receivers{"calculation points"}, views{"tiles of calculation points"};
    GlBuffer sent_tiles{"groups of light vertices"};  // that the CPU chose
    GlBuffer tiles{"groups of light vertices", BufferUse::by_device};
    GlBuffer weights{"weights of groups", BufferUse::by_device};
    GlBuffer cumulated{"summed weights of groups", BufferUse::by_device};
    GlBuffer spacings{"spacings of draws", BufferUse::by_device};
    GlBuffer results{"results", BufferUse::by_device}, sums{"sums", BufferUse::by_device};
    GlBuffer bounded{"bounded connections", BufferUse::by_device};
    GlReadBack read_back{"sums"};
    std::size_t bounded_fetched = 0;  // of the list, with the sums
  };

  void upload(Slot& slot, const DrawPiece& piece);
  void choose(DeviceState& device, const DevicePool& pool, const Slot& slot,
              const DrawPiece& piece);
  static void bind(const DevicePool& pool, const Slot& slot, const DrawPiece& piece);
  void fetch(Slot& slot, const DrawPiece& piece);
  void trace(const GlProgram& program, DeviceState& device, DrawPiece& piece);
  const DrawPrograms& programs(const DeviceState& device, const DrawShape& shape);

  std::array<Slot, kSlots> slot_;
  std::unique_ptr<GlProgram> choose_;
  std::map<DrawShape, std::unique_ptr<DrawPrograms>> programs_;
  DispatchPacer pacer_;
  // Bounded draws that are fetched with the sums: by what pieces had, so that few come back twice.
  std::size_t bounded_expected_ = 1024;
};

}  // namespace gpu
