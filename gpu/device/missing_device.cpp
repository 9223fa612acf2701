#include "gpu/device/missing_device.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace gpu {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVendorFiles = "__EGL_VENDOR_LIBRARY_FILENAMES";
constexpr const char* kVendorFolders = "__EGL_VENDOR_LIBRARY_DIRS";

fs::path under(const MachineView& machine, const fs::path& path) {
  return machine.root / path.relative_path();
}

bool exists(const MachineView& machine, const fs::path& path) {
  std::error_code error;
  return fs::exists(under(machine, path), error);
}

// Names in a folder, sorted; none if it cannot be read.
std::vector<std::string> names_in(const MachineView& machine, const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  fs::directory_iterator it(under(machine, folder), error);
  for (; !error && it != fs::directory_iterator(); it.increment(error)) {
    names.push_back(it->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// A small file, or its beginning.
std::string text_of(const MachineView& machine, const fs::path& path) {
  constexpr std::size_t kMostBytes = 65536;
  std::ifstream file(under(machine, path), std::ios::binary);
  std::string text(kMostBytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
  return text;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    if (end > begin) parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

bool is_number(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// The number behind a prefix, "" if the name is no such.
std::string number_after(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || !is_number(name.substr(prefix.size()))) return "";
  return std::string(name.substr(prefix.size()));
}

void read_pci(const MachineView& machine, DeviceFacts& facts) {
  const fs::path devices = "/sys/bus/pci/devices";
  for (const std::string& name : names_in(machine, devices)) {
    if (!text_of(machine, devices / name / "class").starts_with("0x03")) continue;  // display
    const std::string maker = text_of(machine, devices / name / "vendor").substr(0, 6);
    facts.has_nvidia_gpu = facts.has_nvidia_gpu || maker == "0x10de";
    facts.has_other_gpu = facts.has_other_gpu || maker == "0x1002" || maker == "0x8086";
  }
}

// By name: a sandbox may let devices be opened and yet not let /dev be listed.
std::vector<std::string> nvidia_numbers(const MachineView& machine) {
  constexpr int kMostGpus = 32;  // of one machine [MIG, Device Nodes and Capabilities]
  std::vector<std::string> numbers;
  for (int k = 0; k < kMostGpus; ++k) {
    const std::string number = std::to_string(k);
    if (exists(machine, "/dev/nvidia" + number)) numbers.push_back(number);
  }
  return numbers;
}

void read_nodes(const MachineView& machine, DeviceFacts& facts) {
  std::vector<std::string> nvidia, render;
  if (exists(machine, "/dev/nvidiactl")) nvidia.emplace_back("nvidiactl");
  for (const std::string& number : nvidia_numbers(machine)) nvidia.push_back("nvidia" + number);
  for (const std::string& name : names_in(machine, "/dev/dri")) {
    if (!number_after(name, "renderD").empty()) render.push_back("dri/" + name);
  }
  facts.has_nvidia_nodes = !nvidia.empty();
  facts.has_render_nodes = !render.empty();
  facts.has_graphics_node =
      !nvidia.empty() || exists(machine, "/dev/dri") || exists(machine, "/dev/dxg");
  // NVIDIA's driver needs no render node.
  for (const std::string& name : nvidia.empty() ? render : nvidia) {
    const fs::path node = fs::path("/dev") / name;
    if (!machine.can_open(under(machine, node))) facts.no_entry.push_back(node.string());
  }
}

// The GPUs that may be used, by the numbers of their nodes, are all partitioned. "config" and
// "monitor" are there without partitions too: capabilities 1 and 2.
// [MIG, Device Nodes and Capabilities]
bool is_partitioned(const MachineView& machine) {
  if (machine.environment("NVIDIA_VISIBLE_DEVICES").find("MIG-") != std::string::npos) return true;
  std::set<std::string> partitioned;
  bool has_list = false;
  const fs::path capabilities = "/proc/driver/nvidia/capabilities";
  for (const std::string& gpu : names_in(machine, capabilities)) {
    const std::string number = number_after(gpu, "gpu");
    if (number.empty()) continue;
    has_list = true;
    for (const std::string& instance : names_in(machine, capabilities / gpu / "mig")) {
      if (!number_after(instance, "gi").empty()) partitioned.insert(number);
    }
  }
  if (!has_list) {  // containers hide it, and get the nodes of their own partitions only
    const std::vector<std::string> nodes = names_in(machine, "/dev/nvidia-caps");
    return std::any_of(nodes.begin(), nodes.end(), [](const std::string& name) {
      const std::string number = number_after(name, "nvidia-cap");
      return !number.empty() && number != "0" && number != "1" && number != "2";
    });
  }
  for (const std::string& number : nvidia_numbers(machine)) {
    if (partitioned.count(number) == 0) return false;
  }
  return !partitioned.empty();
}

// Where the dynamic linker looks, near enough.
std::vector<fs::path> library_folders(const MachineView& machine) {
  std::vector<fs::path> folders;
  for (const std::string& folder : split(machine.environment("LD_LIBRARY_PATH"), ':')) {
    folders.emplace_back(folder);
  }
  for (const std::string& name : names_in(machine, "/etc/ld.so.conf.d")) {
    for (const std::string& line :
         split(text_of(machine, fs::path("/etc/ld.so.conf.d") / name), '\n')) {
      if (line.starts_with('/')) folders.emplace_back(line);
    }
  }
  for (const char* folder :
       {"/lib/x86_64-linux-gnu", "/usr/lib/x86_64-linux-gnu", "/lib/aarch64-linux-gnu",
        "/usr/lib/aarch64-linux-gnu", "/lib64", "/usr/lib64", "/lib", "/usr/lib"}) {
    folders.emplace_back(folder);
  }
  return folders;
}

std::vector<fs::path> vendor_files(const MachineView& machine, const std::string& variable) {
  std::vector<fs::path> files;
  if (variable == kVendorFiles) {
    for (const std::string& file : split(machine.environment(kVendorFiles), ':')) {
      files.emplace_back(file);
    }
    return files;
  }
  const std::string folders = variable == kVendorFolders
                                  ? machine.environment(kVendorFolders)
                                  : "/etc/glvnd/egl_vendor.d:/usr/share/glvnd/egl_vendor.d";
  for (const std::string& folder : split(folders, ':')) {
    for (const std::string& name : names_in(machine, folder)) {
      if (name.ends_with(".json")) files.push_back(fs::path(folder) / name);
    }
  }
  return files;
}

EglVendor read_vendor(const MachineView& machine, const std::string& maker,
                      const std::vector<fs::path>& files) {
  EglVendor vendor;
  const std::string library = fmt::format("libEGL_{}.so.0", maker);
  for (const fs::path& folder : library_folders(machine)) {
    vendor.has_library = vendor.has_library || exists(machine, folder / library);
  }
  for (const fs::path& file : files) {
    const std::string text = text_of(machine, file);
    const std::size_t at = text.find("libEGL_" + maker);
    if (at == std::string::npos) continue;
    vendor.has_file = true;
    // It may name a place where the linker does not look.
    const std::size_t begin = text.rfind('"', at) + 1, end = text.find('"', at);
    if (end == std::string::npos || text[begin] != '/') continue;
    vendor.has_library = vendor.has_library || exists(machine, text.substr(begin, end - begin));
  }
  return vendor;
}

// Not set means utility and compute. [NVIDIA container]
bool has_graphics(const std::string& capabilities) {
  const std::vector<std::string> names = split(capabilities, ',');
  return std::any_of(names.begin(), names.end(),
                     [](const std::string& name) { return name == "graphics" || name == "all"; });
}

MissingDevice why_vendor_missing(const DeviceFacts& facts, const EglVendor& vendor) {
  if (!vendor.has_file) {
    return facts.vendor_variable.empty() ? MissingDevice::no_vendor_file
                                         : MissingDevice::vendor_file_elsewhere;
  }
  return MissingDevice::unknown;
}

// Package and file of the driver that the nodes belong to.
struct DriverNames {
  const char *library, *file, *packages;
};
DriverNames driver_names(const DeviceFacts& facts) {
  if (facts.has_nvidia_nodes) {
    return {"libEGL_nvidia.so.0", "10_nvidia.json",
            "libegl-nvidia0 (Debian) or libnvidia-gl-VERSION (Ubuntu)"};
  }
  return {"libEGL_mesa.so.0", "50_mesa.json", "libegl-mesa0 and libgl1-mesa-dri"};
}

std::string no_driver_advice(const DeviceFacts& facts) {
  if (facts.has_nvidia_gpu) {
    return "there is an NVIDIA GPU, but its driver does not run: install it (Debian: "
           "nvidia-driver, Ubuntu: nvidia-driver-VERSION)";
  }
  return "there is a GPU, but no driver for it: the kernel has made no /dev/dri/renderD*; in a "
         "container, hand it in (--device /dev/dri)";
}

std::string no_library_advice(const DeviceFacts& facts) {
  const DriverNames names = driver_names(facts);
  if (facts.has_nvidia_nodes && facts.is_container) {
    return fmt::format(
        "{} is not in the container, though graphics is among its driver capabilities: install {} "
        "on the host and start the container again",
        names.library, names.packages);
  }
  return fmt::format(
      "{} is missing: install {}{}", names.library, names.packages,
      facts.has_nvidia_nodes
          ? "; in a container, start it with NVIDIA_DRIVER_CAPABILITIES=graphics,utility"
          : "");
}

}  // namespace

MachineView this_machine() {
  return {"/",
          [](std::string_view variable) -> std::string {
            // By name each, so that what is read can be found.
            const std::pair<std::string_view, const char*> known[] = {
                {kVendorFiles, std::getenv("__EGL_VENDOR_LIBRARY_FILENAMES")},
                {kVendorFolders, std::getenv("__EGL_VENDOR_LIBRARY_DIRS")},
                {"LD_LIBRARY_PATH", std::getenv("LD_LIBRARY_PATH")},
                {"NVIDIA_DRIVER_CAPABILITIES", std::getenv("NVIDIA_DRIVER_CAPABILITIES")},
                {"NVIDIA_VISIBLE_DEVICES", std::getenv("NVIDIA_VISIBLE_DEVICES")},
                {"container", std::getenv("container")},
                {"KUBERNETES_SERVICE_HOST", std::getenv("KUBERNETES_SERVICE_HOST")}};
            for (const auto& [name, value] : known) {
              if (name == variable) return value == nullptr ? "" : value;
            }
            throw std::logic_error("an environment variable that is not in the list: " +
                                   std::string(variable));
          },
          [](const fs::path& path) {
            const int file = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
            if (file < 0) return errno != EACCES && errno != EPERM;
            close(file);
            return true;
          }};
}

DeviceFacts read_device_facts(const MachineView& machine) {
  DeviceFacts facts;
  read_pci(machine, facts);
  read_nodes(machine, facts);
  facts.is_nvidia_loaded =
      exists(machine, "/proc/driver/nvidia/version") || exists(machine, "/sys/module/nvidia");
  for (const char* variable : {kVendorFiles, kVendorFolders}) {
    if (facts.vendor_variable.empty() && !machine.environment(variable).empty()) {
      facts.vendor_variable = variable;
    }
  }
  const std::vector<fs::path> files = vendor_files(machine, facts.vendor_variable);
  facts.nvidia = read_vendor(machine, "nvidia", files);
  facts.mesa = read_vendor(machine, "mesa", files);
  facts.is_partitioned = is_partitioned(machine);
  facts.driver_capabilities = machine.environment("NVIDIA_DRIVER_CAPABILITIES");
  facts.is_container = exists(machine, "/.dockerenv") || exists(machine, "/run/.containerenv") ||
                       !machine.environment("container").empty() ||
                       !machine.environment("KUBERNETES_SERVICE_HOST").empty() ||
                       !machine.environment("NVIDIA_VISIBLE_DEVICES").empty() ||
                       !facts.driver_capabilities.empty();
  return facts;
}

MissingDevice why_missing(const DeviceFacts& facts) {
  // Nothing else helps where the GPU is in slices. A variable alone is no GPU.
  const bool has_nvidia = facts.has_nvidia_nodes || facts.has_nvidia_gpu || facts.is_nvidia_loaded;
  if (facts.is_partitioned && has_nvidia) return MissingDevice::partitioned;
  if (facts.has_nvidia_nodes) {
    if (!facts.nvidia.has_library) {
      return facts.is_container && !has_graphics(facts.driver_capabilities)
                 ? MissingDevice::no_graphics_capability
                 : MissingDevice::no_library;
    }
    if (!facts.no_entry.empty()) return MissingDevice::no_permission;
    return why_vendor_missing(facts, facts.nvidia);
  }
  if (facts.has_nvidia_gpu && facts.is_nvidia_loaded) return MissingDevice::not_handed_in;
  if (facts.has_render_nodes) {
    if (!facts.mesa.has_library) return MissingDevice::no_library;
    if (!facts.no_entry.empty()) return MissingDevice::no_permission;
    return why_vendor_missing(facts, facts.mesa);
  }
  if (facts.has_nvidia_gpu || facts.has_other_gpu) return MissingDevice::no_driver;
  return facts.has_graphics_node ? MissingDevice::unknown : MissingDevice::no_gpu;
}

std::string no_egl_device_reason(const DeviceFacts& facts) {
  if (!facts.vendor_variable.empty() && !facts.nvidia.has_file && !facts.mesa.has_file) {
    return facts.vendor_variable + " leads it to no OpenGL driver";
  }
  return "no OpenGL driver is installed";
}

std::string missing_device_advice(const DeviceFacts& facts) {
  const DriverNames names = driver_names(facts);
  switch (why_missing(facts)) {
    case MissingDevice::no_gpu:
    case MissingDevice::unknown:
      return "";
    case MissingDevice::partitioned:
      // [MIG, Supported MIG Profiles]
      return "the GPU is partitioned (MIG), and slices have no OpenGL but those with '+gfx' in "
             "their profile: take a whole GPU";
    case MissingDevice::not_handed_in:
      return "NVIDIA's driver runs, but there is no /dev/nvidia*: start the container with the GPU "
             "(docker: --gpus all), or outside of one run nvidia-modprobe";
    case MissingDevice::no_driver:
      return no_driver_advice(facts);
    case MissingDevice::no_permission:
      return fmt::format(
          "no permission for {}: join the group that owns it ({}), or in a container hand it in "
          "with its rights",
          fmt::join(facts.no_entry, ", "), facts.has_nvidia_nodes ? "often video" : "often render");
    case MissingDevice::no_graphics_capability:
      return fmt::format(
          "the container was started without the driver's OpenGL: start it with "
          "NVIDIA_DRIVER_CAPABILITIES=graphics,utility (it is {})",
          facts.driver_capabilities.empty() ? "not set" : "'" + facts.driver_capabilities + "'");
    case MissingDevice::no_library:
      return no_library_advice(facts);
    case MissingDevice::no_vendor_file:
      return fmt::format(
          "{0} is there, but no file tells EGL of it: write /etc/glvnd/egl_vendor.d/{1} with "
          "{{\"file_format_version\": \"1.0.0\", \"ICD\": {{\"library_path\": \"{0}\"}}}}",
          names.library, names.file);
    case MissingDevice::vendor_file_elsewhere:
      return fmt::format("{0} does not lead EGL to {1}: unset it, or add the {2} that names {1}",
                         facts.vendor_variable, names.library, names.file);
  }
  return "";
}

}  // namespace gpu
