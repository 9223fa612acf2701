#pragma once
// What OpenGL complains about, as exceptions.

#include <stdexcept>
#include <string>

namespace gpu {

class GlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// There was not enough memory on the device; the context itself is sound.
class OutOfMemory : public GlError {
 public:
  using GlError::GlError;
};

// Throws if a GL call since the last check failed. doing: "tracing shadow rays".
void check_gl(const std::string& doing);

// Throws calc::BackendFailure: what a device left undone is no result.
[[noreturn]] void throw_not_done();

// Throws away what earlier failures left behind.
void forget_gl_errors();

}  // namespace gpu
