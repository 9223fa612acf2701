#pragma once
// OpenGL's errors as exceptions.

#include <stdexcept>
#include <string>

namespace gpu {

class GlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Not enough memory on the device; the context itself is sound.
class OutOfMemory : public GlError {
 public:
  using GlError::GlError;
};

// Throws if a GL call since the last check failed. doing: "tracing shadow rays".
void check_gl(const std::string& doing);

// Throws calc::BackendFailure, because undone work is not a result.
[[noreturn]] void throw_not_done();

// Discards the errors of earlier failures.
void forget_gl_errors();

}  // namespace gpu
