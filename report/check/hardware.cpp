#include "report/check/hardware.h"

#include "gpu/device/calibration.h"

#include <fmt/format.h>

#include <utility>

namespace check {

RatesOf rates_on_this_machine(gpu::Fault fault, const std::string& program_folder) {
  return [fault, program_folder](const gpu::Device& device, bool may_measure,
                                 std::string& problem) {
    if (may_measure && !program_folder.empty()) {
      gpu::measured_rates({device.index, fault, program_folder}, gpu::kCalibrationLimit_s, problem);
    }
    return gpu::kept_rates(device, program_folder);
  };
}

Hardware::Hardware(gpu::Fault fault, const std::string& program_folder)
    : Hardware(
          fault != gpu::Fault::no_egl && gpu::may_have_hardware(),
          [fault] { return gpu::list_hardware(fault); },
          rates_on_this_machine(fault, program_folder)) {}

Hardware::Hardware(bool may_exist, Find find, RatesOf rates_of)
    : may_exist_(may_exist), find_(std::move(find)), rates_of_(std::move(rates_of)) {}

const gpu::DeviceList& Hardware::list() {
  if (!list_) list_ = find_();
  return *list_;
}

std::string why_no_hardware(const gpu::DeviceList& hardware, const std::string& note_on_software) {
  std::string text = hardware.problem;
  const auto add = [&](const std::string& part) { text += text.empty() ? part : "; " + part; };
  for (const gpu::Device& device : hardware.devices) {
    add(fmt::format("OpenGL device {} {}", device.index,
                    device.is_software ? note_on_software : "cannot be used: " + device.problem));
  }
  if (!hardware.advice.empty()) add(hardware.advice);
  return text;
}

}  // namespace check
