#pragma once
// Measures a device's rates once and keeps them beside the compiled shaders.

#include "calc/forecast/device_cost.h"
#include "gpu/device/device_thread.h"

#include <optional>
#include <string>
#include <string_view>

namespace gpu {

inline constexpr double kCalibrationLimit_s = 1.0;

// Convert rates to text and back; empty if the text is incomplete or has impossible values.
std::string rates_text(const calc::DeviceRates& rates);
std::optional<calc::DeviceRates> read_rates(std::string_view text);

// Returns this device's and driver's kept rates, if any, without a context. device: as listed.
std::optional<calc::DeviceRates> kept_rates(const Device& device,
                                            const std::filesystem::path& program_folder);

// Returns the kept rates, else measures and keeps them. Rates that a slow device does not reach
// within the limit stay 0. A choice based on rates that were not kept may differ the next time.
// Empty if the device fails: `problem` says how.
std::optional<calc::DeviceRates> measured_rates(const DeviceRequest& request, double limit_s,
                                                std::string& problem);

}  // namespace gpu
