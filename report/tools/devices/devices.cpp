#include "report/tools/devices/devices.h"

#include "gpu/device/egl_context.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/print.h"
#include "report/text/json_layout.h"
#include "report/text/plain_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cli {
namespace {

std::string device_lines(const gpu::Device& device) {
  std::string text =
      fmt::format("{:<3} {}\n", device.index,
                  device.renderer.empty() ? "(no OpenGL)" : report::printable(device.renderer));
  if (!device.version.empty()) {
    text += fmt::format("    {}, OpenGL {}\n", report::printable(device.vendor),
                        report::printable(device.version));
  }
  text += device.is_software ? "    software: draws, and calculates with --backend gpu only\n"
                             : "    hardware\n";
  return text + (device.is_usable() ? "    usable\n"
                                    : fmt::format("    not usable: {}\n", device.problem));
}

}  // namespace

std::string render_devices_text(const gpu::DeviceList& list) {
  std::string text;
  for (const gpu::Device& device : list.devices) text += device_lines(device);
  if (list.devices.empty()) text += fmt::format("no OpenGL device: {}\n", list.problem);
  if (!list.advice.empty()) text += fmt::format("GPU not found: {}\n", list.advice);
  return text;
}

nlohmann::ordered_json devices_json(const gpu::DeviceList& list) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const gpu::Device& device : list.devices) {
    json.push_back({{"index", device.index},
                    {"renderer", device.renderer},
                    {"vendor", device.vendor},
                    {"version", device.version},
                    {"software", device.is_software},
                    {"usable", device.is_usable()},
                    {"problem", device.problem}});
  }
  return json;
}

std::string render_devices_json(const gpu::DeviceList& list) {
  return report::json_layout(nlohmann::ordered_json{
      {"devices", devices_json(list)}, {"problem", list.problem}, {"advice", list.advice}});
}

Command devices_command() {
  const auto as_json = std::make_shared<bool>(false);
  Command command{"devices", "List OpenGL devices, and why one cannot be used"};
  command.options = text_or_json_options(*as_json);
  command.examples = {{"luxgate devices --json", "The same for a program"}};
  command.exit_codes = {{0, "at least one device is usable"}, {2, "none is"}};
  command.run = [as_json](const RunContext& context) {
    const gpu::DeviceList list = gpu::list_devices(context.gl_fault);
    return print_outcome({gpu::preferred_device(list) >= 0 ? kAllMet : kNotJudged,
                          *as_json ? render_devices_json(list) : render_devices_text(list),
                          {}});
  };
  return command;
}

}  // namespace cli
