#pragma once
// `luxgate devices`: lists devices for --backend gpu.

#include "gpu/device/device.h"
#include "report/shell/command/command.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace cli {

std::string render_devices_text(const gpu::DeviceList& list);
std::string render_devices_json(const gpu::DeviceList& list);
// Returns the list as JSON, which is also part of `luxgate version --json`.
nlohmann::ordered_json devices_json(const gpu::DeviceList& list);

Command devices_command();

}  // namespace cli
