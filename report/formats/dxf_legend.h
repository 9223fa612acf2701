#pragma once
// The frame beside a plan: lines of text in columns, no taller than the plan.

#include "report/formats/dxf_entities.h"
#include "report/html/drawings/flat_box.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {

// Distance between base lines, in heights of the text.
inline constexpr double kDxfLine = 1.6;

// A line in pieces, each with its distance from the left edge in characters.
struct DxfLine {
  std::vector<std::pair<std::size_t, std::string>> pieces;  // words as dxf_text() makes them
  DxfColour colour = DxfColour::by_layer;
};

class DxfColumns {
 public:
  // columns: characters at which long texts are broken; >= 1.
  explicit DxfColumns(std::size_t columns) : columns_(columns) {}

  // Adds a text in as many lines as it needs.
  void add(std::string_view utf8, DxfColour colour = DxfColour::by_layer);
  // Adds all lines of another legend.
  void add(const DxfColumns& other) {
    lines_.insert(lines_.end(), other.lines_.begin(), other.lines_.end());
  }
  // Adds a table: rows as long as the head. Columns are as wide as needed, at most 40 characters;
  // longer cells show their start and end. colours: of the rows.
  void add_table(const std::vector<std::string>& head,
                 const std::vector<std::vector<std::string>>& rows,
                 const std::vector<DxfColour>& colours);

  // Draws a frame from the corner (upper left, metres) to the right and down, in as many columns as
  // that height needs (at least one line). Returns the box of the frame.
  FlatBox draw(std::string_view layer, const glm::dvec2& corner_m, double height_m, double text_m,
               DxfText& dxf) const;

 private:
  std::size_t columns_;
  std::vector<DxfLine> lines_;
};

}  // namespace report
