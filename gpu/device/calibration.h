#pragma once
// How fast a device is, measured once and kept beside the compiled shaders.

#include "calc/forecast/device_cost.h"
#include "gpu/device/device_thread.h"

#include <optional>
#include <string>
#include <string_view>

namespace gpu {

inline constexpr double kCalibrationLimit_s = 1.0;

// As text, and back: nothing if it is not whole, or says what cannot be.
std::string rates_text(const calc::DeviceRates& rates);
std::optional<calc::DeviceRates> read_rates(std::string_view text);

// Of this device and driver, if they were kept; no context is opened. device: as it was listed.
std::optional<calc::DeviceRates> kept_rates(const Device& device,
                                            const std::filesystem::path& program_folder);

// What was kept, else measures and keeps it. What a slow device does not reach within the limit
// stays 0. A choice that rests on what was not kept may be another one the next time. Nothing if
// the device fails: `problem` says how.
std::optional<calc::DeviceRates> measured_rates(const DeviceRequest& request, double limit_s,
                                                std::string& problem);

}  // namespace gpu
