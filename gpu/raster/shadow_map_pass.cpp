#include "gpu/raster/shadow_map_pass.h"

#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_error.h"
#include "gpu/raster/raster_shaders.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cfloat>
#include <limits>
#include <vector>

namespace gpu {
namespace {

enum Binding : unsigned { kVertices, kReceivers, kResults };

constexpr std::uint32_t kFaces = 5;
constexpr int kWidthInFaces = 3;  // of a map in the atlas
// 64 MiB; one map of 2048 takes 48.
constexpr std::size_t kAtlasTexels = std::size_t{1} << 24;
constexpr std::size_t kMostMaps = 1024;
constexpr std::size_t kFirstMaps = 8;  // of one draw call
constexpr std::size_t kMostResults = std::size_t{1} << 21;
constexpr std::size_t kFewestReceivers = 64;

std::size_t maps_in_atlas(std::uint32_t texels) {
  const std::size_t map = std::size_t{kWidthInFaces} * texels * texels;
  return std::clamp(kAtlasTexels / map, std::size_t{1}, kMostMaps);
}

// As square as it goes, within what the device draws.
std::uint32_t maps_in_row(std::uint32_t texels) {
  const std::uint32_t width = std::min<std::uint32_t>(
      8192, static_cast<std::uint32_t>(std::max(GlTarget::largest_side(), 0)));
  return std::max(1u, width / (kWidthInFaces * texels));
}

}  // namespace

ShadowMapPass::ShadowMapPass(std::uint32_t texels, const ProgramCache& programs)
    : texels_(texels),
      maps_per_row_(maps_in_row(texels)),
      most_maps_(maps_in_atlas(texels)),
      draw_("shadow map", shadow_map_shaders(), programs),
      gather_("shadow gather", shadow_gather_shader(), programs),
      atlas_("shadow maps",
             static_cast<int>(kWidthInFaces * texels *
                              std::min<std::size_t>(maps_per_row_, most_maps_)),
             static_cast<int>(texels * ((most_maps_ + maps_per_row_ - 1) / maps_per_row_)),
             {Layer::depth}),
      vertices_("light vertices"),
      receivers_("calculation points"),
      results_("results", BufferUse::by_device),
      corners_("the scene's corners", BufferUse::fixed),
      triangles_("the scene's triangles", BufferUse::fixed),
      pacer_({1, kMostMaps, kFirstMaps}) {
  glGenVertexArrays(1, &layout_);
}

ShadowMapPass::~ShadowMapPass() { glDeleteVertexArrays(1, &layout_); }

ShadowMapTimes ShadowMapPass::run(DeviceState& device, const ShadowMapJob& job) {
  ShadowMapTimes times;
  upload(job);
  bool goes_on = true;
  for (std::size_t first = 0; goes_on && first < job.vertices.size(); first += most_maps_) {
    const std::size_t count = std::min(most_maps_, job.vertices.size() - first);
    if (job.has_shadows) {
      const calc::PhaseTimer timer(times.maps_s);
      goes_on = render(job, first, count);
    }
    const calc::PhaseTimer timer(times.gather_s);
    goes_on = goes_on && gather(job, first, count);
    device.check("gathering light by shadow maps");
  }
  return times;
}

void ShadowMapPass::upload(const ShadowMapJob& job) {
  if (job.has_shadows) upload_scene(*job.tracer);
  vertices_.assign(job.vertices);
  receivers_.assign(job.receivers);
  check_gl("sending light vertices");
}

void ShadowMapPass::upload_scene(const calc::Tracer& tracer) {
  if (scene_identity_ == tracer.identity()) return;
  scene_identity_ = 0;
  const calc::PreparedScene& scene = tracer.scene();
  corners_.assign(std::span<const glm::vec3>(scene.vertex_m));
  triangles_.assign(std::span<const glm::uvec3>(scene.triangle));
  check_gl("sending the scene");
  indices_ = static_cast<std::uint32_t>(3 * scene.triangle.size());
  depth_unit_m_ = static_cast<float>(1.01 * scene.whole_extent_m());
  scene_identity_ = tracer.identity();
}

// Clears the maps and sets all that is the same for the draw calls of a pass.
void ShadowMapPass::prepare(const ShadowMapJob& job, std::size_t count) {
  atlas_.draw_into();
  glDepthMask(GL_TRUE);
  glClearDepth(1.0);
  // The rows of maps in use: software takes its time for the others.
  const std::size_t rows = (count + maps_per_row_ - 1) / maps_per_row_;
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, atlas_.width(), static_cast<GLsizei>(rows * texels_));
  glClear(GL_DEPTH_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  for (unsigned k = 0; k < kFaces; ++k) glEnable(GL_CLIP_DISTANCE0 + k);
  draw_.use();
  draw_.set("maps_per_row", maps_per_row_);
  draw_.set("map_texels", texels_);
  draw_.set("atlas_width", static_cast<float>(atlas_.width()));
  draw_.set("atlas_height", static_cast<float>(atlas_.height()));
  draw_.set("near_m", static_cast<float>(job.tracer->offset_m()));
  draw_.set("depth_unit_m", depth_unit_m_);
  glBindVertexArray(layout_);
  glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  for (unsigned k = 0; k < 3; ++k) glEnableVertexAttribArray(k);
  for (unsigned k = 1; k < 3; ++k) glVertexAttribDivisor(k, kFaces);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.name());
}

