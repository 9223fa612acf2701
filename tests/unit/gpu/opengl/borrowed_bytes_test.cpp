#include "gpu/opengl/borrowed_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

namespace borrowed_bytes_test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

TEST(BorrowedBytes, ComeBackNotDone) {
  std::array<std::uint32_t, 6> words{1, 2, 3, 4, 5, 6};
  const auto bytes = std::as_writable_bytes(std::span(words));
  gpu::Lender lender;
  {
    gpu::BorrowedBytes lent = lender.lend(bytes.subspan(4, 12), 0xffff'fffeu);
    EXPECT_FALSE(lender.has_all());
    const gpu::BorrowedBytes moved = std::move(lent);
    EXPECT_EQ(moved.bytes().size(), 12u);
    EXPECT_THAT(words, ElementsAre(1, 2, 3, 4, 5, 6));
  }
  EXPECT_TRUE(lender.has_all());
  EXPECT_THAT(words, ElementsAre(1, 0xffff'fffeu, 0xffff'fffeu, 0xffff'fffeu, 5, 6));
  lender.lend(bytes, ~0u);
  EXPECT_THAT(words, Each(~0u));
}

TEST(BorrowedBytes, AreWaitedFor) {
  constexpr std::size_t kReaders = 3, kBytes = 5000;
  std::vector<std::byte> memory(kReaders * kBytes);
  gpu::Lender lender;
  std::vector<std::thread> readers;
  for (int turn = 1; turn <= 10; ++turn) {
    lender.wait();
    EXPECT_THAT(memory, Each(std::byte(turn == 1 ? 0x00 : 0xff)));
    memory.assign(memory.size(), std::byte(turn));
    for (std::size_t k = 0; k < kReaders; ++k) {
      readers.emplace_back(
          [turn, lent = lender.lend(std::span(memory).subspan(k * kBytes, kBytes), ~0u)]() mutable {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            const gpu::BorrowedBytes own = std::move(lent);
            for (const std::byte byte : own.bytes()) ASSERT_EQ(byte, std::byte(turn));
          });
    }
  }
  lender.wait();
  for (std::thread& reader : readers) reader.join();
}

}  // namespace
}  // namespace borrowed_bytes_test
