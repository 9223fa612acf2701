#pragma once
// OpenGL without a window or display. Only egl_context.cpp uses EGL.

#include "gpu/device/device.h"
#include "gpu/device/driver_messages.h"

#include <memory>
#include <string>

namespace gpu {

// Failures for tests, because a working machine does not have them.
enum class Fault {
  none,
  no_egl,
  out_of_memory,
  context_lost,
  fence_lost,        // the device never says that it is done
  results_lost,      // of each buffer only the first results come back
  no_buffer_storage  // no failure: the driver is older than OpenGL 4.4
};

// Returns every device that EGL knows and opens each: a tenth of a second or more.
DeviceList list_devices(Fault fault = Fault::none);

// Returns whether EGL may find hardware; quick.
bool may_have_hardware();

// Does the same, but quick where there is no hardware: it does not use EGL if the machine has no
// graphics device, and does not open devices that EGL itself calls software.
DeviceList list_hardware(Fault fault = Fault::none);

// Returns DeviceList::advice for a context that is software, though hardware was wanted.
std::string missing_hardware_advice(Fault fault);

struct EglHandles;

// A context of one device, current on the thread that opened it until it is destroyed there.
class EglContext {
 public:
  // Opens a context. index: as in list_devices(), -1 = preferred_device(), or kPreferSoftware.
  // Null: `problem` says why, in words. messages: receives the driver's messages, which may cost
  // time; null = none are requested.
  static std::unique_ptr<EglContext> open(int index, Fault fault, std::string& problem,
                                          DriverMessages* messages = nullptr);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  // Returns the context that is current on the calling thread, as for OpenGL's own calls.
  static const EglContext& current();

  const Device& device() const { return device_; }
  Fault fault() const { return fault_; }
  DriverMessages* messages() const { return messages_; }
  // Returns whether there are buffers of fixed placement that can stay mapped.
  bool has_buffer_storage() const { return has_buffer_storage_; }
  // Returns why the context is lost, or "". glGetError() reports other errors, such as
  // GL_OUT_OF_MEMORY.
  std::string loss() const;

 private:
  EglContext(std::unique_ptr<EglHandles> handles, Device device, Fault fault,
             DriverMessages* messages);

  std::unique_ptr<EglHandles> handles_;
  Device device_;
  Fault fault_;
  DriverMessages* messages_;
  bool has_buffer_storage_;
};

}  // namespace gpu
