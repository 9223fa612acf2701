#pragma once
// Parts of drawings at a scale, as SVG in millimetres on paper; y points down. Classes are those of
// .layout in html_style.css.

#include "report/html/drawings/flat_box.h"
#include "report/html/drawings/html_isolux.h"

#include <glm/glm.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace report {

inline constexpr double kDrawingText_mm = 2.5;  // size of words and numbers

// Returns the n of the scale 1:n, from 1, 2, 2.5 and 5 times powers of ten, at which this size in
// metres fits into the millimetres. size_m, room_mm: each > 0.
double drawing_scale(const glm::dvec2& size_m, const glm::dvec2& room_mm);

// A view: metres to the right and up; its upper left corner is at `corner_mm`.
struct DrawingView {
  FlatBox extent_m;
  glm::dvec2 corner_mm{0.0};
  double mm_by_m = 1.0;

  glm::dvec2 at(const glm::dvec2& m) const {
    return corner_mm + mm_by_m * glm::dvec2(m.x - extent_m.low.x, extent_m.high.y - m.y);
  }
  double width_mm() const { return extent_m.size().x * mm_by_m; }
  double height_mm() const { return extent_m.size().y * mm_by_m; }
  double right_mm() const { return corner_mm.x + width_mm(); }
  double bottom_mm() const { return corner_mm.y + height_mm(); }

  // Returns the data of a path; is_closed: back to its first corner.
  std::string path(const std::vector<glm::dvec2>& corners_m, bool is_closed = true) const;
};

// Returns a path of that class; "" without data.
std::string drawing_path(const char* kind, const std::string& data);
// Returns words at a point; escaped.
std::string drawing_words(const glm::dvec2& p, std::string_view words,
                          const char* anchor = "middle", const char* kind = "");
// Returns the approximate width, rather too large than too small.
double drawing_width_mm(std::string_view words);
// Returns a circle as data of a path.
std::string circle_path(const glm::dvec2& p, double radius_mm);

// Returns, as data of a path, a circle with a cross: a luminaire whose outline is not known.
inline constexpr double kPointSign_mm = 1.1;  // its radius
std::string point_sign(const glm::dvec2& p);

// Return a dimension with a tick at each end and the words above its line, if they fit.
std::string level_dimension(double from_mm, double to_mm, double y_mm, const std::string& words);
std::string upright_dimension(double from_mm, double to_mm, double x_mm, const std::string& words);

// Returns a north arrow. north_deg: from +x counter-clockwise.
std::string north_arrow(const glm::dvec2& middle, double north_deg);

// Puts labels where they overlap nothing, as long as there is such a place.
class DrawingLabels {
 public:
  void take(const glm::dvec2& middle, const glm::dvec2& size);
  // Puts the words at the first free place of at least one; at the first if none is free.
  std::string put(const std::vector<glm::dvec2>& places, const std::string& words,
                  const char* kind);

 private:
  std::vector<LabelBox> taken_;
};

}  // namespace report
