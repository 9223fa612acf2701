// What a driver says, counted.
#include "gpu/device/driver_messages.h"

#include "gpu/opengl/gl_buffer.h"
#include "tests/support/opengl.h"

#include <epoxy/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace driver_messages_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using Kind = gpu::DriverMessages::Kind;

TEST(DriverMessages, AreCountedAndKeptOnce) {
  gpu::DriverMessages messages;
  messages.add(Kind::performance, "moved");
  messages.add(Kind::other, "moved");
  messages.add(Kind::performance, "moved");
  EXPECT_EQ(messages.count(Kind::performance), 2u);
  EXPECT_EQ(messages.count(Kind::other), 1u);
  ASSERT_EQ(messages.messages().size(), 2u);
  EXPECT_EQ(messages.messages()[0].count, 2u);
  EXPECT_EQ(messages.messages()[1].count, 1u);
  for (int k = 0; k < 1000; ++k) messages.add(Kind::performance, std::to_string(k));
  EXPECT_EQ(messages.count(Kind::performance), 1002u);
  EXPECT_EQ(messages.messages().size(), gpu::DriverMessages::kMostTexts);
  messages.name_buffer(7, "sums");
  messages.name_buffer(7, "results");
  messages.name_buffer(7, "sums");
  EXPECT_THAT(messages.buffers(), testing::ElementsAre("buffer 7: sums, results"));
}

void say(GLenum type, const char* text) {
  glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, type, 1, GL_DEBUG_SEVERITY_MEDIUM, -1, text);
}

TEST(DriverMessages, ComeFromADebugContext) {
  LUXGATE_NEEDS_OPENGL();
  gpu::DriverMessages messages;
  std::string problem;
  const auto device = gpu::DeviceThread::open({-1, gpu::Fault::none, "", &messages}, problem);
  ASSERT_NE(device, nullptr) << problem;
  std::size_t before = 0;
  std::string buffer;
  device->run([&](gpu::DeviceState& state) {
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    EXPECT_NE(flags & GL_CONTEXT_FLAG_DEBUG_BIT, 0);
    gpu::GlBuffer sums("a test's sums");
    sums.reserve(1);
    buffer = "buffer " + std::to_string(sums.name()) + ": a test's sums";
    glFinish();
    before = messages.count(Kind::performance);
    say(GL_DEBUG_TYPE_PERFORMANCE, "a buffer has moved");
    say(GL_DEBUG_TYPE_PERFORMANCE, "a buffer has moved");
    say(GL_DEBUG_TYPE_OTHER, "a buffer is here");
    say(GL_DEBUG_TYPE_MARKER, "nothing");
    glFinish();
    state.check("testing");
  });
  EXPECT_EQ(messages.count(Kind::performance), before + 2);
  EXPECT_THAT(messages.buffers(), Contains(buffer));
  std::string all;
  for (const auto& message : messages.messages()) all += message.text + "\n";
  EXPECT_THAT(all, HasSubstr("a buffer is here"));
  EXPECT_THAT(all, testing::Not(HasSubstr("nothing")));
}

TEST(DriverMessages, AreNotAskedForOtherwise) {
  LUXGATE_NEEDS_OPENGL();
  test_support::gl_device()->run([&](gpu::DeviceState& state) {
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    EXPECT_EQ(flags & GL_CONTEXT_FLAG_DEBUG_BIT, 0);
    EXPECT_EQ(state.context.messages(), nullptr);
  });
}

}  // namespace
}  // namespace driver_messages_test
