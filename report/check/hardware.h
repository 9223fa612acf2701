#pragma once
// The graphics hardware of this machine and its speed, for choices between devices.

#include "calc/forecast/device_cost.h"
#include "gpu/device/device.h"
#include "gpu/device/egl_context.h"

#include <functional>
#include <optional>
#include <string>

namespace check {

// Returns the rates of a device. may_measure: the work is worth the second that measuring may take;
// otherwise only stored rates are used. Empty: nothing is known, or `problem` says how the device
// failed.
using RatesOf = std::function<std::optional<calc::DeviceRates>(
    const gpu::Device& device, bool may_measure, std::string& problem)>;
// Returns rates measured by gpu::measured_rates(), stored with the compiled shaders. Rates that
// cannot be stored do not count, so that a machine chooses alike every time.
RatesOf rates_on_this_machine(gpu::Fault fault, const std::string& program_folder);

// The graphics hardware, listed once and at the first request, because listing opens every device.
class Hardware {
 public:
  using Find = std::function<gpu::DeviceList()>;

  // program_folder: as for gpu::DeviceRequest.
  Hardware(gpu::Fault fault, const std::string& program_folder);
  // find: gpu::list_hardware(). may_exist: whether calling it is worthwhile.
  Hardware(bool may_exist, Find find, RatesOf rates_of);

  // Returns quickly whether there may be hardware.
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

// Returns for messages why there is no usable hardware. note_on_software: "is software".
std::string why_no_hardware(const gpu::DeviceList& hardware, const std::string& note_on_software);

}  // namespace check
