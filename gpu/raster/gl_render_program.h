#pragma once
// A vertex and a fragment shader.

#include "gpu/opengl/program_cache.h"
#include "gpu/raster/raster_shaders.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>

namespace gpu {

// As GlProgram, for drawing.
class GlRenderProgram {
 public:
  // Throws GlError with the compiler's messages. what: for messages, "shadow map".
  GlRenderProgram(const std::string& what, const RenderShaders& source,
                  const ProgramCache& cache = {});
  ~GlRenderProgram();
  GlRenderProgram(const GlRenderProgram&) = delete;
  GlRenderProgram& operator=(const GlRenderProgram&) = delete;

  void use() const;
  // Of the program in use; names that the shaders do not read are passed over.
  void set(const char* uniform, std::uint32_t value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::mat4& value) const;

  // Whether the cache had it.
  bool is_from_cache() const { return is_from_cache_; }

 private:
  unsigned name_ = 0;
  bool is_from_cache_ = false;
};

}  // namespace gpu
