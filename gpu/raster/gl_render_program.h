#pragma once
// A vertex and a fragment shader.

#include "gpu/opengl/program_cache.h"
#include "gpu/raster/raster_shaders.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>

namespace gpu {

// Like GlProgram, for drawing.
class GlRenderProgram {
 public:
  // Throws GlError with the compiler's messages. what: for messages, "shadow map".
  GlRenderProgram(const std::string& what, const RenderShaders& source,
                  const ProgramCache& cache = {});
  ~GlRenderProgram();
  GlRenderProgram(const GlRenderProgram&) = delete;
  GlRenderProgram& operator=(const GlRenderProgram&) = delete;

  void use() const;
  // Sets a uniform of the program in use; ignores names that the shaders do not read.
  void set(const char* uniform, std::uint32_t value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::mat4& value) const;

  // Returns whether it is from the cache.
  bool is_from_cache() const { return is_from_cache_; }

 private:
  unsigned name_ = 0;
  bool is_from_cache_ = false;
};

}  // namespace gpu
