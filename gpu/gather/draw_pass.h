#pragma once
// Runs pieces of drawn connections on the device, many at a time, so that it has work while the
// next are sent. For the thread that owns the context.

#include "gpu/device/device_thread.h"
#include "gpu/device/dispatch_pacer.h"
#include "gpu/gather/draw_piece.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/opengl/gl_read_back.h"
#include "gpu/scene/device_points.h"
#include "gpu/scene/device_pool.h"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>

namespace gpu {

// The programs of one shape, in the order in which they run.
struct DrawPrograms {
  GlProgram weigh, share, trace, add;

  DrawPrograms(const DeviceState& device, const DrawShape& shape);
};

// A piece and the data to send for it: null where the device should hold it. All live until it is
// finished.
struct DrawTask {
  DrawPiece* piece;
  const PackedPool* pool;
  const DrawPoints::Packed* points;
  std::size_t slot = 0;  // of DrawPass::take_slot()
};

class DrawPass {
 public:
  static constexpr std::size_t kSlots = 24;
  // limits: of the pieces; never change a result.
  DrawPass(const Device& device, const DrawLimits& limits);

  // Returns a free slot for this piece; empty: all are in use. It is free again after finish(),
  // though another thread may still read the results: then send() waits for that.
  std::optional<std::size_t> take_slot(const DrawPiece& piece);
  // Starts the work of `fresh` up to their draws; and beside it the rest of the work of `drawn`,
  // which were `fresh` before: their rays, sums, and the transfer back. Stages of both run between
  // the same barriers, so that a device may work on both at a time. Throws GlError; the contents of
  // the slots are then lost.
  void send(DeviceState& device, std::span<const DrawTask> fresh, std::span<const DrawTask> drawn);
  // Waits at most this long; returns whether finish() would not wait. Throws GlError.
  bool is_ready(const DrawTask& task, double most_s);
  // Waits for the piece, whose rays were sent, and lends its results. Throws GlError.
  void finish(DeviceState& device, const DrawTask& task);
  // Returns all slots' buffer bytes; after send() at most most_bytes(), except those in use.
  std::size_t bytes() const;
  static std::size_t most_bytes(const DrawLimits& limits);
  // Returns the rays of a dispatch, from the times of the last ones.
  std::size_t places_per_dispatch() const { return pacer_.items(); }

 private:
  struct Slot {
    bool is_free = true;
    GlBuffer sent_tiles{"groups of light vertices"};  // that the CPU chose
    GlBuffer tiles{"groups of light vertices", BufferUse::by_device};
    GlBuffer weights{"weights of groups", BufferUse::by_device};
    GlBuffer cumulated{"summed weights of groups", BufferUse::by_device};
    GlBuffer spacings{"spacings of draws", BufferUse::by_device};
    GlBuffer results{"results", BufferUse::by_device}, sums{"sums", BufferUse::by_device};
    GlBuffer bounded{"bounded connections", BufferUse::by_device};
    GlReadBack read_back{"sums"}, rest_back{"bounded connections"};
    std::size_t bounded_fetched = 0;  // of the list, with the sums

    bool has_all() { return read_back.has_all() && rest_back.has_all(); }
    std::size_t bytes() const;
  };
  // Some of a piece's places.
  struct Stretch {
    const DrawTask* task;
    std::size_t first, count;
  };

  void give_back();
  void upload(const DrawTask& task);
  // Binds the buffers of the stages after choosing.
  void bind(DeviceState& device, const DrawTask& task);
  void choose(DeviceState& device, const DrawTask& task);
  void weigh(DeviceState& device, const DrawTask& task);
  void share(DeviceState& device, const DrawTask& task);
  void trace(DeviceState& device, std::span<const DrawTask> tasks, std::span<const DrawTask> fresh);
  void dispatch_rays(DeviceState& device, const Stretch& stretch);
  void add(DeviceState& device, const DrawTask& task);
  void fetch(const DrawTask& task);
  const DrawPrograms& programs(const DeviceState& device, const DrawShape& shape);

  const std::size_t most_bytes_;
  std::array<std::unique_ptr<Slot>, kSlots> slot_;
  std::unique_ptr<GlProgram> choose_;
  std::map<DrawShape, std::unique_ptr<DrawPrograms>> programs_;
  DispatchPacer pacer_;
  // Bounded draws to fetch with the sums, by earlier pieces, so that few need a second fetch.
  std::size_t bounded_expected_ = 1024;
};

}  // namespace gpu
