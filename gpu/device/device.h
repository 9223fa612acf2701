#pragma once
// OpenGL devices as a list to show and to choose from.

#include <string>
#include <vector>

namespace gpu {

// Compute shaders came with this version.
inline constexpr int kLeastMajor = 4, kLeastMinor = 3;

// Device::problem of what list_hardware() leaves closed.
inline constexpr const char* kNotOpened = "not opened: software";

struct Device {
  int index = 0;                          // as --gl-device names it
  std::string renderer, vendor, version;  // "" if it gives no context at all
  bool is_software = false;               // llvmpipe, softpipe, swrast: the CPU under another name
  std::string problem;                    // "" = it runs compute shaders, else why not

  bool is_usable() const { return problem.empty(); }
  // "llvmpipe (...), OpenGL 4.5"
  std::string name() const;
  // What tells drivers apart, for what is kept of them.
  std::string driver_key() const { return vendor + "\n" + renderer + "\n" + version; }
};

struct DeviceList {
  std::vector<Device> devices;  // in EGL's order, but what EGL itself calls software last
  std::string problem;          // why there is none, "" if there are any
  // Why none of them is hardware, though the machine has some, and what to do; else "".
  std::string advice = {};
};

// In place of an index: the first device that is software, if there is any, else as by -1.
inline constexpr int kPreferSoftware = -2;

// By GL_RENDERER.
bool is_software_renderer(const std::string& renderer);

// The first usable device of a list: hardware if there is any. -1 = none.
int preferred_device(const DeviceList& list);

// The first usable device that is not software; -1 = none.
int hardware_device(const DeviceList& list);

// The first software device that can be used, or that list_hardware() left closed; -1 = none.
int software_device(const DeviceList& list);

// For messages: why none of them is usable.
std::string why_none_is_usable(const DeviceList& list);

}  // namespace gpu
