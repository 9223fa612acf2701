#pragma once
// Letters as lines, for pictures made of pixels: the same on every machine, without font files.

#include <glm/glm.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace report {

// Lines in pixels, x to the right from the start of the text, y downwards from its base line.
struct TextStrokes {
  std::vector<std::vector<glm::dvec2>> lines;  // two places or more; equal ones are a dot
  double width_px = 0.0;
  double pen_px = 0.0;  // how wide the lines are
};

// Returns the lines of a text. size_px: of the font; capitals have 0.7 of it. Known are ASCII, the
// letters of Latin-1 with œ, Œ, dashes, quotation marks and the signs of quantities; other
// characters are a box, as is broken UTF-8.
TextStrokes text_strokes(std::string_view utf8, double size_px);

// Returns the text, or its start that fits into this width with "…" behind it.
std::string fitting_text(std::string_view utf8, double size_px, double width_px);

}  // namespace report
