#include "gpu/raster/gl_target.h"

#include "gpu/opengl/gl_error.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace gpu {
namespace {

GLenum format_of(Layer layer) {
  switch (layer) {
    case Layer::depth:
      return GL_DEPTH_COMPONENT32F;
    case Layer::value:
      return GL_R32F;
    case Layer::colour:
      break;
  }
  return GL_RGBA8;
}

}  // namespace

int GlTarget::largest_side() {
  GLint texture = 0, render = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  GLint viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &render);
  return std::min({texture, render, viewport[0], viewport[1]});
}

GlTarget::GlTarget(std::string what, int width, int height, const std::vector<Layer>& layers)
    : what_(std::move(what)), width_(width), height_(height), layer_(layers) {
  try {
    make(layers);
  } catch (...) {
    release();
    throw;
  }
}

void GlTarget::make(const std::vector<Layer>& layers) {
  glGenFramebuffers(1, &frame_);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  std::vector<GLenum> outputs;
  for (const Layer layer : layers) {
    unsigned name = 0;
    glGenTextures(1, &name);
    texture_.push_back(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, format_of(layer), width_, height_);
    check_gl(fmt::format("making a picture of {} x {} for {}", width_, height_, what_));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const GLenum place = layer == Layer::depth
                             ? GLenum{GL_DEPTH_ATTACHMENT}
                             : GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(outputs.size());
    glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, name, 0);
    if (layer != Layer::depth) outputs.push_back(place);
  }
  if (outputs.empty()) {
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  } else {
    glDrawBuffers(static_cast<GLsizei>(outputs.size()), outputs.data());
  }
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw GlError(fmt::format("the device cannot draw {} ({:#x})", what_, status));
  }
  check_gl("preparing " + what_);
}

GlTarget::~GlTarget() { release(); }

void GlTarget::release() {
  glDeleteFramebuffers(1, &frame_);
  glDeleteTextures(static_cast<GLsizei>(texture_.size()), texture_.data());
}

void GlTarget::draw_into(int width, int height) const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glViewport(0, 0, width, height);
}

void GlTarget::bind_texture(std::size_t layer, unsigned unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture_[layer]);
}

void GlTarget::read(std::size_t layer, int width, int height, std::span<std::byte> to) const {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (to.size() != 4 * pixels) throw GlError("a picture is read into the wrong size");
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  const auto before = layer_.begin() + static_cast<std::ptrdiff_t>(layer);
  const auto outputs = (before - layer_.begin()) - std::count(layer_.begin(), before, Layer::depth);
  glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(outputs));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  const bool is_value = layer_[layer] == Layer::value;
  glReadPixels(0, 0, width, height, is_value ? GL_RED : GL_RGBA,
               is_value ? GL_FLOAT : GL_UNSIGNED_BYTE, to.data());
  check_gl("reading " + what_);
}

}  // namespace gpu
