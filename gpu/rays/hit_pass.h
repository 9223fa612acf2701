#pragma once
// Computes the light at the hits of short rays on the device: the first steps of every chain of
// calc::add_near_field(), and their sums. For the thread that owns the context.

#include "calc/radiosity/paths/near_field.h"
#include "gpu/device/device_thread.h"
#include "gpu/device/dispatch_pacer.h"
#include "gpu/opengl/borrowed_bytes.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/opengl/gl_read_back.h"
#include "gpu/rays/gl_short_rays.h"
#include "gpu/rays/hit_answer.h"
#include "gpu/rays/short_ray_pass.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gpu {

// Rays that met a surface that may give light are listed in their order, and light is found for a
// piece of the list at a time:
//   list    [hit] two words: the request, and which of its rays
//   lights  [step][hit of the piece] a calc::HitLight; in later steps of continued chains
//   links   [step][hit of the piece] the chain's row of lights in the next step
//   chains  where the next step's places are, see hit_further.glsl
//   places  [place of the step] four uvec4: position, normal, weight, key, see hit_places.glsl
//   near    draws whose vertex is so near that its own bound is needed, see hit_far.glsl
//   ends    [hit of the piece] of the whole chain: fate, rays, light; portions: that by channels
//   answers [request] a HitAnswer and its channels
//   left    calc::HitLight of rays that the CPU has to finish, in any order
// For their draws from afar places are receivers of the tile with all nodes of the field's cut;
// places without further light are receivers of a tile with none.
//
// Buffers of one call, on its way through the three steps below; shared data is written and read in
// the order of commands.
struct HitBuffers {
  // A part of the list.
  struct Piece {
    GlBuffer left{"what is left of short rays", BufferUse::by_device};
    GlBuffer left_count{"number of short rays that are left", BufferUse::by_device};
    GlReadBack back{"what is left of short rays"}, rest{"more that is left of short rays"};
    std::size_t hits = 0, expected = 0;  // expected: come back with the count
  };

  ShortRayBuffers rays;
  GlBuffer field{"the near field"}, tiles{"groups of light vertices"};
  GlBuffer counts{"numbers of hits", BufferUse::by_device};
  GlBuffer list{"list of hits", BufferUse::by_device};
  GlBuffer answers{"light of short rays", BufferUse::by_device};
  GlReadBack counts_back{"numbers of hits"}, answers_back{"light of short rays"};
  std::size_t hits = 0;
  std::deque<Piece> pieces;  // some of them perhaps of an earlier call
  std::size_t used = 0;      // of these
};

// The results of a call.
struct HitAnswers {
  // Some calc::HitLight, in any order.
  struct Left {
    BorrowedBytes
        bytes;  // all that came back with them: what is lent in parts is not ready for more
    std::size_t first_byte, count;

    std::span<const std::byte> lights() const {
      return bytes.bytes().subspan(first_byte, count * sizeof(calc::HitLight));
    }
  };

  std::size_t hits = 0;    // 0: nothing else
  BorrowedBytes requests;  // [request] a HitAnswer, and a double for each channel
  std::vector<Left> left;
};

class HitPass {
 public:
  HitPass(const ProgramCache& programs, const HitLimits& limits);  // programs must outlive it

  // Three steps, between which other work may run, so that the device has work while a caller waits
  // for results. Each throws GlError and calc::BackendFailure.

  // Starts the rays, and counts those that met what may give light. False: the deadline passed.
  bool start(DeviceState& device, ShortRayPass& rays, const calc::NearField& field,
             const ShortRayJob& job, HitBuffers& buffers);
  // Waits for the counts, lists the hits and starts to find the light there. packed: as in
  // DevicePools::find_or_send(). False: the deadline passed.
  bool find(DeviceState& device, const ShortRayPass& rays, const calc::NearField& field,
            const PackedPool* packed, const ShortRayJob& job, HitBuffers& buffers);
  // Waits for the light and returns it.
  HitAnswers take(DeviceState& device, const calc::NearField& field, const ShortRayJob& job,
                  HitBuffers& buffers);

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
    const PackedPool* packed;
    const ShortRayJob& job;
    const ShortRayPass& rays;
    HitBuffers& buffers;
    std::size_t first, count;
    std::uint32_t depth = 0;  // the step of its chains
  };

  void send_luminaires(const calc::NearField& field);
  void over_blocks(DeviceState& device, const GlProgram& program, const ShortRayPass& rays,
                   const ShortRayJob& job, const HitBuffers& buffers) const;
  std::size_t list_hits(DeviceState& device, const ShortRayPass& rays, const ShortRayJob& job,
                        HitBuffers& buffers);
  std::size_t most_hits(const DeviceState& device, const calc::NearField& field,
                        const ShortRayJob& job) const;
  bool find(DeviceState& device, Piece piece, HitBuffers::Piece& found);
  void prepare(const Piece& piece, HitBuffers::Piece& found);
  void bind(DeviceState& device, const Piece& piece) const;
  void write_sizes(const Piece& piece) const;
  bool do_step(DeviceState& device, const Piece& piece);
  bool draw(DeviceState& device, const Piece& piece);
  void start_near(const Piece& piece);
  bool bound_near(DeviceState& device, const Piece& piece) const;
  void add_up(const Piece& piece, const HitBuffers::Piece& found) const;
  void start(const GlProgram& program, const Piece& piece) const;
  bool run_stage(Stage& stage, const Piece& piece, std::size_t items, std::uint32_t size);
  void run_rows(const GlProgram& program, const Piece& piece, std::size_t groups,
                std::uint32_t size) const;

  const ProgramCache& programs_;
  const HitLimits limits_;
  GlProgram counts_shader_, list_shader_, sizes_shader_, near_shader_, ends_shader_, sums_shader_;
  Stage bounds_, later_bounds_, direct_, further_, far_;
  GlProgram weigh_;
  std::array<std::unique_ptr<GlProgram>, 2> share_;  // [many channels], made when first needed
  GlBuffer tables_, choice_, firsts_, lights_, links_, chains_, sizes_, near_, ends_, portions_,
      places_, receivers_;
  GlBuffer channel_weights_, weights_, cumulated_, spacings_;
  std::uint32_t nodes_ = 0;      // of the scene at hand
  std::uint64_t tables_of_ = 0;  // identity of a tracer; 0 = none
};

}  // namespace gpu
