#pragma once
// What drawing pictures keeps from one to the next.

#include "gpu/opengl/program_cache.h"
#include "gpu/raster/gl_render_program.h"
#include "gpu/raster/gl_target.h"

#include <optional>

namespace gpu {

// Made when first asked for. All calls need the context current in which it lives, the destructor
// too; they throw GlError.
class PictureTools {
 public:
  enum Output : std::size_t { kValue = 0, kCover = 1 };  // layers of target()

  // Layers kValue, kCover and depth, at least so large.
  const GlTarget& target(int width, int height);
  const GlRenderProgram& surfaces(const ProgramCache& cache);
  const GlRenderProgram& lines_and_dots(const ProgramCache& cache);
  void clear();

 private:
  std::optional<GlTarget> target_;
  std::optional<GlRenderProgram> surfaces_, lines_and_dots_;
};

}  // namespace gpu
