// Division and square root in shaders against the processor's, which IEEE 754 rounds.
#include "calc/radiosity/sampling/random.h"
#include "gpu/gather/shader_text.h"
#include "gpu/opengl/gl_buffer.h"
#include "gpu/opengl/gl_program.h"
#include "tests/support/opengl.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace exact_arithmetic_test {
namespace {

using test_support::gl_device;

constexpr std::size_t kCount = std::size_t{1} << 18;

const char* const kMain = R"glsl(
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer A { float a[]; };
layout(std430, binding = 1) readonly buffer B { float b[]; };
layout(std430, binding = 2) writeonly buffer C { vec2 c[]; };
void main() {
  const uint i = gl_GlobalInvocationID.x;
  c[i] = vec2(exact_quotient(a[i], b[i]), exact_root(a[i]));
}
)glsl";

// Positive, of the sizes that weights of nodes meet, with mantissas near powers of two among them.
float number(std::uint64_t i, std::uint64_t part) {
  const std::uint64_t bits = calc::RandomKey(3).with(i).with(part).bits();
  std::uint32_t mantissa = static_cast<std::uint32_t>(bits) & 0x7fffffu;
  if (i % 5 == 0) mantissa &= 0x7u;
  if (i % 7 == 0) mantissa |= 0x7ffff8u;
  const std::uint32_t exponent = 127u - 40u + static_cast<std::uint32_t>(bits >> 32) % 80u;
  return std::bit_cast<float>((exponent << 23) | mantissa);
}

TEST(ExactArithmetic, IsRoundedLikeTheProcessors) {
  LUXGATE_NEEDS_OPENGL();
  std::vector<float> a(kCount), b(kCount), c(2 * kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    a[i] = i < 4 ? 0.0f : number(i, 0);
    b[i] = number(i, 1);
    if (i % 11 == 0) b[i] = a[i] > 0.0f ? a[i] : 1.0f;
  }
  gl_device()->run([&](gpu::DeviceState&) {
    const gpu::GlProgram program("exact", gpu::exact_arithmetic() + kMain);
    gpu::GlBuffer to_a("a"), to_b("b"), from_c("c");
    to_a.reserve(4 * kCount);
    to_b.reserve(4 * kCount);
    from_c.reserve(8 * kCount);
    to_a.write(0, std::as_bytes(std::span(a)));
    to_b.write(0, std::as_bytes(std::span(b)));
    to_a.bind(0);
    to_b.bind(1);
    from_c.bind(2);
    program.use();
    glDispatchCompute(kCount / 64, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    from_c.read(0, std::as_writable_bytes(std::span(c)));
  });
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const bool is_right = c[2 * i] == a[i] / b[i] && c[2 * i + 1] == std::sqrt(a[i]);
    if (is_right) continue;
    if (++wrong <= 3) {
      ADD_FAILURE() << a[i] << " / " << b[i] << " = " << c[2 * i] << ", root " << c[2 * i + 1];
    }
  }
  EXPECT_EQ(wrong, 0u);
}

}  // namespace
}  // namespace exact_arithmetic_test
