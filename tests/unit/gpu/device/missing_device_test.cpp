#include "gpu/device/missing_device.h"

#include "tests/support/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace missing_device_test {
namespace {

namespace fs = std::filesystem;
using gpu::MissingDevice;
using ::testing::HasSubstr;

constexpr const char* kNvidiaJson =
    R"({"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_nvidia.so.0"}})";
constexpr const char* kMesaJson =
    R"({"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_mesa.so.0"}})";

// A tree that looks like a machine.
class FakeMachine {
 public:
  FakeMachine& file(const std::string& path, const std::string& text = "") {
    const fs::path whole = root_.path() / path;
    fs::create_directories(whole.parent_path());
    test_support::put_bytes(whole, text);
    return *this;
  }
  FakeMachine& remove(const std::string& path) {
    fs::remove_all(root_.path() / path);
    return *this;
  }
  FakeMachine& set(const std::string& variable, const std::string& value) {
    variables_[variable] = value;
    return *this;
  }
  FakeMachine& lock(const std::string& path) {
    locked_.insert((root_.path() / path).string());
    return *this;
  }
  FakeMachine& pci(const std::string& place, const std::string& device_class,
                   const std::string& maker) {
    file("sys/bus/pci/devices/" + place + "/class", device_class + "\n");
    return file("sys/bus/pci/devices/" + place + "/vendor", maker + "\n");
  }

  gpu::DeviceFacts facts() const {
    return gpu::read_device_facts({root_.path(),
                                   [this](std::string_view variable) {
                                     const auto found = variables_.find(std::string(variable));
                                     return found == variables_.end() ? "" : found->second;
                                   },
                                   [this](const fs::path& path) {
                                     return fs::exists(path) && locked_.count(path.string()) == 0;
                                   }});
  }
  MissingDevice why() const { return gpu::why_missing(facts()); }
  std::string advice() const { return gpu::missing_device_advice(facts()); }

