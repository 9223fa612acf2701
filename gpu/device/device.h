#pragma once
// Lists OpenGL devices, to show and to choose from.

#include <string>
#include <vector>

namespace gpu {

// The first version with compute shaders.
inline constexpr int kLeastMajor = 4, kLeastMinor = 3;

// Device::problem of devices that list_hardware() does not open.
inline constexpr const char* kNotOpened = "not opened: software";

struct Device {
  int index = 0;                          // as --gl-device names it
  std::string renderer, vendor, version;  // "" if it gives no context at all
  bool is_software = false;               // llvmpipe, softpipe, swrast: the CPU under another name
  std::string problem;                    // "" = it runs compute shaders, else why not

  bool is_usable() const { return problem.empty(); }
  // Returns "llvmpipe (...), OpenGL 4.5".
  std::string name() const;
  // Returns a key that distinguishes drivers, for data kept about them.
  std::string driver_key() const { return vendor + "\n" + renderer + "\n" + version; }
};

struct DeviceList {
  std::vector<Device> devices;  // in EGL's order, but what EGL itself calls software last
  std::string problem;          // why there is none, "" if there are any
  // Why none of them is hardware, though the machine has some, and what to do; else "".
  std::string advice = {};
};

// Instead of an index: the first device that is software, if there is any, else as by -1.
inline constexpr int kPreferSoftware = -2;

// Returns whether GL_RENDERER names software.
bool is_software_renderer(const std::string& renderer);

// Returns the first usable device of a list: hardware if there is any. -1 = none.
int preferred_device(const DeviceList& list);

// Returns the first usable device that is not software; -1 = none.
int hardware_device(const DeviceList& list);

// Returns the first software device, usable or not opened by list_hardware(); -1 = none.
int software_device(const DeviceList& list);

// Returns for messages why none of them is usable.
std::string why_none_is_usable(const DeviceList& list);

}  // namespace gpu
