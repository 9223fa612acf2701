// Buffers and what comes back from them, with storage of a fixed kind and as older drivers do it.
#include "gpu/opengl/gl_buffer.h"

#include "gpu/opengl/gl_error.h"
#include "gpu/opengl/gl_read_back.h"
#include "tests/support/opengl.h"

#include <epoxy/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <span>
#include <thread>
#include <utility>
#include <vector>

namespace gl_buffer_test {
namespace {

using gpu::BufferUse;
using gpu::Fault;
using test_support::gl_device;
using ::testing::Each;
using ::testing::HasSubstr;

std::vector<std::uint32_t> numbers(std::size_t count, std::uint32_t first) {
  std::vector<std::uint32_t> result(count);
  std::iota(result.begin(), result.end(), first);
  return result;
}

std::vector<std::uint32_t> words_of(const gpu::GlBuffer& buffer, std::size_t first,
                                    std::size_t count) {
  std::vector<std::uint32_t> words(count, 0xabcd);
  buffer.read(4 * first, std::as_writable_bytes(std::span(words)));
  return words;
}

bool is_immutable(const gpu::GlBuffer& buffer) {
  GLint is = GL_FALSE;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.name());
  glGetBufferParameteriv(GL_SHADER_STORAGE_BUFFER, GL_BUFFER_IMMUTABLE_STORAGE, &is);
  return is == GL_TRUE;
}

class Buffers : public testing::TestWithParam<Fault> {};

TEST_P(Buffers, GiveBackWhatWasWritten) {
  LUXGATE_NEEDS_OPENGL();
  gl_device(GetParam())->run([&](gpu::DeviceState& device) {
    for (const BufferUse use : {BufferUse::rewritten, BufferUse::fixed, BufferUse::by_device}) {
      gpu::GlBuffer buffer("numbers", use);
      if (use == BufferUse::by_device) {
        buffer.assign(40'000, 7u);
        EXPECT_THAT(words_of(buffer, 0, 10'000), Each(7u));
        buffer.fill(8, 9u);
        EXPECT_EQ(words_of(buffer, 0, 3), (std::vector<std::uint32_t>{9, 9, 7}));
      } else {
        // Less than the smallest buffer, more, and less again.
        for (const std::size_t count : {3u, 10'000u, 20'000u, 5u, 0u}) {
          const std::vector<std::uint32_t> from = numbers(count, 100);
          buffer.assign(from);
          EXPECT_EQ(words_of(buffer, 0, count), from);
        }
        buffer.assign(numbers(10, 0));
        EXPECT_EQ(words_of(buffer, 2, 3), numbers(3, 2));
      }
      if (use == BufferUse::rewritten) {
        const std::vector<std::uint32_t> part = numbers(2, 50);
        buffer.write(4, std::as_bytes(std::span(part)));
        EXPECT_EQ(words_of(buffer, 0, 4), (std::vector<std::uint32_t>{0, 50, 51, 3}));
      }
      EXPECT_EQ(is_immutable(buffer), device.context.has_buffer_storage());
      EXPECT_EQ(device.context.has_buffer_storage(), GetParam() != Fault::no_buffer_storage);
      device.check("testing");
    }
  });
}

TEST_P(Buffers, GrowAndMayBeTooLarge) {
  LUXGATE_NEEDS_OPENGL();
  gl_device(GetParam())->run([&](gpu::DeviceState& device) {
    gpu::GlBuffer buffer("numbers");
    buffer.reserve(100'000);
    EXPECT_EQ(buffer.bytes(), 100'000u);
    buffer.reserve(99);
    EXPECT_EQ(buffer.bytes(), 100'000u);
    buffer.reserve(100'001);
    EXPECT_GE(buffer.bytes(), 140'000u);  // not once more for the next that is a little larger
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    try {
      buffer.reserve(static_cast<std::size_t>(most) + 4);
      ADD_FAILURE();
    } catch (const gpu::OutOfMemory& error) {
      EXPECT_THAT(error.what(), HasSubstr("numbers need "));
    }
    buffer.assign(numbers(9, 0));  // it can be used again
    EXPECT_EQ(words_of(buffer, 0, 9), numbers(9, 0));
    device.check("testing");
  });
}

TEST_P(Buffers, ComeBackInPartsBesideEachOther) {
  LUXGATE_NEEDS_OPENGL();
  gl_device(GetParam())->run([&](gpu::DeviceState& device) {
    gpu::GlBuffer a("a"), b("b");
    a.assign(numbers(5000, 0));
    b.assign(numbers(5000, 100'000));
    gpu::GlReadBack first("first"), second("second");
    first.start({{a, 40, 400}, {b, 0, 0}, {b, 80, 800}}, 1u);
    second.start({{b, 0, 8}}, 1u);
    second.wait("testing");
    std::vector<std::uint32_t> words(2);
    second.copy(0, std::as_writable_bytes(std::span(words)));
    EXPECT_EQ(words, numbers(2, 100'000));
    first.wait("testing");
    EXPECT_TRUE(first.wait_for(0.0, "testing"));
    std::vector<std::uint32_t> expected = numbers(100, 10);
    for (const std::uint32_t word : numbers(200, 100'020)) expected.push_back(word);
    words.assign(300, 0);
    first.copy(0, std::as_writable_bytes(std::span(words)));
    EXPECT_EQ(words, expected);
    words.assign(20, 0);  // across both
    first.copy(4 * 90, std::as_writable_bytes(std::span(words)));
    EXPECT_EQ(words, std::vector<std::uint32_t>(expected.begin() + 90, expected.begin() + 110));
    device.check("testing");
  });
}

TEST_P(Buffers, AreLentToOtherThreads) {
  LUXGATE_NEEDS_OPENGL();
  std::vector<std::thread> readers;
  gl_device(GetParam())->run([&](gpu::DeviceState& device) {
    gpu::GlBuffer buffer("numbers");
    gpu::GlReadBack read_back("numbers");
    for (std::uint32_t turn = 0; turn < 4; ++turn) {
      buffer.assign(numbers(2000, 10'000 * turn));
      read_back.start({{buffer, 0, 8000}}, ~0u);  // waits for those of the turn before
      read_back.wait("testing");
      for (const auto& [first, count] : {std::pair{0u, 500u}, {500u, 1500u}}) {
        readers.emplace_back([expected = numbers(count, 10'000 * turn + first),
                              lent = read_back.lend(4 * first, 4 * count)]() mutable {
          const gpu::BorrowedBytes own = std::move(lent);
          std::this_thread::sleep_for(std::chrono::milliseconds(2));
          EXPECT_TRUE(std::ranges::equal(own.bytes(), std::as_bytes(std::span(expected))));
        });
      }
    }
    EXPECT_THROW(read_back.lend(4, 8000), gpu::GlError);
    device.check("testing");
  });
  for (std::thread& reader : readers) reader.join();
}

INSTANTIATE_TEST_SUITE_P(ByDriver, Buffers, testing::Values(Fault::none, Fault::no_buffer_storage),
                         [](const auto& driver) {
                           return driver.param == Fault::none ? "OfToday" : "WithoutStorage";
                         });

// What came back before must not pass for what did not come back now.
TEST(ReadBack, DoesNotShowEarlierResults) {
  LUXGATE_NEEDS_OPENGL();
  gl_device(Fault::results_lost)->run([&](gpu::DeviceState& device) {
    gpu::GlBuffer buffer("numbers");
    buffer.assign(numbers(5000, 1));
    EXPECT_EQ(words_of(buffer, 0, 5000), numbers(5000, 1));
    EXPECT_THAT(words_of(buffer, 0, 5000), Each(~0u));
    gpu::GlReadBack read_back("numbers");
    std::vector<std::uint32_t> words(5000);
    for (const bool is_lost : {false, true}) {
      read_back.start({{buffer, 0, 20'000}}, 0xffff'fffeu);
      read_back.wait("testing");
      read_back.copy(0, std::as_writable_bytes(std::span(words)));
      if (is_lost) {
        EXPECT_THAT(words, Each(0xffff'fffeu));
      } else {
        EXPECT_EQ(words, numbers(5000, 1));
      }
    }
    device.check("testing");
    EXPECT_EQ(device.context.fault(), Fault::results_lost);
  });
}

TEST(ReadBack, DoesNotShowWhatItLentEarlier) {
  LUXGATE_NEEDS_OPENGL();
  gl_device(Fault::results_lost)->run([&](gpu::DeviceState& device) {
    gpu::GlBuffer buffer("numbers");
    buffer.assign(numbers(5000, 1));
    for (const std::size_t borrowed_bytes : {std::size_t{20'000}, std::size_t{8000}}) {
      gpu::GlReadBack read_back("numbers");
      std::vector<std::uint32_t> words(5000);
      for (const std::size_t bytes : {20'000u, 10'000u, 20'000u}) {
        words.resize(bytes / 4);
        read_back.start({{buffer, 0, bytes}}, ~0u);
        read_back.wait("testing");
        read_back.copy(0, std::as_writable_bytes(std::span(words)));
        if (words[0] == 1) {
          EXPECT_EQ(words, numbers(5000, 1));
          read_back.lend(0, borrowed_bytes);
        } else {
          EXPECT_THAT(words, Each(~0u));
        }
      }
      EXPECT_EQ(words.size(), 5000u);
    }
    device.check("testing");
  });
}

TEST(ReadBack, EndsWhenTheDeviceSaysNothing) {
  LUXGATE_NEEDS_OPENGL();
  gl_device(Fault::fence_lost)->run([&](gpu::DeviceState&) {
    gpu::GlBuffer buffer("numbers");
    buffer.assign(numbers(100, 1));
    try {
      words_of(buffer, 0, 100);
      ADD_FAILURE();
    } catch (const gpu::GlError& error) {
      EXPECT_THAT(error.what(), HasSubstr("the device has not answered for 0.3"));
      EXPECT_THAT(error.what(), HasSubstr("while reading numbers"));
    }
  });
}

}  // namespace
}  // namespace gl_buffer_test
