#pragma once
// Finds out why OpenGL finds no hardware on a machine that has some, and what to do about it.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace gpu {

// The source of facts: this machine, or a tree that a test made.
struct MachineView {
  std::filesystem::path root = "/";
  std::function<std::string(std::string_view variable)> environment;  // "" = not set
  std::function<bool(const std::filesystem::path&)> can_open;         // for reading and writing
};
MachineView this_machine();

// The driver of a maker as libglvnd finds it. [libglvnd, EGL ICD enumeration]
struct EglVendor {
  bool has_library = false;  // libEGL_nvidia.so.0 or libEGL_mesa.so.0
  bool has_file = false;     // the JSON file that names it, where EGL looks
};

struct DeviceFacts {
  // PCI display controllers of makers of GPUs; those of virtual machines do not count.
  bool has_nvidia_gpu = false, has_other_gpu = false;
  bool has_graphics_node = false;     // without one EGL could find nothing but software
  bool is_nvidia_loaded = false;      // its kernel module
  bool has_nvidia_nodes = false;      // /dev/nvidia0 or /dev/nvidiactl
  bool has_render_nodes = false;      // /dev/dri/renderD*
  std::vector<std::string> no_entry;  // of the nodes that matter: those that cannot be opened
  EglVendor nvidia, mesa;
  std::string vendor_variable;  // the variable that tells EGL where to look; "" = its own places
  bool is_partitioned = false;  // MIG: every GPU that is seen
  bool is_container = false;
  std::string driver_capabilities;  // NVIDIA_DRIVER_CAPABILITIES; "" = not set
};
DeviceFacts read_device_facts(const MachineView& machine);

enum class MissingDevice {
  no_gpu,   // nothing says that there is one
  unknown,  // there is one, and nothing that is looked at is wrong
  partitioned,
  not_handed_in,  // its driver runs, but there is no way to it
  no_driver,
  no_permission,
  no_graphics_capability,  // a container without the driver's OpenGL
  no_library,
  no_vendor_file,
  vendor_file_elsewhere,
};
// Returns the first reason that must be fixed.
MissingDevice why_missing(const DeviceFacts& facts);

// Returns the reason and what to do, in words; "" if it is no_gpu or unknown.
std::string missing_device_advice(const DeviceFacts& facts);

// Returns why EGL knows no device at all, not even software.
std::string no_egl_device_reason(const DeviceFacts& facts);

}  // namespace gpu
