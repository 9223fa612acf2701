#pragma once
// Calculation points in the layouts of devices, see plane_blocks.h.

#include "calc/radiosity/sampling/rays.h"
#include "calc/radiosity/sampling/tiles.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/scene/plane_blocks.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpu {

// A receiver for the shaders of draws: four uvec4, the first three with vectors of floats.
struct DrawReceiver {
  glm::vec3 position_m;  // local
  std::uint32_t unused0 = 0;
  glm::vec3 axis;
  std::uint32_t unused1 = 0;
  glm::vec3 lifted_m;  // where its rays begin
  std::uint32_t unused2 = 0;
  std::uint32_t tile;    // of its block
  std::uint32_t kernel;  // calc::ReceiverKernel
  // A point's index in its plane, and 0; for a short ray's hit the halves of its shift.
  glm::uvec2 random;
};
static_assert(sizeof(DrawReceiver) == 64);

// A tile for shaders/gather/choose.glsl: three vec4, calc::ReceiverTile.
struct DrawTileView {
  glm::vec3 centre_m;
  float radius_m;
  glm::vec3 axis;
  float softening_m;
  float slack_m, lowest_m;
  float has_axis;  // 1 = yes
  float unused = 0.0f;
};
static_assert(sizeof(DrawTileView) == 48);

// Data for draws.
struct DrawPoints {
  struct Packed {
    std::vector<DrawReceiver> receivers;
    std::vector<DrawTileView> views;
  };
  struct Block {
    GlBuffer receivers{"calculation points", BufferUse::fixed};
    GlBuffer views{"tiles of calculation points", BufferUse::fixed};
  };

  // Packs the tiles from block * kTilesPerBlock on.
  static Packed pack(const calc::Tracer& tracer, const calc::ReceiverTiles& tiles,
                     std::size_t block);
  static void send(const Packed& packed, Block& block);
  static std::size_t bytes(const Block& block);
};

// A receiver for shaders/hits/short_ray_requests.glsl: five uvec4.
struct NearReceiver {
  glm::dvec3 position_m, axis;  // local
  glm::vec3 origin_m;           // of its rays: lifted
  std::uint32_t kernel;         // calc::ReceiverKernel
  std::uint32_t point;          // index in its plane
  std::uint32_t unused[3] = {};
};
static_assert(sizeof(NearReceiver) == 80);

// Data for short rays.
struct NearPoints {
  using Packed = std::vector<NearReceiver>;
  struct Block {
    GlBuffer receivers{"calculation points", BufferUse::fixed};
  };

  static Packed pack(const calc::Tracer& tracer, const calc::ReceiverTiles& tiles,
                     std::size_t block);
  static void send(const Packed& packed, Block& block);
  static std::size_t bytes(const Block& block);
};

}  // namespace gpu
