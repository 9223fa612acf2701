#pragma once
// Finds free places for the labels of a drawing. All in millimetres on paper.

#include "report/html/drawings/flat_box.h"
#include "report/html/drawings/html_isolux.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace report {

struct LabelPlace {
  std::size_t form = 0;  // which of the sizes
  glm::dvec2 middle{0.0};
};

// A label outside the outline that it names, with a line to it.
struct LeaderPlace {
  glm::dvec2 middle{0.0}, from{0.0}, to{0.0};
};

// The occupied places: boxes of signs and labels, and lines that no label may cross.
class LabelPlaces {
 public:
  // paper: finite; labels stay on it, and signs outside of it do not matter.
  explicit LabelPlaces(const FlatBox& paper);

  // Occupies the box and returns its number.
  std::size_t take(const LabelBox& box);
  void take_line(const glm::dvec2& from, const glm::dvec2& to);
  void take_outline(const std::vector<glm::dvec2>& outline);

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  // Returns whether the box is free. ignored: number of a box that does not matter.
  bool is_free(const LabelBox& box, std::size_t ignored = kNone) const;

  // Returns whether a way crosses an occupied line.
  bool is_crossed(const glm::dvec2& from, const glm::dvec2& to) const;

  // Returns the first of these sizes that fits into the outline, as near to its middle as possible,
  // and occupies it. Requires that the sides of the outline are occupied. Empty: none fits.
  std::optional<LabelPlace> put_inside(const std::vector<glm::dvec2>& outline,
                                       const std::vector<glm::dvec2>& sizes);
  // Returns a place as near as possible to the outline, which has three corners or more, not across
  // a line, and outside of all outlines if possible. Occupies label and leader. Empty: there is no
  // free place within reach.
  std::optional<LeaderPlace> put_beside(const std::vector<glm::dvec2>& outline,
                                        const glm::dvec2& size);

 private:
  struct Line {
    glm::dvec2 from, to;
  };
  struct Cell {
    std::vector<std::size_t> boxes, lines;
  };
  // Calls visit(index) for all cells that the box meets, until it returns false; then returns
  // false.
  template <class Visit>
  bool visit_cells(const LabelBox& box, const Visit& visit) const;
  // Returns the box around the part of a line in a row of cells that it meets.
  LabelBox part_in_row(const Line& line, std::size_t row) const;
  bool is_leader_free(const Line& leader) const;
  bool is_in_outline(const glm::dvec2& place) const;

  FlatBox paper_;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<Cell> cells_;  // [row * columns_ + column]
  std::vector<LabelBox> boxes_;
  std::vector<Line> lines_;
  std::vector<std::vector<glm::dvec2>> outlines_;
};

}  // namespace report
