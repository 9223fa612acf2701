#pragma once
// Traces first short rays of some points on the device. For the thread that owns the context.

#include "calc/radiosity/sampling/short_rays.h"
#include "gpu/device/device_thread.h"
#include "gpu/device/dispatch_pacer.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "gpu/scene/device_points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gpu {

// A point in the layout of shaders/hits/short_ray_requests.glsl.
struct ShortRayRequest {
  std::uint32_t receiver;   // of its block, see plane_blocks.h
  std::uint32_t first_ray;  // rays are numbered one after the other
};

// Points of a batch in one block.
struct ShortRayPart {
  std::size_t block = 0;
  std::vector<ShortRayRequest> requests{};  // and one behind the last, where its rays end

  std::size_t points() const { return requests.size() - 1; }
  std::size_t rays() const { return requests.back().first_ray; }
  std::uint32_t most_rays() const;  // of a point
};
// Returns the parts of a batch. most_points: of a part.
std::vector<ShortRayPart> parts_of(const calc::NearFieldBatch& batch, std::size_t most_points);

struct ShortRayJob {
  const calc::Tracer& tracer;
  float least_m, most_m;
  const calc::NearFieldBatch& batch;
  const ShortRayPart& part;
  const NearPoints::Packed* packed;  // null if the device is thought to hold the block
  bool has_light = false;            // for HitPass
  double deadline_s = 0.0;           // see calc::is_past()
};

// Rays of one call, from their start until the work at their hits is done.
struct ShortRayBuffers {
  GlBuffer requests{"calculation points"};
  // The hits of the rays, kNotDone before: calc::FirstHit; has_light: as short_ray_shader() says.
  GlBuffer hits{"hits of short rays", BufferUse::by_device};
};

class ShortRayPass {
 public:
  explicit ShortRayPass(const ProgramCache& programs);  // must outlive it

  // Bindings shared with later stages; others are those of DeviceScene.
  enum Binding : unsigned { kWords = 4, kHits = 6, kRequests = 9, kField, kPoints = 15 };

  // Sends the points and starts their rays; has_light: with the field's numbers bound. Returns
  // false after the deadline. Throws GlError.
  bool trace(DeviceState& device, const ShortRayJob& job, ShortRayBuffers& buffers);
  void bind(DeviceState& device, const ShortRayJob& job, const ShortRayBuffers& buffers) const;
  // Sets the keys of a program that reads points and their rays.
  static void set_keys(const GlProgram& program, const ShortRayJob& job);

 private:
  const GlProgram& program(bool has_light);

  const ProgramCache& programs_;
  std::array<std::unique_ptr<GlProgram>, 2> program_;  // [has_light], made when first needed
  GlBuffer words_;
  DispatchPacer pacer_;
};

}  // namespace gpu
