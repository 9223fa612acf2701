#include "gpu/opengl/gl_error.h"

#include "calc/radiosity/gather/gatherer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace gpu {
namespace {

std::string name_of(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_CONTEXT_LOST:
      return "GL_CONTEXT_LOST";
    default:
      return fmt::format("GL error {:#x}", error);
  }
}

}  // namespace

void check_gl(const std::string& doing) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  forget_gl_errors();
  if (error == GL_OUT_OF_MEMORY) {
    throw OutOfMemory("the device is out of memory while " + doing);
  }
  throw GlError(fmt::format("{} while {}", name_of(error), doing));
}

void throw_not_done() { throw calc::BackendFailure("the device did not finish its work"); }

void forget_gl_errors() {
  // A lost context may report for ever.
  for (int k = 0; k < 100 && glGetError() != GL_NO_ERROR; ++k) {
  }
}

}  // namespace gpu
