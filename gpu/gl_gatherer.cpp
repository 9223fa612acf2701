#include "gpu/gl_gatherer.h"

namespace gpu {

std::unique_ptr<calc::Gatherer> make_gl_gatherer(std::string& reason) {
  reason = "this build has no OpenGL gatherer yet";
  return nullptr;
}

}  // namespace gpu
