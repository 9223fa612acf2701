#include "calc/forecast/device_cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace device_cost_test {
namespace {

// Of one look at a room, times `size`: about 45 s of one thread each.
calc::DeviceWork work(double size, int threads) {
  calc::DeviceWork w;
  w.threads = threads;
  w.work.light_paths = 1e6 * size;
  w.work.pool_rays = 5e6 * size;
  w.work.direct_rays = 1e7 * size;
  w.work.opening_pairs = 1e6 * size;
  w.work.connection_rays = 4e8 * size;
  w.work.near_rays = 5e6 * size;
  w.receivers = 1e6 * size;
  w.triangles = 1000.0;
  w.one_thread = {0.002, 3.8 * size, 2.4 * size, 38.0 * size, 1.5 * size};
  return w;
}

calc::DeviceRates times(const calc::DeviceRates& rates, double factor) {
  calc::DeviceRates r = rates;
  for (double* rate : {&r.any_hit_per_s, &r.closest_hit_per_s, &r.path_rays_per_s,
                       &r.up_bytes_per_s, &r.down_bytes_per_s}) {
    *rate *= factor;
  }
  r.round_trip_s /= factor;
  return r;
}

bool takes_device(const calc::DeviceWork& w, const calc::DeviceRates& rates,
                  const calc::DeviceStages& possible = {}) {
  return calc::is_device_worth_it(calc::weigh_device(w, rates, possible));
}

TEST(DeviceCost, MoreCoresMoveWorkToTheCpu) {
  const calc::DeviceRates slow = times(calc::kAssumedRates, 0.1);
  EXPECT_TRUE(takes_device(work(1.0, 1), slow));
  EXPECT_TRUE(takes_device(work(1.0, 2), slow));
  EXPECT_FALSE(takes_device(work(1.0, 64), slow));
  double before = 0.0;
  for (int threads = 1; threads <= 256; threads *= 2) {
    const calc::DeviceCost cost = calc::weigh_device(work(1.0, threads), slow, {});
    if (!cost.stages.any()) break;  // nor with more
    const double ratio = cost.device_s() / cost.cpu_s();
    EXPECT_GE(ratio, before) << threads;
    before = ratio;
  }
}

TEST(DeviceCost, MoreWorkMovesToTheDevice) {
  EXPECT_FALSE(takes_device(work(0.001, 8), calc::kAssumedRates));
  EXPECT_TRUE(takes_device(work(1.0, 8), calc::kAssumedRates));
  bool was_taken = false;
  for (double size = 1e-4; size < 1e3; size *= 2.0) {
    const bool is_taken = takes_device(work(size, 8), calc::kAssumedRates);
    EXPECT_TRUE(is_taken || !was_taken) << size;
    was_taken = is_taken;
  }
  EXPECT_TRUE(was_taken);
}

TEST(DeviceCost, WhatIsSlowerThanTheCpuIsNeverTaken) {
  for (const double factor : {1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0}) {
    for (const double size : {1e-3, 0.1, 1.0, 100.0, 1e4}) {
      for (const int threads : {1, 2, 16, 192}) {
        const calc::DeviceCost cost =
            calc::weigh_device(work(size, threads), times(calc::kAssumedRates, factor), {});
        const bool is_taken = calc::is_device_worth_it(cost);
        const double taken_s = is_taken ? cost.device_s() : cost.cpu_s();
        EXPECT_LE(taken_s, 1.2 * std::fmin(cost.device_s(), cost.cpu_s()));
        if (is_taken) {
          EXPECT_LT(cost.device_s(), cost.cpu_s());
        }
      }
    }
  }
  EXPECT_FALSE(takes_device(work(1e4, 1), times(calc::kAssumedRates, 1e-4)));
}

TEST(DeviceCost, StagesThatAreSlowerStayOnTheCpu) {
  calc::DeviceRates no_doubles = calc::kAssumedRates;
  no_doubles.path_rays_per_s = 1e6;
  const calc::DeviceCost cost = calc::weigh_device(work(1.0, 8), no_doubles, {});
  EXPECT_FALSE(cost.stages.light_paths);
  EXPECT_TRUE(cost.stages.connections);
  EXPECT_EQ(cost.with_device.pool, cost.cpu.pool);
  EXPECT_LT(cost.with_device.connect, cost.cpu.connect);
}

TEST(DeviceCost, OnlyStagesThatAreThereAreTaken) {
  calc::DeviceWork w = work(1.0, 2);
  w.one_thread.direct = 1000.0;
  calc::DeviceStages possible;
  possible.direct_light = false;
  const calc::DeviceCost without = calc::weigh_device(w, calc::kAssumedRates, possible);
  EXPECT_FALSE(without.stages.direct_light);
  EXPECT_EQ(without.with_device.direct, 500.0);
  const calc::DeviceCost all = calc::weigh_device(w, calc::kAssumedRates, {});
  EXPECT_TRUE(all.stages.direct_light);
  EXPECT_LT(all.with_device.direct, 10.0);
  const calc::DeviceCost none =
      calc::weigh_device(w, calc::kAssumedRates, {false, false, false, false});
  EXPECT_EQ(none.device_s(), none.cpu_s());
  EXPECT_FALSE(calc::is_device_worth_it(none));
}

TEST(DeviceCost, WhatHasToBeSentCounts) {
  const auto gain_s = [](const calc::DeviceWork& w) {
    const calc::DeviceCost cost = calc::weigh_device(w, calc::kAssumedRates, {});
    return cost.cpu_s() - cost.device_s();
  };
  calc::DeviceWork much = work(1.0, 8);
  much.triangles = 1e7;
  EXPECT_LT(gain_s(much), gain_s(work(1.0, 8)) - 3.0);
  calc::DeviceWork vertices = work(1.0, 8);
  vertices.work.pool_rays = 5e8;
  const calc::DeviceStages connections{false, false, true, false};
  EXPECT_GT(calc::weigh_device(vertices, calc::kAssumedRates, connections).with_device.connect,
            calc::weigh_device(work(1.0, 8), calc::kAssumedRates, connections).with_device.connect +
                5.0 / 8.0);
}

// Adding what comes back, 55 ns of a thread for each of 1e6 receivers.
TEST(DeviceCost, ThreadsShareWhatTheCpuDoesBeside) {
  const auto connect_s = [](int threads) {
    return calc::weigh_ideal_device(work(1.0, threads), {}).with_device.connect;
  };
  EXPECT_NEAR(connect_s(1) - connect_s(4), 0.055 - 0.01375, 1e-9);
}

TEST(DeviceCost, NoDeviceIsFasterThanTheIdealOne) {
  for (const double size : {1e-3, 1.0, 100.0}) {
    const calc::DeviceCost ideal = calc::weigh_ideal_device(work(size, 4), {});
    const calc::DeviceRates fast = times(calc::kAssumedRates, 1e6);
    EXPECT_LE(ideal.device_s(), calc::weigh_device(work(size, 4), fast, {}).device_s());
  }
}

TEST(DeviceCost, WhatIsNotMeasuredIsAssumed) {
  EXPECT_EQ(calc::with_assumptions({}), calc::kAssumedRates);
  calc::DeviceRates some;
  some.any_hit_per_s = 3e9;
  some.open_s = std::numeric_limits<double>::quiet_NaN();
  some.up_bytes_per_s = -1.0;
  some.down_bytes_per_s = std::numeric_limits<double>::infinity();
  calc::DeviceRates expected = calc::kAssumedRates;
  expected.any_hit_per_s = 3e9;
  EXPECT_EQ(calc::with_assumptions(some), expected);
}

// Predictions are for some number of threads, and added up for one.
TEST(DeviceCost, PredictionsAddUp) {
  calc::SpaceWorkload space;
  space.planes.push_back({100, 80, 20.0, 400.0, 0.0, 30.0, 10.0, 7.0});
  space.rays_per_path = 3.0;
  space.vertices_per_path = 2.5;
  space.triangles = 12;
  calc::RadiositySettings settings;
  settings.replicates = 10;
  settings.first_paths = settings.max_paths = 256;
  calc::DeviceWork sum;
  const calc::Prediction one = calc::predict(space, {256}, settings, 1);
  sum.add(one, space, settings, 1);
  sum.add(calc::predict(space, {256}, settings, 8), space, settings, 8);
  EXPECT_DOUBLE_EQ(sum.work.connection_rays, 2.0 * one.work.connection_rays);
  EXPECT_DOUBLE_EQ(sum.work.opening_pairs, 2.0 * 37.0);
  EXPECT_DOUBLE_EQ(sum.receivers, 2.0 * 800.0);
  EXPECT_DOUBLE_EQ(sum.triangles, 24.0);
  EXPECT_NEAR(sum.one_thread.total(), 2.0 * one.seconds.total(), 1e-12);
  EXPECT_EQ(sum.threads, 1);
}

}  // namespace
}  // namespace device_cost_test
