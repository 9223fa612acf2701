#include "gpu/scene/device_scene.h"

#include "gpu/opengl/gl_error.h"
#include "gpu/scene/bvh.h"

#include <algorithm>
#include <span>
#include <vector>

namespace gpu {
namespace {

// A space at a time is computed; its neighbour may still be in use.
constexpr std::size_t kMostScenes = 2;

std::vector<glm::dvec4> surfaces_of(const calc::Tracer& tracer, const Bvh& bvh) {
  std::vector<glm::dvec4> surfaces;
  surfaces.reserve(bvh.order.size());
  for (const std::uint32_t triangle : bvh.order) {
    surfaces.emplace_back(tracer.triangle_normal(triangle), tracer.scene().reflectance[triangle]);
  }
  return surfaces;
}

}  // namespace

void DeviceScene::bind() const {
  node.bind(0);
  triangle.bind(1);
}

void DeviceScene::bind_surfaces() const {
  surface.bind(2);
  order.bind(8);
}

const DeviceScene& DeviceScenes::of(const calc::Tracer& tracer) {
  const auto found = std::find_if(scenes_.begin(), scenes_.end(), [&](const DeviceScene& scene) {
    return scene.identity == tracer.identity();
  });
  if (found != scenes_.end()) {
    scenes_.splice(scenes_.begin(), scenes_, found);
    return scenes_.front();
  }
  while (scenes_.size() >= kMostScenes) scenes_.pop_back();
  const Bvh bvh = build_bvh(tracer.scene());
  DeviceScene scene{tracer.identity(),
                    static_cast<std::uint32_t>(bvh.nodes.size()),
                    static_cast<std::uint32_t>(bvh.nodes.size() + bvh.triangles.size()),
                    GlBuffer("the scene's boxes", BufferUse::fixed),
                    GlBuffer("the scene's triangles", BufferUse::fixed),
                    GlBuffer("the scene's surfaces", BufferUse::fixed),
                    GlBuffer("the scene's triangle numbers", BufferUse::fixed)};
  scene.node.assign(bvh.nodes);
  scene.triangle.assign(bvh.triangles);
  scene.surface.assign(surfaces_of(tracer, bvh));
  scene.order.assign(bvh.order);
  check_gl("sending the scene");
  scenes_.push_front(std::move(scene));
  return scenes_.front();
}

}  // namespace gpu
