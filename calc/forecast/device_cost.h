#pragma once
// Compares a graphics device with the CPU: both times by stages, from counts, rates and threads.

#include "calc/forecast/cost_model.h"
#include "calc/forecast/drawing_cost.h"

namespace calc {

// Rates of a device and of transfers to it; 0 = not measured.
struct DeviceRates {
  double any_hit_per_s = 0;      // connections with their shadow ray, one by one
  double closest_hit_per_s = 0;  // short rays
  double path_rays_per_s = 0;    // of light paths, mostly in double
  double up_bytes_per_s = 0, down_bytes_per_s = 0;
  double round_trip_s = 0;  // a little up, a dispatch of next to nothing, a little down
  double open_s = 0;        // context and programs

  friend bool operator==(const DeviceRates&, const DeviceRates&) = default;
};

// Rates for what was not measured. Assumed, from the slower end of published values for good
// tracers without ray units on such devices; opening a device takes 0.15 to 0.5 s.
inline constexpr DeviceRates kAssumedRates{1e9, 5e8, 1e8, 1e10, 5e9, 1e-4, 0.4};

// Returns the same with assumed rates for those not measured or not plausible.
DeviceRates with_assumptions(const DeviceRates& measured);

// The least time that any driver takes to open.
inline constexpr double kLeastOpen_s = 0.15;

// The stages that a device computes; the CPU computes the rest.
struct DeviceStages {
  bool direct_light = true, light_paths = true, connections = true, near_field = true;

  static constexpr DeviceStages none() { return {false, false, false, false}; }
  bool any() const { return *this != none(); }
  friend bool operator==(const DeviceStages&, const DeviceStages&) = default;
};

// The work for any number of spaces.
struct DeviceWork {
  Work work;
  Seconds one_thread;    // on the CPU; `prepare` is so for any number of threads
  double receivers = 0;  // that gather, in all replicates
  double triangles = 0;
  int threads = 1;
  DrawingWork drawing;  // shadow maps, where settings want them

  // Adds a prediction. predicted_threads: those that it is for; `threads` stays as it is.
  void add(const Prediction& prediction, const SpaceWorkload& space,
           const RadiositySettings& settings, int predicted_threads);
};

struct DeviceCost {
  Seconds cpu;          // all of it on the CPU, on the clock
  Seconds with_device;  // of the stages, what stays on the CPU beside it too
  double open_s = 0;
  double send_s = 0;    // the scene; vertices are part of `connect`
  DeviceStages stages;  // those of the device's that it does faster

  double cpu_s() const { return cpu.total(); }
  double device_s() const { return open_s + send_s + with_device.total(); }
};

// Returns both costs; requires all rates. It assumes that device and CPU wait for each other, which
// they do not always.
DeviceCost weigh_device(const DeviceWork& work, const DeviceRates& rates,
                        const DeviceStages& possible);

// The CPU gives the same bits everywhere, a device its own, so that a device must be worth that.
// The choice may therefore be slower than the faster option by at most this factor.
inline constexpr double kWorthwhileGain = 1.2;
bool is_device_worth_it(const DeviceCost& cost);

// Returns the lower bound for any device: rates without limit.
DeviceCost weigh_ideal_device(const DeviceWork& work, const DeviceStages& possible);

}  // namespace calc