bool ShadowMapPass::render(const ShadowMapJob& job, std::size_t first, std::size_t count) {
  prepare(job, count);
  bool is_whole = true;
  for (std::size_t map = 0; indices_ > 0 && map < count;) {
    is_whole = !calc::is_past(job.deadline_s);
    if (!is_whole) break;
    const std::size_t maps = std::min(pacer_.items(), count - map);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    for (unsigned k = 0; k < 2; ++k) {  // position and normal of calc::LightVertex
      glVertexAttribPointer(
          1 + k, 3, GL_FLOAT, GL_FALSE, sizeof(calc::LightVertex),
          reinterpret_cast<const void*>((first + map) * sizeof(calc::LightVertex) + 16 * k));
    }
    draw_.set("first_map", static_cast<std::uint32_t>(map));
    pacer_.run(maps, "drawing shadow maps", [&] {
      glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(indices_), GL_UNSIGNED_INT,
                              nullptr, static_cast<GLsizei>(kFaces * maps));
    });
    map += maps;
  }
  for (unsigned k = 0; k < kFaces; ++k) glDisable(GL_CLIP_DISTANCE0 + k);
  glBindVertexArray(0);
  check_gl("drawing shadow maps");
  return is_whole;
}

bool ShadowMapPass::gather(const ShadowMapJob& job, std::size_t first, std::size_t count) {
  gather_.use();
  gather_.set("maps_per_row", maps_per_row_);
  gather_.set("map_texels", texels_);
  gather_.set("most_per_m2", std::min(job.most_per_m2, FLT_MAX));
  gather_.set("offset_m", static_cast<float>(job.tracer->offset_m()));
  gather_.set("depth_unit_m", depth_unit_m_);
  gather_.set("has_shadows", job.has_shadows ? 1u : 0u);
  gather_.set("first_vertex", static_cast<std::uint32_t>(first));
  atlas_.bind_texture(0, 0);
  vertices_.bind(kVertices);
  receivers_.bind(kReceivers);
  const std::size_t most = std::max(kFewestReceivers, kMostResults / count);
  std::vector<std::uint32_t> results;
  for (std::size_t begin = 0; begin < job.receivers.size(); begin += most) {
    if (calc::is_past(job.deadline_s)) return false;
    const std::size_t receivers = std::min(most, job.receivers.size() - begin);
    results.assign(count * receivers, kNotDone);
    results_.assign(results.size() * sizeof(std::uint32_t), kNotDone);
    results_.bind(kResults);
    gather_.set("first_receiver", static_cast<std::uint32_t>(begin));
    gather_.set("receiver_count", static_cast<std::uint32_t>(receivers));
    glDispatchCompute(static_cast<GLuint>((receivers + kGroupSize - 1) / kGroupSize),
                      static_cast<GLuint>(count), 1);
    results_.read(0, std::as_writable_bytes(std::span(results)));
    check_gl("reading shadow maps");
    job.take(first, begin, receivers, results);
  }
  return true;
}

}  // namespace gpu
