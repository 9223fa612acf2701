#include "gpu/opengl/gl_fence.h"

#include "calc/radiosity/sampling/phase_timer.h"
#include "gpu/device/egl_context.h"
#include "gpu/opengl/gl_error.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace gpu {
namespace {

constexpr double kSlice_s = 0.1;  // after which it is asked whether the context is lost
// Longer than any of our work takes: a device that is silent for so long is silent for ever.
constexpr double kLongestWait_s = 60.0, kLongestSoftwareWait_s = 600.0, kLongestTestWait_s = 0.3;

double longest_wait_s(const EglContext& context) {
  if (context.fault() == Fault::fence_lost) return kLongestTestWait_s;
  return context.device().is_software ? kLongestSoftwareWait_s : kLongestWait_s;
}

GLsync sync_of(void* sync) { return static_cast<GLsync>(sync); }

}  // namespace

GlFence GlFence::set() {
  GlFence fence;
  fence.sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (fence.sync_ == nullptr) {
    check_gl("marking work of the device");
    throw GlError("the device takes no fence");
  }
  glFlush();
  return fence;
}

GlFence::~GlFence() {
  if (sync_ != nullptr) glDeleteSync(sync_of(sync_));
}

bool GlFence::is_reached() { return poll(0.0); }

bool GlFence::poll(double wait_s) {
  if (sync_ == nullptr) return true;
  if (EglContext::current().fault() == Fault::fence_lost) {
    std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
    return false;
  }
  const GLenum answer = glClientWaitSync(sync_of(sync_), GL_SYNC_FLUSH_COMMANDS_BIT,
                                         static_cast<GLuint64>(1e9 * wait_s));
  if (answer == GL_TIMEOUT_EXPIRED) return false;
  if (answer == GL_WAIT_FAILED) {
    check_gl("waiting for the device");
    throw GlError("the device cannot be waited for");
  }
  glDeleteSync(sync_of(std::exchange(sync_, nullptr)));
  return true;
}

bool GlFence::wait_for(double most_s, const std::string& doing) {
  const double begin_s = calc::now_s();
  if (poll(most_s)) return true;
  const double before_s = waited_s_;
  // No more than was asked for, if the program was stopped meanwhile.
  waited_s_ += std::min(calc::now_s() - begin_s, most_s);
  const EglContext& context = EglContext::current();
  if (std::floor(waited_s_ / kSlice_s) > std::floor(before_s / kSlice_s)) {
    if (const std::string loss = context.loss(); !loss.empty()) throw GlError(loss);
  }
  if (waited_s_ > longest_wait_s(context)) {
    throw GlError(
        fmt::format("the device has not answered for {:.3g} s while {}", waited_s_, doing));
  }
  return false;
}

void GlFence::wait(const std::string& doing) {
  while (!wait_for(kSlice_s, doing)) {
  }
}

}  // namespace gpu
