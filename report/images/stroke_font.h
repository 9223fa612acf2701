#pragma once
// Letters as lines, for pictures made of pixels: the same everywhere, and nothing to load.

#include <glm/glm.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace report {

// In pixels, x to the right from the start of the text, y downwards from its base line.
struct TextStrokes {
  std::vector<std::vector<glm::dvec2>> lines;  // two places or more; equal ones are a dot
  double width_px = 0.0;
  double pen_px = 0.0;  // how wide the lines are
};

// size_px: of the font; capitals have 0.7 of it. ASCII, the letters of Latin-1 with œ, Œ, dashes,
// quotation marks and the signs of quantities are known; other characters are a box, and broken
// UTF-8 as well.
TextStrokes text_strokes(std::string_view utf8, double size_px);

// The text, or as much of its beginning as fits into so many pixels with "…" behind it.
std::string fitting_text(std::string_view utf8, double size_px, double width_px);

}  // namespace report
