#pragma once
// What graphics hardware this machine has and how fast it is, for whoever chooses by that.

#include "calc/forecast/device_cost.h"
#include "gpu/device/device.h"
#include "gpu/device/egl_context.h"

#include <functional>
#include <optional>
#include <string>

namespace check {

// Rates of a device. may_measure: whether the work is worth the second that measuring may take;
// else only what was kept is asked for. Empty: nothing is known, or `problem` says how the device
// failed.
using RatesOf = std::function<std::optional<calc::DeviceRates>(
    const gpu::Device& device, bool may_measure, std::string& problem)>;
// Measured by gpu::measured_rates(), and kept in the folder of compiled shaders: what cannot be
// kept does not count, so that one machine chooses alike every time.
RatesOf rates_on_this_machine(gpu::Fault fault, const std::string& program_folder);

// Looked for when it is first asked for, and once: that opens every device.
class Hardware {
 public:
  using Find = std::function<gpu::DeviceList()>;

  // program_folder: as for gpu::DeviceRequest.
  Hardware(gpu::Fault fault, const std::string& program_folder);
  // find: gpu::list_hardware(). may_exist: whether that is worth it.
  Hardware(bool may_exist, Find find, RatesOf rates_of);

  // Quick.
  bool may_exist() const { return may_exist_; }
  bool is_found() const { return list_.has_value(); }
  const gpu::DeviceList& list();
  const RatesOf& rates_of() const { return rates_of_; }

 private:
  bool may_exist_;
  Find find_;
  RatesOf rates_of_;
  std::optional<gpu::DeviceList> list_;
};

// For messages: why there is none that can be used. note_on_software: "is software".
std::string why_no_hardware(const gpu::DeviceList& hardware, const std::string& note_on_software);

}  // namespace check
