#include "gpu/rays/path_rounds.h"

#include "calc/radiosity/gather/gatherer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <initializer_list>
#include <numeric>
#include <thread>
#include <vector>

namespace path_rounds_test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// What a device lends. Vertices are told by their channel.
struct Device {
  calc::LightVertices vertices;
  gpu::Lender lender;

  gpu::PathRound round(std::initializer_list<std::uint32_t> chunks,
                       std::initializer_list<std::uint32_t> channels) {
    vertices.clear();
    for (const std::uint32_t channel : channels) vertices.push_back({{}, 1.0f, {}, channel});
    return {chunks, lender.lend(std::as_writable_bytes(std::span(vertices)), ~0u), 0.1};
  }
};

std::vector<std::uint32_t> channels(const calc::LightVertices& vertices) {
  std::vector<std::uint32_t> result;
  for (const calc::LightVertex& vertex : vertices) result.push_back(vertex.channel);
  return result;
}

TEST(RoundCollector, PutsRoundsInOrderOfChunks) {
  Device device;
  calc::LightVertices vertices;
  {
    gpu::RoundCollector rounds(vertices, 0.5);
    rounds.add(device.round({2, 0, 3}, {1, 2, 31, 32, 33}));
    rounds.add(device.round({1, 2, 0}, {3, 21, 22}));
    rounds.add(device.round({0, 1, 2}, {23, 34, 35}));
    rounds.finish();
    EXPECT_THAT(channels(vertices), ElementsAre(1, 2, 3, 21, 22, 23, 31, 32, 33, 34, 35));
  }
  {  // behind them: one round alone, and none
    gpu::RoundCollector rounds(vertices, 1.0);
    rounds.add(device.round({1, 1}, {41, 51}));
    rounds.finish();
    gpu::RoundCollector(vertices, 1.0).finish();
  }
  EXPECT_THAT(channels(vertices), ElementsAre(1, 2, 3, 21, 22, 23, 31, 32, 33, 34, 35, 41, 51));
}

TEST(RoundCollector, TakesNothingThatIsNotDone) {
  Device device;
  calc::LightVertices vertices;
  const gpu::PathRound round = device.round({1, 2}, {1, 2, 3});
  { const gpu::PathRound other = device.round({1, 2}, {1, 2, 3}); }  // leaves "not done" behind
  gpu::RoundCollector rounds(vertices, 1.0);
  EXPECT_THROW(rounds.add(round), calc::BackendFailure);
}

TEST(PathInbox, GivesAllBeforeTheEnd) {
  Device device;
  for (const bool is_late : {false, true}) {
    gpu::PathInbox inbox;
    std::thread sender([&] {
      if (is_late) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      inbox.put(device.round({1}, {1}));
      device.lender.wait();
      inbox.put(device.round({2}, {2, 3}));
      inbox.end("the device was reset");
    });
    std::vector<std::size_t> bytes;
    while (const std::optional<gpu::PathRound> round = inbox.next()) {
      bytes.push_back(round->vertices.bytes().size());
    }
    sender.join();
    EXPECT_THAT(bytes, ElementsAre(32, 64));
    EXPECT_EQ(inbox.problem(), "the device was reset");
    EXPECT_TRUE(device.lender.has_all());
  }
}

}  // namespace
}  // namespace path_rounds_test
