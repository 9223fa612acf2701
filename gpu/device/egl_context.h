#pragma once
// OpenGL without a window or display. egl_context.cpp is the only file that knows EGL.

#include "gpu/device/device.h"
#include "gpu/device/driver_messages.h"

#include <memory>
#include <string>

namespace gpu {

// What tests let fail, because a working machine does not.
enum class Fault {
  none,
  no_egl,
  out_of_memory,
  context_lost,
  fence_lost,        // the device never says that it is done
  results_lost,      // of each buffer only the first results come back
  no_buffer_storage  // no failure: the driver is older than OpenGL 4.4
};

// Opens every device that EGL knows, one after the other: a tenth of a second or more.
DeviceList list_devices(Fault fault = Fault::none);

// Whether EGL is worth asking for hardware; quick.
bool may_have_hardware();

// As list_devices(), but quick where there is no hardware: EGL is not even asked if the machine has
// no graphics device, and devices that EGL itself calls software are not opened.
DeviceList list_hardware(Fault fault = Fault::none);

// For a context that turned out to be software, though hardware was wanted: DeviceList::advice.
std::string missing_hardware_advice(Fault fault);

struct EglHandles;

// A context of one device, current on the thread that opened it until it is destroyed there.
class EglContext {
 public:
  // index: as in list_devices(), -1 = preferred_device(), or kPreferSoftware. Null: `problem` says
  // why, in words. messages: what the driver says goes there, which may cost time; null = it is not
  // asked.
  static std::unique_ptr<EglContext> open(int index, Fault fault, std::string& problem,
                                          DriverMessages* messages = nullptr);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  // The one that is current on the calling thread, as OpenGL's own calls take it.
  static const EglContext& current();

  const Device& device() const { return device_; }
  Fault fault() const { return fault_; }
  DriverMessages* messages() const { return messages_; }
  // Buffers whose place the driver may choose once and for all, and that can stay mapped.
  bool has_buffer_storage() const { return has_buffer_storage_; }
  // GL_OUT_OF_MEMORY and the like are told by glGetError(); this is what it does not tell: "" or
  // why the context is gone for good.
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
