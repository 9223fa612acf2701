#include "gpu/raster/picture_tools.h"

#include <algorithm>

namespace gpu {

const GlTarget& PictureTools::target(int width, int height) {
  if (!target_ || target_->width() < width || target_->height() < height) {
    if (target_) {
      width = std::max(width, target_->width());
      height = std::max(height, target_->height());
      target_.reset();  // first, so that both need not have room
    }
    target_.emplace("a picture", width, height,
                    std::vector<Layer>{Layer::value, Layer::colour, Layer::depth});
  }
  return *target_;
}

const GlRenderProgram& PictureTools::surfaces(const ProgramCache& cache) {
  if (!surfaces_) surfaces_.emplace("surfaces", picture_shaders(false), cache);
  return *surfaces_;
}

const GlRenderProgram& PictureTools::lines_and_dots(const ProgramCache& cache) {
  if (!lines_and_dots_) lines_and_dots_.emplace("lines and dots", picture_shaders(true), cache);
  return *lines_and_dots_;
}

void PictureTools::clear() {
  target_.reset();
  surfaces_.reset();
  lines_and_dots_.reset();
}

}  // namespace gpu
