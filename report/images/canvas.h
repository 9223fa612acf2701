#pragma once
// Draws lines, areas and words with smooth edges into a picture made of pixels.

#include "report/images/heatmap.h"

#include <glm/glm.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace report {

enum class TextAnchor { start, middle, end };

// An opaque picture. Places are in its pixels, x to the right, y downwards; parts outside are not
// drawn.
class Canvas {
 public:
  // Makes a white picture.
  Canvas(int width, int height);
  // Draws a picture over white, with its upper left corner at this place.
  void put(const Raster& picture, int left, int top);
  void fill(int left, int top, int width, int height, Rgb colour);

  // Adds a straight piece of a line with round ends; paint() paints the whole line.
  void cover(const glm::dvec2& a, const glm::dvec2& b, double width);
  void paint(Rgb colour);
  // Draws a line at once. corners: of the line.
  void line(std::span<const glm::dvec2> corners, double width, Rgb colour);
  // Writes a text. at: on the base line.
  void write(std::string_view utf8, const glm::dvec2& at, double size_px, TextAnchor anchor,
             Rgb colour);

  const Raster& raster() const { return raster_; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(raster_.width) +
           static_cast<std::size_t>(x);
  }
  void blend(std::size_t pixel, Rgb colour, float share);

  Raster raster_;
  std::vector<float> coverage_;                // of each pixel by what is not yet painted
  int left_, top_, right_ = -1, bottom_ = -1;  // where that is
};

}  // namespace report
