#pragma once
// OpenGL without a window or display. egl_context.cpp is the only file that knows EGL.

#include "gpu/device.h"

#include <memory>
#include <string>

namespace gpu {

// What tests let fail, because a working machine does not.
enum class Fault { none, no_egl, out_of_memory, context_lost };

// Opens every device that EGL knows, one after the other: a tenth of a second or more.
DeviceList list_devices(Fault fault = Fault::none);

// As list_devices(), but quick where there is no hardware: EGL is not even asked if the machine has
// no graphics device, and devices that EGL itself calls software are not opened.
DeviceList list_hardware(Fault fault = Fault::none);

// For a context that turned out to be software, though hardware was wanted: DeviceList::advice.
std::string missing_hardware_advice(Fault fault);

struct EglHandles;

// A context of one device, current on the thread that opened it until it is destroyed there.
class EglContext {
 public:
  // index: as in list_devices(), -1 = preferred_device(). Null: `problem` says why, in words.
  static std::unique_ptr<EglContext> open(int index, Fault fault, std::string& problem);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  const Device& device() const { return device_; }
  // GL_OUT_OF_MEMORY and the like are told by glGetError(); this is what it does not tell: "" or
  // why the context is gone for good.
  std::string loss() const;

 private:
  EglContext(std::unique_ptr<EglHandles> handles, Device device);

  std::unique_ptr<EglHandles> handles_;
  Device device_;
};

}  // namespace gpu
