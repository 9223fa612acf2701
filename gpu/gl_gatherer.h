#pragma once
// The same sum over light vertices as the CPU's, by OpenGL.

#include "calc/radiosity/gatherer.h"

#include <memory>
#include <string>

namespace gpu {

// A gatherer on the first OpenGL device that EGL offers without a window. Null if there is none;
// `reason` then says why in words, for the user. The caller must not fall back to another backend
// unasked.
std::unique_ptr<calc::Gatherer> make_gl_gatherer(std::string& reason);

}  // namespace gpu
