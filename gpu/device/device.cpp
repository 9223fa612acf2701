#include "gpu/device/device.h"

#include <fmt/format.h>

#include <algorithm>

namespace gpu {

std::string Device::name() const {
  return fmt::format("{}, OpenGL {}", renderer, version.substr(0, version.find(' ')));
}

int hardware_device(const DeviceList& list) {
  for (const Device& device : list.devices) {
    if (device.is_usable() && !device.is_software) return device.index;
  }
  return -1;
}

int software_device(const DeviceList& list) {
  for (const Device& device : list.devices) {
    const bool may_work = device.is_usable() || device.problem == kNotOpened;
    if (device.is_software && may_work) return device.index;
  }
  return -1;
}

int preferred_device(const DeviceList& list) {
  if (const int hardware = hardware_device(list); hardware >= 0) return hardware;
  for (const Device& device : list.devices) {
    if (device.is_usable()) return device.index;
  }
  return -1;
}

std::string why_none_is_usable(const DeviceList& list) {
  std::string text = "no OpenGL device can be used";
  for (const Device& device : list.devices) {
    text += fmt::format("; device {}: {}", device.index, device.problem);
  }
  if (!list.advice.empty()) text += "; " + list.advice;
  return text;
}

bool is_software_renderer(const std::string& renderer) {
  std::string lower = renderer;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  for (const char* name :
       {"llvmpipe", "softpipe", "swrast", "software rasterizer", "swiftshader"}) {
    if (lower.find(name) != std::string::npos) return true;
  }
  return false;
}

}  // namespace gpu
