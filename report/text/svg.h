#pragma once
// Pieces of SVG shared by several drawings.

#include <string>
#include <string_view>
#include <vector>

namespace report {

// Returns a coordinate in an SVG: two decimals at most, no trailing zeros.
std::string svg_number(double value);

// Returns text at a point; escaped. anchor: the part of the text at the point, "start", "middle" or
// "end".
std::string svg_text(double x, double y, const char* anchor, std::string_view text);

// Returns multiples of 1, 2 or 5 times a power of ten in [low, high], ascending, at most `most` >=
// 2 of them. Empty unless low < high, both finite.
std::vector<double> round_ticks(double low, double high, int most);

// A picture with room for axes around a field; in pixels.
struct PlotFrame {
  double width, height;
  double left, right, top, bottom;  // room on each side

  double x_end() const { return width - right; }
  double y_end() const { return height - bottom; }
  // Return places in the field: 0 left, 1 right; 0 at the bottom, 1 at the top.
  double x(double share) const { return left + share * field_width(); }
  double y(double share) const { return y_end() - share * field_height(); }
  double field_width() const { return width - left - right; }
  double field_height() const { return height - top - bottom; }
};

}  // namespace report
