#pragma once
// Scenes on the device, for shaders that trace rays.

#include "calc/radiosity/sampling/rays.h"
#include "gpu/opengl/gl_buffer.h"

#include <cstdint>
#include <list>

namespace gpu {

// A scene's triangles and the tree over them (bvh.h), for shaders/common/visibility.glsl.
struct DeviceScene {
  std::uint64_t identity;  // calc::Tracer::identity()
  std::uint32_t nodes;
  std::uint32_t most_turns;  // of a ray's loops: it visits all nodes and triangles
  GlBuffer node, triangle;
  GlBuffer surface;  // per triangle of the tree: unit normal and reflectance, four double
  GlBuffer order;    // per triangle of the tree: its index in the scene

  // Binds to bindings 0 and 1.
  void bind() const;
  // Binds the further data of closest hits to bindings 2 and 8: surfaces and triangle numbers.
  void bind_surfaces() const;
};

// The scenes used last. All calls, also the destructor, need the context current in which it lives.
class DeviceScenes {
 public:
  // Returns the scene, valid until the next call. Throws GlError.
  const DeviceScene& of(const calc::Tracer& tracer);
  void clear() { scenes_.clear(); }

 private:
  std::list<DeviceScene> scenes_;  // latest use first
};

}  // namespace gpu
