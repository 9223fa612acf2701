#pragma once
// Light at the hits of short rays on the device: the first step of every chain of
// calc::add_near_field(). For the thread that owns the context.

#include "calc/radiosity/near_field.h"
#include "gpu/device_thread.h"
#include "gpu/dispatch_pacer.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_program.h"
#include "gpu/gl_read_back.h"
#include "gpu/gl_short_rays.h"
#include "gpu/lent_bytes.h"
#include "gpu/short_ray_pass.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace gpu {

// Rays that met what may give light are listed in their order, and light is found for a piece of
// the list at a time:
//   list    [hit] two words: the request, and which of its rays
//   places  [hit of the piece] four uvec4: position, normal, weight, key, see hit_places.glsl
//   lights  [hit of the piece] a calc::HitLight
// For their draws from afar hits are receivers of the tile that has all nodes of the field's cut;
// those that nothing is to be found for, of one that has none.
//
// Buffers of one call, on its way through the three steps below; what calls share is written and
// read in the order of commands.
struct HitBuffers {
  // Some of the list.
  struct Piece {
    GlBuffer lights{"light at hits of short rays", BufferUse::by_device};
    GlReadBack back{"light at hits of short rays"};
    std::size_t hits = 0;
  };

  ShortRayBuffers rays;
  GlBuffer field{"the near field"}, tiles{"groups of light vertices"};
  GlBuffer counts{"numbers of hits", BufferUse::by_device};
  GlBuffer list{"list of hits", BufferUse::by_device};
  GlReadBack counts_back{"numbers of hits"};
  std::deque<Piece> pieces;  // some of them perhaps of an earlier call
  std::size_t used = 0;      // of these
};

class HitPass {
 public:
  HitPass(const ProgramCache& programs, const HitLimits& limits);  // programs must outlive it

  // Three steps, between which other work may run, so that the device has work while a caller waits
  // for what came back. Each throws GlError and calc::BackendFailure.

  // Starts the rays, and counts those that met what may give light. False: the deadline passed.
  bool start(DeviceState& device, ShortRayPass& rays, const calc::NearField& field,
             const ShortRayJob& job, HitBuffers& buffers);
  // Waits for the counts, lists the hits and starts to find the light there. packed: as
  // DevicePools::find_or_send() takes it. False: the deadline passed.
  bool find(DeviceState& device, const ShortRayPass& rays, const calc::NearField& field,
            const PackedPool* packed, const ShortRayJob& job, HitBuffers& buffers);
  // Waits for it: calc::HitLight in the order of rays, some behind others.
  std::vector<LentBytes> take(DeviceState& device, HitBuffers& buffers);

 private:
  // A stage with one invocation for each hit, or for some of each.
  struct Stage {
    GlProgram program;
    DispatchPacer pacer;

    Stage(const std::string& what, const std::string& source, const ProgramCache& programs);
  };
  // Some of the listed hits.
  struct Piece {
    const calc::NearField& field;
    const ShortRayJob& job;
    const ShortRayPass& rays;
    const HitBuffers& buffers;
    std::size_t first, count;
  };

  void send_luminaires(const calc::NearField& field);
  void over_blocks(DeviceState& device, const GlProgram& program, const ShortRayPass& rays,
                   const ShortRayJob& job, const HitBuffers& buffers) const;
  std::size_t list_hits(DeviceState& device, const ShortRayPass& rays, const ShortRayJob& job,
                        HitBuffers& buffers);
  std::size_t most_hits(const calc::NearField& field) const;
  bool find(DeviceState& device, const PackedPool* packed, const Piece& piece,
            HitBuffers::Piece& found);
  void weigh(DeviceState& device, const PackedPool* packed, const Piece& piece);
  void start(const GlProgram& program, const Piece& piece) const;
  bool run_stage(Stage& stage, const Piece& piece, std::size_t items);

  const ProgramCache& programs_;
  const HitLimits limits_;
  GlProgram counts_shader_, list_shader_;
  Stage bounds_, direct_, further_, far_;
  GlProgram weigh_;
  std::array<std::unique_ptr<GlProgram>, 2> share_;  // [many channels], made when first needed
  GlBuffer tables_, choice_, firsts_, places_, receivers_;
  GlBuffer channel_weights_, weights_, cumulated_, spacings_;
  std::uint32_t nodes_ = 0;      // of the scene at hand
  std::uint64_t tables_of_ = 0;  // identity of a tracer; 0 = none
};

}  // namespace gpu
