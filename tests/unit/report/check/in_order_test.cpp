#include "report/check/in_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace check::in_order_test {
namespace {

const auto kAlways = [] { return true; };

std::vector<std::size_t> counted(std::size_t count) {
  std::vector<std::size_t> list(count);
  std::iota(list.begin(), list.end(), std::size_t{0});
  return list;
}

// The first pieces take longest, so that others overtake them.
TEST(InOrder, DeliversInOrderWhateverEndsFirst) {
  for (const Concurrency concurrency : {Concurrency{1, 1}, Concurrency{1, 4}, Concurrency{2, 4},
                                        Concurrency{4, 8}, Concurrency{0, 3}}) {
    std::vector<std::size_t> delivered;
    std::vector<int> done(40, 0);
    const auto work = [&](std::size_t i) {
      std::this_thread::sleep_for(std::chrono::microseconds(i % 4 == 0 ? 2000 : 10));
      done[i] = 1;
    };
    const auto deliver = [&](std::size_t i) {
      EXPECT_EQ(done[i], 1);
      delivered.push_back(i);
    };
    in_order(done.size(), concurrency, work, deliver, kAlways);
    EXPECT_EQ(delivered, counted(done.size()));
  }
}

// Also while pieces wait for parallel work of their own: no thread takes up another piece then.
TEST(InOrder, NoMoreAreBegunThanAskedFor) {
  constexpr std::size_t kMost = 3;
  std::atomic<int> begun{0}, most{0};
  const auto work = [&](std::size_t /*i*/) {
    const int now = ++begun;
    int seen = most;
    while (now > seen && !most.compare_exchange_weak(seen, now)) {
    }
    tbb::parallel_for(0, 8,
                      [](int) { std::this_thread::sleep_for(std::chrono::microseconds(50)); });
  };
  in_order(
      60, {4, kMost}, work, [&](std::size_t) { --begun; }, kAlways);
  EXPECT_LE(most, static_cast<int>(kMost));
  EXPECT_GE(most, 1);
}

// That would hold up the first piece until the second is done.
TEST(InOrder, AThreadThatWaitsForItsPieceTakesUpNoOther) {
  // On few cores no thread would ever be without work.
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 8);
  thread_local int pieces = 0;
  std::atomic<int> most{0};
  const auto work = [&](std::size_t /*i*/) {
    if (++pieces > most) most = pieces;
    tbb::parallel_for(0, 16,
                      [](int) { std::this_thread::sleep_for(std::chrono::microseconds(20)); });
    --pieces;
  };
  in_order(
      300, {4, 16}, work, [](std::size_t) {}, kAlways);
  EXPECT_EQ(most, 1);
}

TEST(InOrder, WhatWasBegunIsFinishedOnceItStops) {
  for (const Concurrency concurrency : {Concurrency{1, 1}, Concurrency{2, 4}}) {
    std::atomic<bool> go_on{true};
    std::atomic<std::size_t> worked{0};
    std::vector<std::size_t> delivered;
    const auto work = [&](std::size_t i) {
      ++worked;
      if (i == 5) go_on = false;
    };
    in_order(
        100, concurrency, work, [&](std::size_t i) { delivered.push_back(i); },
        [&] { return go_on.load(); });
    EXPECT_EQ(delivered, counted(worked));
    EXPECT_GE(delivered.size(), 6U);
    EXPECT_LT(delivered.size(), 100U);
  }
}

TEST(InOrder, PassesOnAnException) {
  const auto work = [](std::size_t i) {
    if (i == 7) throw std::runtime_error("seven");
  };
  for (const Concurrency concurrency : {Concurrency{1, 1}, Concurrency{2, 4}}) {
    EXPECT_THROW(in_order(
                     20, concurrency, work, [](std::size_t) {}, kAlways),
                 std::runtime_error);
  }
}

TEST(InOrder, NothingIsNothing) {
  in_order(
      0, {2, 4}, [](std::size_t) { FAIL(); }, [](std::size_t) { FAIL(); }, kAlways);
}

}  // namespace
}  // namespace check::in_order_test
