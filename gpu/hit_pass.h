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
#include "gpu/short_ray_pass.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
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
class HitPass {
 public:
  HitPass(const ProgramCache& programs, const HitLimits& limits);  // programs must outlive it

  // The rays of some requests and the light at their hits, in the order of rays, in place of what
  // `found` has behind the first `keep`: room that need not be made here. packed: as
  // DevicePools::find_or_send() takes it. Nothing once the deadline passed. Throws GlError and
  // calc::BackendFailure.
  void run(DeviceState& device, ShortRayPass& rays, const calc::NearField& field,
           const PackedPool* packed, const ShortRayJob& job, std::size_t keep,
           std::vector<calc::HitLight>& found);

 private:
  struct Slot {
    GlBuffer lights{"light at hits of short rays", BufferUse::by_device};
    GlReadBack back{"light at hits of short rays"};
    std::span<calc::HitLight> to{};  // empty: nothing is on its way
  };
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
    std::size_t first, count;
  };

  void send(const calc::NearField& field);
  void send_luminaires(const calc::NearField& field);
  std::size_t list_hits(const ShortRayPass& rays, const ShortRayJob& job);
  std::size_t most_hits(const calc::NearField& field) const;
  bool find(DeviceState& device, const ShortRayPass& rays, const PackedPool* packed,
            const Piece& piece, Slot& slot);
  void weigh(DeviceState& device, const PackedPool* packed, const Piece& piece);
  void start(const GlProgram& program, const Piece& piece) const;
  bool run_stage(Stage& stage, const Piece& piece, std::size_t items);
  static void take(Slot& slot);

  const ProgramCache& programs_;
  const HitLimits limits_;
  GlProgram counts_shader_, list_shader_;
  Stage bounds_, direct_, further_, far_;
  GlProgram weigh_;
  std::array<std::unique_ptr<GlProgram>, 2> share_;  // [many channels], made when first needed
  GlBuffer field_, tables_, choice_, tiles_, counts_, firsts_, list_, places_, receivers_;
  GlBuffer channel_weights_, weights_, cumulated_, spacings_;
  GlReadBack counts_back_;
  std::array<Slot, 2> slot_;     // so that the device has the next piece while one comes back
  std::uint32_t nodes_ = 0;      // of the scene at hand
  std::uint64_t tables_of_ = 0;  // identity of a tracer; 0 = none
};

}  // namespace gpu
