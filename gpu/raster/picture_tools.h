#pragma once
// Keeps tools for drawing between pictures.

#include "gpu/opengl/program_cache.h"
#include "gpu/raster/gl_render_program.h"
#include "gpu/raster/gl_target.h"

#include <optional>

namespace gpu {

// Tools made on first use. All calls, also the destructor, need the context current in which it
// lives; they throw GlError.
class PictureTools {
 public:
  enum Output : std::size_t { kValue = 0, kCover = 1 };  // layers of target()

  // Returns a target of layers kValue, kCover and depth, at least so large.
  const GlTarget& target(int width, int height);
  const GlRenderProgram& surfaces(const ProgramCache& cache);
  const GlRenderProgram& lines_and_dots(const ProgramCache& cache);
  void clear();

 private:
  std::optional<GlTarget> target_;
  std::optional<GlRenderProgram> surfaces_, lines_and_dots_;
};

}  // namespace gpu