 private:
  const test_support::ScratchFolder root_;
  std::map<std::string, std::string> variables_;
  std::set<std::string> locked_;
};

// A machine of one NVIDIA GPU on which nothing is wrong. Capabilities for all GPUs are there
// without MIG too.
struct NvidiaMachine : FakeMachine {
  NvidiaMachine() {
    pci("0000:17:00.0", "0x030200", "0x10de").file("proc/driver/nvidia/version");
    file("dev/nvidia0").file("dev/nvidiactl").file("dev/nvidia-uvm");
    file("dev/nvidia-caps/nvidia-cap1").file("dev/nvidia-caps/nvidia-cap2");
    file("proc/driver/nvidia/capabilities/mig/config");
    file("proc/driver/nvidia/capabilities/mig/monitor");
    file("usr/lib/x86_64-linux-gnu/libEGL_nvidia.so.0");
    file("usr/share/glvnd/egl_vendor.d/10_nvidia.json", kNvidiaJson);
    file("usr/share/glvnd/egl_vendor.d/50_mesa.json", kMesaJson);
  }
};

TEST(MissingDevice, NothingIsSaidWhereThereIsNoGpu) {
  FakeMachine machine;
  EXPECT_EQ(machine.why(), MissingDevice::no_gpu);
  // Of a virtual machine; and a sound card by a maker of GPUs.
  machine.pci("0000:00:01.0", "0x030000", "0x1af4").pci("0000:00:02.0", "0x040300", "0x10de");
  EXPECT_EQ(machine.why(), MissingDevice::no_gpu);
  EXPECT_EQ(machine.advice(), "");
}

// What a variable says of slices does not make a GPU; one that hides all drivers is named.
TEST(MissingDevice, VariablesAloneAreNoGpu) {
  FakeMachine machine;
  machine.set("NVIDIA_VISIBLE_DEVICES", "MIG-1");
  EXPECT_EQ(machine.why(), MissingDevice::no_gpu);
  EXPECT_EQ(gpu::no_egl_device_reason(machine.facts()), "no OpenGL driver is installed");
  machine.file("usr/share/glvnd/egl_vendor.d/50_mesa.json", kMesaJson);
  machine.set("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent");
  EXPECT_EQ(gpu::no_egl_device_reason(machine.facts()),
            "__EGL_VENDOR_LIBRARY_FILENAMES leads it to no OpenGL driver");
}

TEST(MissingDevice, NothingIsSaidWhereAllIsAsItShouldBe) {
  const NvidiaMachine machine;
  EXPECT_EQ(machine.why(), MissingDevice::unknown);
  EXPECT_EQ(machine.advice(), "");
}

TEST(MissingDevice, ContainerWithoutGraphics) {
  NvidiaMachine machine;
  machine.remove("usr/lib/x86_64-linux-gnu/libEGL_nvidia.so.0").file(".dockerenv");
  EXPECT_EQ(machine.why(), MissingDevice::no_graphics_capability);
  EXPECT_THAT(machine.advice(),
              HasSubstr("NVIDIA_DRIVER_CAPABILITIES=graphics,utility (it is not set)"));
  machine.set("NVIDIA_DRIVER_CAPABILITIES", "compute,utility");
  EXPECT_EQ(machine.why(), MissingDevice::no_graphics_capability);
  EXPECT_THAT(machine.advice(), HasSubstr("(it is 'compute,utility')"));
  // Where graphics is asked for, it is the host that has none.
  for (const char* enough : {"all", "compute,graphics"}) {
    machine.set("NVIDIA_DRIVER_CAPABILITIES", enough);
    EXPECT_EQ(machine.why(), MissingDevice::no_library) << enough;
    EXPECT_THAT(machine.advice(), HasSubstr("on the host"));
  }
}

TEST(MissingDevice, DriverWithoutItsOpenGl) {
  NvidiaMachine machine;
  machine.remove("usr/lib/x86_64-linux-gnu/libEGL_nvidia.so.0");
  EXPECT_EQ(machine.why(), MissingDevice::no_library);
  EXPECT_THAT(machine.advice(), HasSubstr("libEGL_nvidia.so.0 is missing: install libegl-nvidia0"));
}

TEST(MissingDevice, LibrariesAreFoundWhereTheLinkerLooks) {
  NvidiaMachine machine;
  machine.remove("usr/lib/x86_64-linux-gnu/libEGL_nvidia.so.0");
  machine.file("opt/driver/libEGL_nvidia.so.0");
  EXPECT_FALSE(machine.facts().nvidia.has_library);
  machine.file("etc/ld.so.conf.d/driver.conf", "# driver\n/opt/driver\n");
  EXPECT_TRUE(machine.facts().nvidia.has_library);
  machine.remove("etc/ld.so.conf.d/driver.conf")
      .set("LD_LIBRARY_PATH", "/usr/local/lib:/opt/driver");
  EXPECT_TRUE(machine.facts().nvidia.has_library);
  // A whole path in the vendor's file needs no linker.
  machine.set("LD_LIBRARY_PATH", "");
  machine.file("usr/share/glvnd/egl_vendor.d/10_nvidia.json",
               R"({"ICD": {"library_path": "/opt/driver/libEGL_nvidia.so.0"}})");
  EXPECT_TRUE(machine.facts().nvidia.has_library);
}

TEST(MissingDevice, VendorFileIsMissing) {
  NvidiaMachine machine;
  machine.remove("usr/share/glvnd/egl_vendor.d/10_nvidia.json");
  EXPECT_EQ(machine.why(), MissingDevice::no_vendor_file);
  EXPECT_THAT(machine.advice(), HasSubstr("write /etc/glvnd/egl_vendor.d/10_nvidia.json with "
                                          "{\"file_format_version\": \"1.0.0\""));
  machine.file("etc/glvnd/egl_vendor.d/10_nvidia.json", kNvidiaJson);
  EXPECT_EQ(machine.why(), MissingDevice::unknown);
}

TEST(MissingDevice, VariablesLeadEglElsewhere) {
  NvidiaMachine machine;
  machine.set("__EGL_VENDOR_LIBRARY_DIRS", "/opt/vendors");
  EXPECT_EQ(machine.why(), MissingDevice::vendor_file_elsewhere);
  EXPECT_THAT(machine.advice(), HasSubstr("__EGL_VENDOR_LIBRARY_DIRS does not lead EGL to"));
  machine.file("opt/vendors/n.json", kNvidiaJson);
  EXPECT_EQ(machine.why(), MissingDevice::unknown);
  // The list of files is asked first, and alone.
  machine.set("__EGL_VENDOR_LIBRARY_FILENAMES", "/usr/share/glvnd/egl_vendor.d/50_mesa.json");
  EXPECT_EQ(machine.why(), MissingDevice::vendor_file_elsewhere);
  EXPECT_THAT(machine.advice(), HasSubstr("__EGL_VENDOR_LIBRARY_FILENAMES does not lead EGL to"));
}

TEST(MissingDevice, NoPermission) {
  NvidiaMachine machine;
  machine.file("dev/dri/renderD128").lock("dev/dri/renderD128");
  EXPECT_EQ(machine.why(), MissingDevice::unknown) << "NVIDIA's driver needs no render node";
  machine.lock("dev/nvidiactl");
  EXPECT_EQ(machine.why(), MissingDevice::no_permission);
  EXPECT_THAT(machine.advice(), HasSubstr("no permission for /dev/nvidiactl: join the group"));

  FakeMachine other;
  other.pci("0000:00:02.0", "0x030000", "0x1002").file("dev/dri/renderD128").file("dev/dri/card0");
  other.file("usr/lib64/libEGL_mesa.so.0");
  other.file("usr/share/glvnd/egl_vendor.d/50_mesa.json", kMesaJson);
  EXPECT_EQ(other.why(), MissingDevice::unknown);
  other.lock("dev/dri/renderD128");
  EXPECT_EQ(other.why(), MissingDevice::no_permission);
  EXPECT_THAT(other.advice(), HasSubstr("/dev/dri/renderD128: join the group that owns it (often "
                                        "render)"));
}

TEST(MissingDevice, Partitions) {
  for (const char* sign :
       {"proc/driver/nvidia/capabilities/gpu0/mig/gi1/access", "dev/nvidia-caps/nvidia-cap12"}) {
    NvidiaMachine machine;
    machine.file(sign);
    EXPECT_EQ(machine.why(), MissingDevice::partitioned) << sign;
  }
  NvidiaMachine machine;
  machine.set("NVIDIA_VISIBLE_DEVICES", "MIG-c6d4f1ef-42e4-5de3-91c7-45d71c87eb3f");
  EXPECT_EQ(machine.why(), MissingDevice::partitioned);
  EXPECT_THAT(machine.advice(), HasSubstr("take a whole GPU"));
}

TEST(MissingDevice, PartitionsOfOneGpuDoNotMatterToAnother) {
  NvidiaMachine machine;
  machine.file("proc/driver/nvidia/capabilities/gpu0/mig/gi1/access");
  machine.file("dev/nvidia1").remove("usr/lib/x86_64-linux-gnu/libEGL_nvidia.so.0");
  EXPECT_EQ(machine.why(), MissingDevice::no_library);
}

TEST(MissingDevice, NoDriverAtAll) {
  FakeMachine nvidia;
  nvidia.pci("0000:17:00.0", "0x030200", "0x10de");
  EXPECT_EQ(nvidia.why(), MissingDevice::no_driver);
  EXPECT_THAT(nvidia.advice(), HasSubstr("its driver does not run: install it"));
  // The kernel's part shows in containers that were not given the GPU.
  nvidia.file("proc/driver/nvidia/version");
  EXPECT_EQ(nvidia.why(), MissingDevice::not_handed_in);
  EXPECT_THAT(nvidia.advice(), HasSubstr("docker: --gpus all"));

  FakeMachine other;
  other.pci("0000:00:02.0", "0x030000", "0x8086");
  EXPECT_EQ(other.why(), MissingDevice::no_driver);
  other.file("dev/dri/renderD128");
  EXPECT_EQ(other.why(), MissingDevice::no_library);
  EXPECT_THAT(other.advice(), HasSubstr("libEGL_mesa.so.0 is missing: install libegl-mesa0"));
}

TEST(MissingDevice, GraphicsNodesAreSeen) {
  EXPECT_FALSE(FakeMachine().facts().has_graphics_node);
  for (const char* node : {"dev/dri/card0", "dev/dxg", "dev/nvidiactl", "dev/nvidia3"}) {
    FakeMachine machine;
    EXPECT_TRUE(machine.file(node).facts().has_graphics_node) << node;
  }
}

}  // namespace
}  // namespace missing_device_test
